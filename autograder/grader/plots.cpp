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

std::string script_of(const Layout& layout, const Lab& lab, const std::vector<std::string>& labels,
                      const std::vector<fs::path>& data, const fs::path& out,
                      const std::string& extension) {
  const fs::path here = layout.labs() / lab.folder;
  return fmt::format("count = {}\n{}{}out = {}\next = {}\ndraw = {}\nhere = {}\nload {}\n",
                     labels.size(), gnuplot_array("labels", labels),
                     gnuplot_array("data", std::vector<std::string>(data.begin(), data.end())),
                     gnuplot_string(out.string()), gnuplot_string(extension),
                     gnuplot_string((layout.labs() / "common" / "draw.gp").string()),
                     gnuplot_string(here.string()), gnuplot_string((here / "plots.gp").string()));
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

ProcessResult run_hidden_cases(const Layout& layout, const Lab& lab, const Program& program,
                               const std::string& tag, const fs::path& data,
                               std::vector<std::pair<std::string, std::string>> environment) {
  fs::create_directories(data);
  environment.insert(environment.end(),
                     {{"MC_PROGRAM_DESCRIPTOR", std::to_string(program_descriptor)},
                      {"MC_PLOT_DATA", data.string()},
                      {"MC_SEED", "1"}});
  return run_process({layout.checks(lab.name).string(), tag, "--reporter", "xml"},
                     {.environment = std::move(environment),
                      .descriptors = {{program.descriptor, program_descriptor}},
                      .wall_seconds = 300});
}

Plots draw_plots(const Layout& layout, const Lab& lab, const std::vector<Submission>& submissions,
                 const std::string& folder) {
  Plots plots;
  if (!gnuplot_is_there()) {
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
    if (run_hidden_cases(layout, lab, *built.program, "[.plot]", measured).succeeded()) {
      labels.push_back(submission.label);
      data.push_back(measured);
    } else {
      plots.remarks.push_back(submission.label + " is not drawn: its measurements failed");
    }
  }
  if (labels.empty()) return plots;
  for (const std::string extension : {"svg", "png"}) {
    const fs::path script = place / "data" / fmt::format("{}.{}.gp", lab.name, extension);
    const std::string failure =
        run_gnuplot(script, script_of(layout, lab, labels, data, place / lab.name, extension));
    if (!failure.empty()) plots.remarks.push_back(failure);
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
