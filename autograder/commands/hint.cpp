// hint: the next step towards a task.

#include <charconv>

#include "commands/command.hpp"
#include "judge/checkout/hints.hpp"

namespace mc::grader {
namespace {

/// The requested step, or the one after the last that was shown.
std::size_t step_for(const fs::path& shown, const std::vector<std::string>& words,
                     std::size_t steps) {
  std::size_t step = 0;
  const std::string text = words.empty() ? read_text(shown) : words[0];
  const auto end = std::from_chars(text.data(), text.data() + text.size(), step);
  if (words.empty()) return std::min(step + 1, steps);
  if (end.ec != std::errc{} || end.ptr != text.data() + text.size() || step < 1 || step > steps) {
    throw UsageError(
        fmt::format("a step is 1 to {}, not '{}'", steps, sandbox::printable_line(text)));
  }
  return step;
}

int hint(const Context& context, const Arguments& arguments) {
  const auto [lab, task, rest] = lab_and_task(context.labs, arguments.words);
  if (task.empty() || rest.size() > 1) throw WrongUsage();
  const auto steps = hints_for(context.layout, lab, task);
  if (steps.empty()) throw UsageError(fmt::format("there are no hints for task {}", task));
  const fs::path shown = context.layout.build / "hints" / task;
  const std::size_t step = step_for(shown, rest, steps.size());
  fmt::print("Task {}, step {} of {}\n\n{}\n", task, step, steps.size(), steps[step - 1]);
  if (step < steps.size()) {
    fmt::print("\nStill stuck? The same command shows the next step.\n");
  }
  fs::create_directories(shown.parent_path());
  write_text(shown, std::to_string(step));
  return 0;
}

const RegisterCommand hint_command{
    {.usage = "hint TASK [STEP]",
     .about = "show a hint for a task",
     .details = "Up to three steps for each task, one per call: what to think of; the idea; "
                "pseudocode. STEP shows one of them again: ./lab hint 1.1 2. Hints cost no points.",
     .run = hint,
     .least_words = 1}};

}  // namespace
}  // namespace mc::grader
