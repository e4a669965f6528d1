#include "runner/text.hpp"

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <stdexcept>
#include <system_error>

// No fmt here: no distribution ships a static one, and header-only it costs eight seconds of every
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

template <class Integer>
void parse_integer(std::string_view text, Integer& value) {
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc{} || stop != end) {
    throw std::invalid_argument(quoted(text) + " is not a whole number that fits here");
  }
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
void parse(std::string_view text, std::uint64_t& value) {
  parse_integer(text, value);
}
void parse(std::string_view text, std::int64_t& value) {
  parse_integer(text, value);
}
void parse(std::string_view text, unsigned& value) {
  parse_integer(text, value);
}
void parse(std::string_view text, int& value) {
  parse_integer(text, value);
}
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

std::string print(double value) {
  return std::isnan(value) ? "nan" : shortest(value);  // whose sign means nothing
}
std::string print(std::uint64_t value) {
  return shortest(value);
}
std::string print(std::int64_t value) {
  return shortest(value);
}
std::string print(unsigned value) {
  return shortest(value);
}
std::string print(int value) {
  return shortest(value);
}
std::string print(const std::string& value) {
  return value;
}

}  // namespace mc::text
