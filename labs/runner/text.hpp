#pragma once
// Arguments and results as text, for running an experiment by hand: 3 or 0.5 is a number, 1,2,4 a
// list, 3:0.5:2 a struct field by field, anything else a word.

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "runner/wire.hpp"

namespace mc::text {

/// Each throws std::invalid_argument for what is not such a number, or does not fit.
void parse(std::string_view text, double& value);
void parse(std::string_view text, std::uint64_t& value);
void parse(std::string_view text, std::int64_t& value);
void parse(std::string_view text, unsigned& value);
void parse(std::string_view text, int& value);
void parse(std::string_view text, std::string& value);
template <wire::Listed T>
void parse(std::string_view text, T& value);
std::vector<std::string_view> split(std::string_view text, char separator);
[[noreturn]] void wrong_number_of_fields(std::string_view names);

template <class T>
void parse(std::string_view text, std::vector<T>& values) {
  values.clear();
  if (text.empty()) return;
  for (std::string_view part : split(text, ',')) parse(part, values.emplace_back());
}
template <wire::Listed T>
void parse(std::string_view text, T& value) {
  const auto parts = split(text, ':');
  std::apply(
      [&](auto&... field) {
        if (parts.size() != sizeof...(field)) wrong_number_of_fields(field_names(value));
        std::size_t i = 0;
        (parse(parts[i++], field), ...);
      },
      fields(value));
}

/// A value in the form in which it is typed: what parse() reads back. Lists of lists are not typed.
template <class T>
std::string as_typed(const T& value);
template <class T>
std::string as_typed(const std::vector<T>& values);

/// A text with this in place of each {}.
std::string filled(std::string_view text, const std::string& with);

/// The fewest digits that give back the same number.
std::string print(double value);
std::string print(std::uint64_t value);
std::string print(std::int64_t value);
std::string print(unsigned value);
std::string print(int value);
std::string print(const std::string& value);

template <class T>
std::string as_typed(const std::vector<T>& values) {
  std::string all;
  for (const T& value : values) {
    if (!all.empty()) all += ',';
    all += as_typed(value);
  }
  return all;
}
template <class T>
std::string as_typed(const T& value) {
  if constexpr (wire::Listed<T>) {
    std::string all;
    std::apply([&](const auto&... field) { ((all += ':' + as_typed(field)), ...); },
               fields(const_cast<T&>(value)));
    return all.substr(std::min<std::size_t>(1, all.size()));
  } else {
    return print(value);
  }
}

}  // namespace mc::text
