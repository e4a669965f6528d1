#include "commands/progress.hpp"

#include <algorithm>
#include <sstream>

namespace mc::grader {
namespace {

fs::path file_of(const Layout& layout, const Lab& lab) {
  return layout.build / "progress" / lab.name;
}
std::uint64_t hash_now(const Layout& layout, const Lab& lab) {
  return hash_text(read_text(layout.starter() / lab.file()));
}

}  // namespace

void write_progress(const Layout& layout, const LabVerdict& verdict) {
  const auto next = std::ranges::find_if(
      verdict.checks, [](const CheckResult& result) { return result.is_open(); });
  const auto file = file_of(layout, verdict.lab);
  fs::create_directories(file.parent_path());
  write_text(file, fmt::format("{} {} {} {}\n", verdict.earned(), verdict.points(),
                               next == verdict.checks.end() ? "-" : next->check.task,
                               hash_now(layout, verdict.lab)));
}

std::pair<int, std::string> failures_in_a_row(const Layout& layout, const LabVerdict& verdict) {
  const auto file = file_of(layout, verdict.lab).concat(".failing");
  for (const CheckResult& result : verdict.checks) {
    if (result.status != Status::failed) continue;
    std::istringstream known(read_text(file));
    std::string task;
    int count = 0;
    if (!(known >> task >> count) || task != result.check.task) count = 0;
    fs::create_directories(file.parent_path());
    write_text(file, fmt::format("{} {}\n", result.check.task, count + 1));
    return {count + 1, result.check.task};
  }
  fs::remove(file);
  return {0, {}};
}

std::optional<Progress> read_progress(const Layout& layout, const Lab& lab) {
  std::istringstream file(read_text(file_of(layout, lab)));
  Progress progress;
  std::uint64_t text = 0;
  if (!(file >> progress.earned >> progress.points >> progress.next >> text)) return {};
  if (progress.next == "-") progress.next.clear();
  progress.is_current = text == hash_now(layout, lab);
  return progress;
}

}  // namespace mc::grader
