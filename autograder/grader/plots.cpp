#include "grader/plots.hpp"

#include <algorithm>

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

std::string script_of(const Layout& layout, const Lab& lab, const std::vector<std::string>& labels,
                      const std::vector<fs::path>& data, const fs::path& out,
                      const std::string& extension) {
  std::string labels_list, data_list;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    labels_list += (i > 0 ? ", " : "") + quoted(labels[i]);
    data_list += (i > 0 ? ", " : "") + quoted(data[i].string());
  }
  return fmt::format(
      "set encoding utf8\nset termoption noenhanced\ncount = {}\narray labels[count] = [{}]\n"
      "array data[count] = [{}]\nout = {}\next = {}\ndraw = {}\nload {}\n",
      labels.size(), labels_list, data_list, quoted(out.string()), quoted(extension),
      quoted((layout.labs() / "common" / "draw.gp").string()),
      quoted((layout.labs() / lab.folder / "plots.gp").string()));
}

}  // namespace

Plots draw_plots(const Layout& layout, const Lab& lab, const std::vector<Submission>& submissions,
                 const std::string& folder) {
  Plots plots;
  if (run_process({"gnuplot", "--version"}).exit_code != 0) {
    plots.remarks.push_back("no plots: gnuplot is not installed (./lab setup)");
    return plots;
  }
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
  for (const std::string extension : {"svg", "png"}) {
    const fs::path script = place / "data" / fmt::format("{}.{}.gp", lab.name, extension);
    write_text(script, script_of(layout, lab, labels, data, place / lab.name, extension));
    const ProcessResult drawn = run_process({"gnuplot", script.string()}, {.wall_seconds = 120});
    if (!drawn.succeeded()) {
      plots.remarks.push_back("gnuplot failed: " + printable(drawn.errors));
      continue;
    }
  }
  for (const auto& entry : fs::directory_iterator(place)) {
    if (entry.path().filename().string().starts_with(lab.name + "-")) {
      plots.pictures.push_back(entry.path());
    }
  }
  std::sort(plots.pictures.begin(), plots.pictures.end());
  return plots;
}

}  // namespace mc::grader
