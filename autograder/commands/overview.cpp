// ./lab without a command: the student's progress.

#include "commands/command.hpp"
#include "commands/progress.hpp"

namespace mc::grader {
namespace {

int overview(const Context& context, const Arguments&) {
  const Lab* next = nullptr;
  for (const Lab& lab : context.labs) {
    const auto known = read_progress(context.layout, lab);
    std::string state = "not checked yet";
    if (known) {
      state = fmt::format("{:g} of {:g} points", known->earned, known->points);
      if (!known->is_current) state += ", changed since";
      if (!known->next.empty()) state += fmt::format("; next: {}", known->next);
    }
    if (next == nullptr && (!known || !known->is_current || !known->next.empty())) next = &lab;
    fmt::print("  {:<24} {}\n", lab.title(), state);
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

const RegisterCommand overview_command{
    {.about = "show your labs, your points and what to do next", .run = overview}};

}  // namespace
}  // namespace mc::grader
