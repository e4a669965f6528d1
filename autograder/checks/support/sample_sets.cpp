#include "checks/support/sample_sets.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "checks/support/inversions.hpp"
#include "checks/support/strata.hpp"

namespace mc::checks {
namespace {

/// Whether the whole parts of the values are 0 … strata-1, as many of each: strata that were not
/// divided by their number. Where the row number is wrong, not the division, the values of the
/// first row are in order.
bool are_undivided(View x, std::size_t strata) {
  const auto cell = [=](double value) { return std::floor(value * static_cast<double>(strata)); };
  const auto end = std::find_if(x.begin(), x.end(), [](double value) { return !(value < 1); });
  const bool is_in_order = std::is_sorted(
      x.begin(), end, [&](double one, double other) { return cell(one) < cell(other); });
  if (is_in_order && end - x.begin() >= 8) return false;
  std::vector<std::size_t> counts(strata);
  for (const double value : x) {
    if (!(value >= 0 && value < static_cast<double>(strata))) return false;
    ++counts[static_cast<std::size_t>(value)];
  }
  return strata > 1 && std::all_of(counts.begin(), counts.end(),
                                   [&](std::size_t c) { return c * strata == x.size(); });
}

}  // namespace

void require_in_cube(const std::string& call, const std::string& name, View x, std::size_t strata) {
  const auto odd =
      std::find_if_not(x.begin(), x.end(), [](double value) { return value >= 0 && value < 1; });
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

SampleSets sets_from_xy(std::string call, View x, View y, std::span<const std::uint64_t> sizes) {
  Values values;
  values.reserve(2 * x.size());
  std::size_t first = 0;
  for (const std::uint64_t size : sizes) {
    for (const View all : {x, y}) {
      const View part = all.subspan(first, size);
      values.insert(values.end(), part.begin(), part.end());
    }
    first += size;
  }
  return {std::move(call), sizes, 2, std::move(values)};
}

SampleSets sets_from_columns(const Measured<Values>& got, std::size_t n, std::size_t dims,
                             std::size_t sets, std::size_t strata) {
  SampleSets all(got.call, sets, n, dims, got.exactly(n * dims * sets, any_number));
  for (std::size_t set = 0; set < sets; ++set) {
    for (std::size_t d = 0; d < dims; ++d) {
      const std::string name = dims == 1 ? "x" : fmt::format("column {}, x", d);
      require_in_cube(got.call, name, all.column(set, d), strata);
    }
  }
  return all;
}

Uniforms jitters_of(const SampleSets& sets, std::span<const Pattern> patterns,
                    const std::string& elsewhere) {
  Uniforms jitters{sets.call, 0};
  for (const Pattern& pattern : patterns) jitters.positions += sets.n * pattern.dims.size();
  jitters.values.resize(sets.size() * jitters.positions);
  std::vector<std::size_t> axis_of;  // of each position: its dimension and its cell
  for (std::size_t set = 0; set < sets.size(); ++set) {
    std::size_t first = set * jitters.positions;
    for (const Pattern& pattern : patterns) {
      const auto cells = expect_one_in_each_cell(sets, set, pattern, elsewhere);
      for (std::size_t i = 0; i < pattern.dims.size(); ++i, first += sets.n) {
        const View column = sets.column(set, pattern.dims[i]);
        jitters.bits = std::min(jitters.bits, bits_of_jitter(pattern.strata[i]));
        for (std::size_t k = 0; k < sets.n; ++k) {
          jitters.values[first + cells[k]] = jitter_of(column[k], pattern.strata[i]);
        }
        if (set == 0) axis_of.push_back(pattern.dims[i]);
      }
    }
  }
  jitters.name = [axis_of, n = sets.n, dims = sets.dims](std::size_t position) {
    const std::size_t d = axis_of[position / n];
    return fmt::format("the jitter of {} in cell {}",
                       dims <= 2 ? (d == 0 ? "x" : "y") : fmt::format("coordinate {}", d),
                       position % n);
  };
  return jitters;
}

void expect_fresh(const SampleSets& sets, const SampleSets& other_seed,
                  std::span<const Pattern> patterns) {
  for (const Pattern& pattern : patterns) {
    for (std::size_t i = 0; i < pattern.dims.size(); ++i) {
      const std::size_t d = pattern.dims[i];
      const View a = sets.column(0, d);
      const std::pair<View, const char*> others[] = {
          {sets.column(1, d), "two sets one after the other"},
          {other_seed.column(0, d), "a set of another seed"}};
      for (const auto& [b, where] : others) {
        Values x(a.begin(), a.end()), y(b.begin(), b.end()), common;
        std::sort(x.begin(), x.end());
        std::sort(y.begin(), y.end());
        std::set_intersection(x.begin(), x.end(), y.begin(), y.end(), std::back_inserter(common));
        if (2 * common.size() <= x.size()) continue;
        for (double& value : x) value = jitter_of(value, pattern.strata[i]);
        const auto [low, high] = std::minmax_element(x.begin(), x.end());
        fail(Failure{fmt::format("{}: coordinate {} is the same in {}", sets.call, d, where),
                     "other points in every set, and for every seed",
                     "points are random, or estimates are biased",
                     *high - *low < 1e-6
                         ? fmt::format("every point lies at {:.3g} of its stratum: place it there "
                                       "at random",
                                       *low)
                         : "the same numbers come again: draw them all from the generator that is "
                           "passed in, anew for each set"});
      }
    }
  }
  pass();
}

}  // namespace mc::checks
