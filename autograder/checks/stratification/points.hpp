#pragma once
// Sets of points as lab 3's experiments give them, past the gate: as many as were asked for, all of
// them in the unit cube. What was never written is NaN (experiments.hpp), and said.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "3-stratification/experiments.hpp"
#include "checks/support/measure.hpp"
#include "checks/support/strata.hpp"

namespace mc::checks {

using Values = std::vector<double>;
using View = std::span<const double>;

/// Short enough to be typed again.
inline std::uint64_t fresh_seed(Rng& rng) {
  return rng() >> 32;
}

/// Sets of n points of the unit cube: of each set one column after the other.
class Sets {
 public:
  Sets(std::string from, std::size_t points, std::size_t axes, Values values)
      : call(std::move(from)), n(points), dims(axes), values_(std::move(values)) {}

  std::string call;
  std::size_t n, dims;

  std::size_t size() const { return values_.size() / (n * dims); }
  View column(std::size_t set, std::size_t d) const {
    return View(values_).subspan((set * dims + d) * n, n);
  }

 private:
  Values values_;
};

/// Whether each of 0 … strata-1 is the whole part of as many of the values: strata that nobody
/// divided by their number.
inline bool are_undivided(View x, std::size_t strata) {
  std::vector<std::size_t> counts(strata);
  for (const double value : x) {
    if (!(value >= 0 && value < static_cast<double>(strata))) return false;
    ++counts[static_cast<std::size_t>(value)];
  }
  return strata > 1 && std::all_of(counts.begin(), counts.end(),
                                   [&](std::size_t c) { return c * strata == x.size(); });
}

/// Ends the check where a coordinate of a set does not lie in [0,1), saying why that may be. `name`
/// is the list's, `strata` how many there are along that axis.
inline void require_in_cube(const std::string& call, const std::string& name, View x,
                            std::size_t strata) {
  const auto inside = [](double value) { return value >= 0 && value < 1; };
  const auto odd = std::find_if_not(x.begin(), x.end(), inside);
  if (odd == x.end()) return;
  const auto at = static_cast<std::size_t>(odd - x.begin());
  const auto is_nan = [](double value) { return std::isnan(value); };
  std::string likely;
  if (std::all_of(x.begin(), x.end(), is_nan)) {
    likely = "nothing was written there, or it was added to what was there: NaN";
  } else if (is_nan(*odd) && std::all_of(odd, x.end(), is_nan)) {
    likely = fmt::format("the last {} of {} values were never written", x.size() - at, x.size());
  } else if (is_nan(*odd)) {
    likely = "this value was never written, or is 0/0";
  } else if (*odd == 1) {
    likely = "it was rounded up to 1: hold it below the upper edge of its stratum";
  } else if (are_undivided(x, strata)) {
    likely = fmt::format("divide by the number of strata: {} of them share [0, 1)", strata);
  }
  refuse(call, {fmt::format("gave {}[{}] = {}", name, at, *odd),
                "numbers in [0, 1): points lie in the unit cube, without its upper faces", likely});
}

/// Point i of n lies in stratum i, for all i.
inline void expect_in_order(const std::string& call, View x) {
  const std::size_t n = x.size();
  for (std::size_t i = 0; i < n; ++i) {
    if (stratum_of(x[i], n) == i) continue;
    const double low = static_cast<double>(i) / static_cast<double>(n);
    const double high = static_cast<double>(i + 1) / static_cast<double>(n);
    Values sorted(x.begin(), x.end());
    std::sort(sorted.begin(), sorted.end());
    bool only_order = true;
    for (std::size_t k = 0; k < n; ++k) only_order = only_order && stratum_of(sorted[k], n) == k;
    expect_that(false, fmt::format("{}: x[{}] = {}", call, i, x[i]),
                fmt::format("a value in [{}/{}, {}/{}) = [{}, {})", i, n, i + 1, n, low, high),
                "point i lies in stratum i, with edges i / N and (i+1) / N in double division",
                only_order ? "every stratum has its point, but they do not come in order"
                : n > 2 && sorted.back() < 1 / static_cast<double>(n)
                    ? "every point lies in the first stratum: i / N of two whole numbers is 0"
                : x[i] == high ? "it was rounded up to the edge: keep the point below (i + 1) / N"
                : std::nextafter(x[i], 1.0) == low
                    ? "it was rounded down below the edge: 1 / N is rounded, and so is its product"
                    : "one point in each stratum: (i + u) / N for i = 0 … N-1");
  }
  pass();
}

/// Of an experiment that gives sets column by column; `strata` along every axis.
inline Sets columns_of(const Measured<Values>& got, std::size_t n, std::size_t dims,
                       std::size_t sets, std::size_t strata) {
  const Values& values = got.exactly(n * dims * sets, any_number);
  Sets all(got.call, n, dims, values);
  for (std::size_t set = 0; set < sets; ++set) {
    for (std::size_t d = 0; d < dims; ++d) {
      const std::string name = dims == 1 ? "x" : fmt::format("column {}, x", d);
      require_in_cube(got.call, name, all.column(set, d), strata);
    }
  }
  return all;
}

/// Of an experiment that gives all x and all y.
inline Sets planes_of(const Measured<experiments::Points>& got, Grid grid, std::size_t sets) {
  const std::size_t n = grid.nx * grid.ny;
  const experiments::Points& points = got.exactly(n * sets, any_number);
  Values values;
  values.reserve(2 * n * sets);
  for (std::size_t set = 0; set < sets; ++set) {
    const auto x = View(points.x).subspan(set * n, n), y = View(points.y).subspan(set * n, n);
    require_in_cube(got.call, "x", x, grid.nx);
    require_in_cube(got.call, "y", y, grid.ny);
    values.insert(values.end(), x.begin(), x.end());
    values.insert(values.end(), y.begin(), y.end());
  }
  return {got.call, n, 2, std::move(values)};
}

}  // namespace mc::checks
