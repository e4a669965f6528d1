#include "runner/list.hpp"

#include <algorithm>
#include <string_view>
#include <vector>

namespace mc::runner {
namespace {

/// "--x LIST" of each parameter.
std::vector<std::string> parameters_of(const Experiment& experiment) {
  std::vector<std::string> all;
  const auto forms = experiment.forms();
  const auto names = text::split(experiment.parameters, ' ');
  for (std::size_t i = 0; i < forms.size(); ++i) {
    all.push_back("--" + std::string(names[i]) + ' ' + forms[i]);
  }
  return all;
}

/// Words in lines of at most `width` columns, all but the first after `indent` blanks.
std::string wrapped(const std::vector<std::string>& words, std::size_t width, std::size_t indent) {
  std::string all;
  std::size_t column = indent;
  for (const std::string& word : words) {
    if (column > indent && column + 1 + word.size() > width) {
      all += '\n' + std::string(indent, ' ');
      column = indent;
    }
    if (column > indent) all += ' ', ++column;
    all += word;
    column += word.size();
  }
  return all;
}

std::vector<std::string> words_of(std::string_view text) {
  std::vector<std::string> words;
  for (const std::string_view word : text::split(text, ' ')) {
    if (!word.empty()) words.emplace_back(word);
  }
  return words;
}

}  // namespace

std::string call_of(const Experiment& experiment) {
  std::string all(experiment.name);
  for (const std::string& parameter : parameters_of(experiment)) all += ' ' + parameter;
  return all;
}

std::string list_of_experiments(std::size_t width) {
  std::size_t longest = 0;
  for (const Experiment& one : experiments()) longest = std::max(longest, one.name.size());
  const std::size_t indent = longest + 4;
  std::string all;
  for (const Experiment& one : experiments()) {
    const std::string blank(longest - one.name.size() + 2, ' ');
    all += "  " + std::string(one.name) + blank + wrapped(parameters_of(one), width, indent) + '\n';
    all += "    " + wrapped(words_of(one.description), width, 4) + '\n';
  }
  for (const Choice& choice : choices()) {
    all +=
        '\n' + wrapped(words_of("--" + choice.parameter + " " + choice.meaning), width, 2) + '\n';
    const bool are_words = std::all_of(choice.values.begin(), choice.values.end(), [](auto& value) {
      return value.find(' ') == std::string::npos;
    });
    if (are_words) {
      all += "    " + wrapped(choice.values, width, 4) + '\n';
      continue;
    }
    for (const std::string& value : choice.values) {
      all += "    " + wrapped(words_of(value), width, 8) + '\n';
    }
  }
  return all;
}

}  // namespace mc::runner
