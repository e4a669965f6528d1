// ./lab without a command: the student's progress.

#include <fmt/format.h>

#include "grader/commands/command.hpp"
#include "grader/commands/progress.hpp"

namespace mc::grader {
namespace {

int overview(const Context& context, const Arguments&) {
  const Lab* next = nullptr;
  for (const Lab& lab : context.labs) {
    const auto known = recall(context.layout, lab);
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

const RegisterCommand overview_command{{"", "", {}, "", overview}};

}  // namespace
}  // namespace mc::grader
