// 4.5

#include <cmath>
#include <functional>
#include <numbers>
#include <utility>

#include "checks/blue_noise/random_sets.hpp"
#include "checks/support/catch.hpp"
#include "checks/support/compare.hpp"
#include "checks/support/refusals.hpp"

namespace mc::checks {
namespace {

/// The ring of (kx, ky), whose length is k; none beyond the last.
using RingOf = std::function<double(int kx, int ky, double k)>;

/// Of each ring: the sum of `power`, and how many terms it has.
std::pair<Values, Values> sums_over(const Values& power, int kmax, const RingOf& ring_of) {
  const auto rings = static_cast<std::size_t>(kmax) + 1;
  Values sum(rings), count(rings);
  std::size_t i = 0;
  for (int ky = -kmax; ky <= kmax; ++ky) {
    for (int kx = -kmax; kx <= kmax; ++kx, ++i) {
      const double ring = ring_of(kx, ky, std::hypot(kx, ky));
      if (ring > kmax) continue;
      sum[static_cast<std::size_t>(ring)] += power[i];
      ++count[static_cast<std::size_t>(ring)];
    }
  }
  return {sum, count};
}

/// The means; NaN for ring 0.
Values means_over(const Values& power, int kmax, const RingOf& ring_of) {
  auto [sum, count] = sums_over(power, kmax, ring_of);
  for (std::size_t r = 0; r < sum.size(); ++r) sum[r] = r == 0 ? nan : sum[r] / count[r];
  return sum;
}

/// What well-known mistakes give.
std::vector<Curve> wrong_means(const Values& power, int kmax, const RingOf& nearest) {
  Values sum = sums_over(power, kmax, nearest).first, by_length = sum;
  for (std::size_t r = 1; r < sum.size(); ++r) {
    by_length[r] /= 2 * std::numbers::pi * static_cast<double>(r);
  }
  sum[0] = by_length[0] = nan;
  Values with_center = means_over(power, kmax, nearest), with_zero = with_center;
  with_center[0] = power[power.size() / 2];
  with_zero[0] = 0;
  const auto means = [&](const RingOf& ring_of) { return means_over(power, kmax, ring_of); };
  return {
      {means([](int, int, double k) { return std::floor(k); }),
       "abs(k) is cut here: round it to the nearest ring"},
      {sum, "this is the sum over the ring: its mean is asked for"},
      {by_length, "this is the sum over 2 pi r: divide by how many (kx, ky) there are in the ring"},
      {means([=](int, int ky, double k) { return ky >= 0 ? std::round(k) : infinity; }),
       "this is the mean over ky >= 0 alone"},
      {means([=](int, int, double k) { return std::min<double>(std::round(k), kmax); }),
       "the corners are in the last ring: they belong to none"},
      {with_center, "the power at k = 0 is still in here: ring 0 has no meaning, so NaN"},
      {with_zero, "ring 0 has no meaning, so NaN, not 0"}};
}

CHECK_CASE("4.5 the mean over each ring", "[4.5][main][points:5]") {
  Rng rng = check_rng();
  for (const int kmax : {5, 2, 24, 3, 63, 129, 300, 1}) {
    const auto side = static_cast<std::size_t>(2 * kmax + 1);
    const Values power = uniform_values(rng, side * side, 0, 3);
    // k + 1/2 is the root of no whole number: never halfway.
    const RingOf nearest = [](int, int, double k) { return std::round(k); };
    const Values count = sums_over(power, kmax, nearest).second;
    Comparison rings{.exact = means_over(power, kmax, nearest),
                     .tolerance = {},
                     .because =
                         "n additions of positive numbers lose n eps at most; the power at k = 0 "
                         "is N for any points, so ring 0 is NaN",
                     .otherwise =
                         "the mean of all (kx, ky) whose sqrt(kx^2 + ky^2) rounds to this ring, of "
                         "negative k too"};
    for (std::size_t r = 0; r < count.size(); ++r) {
      rings.tolerance.push_back((count[r] + 2) * eps * rings.exact[r]);
    }
    const auto measured = MEASURE(radial_power, power, kmax);
    const MeasuredValues got{measured.call, measured.exactly(count.size(), any_number)};
    if (difference(got, rings)) rings.suspects = wrong_means(power, kmax, nearest);
    expect_each(got, rings);
  }
}

std::vector<InvalidCall> wrong_rings() {
  std::vector<InvalidCall> calls;
  for (const int kmax : {0, -1, -2, std::numeric_limits<int>::min()}) {
    calls.push_back(
        {MEASURE_OUTCOME(radial_power, Values(1, 1.0), kmax), "kmax", "kmax is 1 at least"});
  }
  calls.push_back({MEASURE_OUTCOME(radial_power, Values(9, 1.0), -2), "kmax",
                   "kmax is 1 at least; (2 kmax + 1)^2 is 9 all the same"});
  for (const std::size_t size : {0u, 9u, 24u, 26u, 49u}) {
    calls.push_back({MEASURE_OUTCOME(radial_power, Values(size, 1.0), 2), "power",
                     "there are (2 kmax + 1)^2 = 25 values of k"});
  }
  return calls;
}

REFUSAL_CASES("4.5", "misuse of radial_power is refused", "2", "a refusal names the argument", "1",
              wrong_rings())

}  // namespace
}  // namespace mc::checks
