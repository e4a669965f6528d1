#include "grader/plots.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "grader/build.hpp"
#include "grader/jail.hpp"
#include "grader/process.hpp"
#include "grader/text_file.hpp"

namespace mc::grader {
namespace fs = std::filesystem;
namespace {

constexpr int program_descriptor = 10;

/// A string as gnuplot reads it between single quotes.
std::string quoted(const std::string& text) {
  std::string all = "'";
  for (const char c : text) all += c == '\'' ? "''" : std::string(1, c);
  return all + "'";
}

/// Runs the lab's hidden plot cases on a program; true where they wrote their data.
bool measure(const Layout& layout, const Lab& lab, const Program& program, const fs::path& data) {
  fs::create_directories(data);
  const ProcessResult run =
      run_process({layout.checks(lab.name).string(), "[.plot]"},
                  {.environment = {{"MC_PROGRAM_DESCRIPTOR", std::to_string(program_descriptor)},
                                   {"MC_PLOT_DATA", data.string()},
                                   {"MC_SEED", "1"}},
                   .descriptors = {{program.descriptor, program_descriptor}},
                   .wall_seconds = 300});
  return run.succeeded();
}

/// What every script begins with.
std::string beginning(const Layout& layout, const fs::path& out, const std::string& extension) {
  return fmt::format(
      "set encoding utf8\nset termoption noenhanced\nout = {}\next = {}\ndraw = {}\n",
      quoted(out.string()), quoted(extension),
      quoted((layout.labs() / "common" / "draw.gp").string()));
}

std::string script_of(const Layout& layout, const Lab& lab, const std::vector<std::string>& labels,
                      const std::vector<fs::path>& data, const fs::path& out,
                      const std::string& extension) {
  std::string labels_list, data_list;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    labels_list += (i > 0 ? ", " : "") + quoted(labels[i]);
    data_list += (i > 0 ? ", " : "") + quoted(data[i].string());
  }
  return beginning(layout, out, extension) +
         fmt::format("count = {}\narray labels[count] = [{}]\narray data[count] = [{}]\nload {}\n",
                     labels.size(), labels_list, data_list,
                     quoted((layout.labs() / lab.folder / "plots.gp").string()));
}

bool gnuplot_is_there(Plots& plots) {
  if (run_process({"gnuplot", "--version"}).exit_code == 0) return true;
  plots.remarks.push_back("no plots: gnuplot is not installed (./lab setup)");
  return false;
}

/// Draws with `script(extension)`, which is kept beside `name`, once for SVG and once for PNG.
template <class Script>
void draw(Plots& plots, const fs::path& name, Script script) {
  for (const std::string extension : {"svg", "png"}) {
    const fs::path file = name.string() + "." + extension + ".gp";
    write_text(file, script(extension));
    const ProcessResult drawn = run_process({"gnuplot", file.string()}, {.wall_seconds = 120});
    if (!drawn.succeeded()) plots.remarks.push_back("gnuplot failed: " + printable(drawn.errors));
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

Plots draw_plots(const Layout& layout, const Lab& lab, const std::vector<Submission>& submissions,
                 const std::string& folder) {
  Plots plots;
  if (!gnuplot_is_there(plots)) return plots;
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
    if (measure(layout, lab, *built.program, measured)) {
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
  if (!gnuplot_is_there(plots)) return plots;
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
           fmt::format("data = {}\nload {}\n", quoted(place.string()),
                       quoted((layout.root / "autograder" / "bench" / "plots.gp").string()));
  });
  collect(plots, place, "bench-");
  return plots;
}

}  // namespace mc::grader
