#include "bench/bench.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "bench/markdown.hpp"
#include "grader/base/text_file.hpp"

namespace mc::grader {
namespace fs = std::filesystem;
namespace {

/// Nanoseconds, digits and the task of each method for a variance; equal methods share one label.
std::string variance_points(const Bench& bench, const std::string& submission) {
  struct Point {
    double nanoseconds, digits;
    std::string tasks;
  };
  std::vector<Point> points;
  for (const BenchRow& row : bench.of("digits")) {
    const double time = time_of(bench, submission, row.what, "in cache", 4096);
    if (row.submission != submission || row.on != "1e9 + U(0, 1)" || std::isnan(time)) continue;
    const std::string task = row.what.substr(0, row.what.find(' '));
    const auto same = std::find_if(points.begin(), points.end(), [&](const Point& point) {
      return std::abs(point.nanoseconds / time - 1) < 0.15 &&
             std::abs(point.digits - row.value) < 0.4;
    });
    if (same == points.end()) {
      points.push_back({time, row.value, task});
    } else {
      same->tasks += ", " + task;
    }
  }
  std::string rows;
  for (const Point& point : points) {
    rows += fmt::format("{}\t{}\t{}\n", point.nanoseconds, point.digits, point.tasks);
  }
  return rows;
}

}  // namespace

Plots draw_bench(const Layout& layout, const Bench& bench, const fs::path& place) {
  Plots plots;
  if (!can_draw(plots)) return plots;
  // Blocks that gnuplot finds by their names: n, microseconds, RMSE and its standard error.
  std::string curves, variances;
  std::vector<std::string> peers, peers_draw;
  for (const Curve& curve : curves_of(bench)) {
    const std::string block = fmt::format("{}|{}", curve.submission, curve.what);
    const bool is_peer = curve.submission != "solutions";
    if (is_peer && enlist(peers, block) == peers_draw.size()) peers_draw.push_back(curve.what);
    curves += fmt::format("# {}|{}\n", block, curve.on);
    for (const auto& point : curve.points) {
      curves +=
          fmt::format("{}\t{}\t{}\t{}\n", point.n, 1e6 * point.seconds(), point.rmse, point.error);
    }
    curves += "\n\n";
  }
  std::vector<std::string> who;  // the solutions, submissions, libraries
  for (const BenchRow& row : bench.of("digits")) enlist(who, row.submission);
  for (const std::string& submission : who) {
    variances += fmt::format("# {}\n", submission) + variance_points(bench, submission) + "\n\n";
  }
  write_text(place / "curves.tsv", curves);
  write_text(place / "variances.tsv", variances);
  const fs::path drawing = layout.root / "autograder" / "bench" / "plots.gp";
  for (const std::string extension : {"svg", "png"}) {
    const std::string failure = run_gnuplot(
        place / ("plots." + extension + ".gp"),
        script_beginning(layout, place / "bench", extension) +
            fmt::format("data = {}\n{}{}{}load {}\n", gnuplot_string(place.string()),
                        gnuplot_array("who", who), gnuplot_array("peer", peers),
                        gnuplot_array("peerwhat", peers_draw), gnuplot_string(drawing.string())));
    if (!failure.empty()) plots.remarks.push_back(failure);
  }
  collect(plots, place, "bench-");
  return plots;
}

}  // namespace mc::grader
