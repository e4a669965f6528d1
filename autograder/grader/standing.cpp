#include "grader/standing.hpp"

#include <sstream>

#include <fmt/format.h>

#include "grader/text_file.hpp"
#include "grader/verbs.hpp"

namespace mc::grader {
namespace {

std::filesystem::path file_of(const Layout& layout, const Lab& lab) {
  return layout.build / "standing" / lab.name;
}
std::uint64_t text_now(const Layout& layout, const Lab& lab) {
  return hash_text(read_text(layout.starter() / lab.file()));
}

}  // namespace

void remember(const Layout& layout, const LabVerdict& verdict) {
  std::string next = "-";
  for (const CheckResult& result : verdict.checks) {
    if (result.status == Status::passed || result.status == Status::waiting) continue;
    next = result.check.task;
    break;
  }
  const auto file = file_of(layout, verdict.lab);
  std::filesystem::create_directories(file.parent_path());
  write_text(file, fmt::format("{} {} {} {}\n", verdict.earned(), verdict.points(), next,
                               text_now(layout, verdict.lab)));
}

std::optional<Standing> recall(const Layout& layout, const Lab& lab) {
  std::istringstream file(read_text(file_of(layout, lab)));
  Standing standing;
  std::uint64_t text = 0;
  if (!(file >> standing.earned >> standing.points >> standing.next >> text)) return {};
  if (standing.next == "-") standing.next.clear();
  standing.is_current = text == text_now(layout, lab);
  return standing;
}

int standing(const House& house, const Arguments&) {
  const Lab* next = nullptr;
  for (const Lab& lab : house.labs) {
    const auto known = recall(house.layout, lab);
    std::string where = "not checked yet";
    if (known) {
      where = fmt::format("{:g} of {:g} points", known->earned, known->points);
      if (!known->is_current) where += ", changed since";
      if (!known->next.empty()) where += fmt::format("; next: {}", known->next);
    }
    if (next == nullptr && (!known || !known->is_current || !known->next.empty())) next = &lab;
    fmt::print("  {:<24} {}\n", lab.title(), where);
  }
  if (next != nullptr) {
    fmt::print(
        "\nRead labs/{}/README.md, write starter/{}, and see how far you are:\n\n"
        "  ./lab check {}\n",
        next->folder, next->file(), next->name);
  } else {
    fmt::print("\nAll done.\n");
  }
  return 0;
}

}  // namespace mc::grader
