#include "grader/plots.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "grader/build.hpp"
#include "grader/jail.hpp"
#include "grader/judge.hpp"
#include "grader/process.hpp"
#include "grader/text_file.hpp"

namespace mc::grader {
namespace fs = std::filesystem;
namespace {

/// What every script begins with.
std::string beginning(const Layout& layout, const fs::path& out, const std::string& extension) {
  return fmt::format("out = {}\next = {}\ndraw = {}\n", gnuplot_string(out.string()),
                     gnuplot_string(extension),
                     gnuplot_string((layout.labs() / "common" / "draw.gp").string()));
}

std::string script_of(const Layout& layout, const Lab& lab, const std::vector<std::string>& labels,
                      const std::vector<fs::path>& data, const fs::path& out,
                      const std::string& extension) {
  const fs::path here = layout.labs() / lab.folder;
  return beginning(layout, out, extension) +
         fmt::format("count = {}\n{}{}here = {}\nload {}\n", labels.size(),
                     gnuplot_array("labels", labels),
                     gnuplot_array("data", std::vector<std::string>(data.begin(), data.end())),
                     gnuplot_string(here.string()), gnuplot_string((here / "plots.gp").string()));
}

bool can_draw(Plots& plots) {
  if (gnuplot_is_there()) return true;
  plots.remarks.push_back("no plots: gnuplot is not installed (./lab setup)");
  return false;
}

/// Draws with `script(extension)`, which is kept beside `name`, once for SVG and once for PNG.
template <class Script>
void draw(Plots& plots, const fs::path& name, Script script) {
  for (const std::string extension : {"svg", "png"}) {
    const std::string failure =
        run_gnuplot(name.string() + "." + extension + ".gp", script(extension));
    if (!failure.empty()) plots.remarks.push_back(failure);
  }
}

void collect(Plots& plots, const fs::path& place, const std::string& start) {
  for (const auto& entry : fs::directory_iterator(place)) {
    if (entry.path().filename().string().starts_with(start)) plots.pictures.push_back(entry.path());
  }
  std::sort(plots.pictures.begin(), plots.pictures.end());
}

/// Nanoseconds, digits and the task for each way to a variance; ways that are one get one label.
std::string variance_points(const Bench& bench, const std::string& submission) {
  struct Point {
    double nanoseconds, digits;
    std::string tasks;
  };
  std::vector<Point> points;
  for (const BenchRow& row : bench.of("digits")) {
    const auto time = time_of(bench, submission, row.what, "in cache", 1, 4096);
    if (row.submission != submission || row.on != "1e9 + U(0, 1)" || !time) continue;
    const std::string task = row.what.substr(0, row.what.find(' '));
    const auto same = std::find_if(points.begin(), points.end(), [&](const Point& point) {
      return std::abs(point.nanoseconds / time->value - 1) < 0.15 &&
             std::abs(point.digits - row.value) < 0.4;
    });
    if (same == points.end()) {
      points.push_back({time->value, row.value, task});
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

bool gnuplot_is_there() {
  return run_process({"gnuplot", "--version"}).exit_code == 0;
}

std::string gnuplot_string(const std::string& text) {
  std::string all = "'";
  for (const char c : text) all += c == '\'' ? "''" : std::string(1, c);
  return all + "'";
}

std::string gnuplot_array(const std::string& name, const std::vector<std::string>& texts) {
  std::string list;
  for (const std::string& text : texts) list += (list.empty() ? "" : ", ") + gnuplot_string(text);
  return fmt::format("array {}[{}] = [{}]\n", name, texts.size(), list);
}

std::string run_gnuplot(const fs::path& script, const std::string& text) {
  write_text(script, "set encoding utf8\nset termoption noenhanced\n" + text);
  const ProcessResult drawn = run_process({"gnuplot", script.string()}, {.wall_seconds = 120});
  return drawn.succeeded() ? "" : "gnuplot failed: " + printable(drawn.errors);
}

Plots draw_plots(const Layout& layout, const Lab& lab, const std::vector<Submission>& submissions,
                 const std::string& folder) {
  Plots plots;
  if (!can_draw(plots)) return plots;
  const fs::path place = layout.build / "plots" / folder;
  std::vector<std::string> labels;
  std::vector<fs::path> data;
  for (const Submission& submission : submissions) {
    const Built built = build_program(layout, lab, submission, Variant::speed);
    if (!built.program) {
      plots.remarks.push_back(fmt::format("{} is not drawn: {}", submission.label, built.failure));
      continue;
    }
    const fs::path measured = place / "data" / fmt::format("{}-{}", lab.name, labels.size());
    fs::create_directories(measured);
    const ProcessOptions options{.environment = {{"MC_PLOT_DATA", measured.string()}},
                                 .wall_seconds = 300};
    if (run_hidden_cases(layout, lab, *built.program, "[.plot]", options).succeeded()) {
      labels.push_back(submission.label);
      data.push_back(measured);
    } else {
      plots.remarks.push_back(submission.label + " is not drawn: its measurements failed");
    }
  }
  if (labels.empty()) return plots;
  draw(plots, place / "data" / lab.name, [&](const std::string& extension) {
    return script_of(layout, lab, labels, data, place / lab.name, extension);
  });
  collect(plots, place, lab.name + "-");
  return plots;
}

Plots draw_bench(const Layout& layout, const Bench& bench, const fs::path& place) {
  Plots plots;
  if (!can_draw(plots)) return plots;
  // Blocks that gnuplot finds by their names: n, microseconds, RMSE and its standard error.
  std::string curves, variances;
  for (const Curve& curve : curves_of(bench)) {
    curves += fmt::format("# {}|{}|{}\n", curve.submission, curve.what, curve.on);
    for (const auto& point : curve.points) {
      curves +=
          fmt::format("{}\t{}\t{}\t{}\n", point.n, 1e6 * point.seconds(), point.rmse, point.error);
    }
    curves += "\n\n";
  }
  for (const char* submission : {"solutions", "std", "gsl", "boost"}) {
    variances += fmt::format("# {}\n", submission) + variance_points(bench, submission) + "\n\n";
  }
  write_text(place / "curves.tsv", curves);
  write_text(place / "variances.tsv", variances);
  draw(plots, place / "plots", [&](const std::string& extension) {
    return beginning(layout, place / "bench", extension) +
           fmt::format(
               "data = {}\nload {}\n", gnuplot_string(place.string()),
               gnuplot_string((layout.root / "autograder" / "bench" / "plots.gp").string()));
  });
  collect(plots, place, "bench-");
  return plots;
}

}  // namespace mc::grader
