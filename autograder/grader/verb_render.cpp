// render: pictures by every kind of sampler beside each other.

#include <algorithm>
#include <chrono>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "grader/errors.hpp"
#include "grader/renders.hpp"
#include "grader/report.hpp"
#include "grader/verbs.hpp"

namespace mc::grader {
namespace fs = std::filesystem;
namespace {

template <class Names>
bool is_one_of(const Names& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// A line that shows how far the work is, once it takes longer than a second; at a terminal only.
class Progress {
 public:
  explicit Progress(const Terminal& terminal) : terminal_(terminal) {}
  ~Progress() { clear(); }

  void show(std::size_t done, std::size_t all, const std::string& what) {
    using namespace std::chrono;
    if (!terminal_.interactive || steady_clock::now() - begun_ < seconds(1)) return;
    constexpr std::size_t cells = 20;
    const std::size_t full = cells * done / all;
    const std::string bar = std::string(full, '#') + std::string(cells - full, '.');
    fmt::print("\r\033[K[{}] {:.{}}", bar, what, terminal_.width - cells - 3);
    std::fflush(stdout);
    shown_ = true;
  }
  void clear() {
    if (shown_) fmt::print("\r\033[K");
    shown_ = false;
  }

 private:
  Terminal terminal_;
  std::chrono::steady_clock::time_point begun_ = std::chrono::steady_clock::now();
  bool shown_ = false;
};

RenderOptions options_of(const Arguments& arguments, std::vector<std::string>& directories) {
  RenderOptions options;
  directories = arguments.words;
  if (!directories.empty() && is_one_of(render_pictures, directories[0])) {
    options.pictures = {directories[0]};
    directories.erase(directories.begin());
  } else if (!directories.empty() && !fs::exists(directories[0])) {
    throw UsageError(fmt::format("no picture and no directory '{}'; the pictures are {}",
                                 directories[0], fmt::join(render_pictures, ", ")));
  } else {
    options.pictures.assign(render_pictures.begin(), render_pictures.end());
  }
  options.kinds.assign(sampler_kinds.begin(), sampler_kinds.end());
  if (const auto kind = arguments.get("sampler")) {
    if (!is_one_of(sampler_kinds, *kind)) {
      throw UsageError(
          fmt::format("no sampler '{}'; the kinds are {}", *kind, fmt::join(sampler_kinds, ", ")));
    }
    options.kinds = {*kind};
  }
  options.spp = arguments.number("spp").value_or(options.spp);
  if (options.spp < 1 || options.spp > most_spp) {
    throw UsageError(
        fmt::format("--spp takes 1 to {} samples a pixel, not {}", most_spp, options.spp));
  }
  return options;
}

void print_table(const std::vector<Rendered>& table, std::uint64_t spp) {
  std::string above;
  for (const Rendered& row : table) {
    const std::string what = fmt::format("{}, {}", row.submission, row.picture);
    if (what != above) {
      fmt::print("\n{:<24}{:>7} spp              in equal time\n", what, spp);
      fmt::print("{:<24}{:>11}{:>8}{:>10}{:>8}{:>11}\n", "", "RMSE", "ms", "spp", "ms", "RMSE");
    }
    above = what;
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

}  // namespace

int render(const House& house, const Arguments& arguments) {
  std::vector<std::string> directories;
  const RenderOptions options = options_of(arguments, directories);
  const Lab& lab = find_lab(house.labs, "sampler");
  const std::vector<Submission> submissions = submissions_beside(house, lab, directories);
  Progress progress(this_terminal());
  const Renders renders =
      draw_renders(house.layout, lab, submissions, options,
                   [&](std::size_t done, std::size_t all, const std::string& what) {
                     progress.show(done, all, what);
                   });
  progress.clear();
  print_table(renders.table, options.spp);
  fmt::print("\n");
  for (const std::string& remark : renders.remarks) fmt::print("{}\n", remark);
  for (const fs::path& sheet : renders.sheets) fmt::print("{}\n", sheet.string());
  return renders.sheets.empty() ? 1 : 0;
}

}  // namespace mc::grader
