#pragma once
// Validates the number and the ranges of the untrusted values that a program sends.

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "runner/wire.hpp"

namespace mc::checks {

/// The cause of a failure that a report names: a literal with the suffix _likely, or the format of
/// likely(). `self_test repository` finds them all and requires a mistake whose "hint:" quotes
/// each.
struct Likely {
  Likely() = default;
  explicit Likely(std::string words) : text(std::move(words)) {}
  bool operator==(const Likely&) const = default;
  std::string text;
};
inline Likely operator""_likely(const char* text, std::size_t size) {
  return Likely({text, size});
}
template <class... T>
Likely likely(fmt::format_string<T...> text, T&&... values) {
  return Likely(fmt::format(text, std::forward<T>(values)...));
}

/// A failure report, which students read.
struct Failure {
  std::string measured, expected;
  std::string because = {};  ///< the reason for the expected value or the bound
  Likely likely = {};        ///< the mistake that explains what was measured
  std::string rule = {};     ///< if no mistake does: what the answer must do
};

[[noreturn]] void fail(const Failure& failure);
[[noreturn]] void fail(const std::string& report);

/// An expectation is met. Catch2 needs at least one per check.
void pass();

/// `holds` is true; `expected` describes it in words.
void expect_that(bool holds, const std::string& measured, const std::string& expected,
                 const std::string& because, const std::string& rule, const Likely& likely = {});

/// A count is exact; `what` names it.
void expect_equal(const std::string& what, std::uint64_t got, std::uint64_t expected,
                  const std::string& because, const std::string& rule, const Likely& likely = {});

/// `got` is NaN: the result is undefined.
void expect_nan(const std::string& what, double got, const std::string& because);

/// `got` is infinite or NaN.
void expect_not_finite(const std::string& what, double got, const std::string& because,
                       const std::string& hint);

/// The range of valid numbers.
struct Range {
  double low, high;  ///< both inside, unless `below_high`
  bool below_high;
  bool any;  ///< NaN and infinities too: each value is compared with an expected one
  const char* words;
};
inline constexpr double largest_finite = std::numeric_limits<double>::max();
inline constexpr Range finite{-largest_finite, largest_finite, false, false, "finite numbers"};
inline constexpr Range unit{0, 1, true, false, "numbers in [0, 1)"};
inline constexpr Range closed_unit{0, 1, false, false, "numbers in [0, 1]"};
inline constexpr Range any_number{0, 0, false, true, "numbers"};
/// Integers up to `most`.
constexpr Range up_to(double most) {
  return {0, most, false, false, "integers in their range"};
}

/// The expected length of a list, and the range of its values.
struct ListSpec {
  std::size_t count;
  Range range;
  bool or_less = false;  ///< `count` is a maximum; adjacent lists with this have equal sizes
};

/// Ends the check because the answer to this call is invalid.
[[noreturn]] void refuse(const std::string& call, const Failure& failure);

/// The failures for a list of the wrong size, and for the value at `index` of a list.
Failure wrong_size(const std::string& list, std::size_t size, std::size_t expected, bool or_less);
Failure wrong_value(const std::string& list, std::size_t index, double value, const Range& range);

/// Splits "x, y".
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
constexpr bool has_lists() {
  if constexpr (IsVector<T>::value) {
    return true;
  } else if constexpr (wire::Listed<T>) {
    using Fields = decltype(fields(std::declval<T&>()));
    return []<class... F>(std::type_identity<std::tuple<F&...>>) {
      return (has_lists<F>() || ...);
    }(std::type_identity<Fields>{});
  } else {
    return false;
  }
}
template <class T>
concept HasLists = has_lists<T>();

/// The first number of a value that is outside the range: itself, or one of its fields.
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

/// The first fault of an answer, if any. `specs` has one element per list, or a single one for all.
template <HasLists T>
std::optional<Failure> failure_of(const T& value, std::span<const ListSpec> specs) {
  if constexpr (IsVector<T>::value) {
    return list_failure("", value, specs[0]);
  } else {
    std::optional<Failure> found;
    std::optional<std::size_t> before;  // the size of the previous list, if it was free
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

/// A failure report with "-nan" and "-0" replaced by "nan" and "0".
std::string without_empty_signs(const std::string& report);

}  // namespace mc::checks
