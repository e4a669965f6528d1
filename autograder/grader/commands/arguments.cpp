#include "grader/commands/arguments.hpp"

#include <getopt.h>

#include <charconv>
#include <string_view>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "grader/base/errors.hpp"
#include "grader/checkout/labs.hpp"

namespace mc::grader {

std::optional<std::string> Arguments::get(const std::string& option) const {
  const auto found = options.find(option);
  return found == options.end() ? std::nullopt : std::optional(found->second);
}

std::optional<std::uint64_t> Arguments::number(const std::string& option) const {
  const auto text = get(option);
  if (!text) return {};
  std::uint64_t value = 0;
  const char* end = text->data() + text->size();
  const auto [stop, error] = std::from_chars(text->data(), end, value);
  if (error != std::errc{} || stop != end) {
    throw UsageError(fmt::format("--{} takes a whole number, not '{}'", option, *text));
  }
  return value;
}

Arguments parse_arguments(const std::vector<std::string>& words, const Syntax& syntax) {
  struct OptionSpec {
    std::string name;
    bool takes_value;
    char letter;
  };
  std::vector<OptionSpec> options;
  std::string letters = "+:";  // ends at the first word
  for (const std::string& text : syntax.options) {
    const auto equals = text.find('=');
    const char letter =
        equals != std::string::npos && equals + 1 < text.size() ? text[equals + 1] : '\0';
    options.push_back({text.substr(0, equals), equals != std::string::npos, letter});
    if (letter != '\0' && letter != ',') letters += std::string(1, letter) + ':';
  }
  std::vector<option> longs;
  for (const OptionSpec& one : options) {
    longs.push_back(
        {one.name.c_str(), one.takes_value ? required_argument : no_argument, nullptr, 0});
  }
  longs.push_back({nullptr, 0, nullptr, 0});

  std::vector<std::string> copies{"lab"};
  copies.insert(copies.end(), words.begin(), words.end());
  std::vector<char*> pointers;
  for (std::string& copy : copies) pointers.push_back(copy.data());
  pointers.push_back(nullptr);
  const int count = static_cast<int>(copies.size());

  Arguments arguments;
  std::size_t before_verbatim = syntax.words_before_verbatim;
  optind = 1;
  opterr = 0;
  while (optind < count) {
    if (arguments.words.size() >= before_verbatim) {
      arguments.words.emplace_back(pointers[static_cast<std::size_t>(optind++)]);
      continue;
    }
    int index = -1;
    const int found = getopt_long(count, pointers.data(), letters.c_str(), longs.data(), &index);
    if (found == -1) {  // a word, or "--", after which there are only words
      const bool verbatim =
          optind > 1 && std::string_view(pointers[static_cast<std::size_t>(optind - 1)]) == "--";
      if (verbatim) before_verbatim = 0;
      if (optind < count && !verbatim) {
        arguments.words.emplace_back(pointers[static_cast<std::size_t>(optind++)]);
      }
      continue;
    }
    const std::string given = pointers[static_cast<std::size_t>(optind - 1)];
    if (found == ':') throw UsageError(fmt::format("{} takes a value", given));
    if (found == '?') {
      std::vector<std::string> names;
      for (const OptionSpec& one : options) names.push_back("--" + one.name);
      throw UsageError(names.empty() ? fmt::format("no option {}", given)
                                     : fmt::format("no option {}; did you mean {}?", given,
                                                   nearest(given, names)));
    }
    for (std::size_t i = 0; i < options.size(); ++i) {
      if (static_cast<int>(i) == index || (index < 0 && options[i].letter == found)) {
        std::string& value = arguments.options[options[i].name];
        const bool is_list = options[i].letter == ',' && !value.empty();
        value = (is_list ? value + ',' : "") + (options[i].takes_value ? optarg : "");
      }
    }
  }
  return arguments;
}

}  // namespace mc::grader
