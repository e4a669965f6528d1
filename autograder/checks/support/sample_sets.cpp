#include "checks/support/sample_sets.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace mc::checks {
namespace {

/// Whether the whole parts of the values are 0 … strata-1, as many of each: strata that were not
/// divided by their number.
bool are_undivided(View x, std::size_t strata) {
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

SampleSets sets_from_columns(const Measured<Values>& got, std::size_t n, std::size_t dims,
                             std::size_t sets, std::size_t strata) {
  SampleSets all(got.call, n, dims, got.exactly(n * dims * sets, any_number));
  for (std::size_t set = 0; set < sets; ++set) {
    for (std::size_t d = 0; d < dims; ++d) {
      const std::string name = dims == 1 ? "x" : fmt::format("column {}, x", d);
      require_in_cube(got.call, name, all.column(set, d), strata);
    }
  }
  return all;
}

}  // namespace mc::checks
