#include "commands/arguments.hpp"

#include <getopt.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <random>
#include <string_view>

#include <fmt/format.h>

#include "judge/base/errors.hpp"

namespace mc::grader {
namespace {

/// An option that getopt_long knows.
struct KnownOption {
  std::string name;
  bool takes_value = false, is_list = false;
  int code = 0;  ///< what getopt_long returns for it: its letter, or a number above all letters
};

/// From "--jobs N, -j N".
KnownOption known_option(const std::string& shown, std::size_t index) {
  KnownOption option;
  const auto end = shown.find_first_of(" ,");
  option.name = shown.substr(2, end - 2);
  option.takes_value = end != std::string::npos && shown[end] == ' ';
  option.is_list = shown.ends_with(",…");
  const auto letter = shown.find(", -");
  option.code = letter == std::string::npos ? 256 + static_cast<int>(index) : shown[letter + 3];
  return option;
}

/// The lab in a task's number, "1" in "1.3"; nothing if the text is not a task's number.
std::optional<std::string> lab_of_task(const std::string& word) {
  const auto digits = [](const std::string& text) {
    return !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
  };
  const auto dot = word.find('.');
  if (dot == std::string::npos || !digits(word.substr(0, dot)) || !digits(word.substr(dot + 1))) {
    return {};
  }
  return word.substr(0, dot);
}

}  // namespace

std::optional<std::string> Arguments::get(const std::string& option) const {
  const auto found = options.find(option);
  return found == options.end() ? std::nullopt : std::optional(found->second);
}

std::vector<std::string> Arguments::words_after(std::size_t count) const {
  return {words.begin() + static_cast<std::ptrdiff_t>(std::min(count, words.size())), words.end()};
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

std::optional<std::string> Arguments::output(const std::string& option) const {
  auto file = get(option);
  if (!file) return {};
  const auto directory = std::filesystem::absolute(*file).parent_path();
  if (!std::filesystem::is_directory(directory)) {
    throw UsageError(fmt::format("no such directory: {}", directory.string()));
  }
  return file;
}

std::uint64_t Arguments::seed() const {
  return number("seed").value_or(std::random_device()() % 1'000'000'000);
}

Arguments parse_arguments(const std::vector<std::string>& words, const Syntax& syntax) {
  std::vector<KnownOption> known;
  for (const std::string& shown : syntax.options)
    known.push_back(known_option(shown, known.size()));
  known.push_back(known_option("--help", known.size()));
  std::vector<option> longs;
  std::string letters = "+:";  // ends at the first word
  for (const KnownOption& one : known) {
    longs.push_back(
        {one.name.c_str(), one.takes_value ? required_argument : no_argument, nullptr, one.code});
    if (one.code < 256) letters += {static_cast<char>(one.code), ':'};
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
    const int before = optind;
    const int code = getopt_long(count, pointers.data(), letters.c_str(), longs.data(), nullptr);
    const std::string last = pointers[static_cast<std::size_t>(optind - 1)];
    if (code == -1 && optind > before) {  // "--": only words follow
      before_verbatim = 0;
    } else if (code == -1) {
      arguments.words.emplace_back(pointers[static_cast<std::size_t>(optind++)]);
    } else if (code == ':') {
      throw UsageError(fmt::format("{} takes a value", last));
    } else if (code == '?') {
      std::vector<std::string> names;
      for (const KnownOption& one : known) names.push_back("--" + one.name);
      throw UsageError(fmt::format("no option {}; did you mean {}?", last, nearest(last, names)));
    } else {
      for (const KnownOption& one : known) {
        if (one.code != code) continue;
        std::string& value = arguments.options[one.name];
        const bool is_next = one.is_list && !value.empty();
        value = (is_next ? value + ',' : "") + (one.takes_value ? optarg : "");
      }
    }
  }
  return arguments;
}

LabAndTask lab_and_task(const std::vector<Lab>& labs, const std::vector<std::string>& words) {
  const auto number = lab_of_task(words[0]);
  const Lab& lab = find_lab(labs, number.value_or(words[0]));
  LabAndTask found{lab, number ? words[0] : "", {words.begin() + 1, words.end()}};
  if (number || found.rest.empty()) return found;
  if (const auto owner = lab_of_task(found.rest[0])) {
    if (*owner != std::to_string(lab.number)) {
      throw UsageError(fmt::format("{} is not a task of lab {}", found.rest[0], lab.name));
    }
    found.task = found.rest[0];
    found.rest.erase(found.rest.begin());
  }
  return found;
}

}  // namespace mc::grader
