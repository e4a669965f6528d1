#pragma once
// How the errors of scrambled points are distributed.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <optional>
#include <vector>

#include "measurements/halton/plot_points.hpp"
#include "measurements/support/bench_data.hpp"

namespace mc::checks {

/// ErrorSums of the mean of exp(x) over the first n points of base 2, scrambled by 5.8 in so many
/// ways.
inline std::optional<ErrorSums> errors_of_exp(std::size_t n, std::size_t sets) {
  const double exact = std::expm1(1.0);
  const Column column = column_of(TRY_MEASURE(sobol, 0, 0, n), n);
  if (!column) return {};
  ErrorSums errors;
  for (std::size_t done = 0; done < sets;) {
    // As many at once as a result may carry.
    std::vector<std::uint64_t> seeds(std::min(sets - done, 1'500'000 / n));
    std::iota(seeds.begin(), seeds.end(), 1'000'000 * n + done);
    done += seeds.size();
    const Column all = column_of(TRY_MEASURE(owen_scramble, *column, seeds), n * seeds.size());
    if (!all) return {};
    for (std::size_t set = 0; set < seeds.size(); ++set) {
      double sum = 0;
      for (std::size_t i = 0; i < n; ++i) sum += std::exp((*all)[set * n + i]) - exact;
      errors.add(sum / static_cast<double>(n));
    }
  }
  return errors;
}

}  // namespace mc::checks
