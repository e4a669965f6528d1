#include "runner/text.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <stdexcept>
#include <system_error>

// Without fmt: no distribution has a static one, and as headers it costs eight seconds of every
// fresh build.

namespace mc::text {
namespace {

std::string quoted(std::string_view text) {
  return '\'' + std::string(text) + '\'';
}

template <class Number>
std::string shortest(Number value) {
  char digits[32];
  return {digits, std::to_chars(digits, digits + sizeof digits, value).ptr};
}

}  // namespace

void parse(std::string_view text, double& value) {
  const std::string copy(text);
  char* stop = nullptr;
  value = std::strtod(copy.c_str(), &stop);
  if (copy.empty() || *stop != '\0') {
    throw std::invalid_argument(quoted(text) + " is not a number");
  }
}
template <std::integral T>
void parse(std::string_view text, T& value) {
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc{} || stop != end) {
    throw std::invalid_argument(quoted(text) + " is not a whole number that fits here");
  }
}
template void parse(std::string_view text, int& value);
template void parse(std::string_view text, unsigned& value);
template void parse(std::string_view text, std::int64_t& value);
template void parse(std::string_view text, std::uint64_t& value);
void parse(std::string_view text, std::string& value) {
  value = text;
}

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (;;) {
    const auto at = text.find(separator);
    auto part = text.substr(0, at);
    while (!part.empty() && part.front() == ' ') part.remove_prefix(1);
    while (!part.empty() && part.back() == ' ') part.remove_suffix(1);
    parts.push_back(part);
    if (at == std::string_view::npos) return parts;
    text.remove_prefix(at + 1);
  }
}

std::vector<std::string> words_of(std::string_view text) {
  std::vector<std::string> words;
  for (const std::string_view part : split(text, ' ')) {
    if (!part.empty()) words.emplace_back(part);
  }
  return words;
}

std::string wrapped(const std::vector<std::string>& words, std::size_t width, std::size_t indent) {
  std::string all, line;
  for (const std::string& word : words) {
    if (!line.empty() && columns_of(line) + 1 + columns_of(word) > width) {
      all += line + '\n' + std::string(indent, ' ');
      line.clear();
    }
    line += (line.empty() ? "" : " ") + word;
  }
  return all + line;
}

std::size_t columns_of(std::string_view text) {
  return static_cast<std::size_t>(
      std::ranges::count_if(text, [](char c) { return (c & 0xc0) != 0x80; }));
}

void wrong_number_of_fields(std::string_view names) {
  throw std::invalid_argument("expected the fields " + std::string(names) + ", separated by ':'");
}

std::string filled(std::string_view text, const std::string& with) {
  std::string all(text);
  for (auto at = all.find("{}"); at != std::string::npos; at = all.find("{}", at)) {
    all.replace(at, 2, with);
    at += with.size();
  }
  return all;
}

std::string joined(const std::vector<std::string>& items, const std::string& separator,
                   std::size_t most, const std::string& what) {
  if (items.size() == most + 1) ++most;  // "1 more" is as long
  std::string all;
  for (std::size_t i = 0; i < items.size() && i < most; ++i) {
    all += (i > 0 ? separator : "") + items[i];
  }
  if (items.size() <= most) return all;
  return all + separator + "… " + std::to_string(items.size() - most) + " more " + what;
}

std::string print(double value) {
  return std::isnan(value) ? "nan" : shortest(value);  // the sign of a NaN has no meaning
}
template <std::integral T>
std::string print(T value) {
  return shortest(value);
}
template std::string print(int value);
template std::string print(unsigned value);
template std::string print(std::int64_t value);
template std::string print(std::uint64_t value);
std::string print(const std::string& value) {
  return value;
}

}  // namespace mc::text
