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
#include "checks/support/sample_sets.hpp"
#include "checks/support/strata.hpp"

namespace mc::checks {

/// Short enough to be typed again.
inline std::uint64_t fresh_seed(Rng& rng) {
  return rng() >> 32;
}

using Sets = SampleSets;

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

inline Sets columns_of(const Measured<Values>& got, std::size_t n, std::size_t dims,
                       std::size_t sets, std::size_t strata) {
  return sets_from_columns(got, n, dims, sets, strata);
}
inline Sets planes_of(const Measured<experiments::Points>& got, Grid grid, std::size_t sets) {
  return sets_from_xy(got, grid, sets);
}

}  // namespace mc::checks
