#include "judge/pictures/plots.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <mutex>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "judge/base/side_by_side.hpp"
#include "judge/base/text_file.hpp"
#include "judge/judging/judge.hpp"
#include "judge/submission/build.hpp"
#include "protocol/environment.hpp"
#include "runner/text.hpp"
#include "sandbox/printable.hpp"

namespace mc::grader {
namespace fs = std::filesystem;
namespace {

/// A submission to draw.
struct Panel {
  std::string label;
  BuildResult built;
  fs::path data;
};

/// A part of plots.gp: those that begin with a line "# Title ------" draw a picture or two each,
/// and run separately, so that a failure affects no other.
struct Section {
  std::string script, title;
  std::vector<std::string> names{}, labels{};  ///< of its pictures, of the panels in them
  std::string why_empty{};                     ///< set if no panel has anything to draw
};

bool begins_section(std::string_view line) {
  return line.starts_with("# ") && line.ends_with("----------");
}

/// Arrays and functions that later sections may use, too.
bool is_definition(std::string_view line) {
  if (line.starts_with("array ")) return true;
  const auto equals = line.find(" = ");
  return equals != std::string_view::npos && equals > 0 && line[equals - 1] == ')' &&
         line.find(' ') >= equals;
}

std::vector<Section> sections_of(const std::string& script) {
  std::vector<Section> sections;
  std::string shared;
  for (const std::string_view piece : text::split(script, '\n')) {
    const std::string line(piece);
    if (begins_section(line)) {
      sections.push_back({shared, line.substr(2, line.find_last_not_of("- ") - 1)});
    }
    if (sections.empty() || is_definition(line)) shared += line + '\n';
    if (sections.empty()) continue;
    sections.back().script += line + '\n';
  }
  return sections;
}

/// The pictures that a section draws, from the strings it assigns to "name" or "sheet".
std::vector<std::string> names_in(const std::string& script) {
  std::vector<std::string> names;
  for (const std::string_view line : text::split(script, '\n')) {
    if (!line.starts_with("name = ") && !line.starts_with("sheet = ")) continue;
    std::string_view assigned = line.substr(0, line.find(';'));
    if (const auto question = assigned.find('?'); question != std::string_view::npos) {
      assigned.remove_prefix(question);  // name = against == 1 ? "error" : "time"
    }
    const auto parts = text::split(assigned, '"');
    for (std::size_t i = 1; i < parts.size(); i += 2) names.emplace_back(parts[i]);
  }
  return names;
}

/// Draws the reason in place of the picture.
std::string placeholder(const std::string& beginning, const std::string& name,
                        const std::string& reason) {
  return fmt::format(
      "{}name = {}; width = 800; height = 200\n"
      "load draw\n"
      "unset border\nunset tics\nunset key\n"
      "set label 1 {} at graph 0.5,0.5 center noenhanced\n"
      "set xrange [0:1]\nset yrange [0:1]\n"
      "plot NaN\n",
      beginning, gnuplot_string(name), gnuplot_string(reason));
}

/// Do a picture's rows have a number after the first, which says where to draw?
bool has_data(const Panel& panel, const std::string& name) {
  for (const auto& entry : fs::directory_iterator(panel.data)) {
    const std::string file = entry.path().filename().string();
    if (!file.ends_with(".tsv") || file.substr(0, file.find_first_of("-.")) != name) continue;
    const std::string rows = read_text(entry.path());
    for (const std::string_view row : text::split(rows, '\n')) {
      const auto values = text::split(row, '\t');
      for (std::size_t i = 1; i < values.size(); ++i) {
        const std::string value(values[i]);
        char* end = nullptr;
        if (std::isfinite(std::strtod(value.c_str(), &end)) && end != value.c_str()) return true;
      }
    }
  }
  return false;
}

/// A reason, shortened to fit into a picture.
std::string in_a_title(const std::string& reason) {
  return sandbox::shortened(reason, 90);
}

/// The facts about a section's pictures before they are drawn.
void look_at(Section& section, const std::vector<Panel>& panels,
             std::vector<std::string>& remarks) {
  section.names = names_in(section.script);
  bool has_some = false;
  for (const Panel& panel : panels) {
    bool is_empty = true;
    std::string reason;  // for the first missing data
    for (const std::string& name : section.names) {
      if (has_data(panel, name)) is_empty = false;
      const auto missing = missing_in(panel.data, name);
      if (missing.empty()) continue;
      if (reason.empty()) reason = *missing.begin();
      remarks.push_back(fmt::format("{}, {}: {}", panel.label, name, fmt::join(missing, ", ")));
    }
    if (reason.empty()) is_empty = false;
    section.labels.push_back(is_empty ? panel.label + ": " + in_a_title(reason) : panel.label);
    if (section.why_empty.empty()) section.why_empty = reason;
    has_some = has_some || !is_empty;
  }
  if (has_some) section.why_empty.clear();
}

/// What the panels are called: directories by their names, or by their paths if two have the same.
std::vector<std::string> labels_of(const std::vector<Submission>& submissions) {
  std::vector<std::string> names, paths;
  for (const Submission& submission : submissions) {
    paths.push_back(submission.label);
    names.push_back(fs::path(submission.label).filename().string());
  }
  const std::set<std::string> different(names.begin(), names.end());
  return different.size() == names.size() && !different.contains("") ? names : paths;
}

/// Runs the cases that `tag` selects, for each submission.
void measure(const Layout& layout, const Lab& lab, const std::vector<Panel>& panels,
             const std::string& tag, unsigned workers, std::vector<std::string>& remarks) {
  const auto cases = hidden_cases(layout, lab, CaseKind::measurements, tag);
  std::mutex mutex;
  run_side_by_side(panels.size() * cases.size(), workers, [&](std::size_t i) {
    const Panel& panel = panels[i / cases.size()];
    const std::string& name = cases[i % cases.size()];
    const auto run =
        run_hidden_cases(layout, lab, CaseKind::measurements, *panel.built.program, name,
                         {.environment = {{protocol::plot_data_variable, panel.data.string()}},
                          .wall_seconds = 600});
    if (const std::string why = failure_of(run); !why.empty()) {
      const std::lock_guard lock(mutex);
      remarks.push_back(fmt::format("{}: {} is incomplete: {}", panel.label, name, why));
    }
  });
}

}  // namespace

std::set<std::string> missing_in(const fs::path& data, const std::string& picture) {
  std::set<std::string> reasons;
  for (const auto& entry : fs::directory_iterator(data)) {
    const std::string file = entry.path().filename().string();
    if (!file.starts_with(picture.empty() ? "" : picture + '.') || !file.ends_with(".missing")) {
      continue;
    }
    const std::string lines = read_text(entry.path());
    for (const std::string_view line : text::split(lines, '\n')) {
      if (!line.empty()) reasons.insert(sandbox::printable_line(line));
    }
  }
  return reasons;
}

std::string failure_of(const CheckProcess& run) {
  const auto ends = run.ends();
  if (ends.empty()) return "its measurement did not finish";
  if (ends[0].passed) return "";
  for (std::string_view line : text::split(ends[0].message, '\n')) {
    line.remove_prefix(std::min(line.find_first_not_of(' '), line.size()));
    if (!line.empty()) return sandbox::printable(line);
  }
  return "its measurement failed";
}

Plots draw_plots(const Layout& layout, const Lab& lab, const std::vector<Submission>& submissions,
                 const std::string& folder) {
  Plots plots;
  const fs::path here = layout.labs() / lab.folder;
  if (!fs::exists(here / "plots.gp") || !fs::exists(layout.measurements(lab.name))) {
    plots.remarks.push_back(fmt::format("lab {}, {}, has no plots", lab.number, lab.name));
    return plots;
  }
  if (!can_draw(plots)) return plots;
  const fs::path place = layout.build / "plots" / folder;
  std::vector<Panel> panels;
  const std::vector<std::string> labels = labels_of(submissions);
  for (std::size_t i = 0; i < submissions.size(); ++i) {
    BuildResult built = build_program(layout, lab, submissions[i]);
    if (!built.program) {
      plots.remarks.push_back(fmt::format("{} is not drawn: {}", labels[i], built.failure));
      continue;
    }
    const fs::path data = place / "data" / fmt::format("{}-{}", lab.name, panels.size());
    fs::remove_all(data);
    fs::create_directories(data);
    panels.push_back({labels[i], std::move(built), data});
  }
  if (panels.empty()) return plots;
  measure(layout, lab, panels, "[.plot]~[time]", cores(), plots.remarks);
  measure(layout, lab, panels, "[.plot][time]", 1,
          plots.remarks);  // one at a time: others disturb times

  std::vector<std::string> data;
  for (const Panel& panel : panels) data.push_back(panel.data.string());
  std::vector<Section> sections = sections_of(read_text(here / "plots.gp"));
  if (sections.empty()) {
    plots.remarks.push_back("plots.gp has no picture: each must begin with a line \"# Title ---\"");
  }
  for (Section& section : sections) look_at(section, panels, plots.remarks);
  // What the lab calls its methods, if it has any: the same for all submissions.
  const fs::path named = panels[0].data / "names.gp";
  const std::string names = fs::exists(named) ? read_text(named) : "";
  constexpr std::array extensions{"svg", "png"};
  std::mutex mutex;
  run_side_by_side(sections.size() * extensions.size(), cores(), [&](std::size_t i) {
    const Section& section = sections[i / extensions.size()];
    const std::string extension = extensions[i % extensions.size()];
    const std::string beginning =
        script_beginning(layout, place / lab.name, extension) +
        fmt::format("count = {}\n{}{}here = {}\n{}", panels.size(),
                    gnuplot_array("labels", section.labels), gnuplot_array("data", data),
                    gnuplot_string(here.string()), names);
    const auto script =
        place / "data" / fmt::format("{}-{}.{}.gp", lab.name, i / extensions.size(), extension);
    std::string why_not = section.why_empty;
    if (why_not.empty()) {
      why_not = run_gnuplot(script, beginning + section.script);
      if (why_not.empty()) return;
      const std::lock_guard lock(mutex);
      plots.remarks.push_back(why_not);
    }
    for (const std::string& name : section.names) {
      run_gnuplot(script, placeholder(beginning, name, "not drawn: " + in_a_title(why_not)));
    }
  });
  collect(plots, place, lab.name + "-");
  for (const Section& section : sections) {
    for (const std::string& name : section.names) {
      plots.descriptions.push_back(fmt::format(
          "{}.svg, .png: {}", (place / (lab.name + '-' + name)).string(), section.title));
    }
  }
  return plots;
}

}  // namespace mc::grader
