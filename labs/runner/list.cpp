#include <algorithm>
#include <string>
#include <vector>

#include "runner/experiment.hpp"

namespace mc::runner {
namespace {

/// "--x LIST" of each parameter.
std::vector<std::string> parameters_of(const Experiment& experiment) {
  std::vector<std::string> all;
  const auto forms = experiment.forms();
  const auto names = text::words_of(experiment.parameters);
  for (std::size_t i = 0; i < forms.size(); ++i) all.push_back("--" + names[i] + ' ' + forms[i]);
  return all;
}

}  // namespace

std::string call_of(const Experiment& experiment) {
  std::string all(experiment.name);
  for (const std::string& parameter : parameters_of(experiment)) all += ' ' + parameter;
  return all;
}

std::string list_of_experiments(std::size_t width) {
  std::string all;
  // Adds words after what the line begins with; more lines begin with `indent` blanks.
  const auto add = [&](const std::string& begin, const std::vector<std::string>& words,
                       std::size_t indent) {
    all += begin + text::wrapped(words, width - std::min(width, indent), indent) + '\n';
  };
  std::size_t longest = 0;
  for (const Experiment& one : experiments()) longest = std::max(longest, one.name.size());
  for (const Experiment& one : experiments()) {
    const std::string blank(longest - one.name.size() + 2, ' ');
    add("  " + std::string(one.name) + blank, parameters_of(one), longest + 4);
    add("    ", text::words_of(one.description), 4);
  }
  for (const Choice& choice : choices()) {
    add("\n", text::words_of("--" + choice.parameter + " " + choice.meaning), 2);
    const bool are_words = std::ranges::all_of(
        choice.values, [](auto& value) { return value.find(' ') == std::string::npos; });
    if (are_words) {
      add("    ", choice.values, 4);
      continue;
    }
    for (const std::string& value : choice.values) add("    ", text::words_of(value), 8);
  }
  return all;
}

}  // namespace mc::runner
