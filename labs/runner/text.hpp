#pragma once
// Arguments and results as text, for running an experiment by hand: 3 or 0.5 is a number, 1,2,4 a
// list, 3:0.5:2 a struct field by field, anything else a word.

#include <algorithm>
#include <concepts>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "runner/wire.hpp"

namespace mc::text {

/// Reads a whole text. Throws std::invalid_argument if it is not such a number or does not fit.
void parse(std::string_view text, double& value);
template <std::integral T>  // int, unsigned, and of 64 bits
void parse(std::string_view text, T& value);
void parse(std::string_view text, std::string& value);
template <wire::Listed T>
void parse(std::string_view text, T& value);

/// The parts between separators, without the blanks around them; one empty part for an empty text.
std::vector<std::string_view> split(std::string_view text, char separator);

/// The words between blanks.
std::vector<std::string> words_of(std::string_view text);

/// Words in lines of at most `width` columns; lines after the first begin with `indent` blanks,
/// which do not count.
std::string wrapped(const std::vector<std::string>& words, std::size_t width, std::size_t indent);

/// The columns that a UTF-8 text takes: one per code point; the labs use no others.
std::size_t columns_of(std::string_view text);

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

/// A value as a user types it: parse() reads it back. There is no form for lists of lists.
template <class T>
std::string as_typed(const T& value);
template <class T>
std::string as_typed(const std::vector<T>& values);

/// `text` with each {} replaced by `with`.
std::string filled(std::string_view text, const std::string& with);

/// Joins items; of more than `most`, the first of them, and how many more `what` there are.
std::string joined(const std::vector<std::string>& items, const std::string& separator,
                   std::size_t most, const std::string& what);

/// With the fewest digits that give back the same number.
std::string print(double value);
template <std::integral T>
std::string print(T value);
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
