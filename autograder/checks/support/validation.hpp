#pragma once
// Validation of what a program sends: untrusted numbers. Before a check counts, sorts or indexes by
// them, there are as many as were asked for, and each is in its range.

#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <vector>

#include "runner/wire.hpp"

namespace mc::checks {

/// What a student reads where a check fails.
struct Failure {
  std::string measured, expected;
  std::string because = {};  ///< why that is expected, or where the bound comes from
  std::string likely = {};   ///< the mistake, where what was measured shows it
};

/// Ends the check: it failed.
[[noreturn]] void fail(const Failure& failure);
[[noreturn]] void fail(const std::string& report);

/// An expectation was met. Catch2 counts the first: it takes a check without any for an empty one.
void pass();

/// `holds` is true; `expected` says in words what that is.
void expect_that(bool holds, const std::string& measured, const std::string& expected,
                 const std::string& because, const std::string& hint);

/// `got` is NaN, as in numpy and R for what is undefined.
void expect_nan(const std::string& what, double got, const std::string& because);

/// `got` is infinite or NaN.
void expect_not_finite(const std::string& what, double got, const std::string& because,
                       const std::string& hint);

/// Where numbers must lie.
struct Range {
  double low, high;  ///< both inside, unless `below_high`
  bool below_high;
  bool any;  ///< NaN and infinities too: each is judged by itself, and counts nothing
  const char* words;
};
inline constexpr double largest_finite = std::numeric_limits<double>::max();
inline constexpr Range finite{-largest_finite, largest_finite, false, false, "finite numbers"};
inline constexpr Range unit{0, 1, true, false, "numbers in [0, 1)"};
inline constexpr Range closed_unit{0, 1, false, false, "numbers in [0, 1]"};
inline constexpr Range any_number{0, 0, false, true, "numbers"};
/// Whole numbers up to `most`.
constexpr Range up_to(double most) {
  return {0, most, false, false, "whole numbers in their range"};
}

/// What is expected of a list: its length, and the range of its values.
struct ListSpec {
  std::size_t count;
  Range range;
  bool or_less = false;  ///< at most so many; neighbors that both may have fewer are of one size
};

/// Ends the check: the answer to this call is invalid.
[[noreturn]] void refuse(const std::string& call, const Failure& failure);

/// Failures of a list of `size` values where `expected` are; of the value at `index` of one.
Failure wrong_size(const std::string& list, std::size_t size, std::size_t expected, bool or_less);
Failure wrong_value(const std::string& list, std::size_t index, double value, const Range& range);

/// "x, y" taken apart.
std::vector<std::string> names_of(std::string_view fields);

inline bool lies_in(double value, const Range& range) {
  return range.any ||
         (value >= range.low && (range.below_high ? value < range.high : value <= range.high));
}

template <class T>
struct IsVector : std::false_type {};
template <class T>
struct IsVector<std::vector<T>> : std::true_type {};

template <class T>
constexpr bool has_lists();
template <class Tuple>
struct AnyHasLists;
template <class... Fields>
struct AnyHasLists<std::tuple<Fields&...>> {
  static constexpr bool value = (has_lists<Fields>() || ...);
};
template <class T>
constexpr bool has_lists() {
  if constexpr (IsVector<T>::value) {
    return true;
  } else if constexpr (wire::Listed<T>) {
    return AnyHasLists<decltype(fields(std::declval<T&>()))>::value;
  } else {
    return false;
  }
}
template <class T>
concept HasLists = has_lists<T>();

/// The first number of a value that does not lie in the range: itself, or one of its fields.
template <class T>
std::optional<double> outside(const T& value, const Range& range) {
  if constexpr (wire::Arithmetic<T>) {
    const auto number = static_cast<double>(value);
    if (lies_in(number, range)) return {};
    return number;
  } else if constexpr (wire::Listed<T>) {
    std::optional<double> found;
    std::apply(
        [&](const auto&... field) { ((found = found ? found : outside(field, range)), ...); },
        fields(const_cast<T&>(value)));
    return found;
  } else {
    return {};
  }
}

template <class T>
std::optional<Failure> list_failure(const std::string& name, const std::vector<T>& list,
                                    const ListSpec& spec) {
  if (spec.or_less ? list.size() > spec.count : list.size() != spec.count) {
    return wrong_size(name, list.size(), spec.count, spec.or_less);
  }
  if (spec.range.any) return {};
  for (std::size_t i = 0; i < list.size(); ++i) {
    if constexpr (wire::Arithmetic<T>) {  // most lists: millions of numbers
      if (lies_in(static_cast<double>(list[i]), spec.range)) continue;
    }
    if (const auto number = outside(list[i], spec.range)) {
      return wrong_value(name, i, *number, spec.range);
    }
  }
  return {};
}

/// What is wrong with an answer, if anything. `specs` has an element for each of its lists, or one
/// for all.
template <HasLists T>
std::optional<Failure> failure_of(const T& value, std::span<const ListSpec> specs) {
  if constexpr (IsVector<T>::value) {
    return list_failure("", value, specs[0]);
  } else {
    std::optional<Failure> found;
    std::optional<std::size_t> before;  // the size of the list before, where it was free
    std::size_t list = 0;
    const auto look = [&](const auto& field, const std::string& name) {
      if constexpr (IsVector<std::remove_cvref_t<decltype(field)>>::value) {
        const ListSpec& here = specs[specs.size() == 1 ? 0 : list++];
        if (!found) found = list_failure(name, field, here);
        if (!here.or_less) return before.reset();
        if (!found && before.value_or(field.size()) != field.size()) {
          found = wrong_size(name, field.size(), *before, false);
        }
        before = field.size();
      }
    };
    const std::vector<std::string> names = names_of(field_names(value));
    std::apply(
        [&](const auto&... field) {
          std::size_t i = 0;
          (look(field, names[i++]), ...);
        },
        fields(const_cast<T&>(value)));
    return found;
  }
}

/// A failure report without signs that carry no information: "-nan" and "-0" become "nan" and
/// "0".
std::string without_empty_signs(std::string report);

}  // namespace mc::checks
