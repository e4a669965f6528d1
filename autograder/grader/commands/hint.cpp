// hint: the next step for a task, for who is stuck.

#include <charconv>
#include <filesystem>

#include <fmt/format.h>

#include "grader/base/errors.hpp"
#include "grader/base/text_file.hpp"
#include "grader/checkout/hints.hpp"
#include "grader/commands/command.hpp"
#include "grader/commands/lab_and_task.hpp"
#include "sandbox/printable.hpp"

namespace mc::grader {
namespace {

namespace fs = std::filesystem;

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
  const char* const usage = "usage: ./lab hint TASK [STEP] (try: ./lab hint 1.1)";
  if (arguments.words.empty()) throw UsageError(usage);
  const LabAndTask asked = lab_and_task(context.labs, arguments.words);
  if (asked.task.empty() || asked.rest.size() > 1) throw UsageError(usage);
  const auto steps = hints_for(context.layout, asked.lab, asked.task);
  if (steps.empty()) {
    throw UsageError(fmt::format("there are no hints for task {}", asked.task));
  }
  const fs::path shown = context.layout.build / "hints" / asked.task;
  const std::size_t step = step_for(shown, asked.rest, steps.size());
  fmt::print("Task {}, step {} of {}\n\n{}\n", asked.task, step, steps.size(), steps[step - 1]);
  if (step < steps.size()) {
    fmt::print("\nStill stuck? The same command shows the next step.\n");
  }
  fs::create_directories(shown.parent_path());
  write_text(shown, std::to_string(step));
  return 0;
}

const RegisterCommand hint_command{
    {"hint",
     "hint TASK [STEP]",
     {},
     "Up to three steps for each task, one per call: what to think of; the idea; pseudocode. STEP\n"
     "shows one of them again. Hints cost no points.\n",
     hint}};

}  // namespace
}  // namespace mc::grader
