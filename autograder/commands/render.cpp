// render: pictures by every kind of sampler, side by side.

#include <algorithm>

#include "commands/command.hpp"
#include "judge/pictures/renders.hpp"
#include "judge/reports/progress_line.hpp"

namespace mc::grader {
namespace {

bool is_one_of(const std::vector<std::string>& names, const std::string& name) {
  return std::ranges::find(names, name) != names.end();
}

/// Takes the picture off `words`; what is left are directories.
RenderOptions options_of(const Arguments& arguments, const protocol::RenderList& list,
                         std::vector<std::string>& words) {
  RenderOptions options;
  options.reference = list.kinds[0];
  options.pictures = list.pictures;
  options.kinds = list.kinds;
  if (!words.empty() && is_one_of(list.pictures, words[0])) {
    options.pictures = {words[0]};
    words.erase(words.begin());
  } else if (!words.empty() && !fs::exists(words[0])) {
    throw UsageError(fmt::format("'{}' is neither a picture nor a directory; the pictures are {}",
                                 words[0], fmt::join(list.pictures, ", ")));
  }
  if (const auto kind = arguments.get("sampler")) {
    if (!is_one_of(list.kinds, *kind)) {
      throw UsageError(
          fmt::format("no sampler '{}'; the kinds are {}", *kind, fmt::join(list.kinds, ", ")));
    }
    options.kinds = {*kind};
  }
  options.spp = arguments.number("spp").value_or(options.spp);
  if (options.spp < 1 || options.spp > most_spp) {
    throw UsageError(
        fmt::format("--spp takes 1 to {} samples per pixel, not {}", most_spp, options.spp));
  }
  return options;
}

void print_table(const std::vector<RenderResult>& table, std::uint64_t spp) {
  std::string above;
  for (const RenderResult& row : table) {
    const std::string title = fmt::format("{}, {}", row.submission, row.picture);
    if (title != above) {
      fmt::print("\n{:<24}{:>7} spp              in equal time\n", title, spp);
      fmt::print("{:<24}{:>11}{:>8}{:>10}{:>8}{:>11}\n", "", "RMSE", "ms", "spp", "ms", "RMSE");
    }
    above = title;
    if (!row.failure.empty()) {
      fmt::print("  {:<22}   {}\n", row.kind, row.failure);
      continue;
    }
    fmt::print("  {:<22}{:>11.3g}{:>8.3g}", row.kind, row.samples.rmse, 1e3 * row.samples.seconds);
    if (row.timed) {
      fmt::print("{:>10}{:>8.3g}{:>11.3g}", row.time.spp, 1e3 * row.time.seconds, row.time.rmse);
    }
    fmt::print("\n");
  }
}

int render(const Context& context, const Arguments& arguments) {
  const Lab& lab = lab_with_pictures(context.layout, context.labs);
  std::vector<std::string> directories = arguments.words;
  const RenderOptions options =
      options_of(arguments, render_list(context.layout, lab), directories);
  const std::vector<Submission> submissions = submissions_with_solutions(context, lab, directories);
  const Renders renders = [&] {
    ProgressLine line("rendering");
    return draw_renders(context.layout, lab, submissions, options,
                        [&](std::size_t done, std::size_t all, const std::string& what) {
                          line.show(static_cast<double>(done), static_cast<double>(all), what);
                        });
  }();
  print_table(renders.table, options.spp);
  fmt::print("\n");
  for (const std::string& remark : renders.remarks) fmt::print("{}\n", remark);
  for (const fs::path& sheet : renders.sheets) fmt::print("{}\n", sheet.string());
  return renders.sheets.empty() ? 1 : 0;
}

const RegisterCommand render_command{
    {.usage = "render [PICTURE] [--sampler KIND] [--spp N] [DIR...]",
     .about = "draw lab 6's pictures by every sampler, and their errors",
     .details =
         "Draws two sheets of each picture into build/render: one with N samples per pixel, one "
         "with as many as each sampler makes in the time of N independent ones. Draws all pictures "
         "if none is named; an unknown name prints a list of them. DIR is as in ./lab plot.",
     .options = {{"--sampler KIND", "only this kind of sampler"},
                 {"--spp N", "the samples per pixel (16)"}},
     .run = render,
     .place = "labs/6-sampler",
     .targets = [](const Context&, const Arguments&) {
       return std::vector<std::string>{"measure_sampler"};
     }}};

}  // namespace
}  // namespace mc::grader
