#include "judge/judging/repeat_commands.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "judge/base/shell.hpp"
#include "judge/base/text_file.hpp"
#include "judge/checkout/labs.hpp"

namespace mc::grader {
namespace fs = std::filesystem;
namespace {

bool is_own(const JudgeOptions& options) {
  return options.submission.empty() || options.submission == "starter";
}

/// The names of an experiment's parameters.
std::vector<std::string> parameters_of(const Layout& layout, const Lab& lab,
                                       const std::string& name) {
  for (const Experiment& one : experiments_of(layout, lab)) {
    if (one.name == name) return one.parameters;
  }
  return {};
}

/// The argument itself, or a file that holds it.
std::string short_of(const Layout& layout, const std::string& argument) {
  constexpr std::size_t longest = 60;
  if (argument.size() <= longest) return shell_quoted_value(argument);
  const fs::path file = layout.build / "inputs" / fmt::format("{:016x}.txt", hash_text(argument));
  std::error_code ignored;
  fs::create_directories(file.parent_path(), ignored);
  if (!fs::exists(file)) {
    std::string lines = argument;
    std::ranges::replace(lines, ',', '\n');
    write_text(file, lines + '\n');
  }
  // Short where it is typed: from the checkout.
  std::error_code unrelated;
  const fs::path near = fs::relative(file, layout.root, unrelated);
  return '@' + (unrelated || near.empty() ? file : near).string();
}

}  // namespace

std::string repeat_command(const Lab& lab, const Check& check, const JudgeOptions& options) {
  return fmt::format("./lab check {}{} --only {} --seed {}{}", lab.name,
                     is_own(options) ? "" : ' ' + shell_quoted(options.submission), check.task,
                     options.seed, options.with_reference ? " --with-reference" : "");
}

std::string own_repeat_command(const Lab& lab, const Check& check, std::uint64_t seed) {
  JudgeOptions own;
  own.seed = seed;
  return repeat_command(lab, check, own);
}

std::string by_hand_command(const Layout& layout, const Lab& lab,
                            const std::vector<std::string>& call, const JudgeOptions& options) {
  std::string command =
      fmt::format("./lab run {}{} {}", lab.name,
                  is_own(options) ? "" : " --dir " + shell_quoted(options.submission), call[0]);
  const auto names = parameters_of(layout, lab, call[0]);
  for (std::size_t i = 1; i < call.size(); ++i) {
    const bool is_named = names.size() + 1 == call.size();
    if (is_named) command += " --" + names[i - 1];
    command += ' ' + short_of(layout, call[i]);
  }
  return command;
}

}  // namespace mc::grader
