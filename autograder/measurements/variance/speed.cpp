// How fast 1.8 is.

#include <cmath>
#include <random>

#include <fmt/format.h>

#include "1-variance/experiments.hpp"
#include "checks/support/catch.hpp"
#include "checks/variance/data_sets.hpp"
#include "measurements/support/plot_data.hpp"
#include "measurements/support/speed_data.hpp"

namespace mc::checks {
namespace {

/// What repeat() must give: the same changes to the same values. Sums of offsets from a value near
/// the data follow a change at once; they keep ten digits of a million rounds.
double mean_variance(const Values& original, std::uint64_t rounds, std::uint64_t seed) {
  const auto n = static_cast<double>(original.size());
  const double shift = static_cast<double>(exact_mean(original));
  Values x = original;
  double sum = 0, squares = 0, variances = 0;
  const auto count = [&](double value, double sign) {
    sum += sign * (value - shift);
    squares += sign * (value - shift) * (value - shift);
  };
  for (const double value : x) count(value, 1);
  Rng changes(seed);
  for (std::uint64_t round = 0; round < rounds; ++round) {
    if (round > 0) {
      double& changed = x[changes() % x.size()];
      count(changed, -1);
      changed = original[changes() % x.size()];
      count(changed, 1);
    }
    variances += (squares - sum * sum / n) / (n - 1);
  }
  return variances / static_cast<double>(rounds);
}

TEST_CASE("speed of moments", "[.speed]") {
  Rng rng{std::random_device()()};
  const Values x = uniform_values(rng, 4096, 1e6, 1e6 + 1);  // 32 KB: in the first-level cache
  bench_speed("1.8", "moments", x.size(), [&](std::uint64_t rounds) -> std::optional<double> {
    const std::uint64_t seed = rng();
    const auto got = TRY_MEASURE(repeat, 8, x, rounds, seed);
    if (!got) return {};
    const double exact = mean_variance(x, rounds, seed);
    if (!(std::abs(got->value - exact) <= 1e-8 * exact)) {
      throw WrongWhenTimed{
          fmt::format("the mean of {} variances is {:.9g}, not {:.9g}", rounds, got->value, exact)};
    }
    return got->cpu_seconds;
  });
}

}  // namespace
}  // namespace mc::checks
