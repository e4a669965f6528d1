#pragma once
// The gate. What a program sends are numbers of a stranger: before a check counts, sorts or indexes
// by them, they are as many as were asked for, and each is in its range.

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

/// What a student is told where a check fails.
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
inline constexpr Range non_negative{0, largest_finite, false, false,
                                    "finite numbers, none negative"};
inline constexpr Range any_number{0, 0, false, true, "numbers"};
/// Whole numbers up to `most`.
constexpr Range up_to(double most) {
  return {0, most, false, false, "whole numbers in their range"};
}

/// How many values a list must have, list by list (or the same for all).
struct Sizes {
  std::vector<std::size_t> counts;
  bool same_for_all;
  bool or_less;  ///< at most so many, the same number in every list
};

/// What is due of one list of a struct whose lists differ in kind.
struct Due {
  std::size_t count;
  Range range;
  bool or_less = false;  ///< at most so many; neighbours that are both due so are of one size
};

/// What the gate has against an answer.
struct Objection {
  std::string measured, expected, likely;
};

[[noreturn]] void refuse(const std::string& call, const Objection& objection);

/// An objection to a list of `size` values where `due` are due; to the value at `index` of one.
Objection wrong_size(const std::string& list, std::size_t size, std::size_t due, bool or_less);
Objection wrong_value(const std::string& list, std::size_t index, double value, const Range& range);

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
std::optional<Objection> list_objection(const std::string& name, const std::vector<T>& list,
                                        std::size_t due, bool or_less, const Range& range) {
  if (or_less ? list.size() > due : list.size() != due) {
    return wrong_size(name, list.size(), due, or_less);
  }
  if (range.any) return {};
  for (std::size_t i = 0; i < list.size(); ++i) {
    if constexpr (wire::Arithmetic<T>) {  // most lists: millions of numbers
      if (lies_in(static_cast<double>(list[i]), range)) continue;
    }
    if (const auto number = outside(list[i], range)) return wrong_value(name, i, *number, range);
  }
  return {};
}

/// What is wrong with an answer, if anything.
template <HasLists T>
std::optional<Objection> objection(const T& value, const Sizes& sizes, const Range& range) {
  if constexpr (IsVector<T>::value) {
    return list_objection("", value, sizes.counts.at(0), sizes.or_less, range);
  } else {
    std::optional<Objection> found;
    std::size_t list = 0;
    std::optional<std::size_t> first;
    const auto look = [&](const auto& field, std::string_view name) {
      using Field = std::remove_cvref_t<decltype(field)>;
      if constexpr (IsVector<Field>::value) {
        const std::size_t due = sizes.same_for_all ? sizes.counts.at(0) : sizes.counts.at(list++);
        const std::string called(name);
        if (!found) found = list_objection(called, field, due, sizes.or_less, range);
        if (!found && sizes.or_less && first.value_or(field.size()) != field.size()) {
          found = wrong_size(called, field.size(), *first, false);
        }
        first = field.size();
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

/// The same, list by list: as many `due` as the struct has lists.
template <HasLists T>
std::optional<Objection> objection(const T& value, std::span<const Due> due) {
  std::optional<Objection> found;
  std::size_t list = 0, before = 0;
  const auto look = [&](const auto& field, const std::string& name) {
    if constexpr (IsVector<std::remove_cvref_t<decltype(field)>>::value) {
      const Due& here = due[list];
      if (!found) found = list_objection(name, field, here.count, here.or_less, here.range);
      const bool as_before = list > 0 && here.or_less && due[list - 1].or_less;
      if (!found && as_before && field.size() != before) {
        found = wrong_size(name, field.size(), before, false);
      }
      before = field.size();
      ++list;
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

/// Sets of points as most experiments return them: set after set, each column by column.
class SetsOfPoints {
 public:
  /// Of an admitted list of sets * n * dims values.
  SetsOfPoints(std::span<const double> values, std::size_t n, std::size_t dims)
      : values_(values), n_(n), dims_(dims) {}
  std::size_t size() const { return values_.size() / (n_ * dims_); }
  std::span<const double> column(std::size_t set, std::size_t d) const {
    return values_.subspan((set * dims_ + d) * n_, n_);
  }

 private:
  std::span<const double> values_;
  std::size_t n_, dims_;
};

}  // namespace mc::checks
