#include "judge/pictures/renders.hpp"

#include <algorithm>
#include <fstream>

#include <fmt/format.h>

#include "judge/base/errors.hpp"
#include "judge/judging/judge.hpp"
#include "judge/pictures/gnuplot.hpp"
#include "judge/pictures/plots.hpp"
#include "judge/submission/build.hpp"
#include "protocol/environment.hpp"
#include "sandbox/jail.hpp"

namespace mc::grader {
namespace fs = std::filesystem;
namespace {

struct RenderJob {
  const Layout& layout;
  const Lab& lab;
  const sandbox::Program& program;
  const std::string& reference;
  fs::path data;

  /// Fills in the row; `seconds` is the time limit, 0 for none.
  void measure(RenderResult& row, std::uint64_t spp, double seconds) const {
    fs::create_directories(data);
    const CheckProcess run = run_hidden_cases(
        layout, lab, CaseKind::measurements, program, "[.render]",
        {.environment = {{protocol::plot_data_variable, data.string()},
                         {protocol::render_variable, protocol::text_of(protocol::RenderRequest{
                                                         row.picture, row.kind, spp, seconds})}},
         .wall_seconds = 300});
    std::ifstream result(data / (row.kind + ".txt"));
    result >> row.samples >> row.time;
    row.failure = failure_of(run);
    if (row.failure.empty() && !result) row.failure = "it was not measured";
    row.timed = row.failure.empty() && (seconds > 0 || row.kind == reference);
  }
};

/// The title of a row's picture; "" if there is no picture.
std::string title_of(const RenderResult& row, bool in_time) {
  if (!row.failure.empty() || (in_time && !row.timed)) return "";
  const protocol::RenderErrors& drawn = in_time ? row.time : row.samples;
  return fmt::format("{}, {} spp\nRMSE {:.3g}", row.kind, drawn.spp, drawn.rmse);
}

/// A picture of all submissions.
struct Sheet {
  std::string picture, name, headline;
  std::vector<std::string> labels = {}, data = {}, titles = {};
  double white = 1, range = 0;
};

std::string script_of(const Layout& layout, const Lab& lab, const Sheet& sheet,
                      const std::vector<std::string>& kinds) {
  return script_beginning(layout, layout.build / "render" / sheet.picture, "png") +
         fmt::format(
             "count = {}\ncolumns = {}\n{}{}{}{}headline = {}\nsheet = {}\nwhite = {}\nrange = {}\n"
             "load {}\n",
             sheet.labels.size(), kinds.size(), gnuplot_array("labels", sheet.labels),
             gnuplot_array("data", sheet.data), gnuplot_array("kinds", kinds),
             gnuplot_array("titles", sheet.titles), gnuplot_string(sheet.headline),
             gnuplot_string(sheet.name), sheet.white, sheet.range,
             gnuplot_string((layout.labs() / lab.folder / "render.gp").string()));
}

/// The largest value of a picture, which is drawn white.
double largest_in(const fs::path& file) {
  std::ifstream values(file);
  double largest = 0;
  for (double value = 0; values >> value;) largest = std::max(largest, value);
  return largest > 0 ? largest : 1;
}

}  // namespace

const Lab& lab_with_pictures(const Layout& layout, const std::vector<Lab>& labs) {
  const auto found = std::ranges::find_if(
      labs, [&](const Lab& lab) { return fs::exists(layout.labs() / lab.folder / "render.gp"); });
  if (found == labs.end()) throw MachineError("no lab has pictures: labs/*/render.gp is missing");
  return *found;
}

protocol::RenderList render_list(const Layout& layout, const Lab& lab) {
  const fs::path place = layout.build / "render" / "list.txt";
  fs::create_directories(place.parent_path());
  sandbox::run_process(
      {layout.measurements(lab.name).string(), "[.render-list]"},
      {.environment = {{protocol::render_variable, place.string()}}, .wall_seconds = 60});
  protocol::RenderList list;
  std::ifstream file(place);
  file >> list;
  if (list.pictures.empty() || list.kinds.empty()) {
    throw MachineError(fmt::format("{} does not list its pictures: build it again",
                                   layout.measurements(lab.name).string()));
  }
  return list;
}

Renders draw_renders(
    const Layout& layout, const Lab& lab, const std::vector<Submission>& submissions,
    const RenderOptions& options,
    const std::function<void(std::size_t done, std::size_t all, const std::string& what)>& step) {
  Renders renders;
  const bool draws = gnuplot_is_there();
  if (!draws) renders.remarks.push_back("no sheets: gnuplot is not installed (./lab setup)");
  const std::size_t steps =
      submissions.size() * (1 + options.pictures.size() * options.kinds.size());
  std::size_t done = 0;
  std::vector<Sheet> sheets;
  for (const std::string& picture : options.pictures) {
    sheets.push_back({.picture = picture,
                      .name = "samples",
                      .headline = fmt::format("{}, {} samples per pixel", picture, options.spp)});
    sheets.push_back({.picture = picture,
                      .name = "time",
                      .headline = fmt::format("{}, in the time of {} {} samples per pixel", picture,
                                              options.spp, options.reference)});
  }
  for (const Submission& submission : submissions) {
    step(done, steps, "compiling " + submission.label);
    const BuildResult built = build_program(layout, lab, submission);
    ++done;
    if (!built.program) {
      renders.remarks.push_back(
          fmt::format("{} is not drawn: {}", submission.label, built.failure));
      done += steps / submissions.size() - 1;
      continue;
    }
    for (std::size_t p = 0; p < options.pictures.size(); ++p) {
      const std::string& picture = options.pictures[p];
      const RenderJob rendering{
          layout, lab, *built.program, options.reference,
          layout.build / "render" / "data" /
              fmt::format("{}-{}", picture, &submission - submissions.data())};
      fs::remove_all(rendering.data);
      const auto row_of = [&](const std::string& kind) {
        RenderResult row;
        row.submission = submission.label;
        row.picture = picture;
        row.kind = kind;
        return row;
      };
      RenderResult reference = row_of(options.reference);
      step(done, steps, fmt::format("{}, {}", submission.label, picture));
      rendering.measure(reference, options.spp, 0);
      std::vector<RenderResult> rows;
      for (const std::string& kind : options.kinds) {
        step(done++, steps, fmt::format("{}, {}, {}", submission.label, picture, kind));
        rows.push_back(kind == reference.kind ? reference : row_of(kind));
        if (kind == reference.kind) continue;
        rendering.measure(rows.back(), options.spp,
                          reference.failure.empty() ? reference.samples.seconds : 0);
      }
      for (const std::size_t s : {2 * p, 2 * p + 1}) {
        Sheet& sheet = sheets[s];
        const bool in_time = s % 2 == 1;
        std::vector<std::string> titles;
        for (const RenderResult& row : rows) {
          titles.push_back(title_of(row, in_time));
          if (!titles.back().empty())
            sheet.range = std::max(sheet.range, (in_time ? row.time : row.samples).large_error);
        }
        if (std::ranges::all_of(titles, [](auto& title) { return title.empty(); })) {
          continue;
        }
        sheet.white = largest_in(rendering.data / "exact.tsv");
        sheet.labels.push_back(submission.label);
        sheet.data.push_back(rendering.data.string());
        sheet.titles.insert(sheet.titles.end(), titles.begin(), titles.end());
      }
      renders.table.insert(renders.table.end(), rows.begin(), rows.end());
    }
  }
  for (Sheet& sheet : sheets) {
    if (!draws || sheet.labels.empty()) continue;
    if (sheet.range == 0) sheet.range = 1;  // no error anywhere
    step(done, steps, "drawing " + sheet.picture);
    const std::string failure = run_gnuplot(
        layout.build / "render" / "data" / fmt::format("{}-{}.gp", sheet.picture, sheet.name),
        script_of(layout, lab, sheet, options.kinds));
    if (failure.empty()) {
      renders.sheets.push_back(layout.build / "render" /
                               fmt::format("{}-{}.png", sheet.picture, sheet.name));
    } else {
      renders.remarks.push_back(failure);
    }
  }
  return renders;
}

}  // namespace mc::grader
