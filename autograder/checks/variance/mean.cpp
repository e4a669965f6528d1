// 1.1: the mean.

#include "1-variance/experiments.hpp"
#include "data_sets.hpp"
#include "list_results.hpp"

namespace mc::checks {
namespace {

std::vector<Suspect> overflows(std::span<const double> x, double exact);

CHECK_CASE("1.1 the mean of a list of values", "[1.1][main][points:6]") {
  const auto judge = [](const std::vector<List>& lists, bool is_tame) {
    Results means;
    means.is_tame = is_tame;
    for (const List& list : lists) {
      const auto got = MEASURE(mean, list.x);
      means.add_digits(got.call + list.name, got.value, static_cast<double>(list.exact.mean),
                       mean_floor(list), [&] { return mean_suspects(list); });
    }
    means.expect(
        because_sum,
        "add up the values and divide by their number; means of parts of a list need their "
        "weights");
  };
  judge(tame_lists(rng, 1, 1, 2), true);
  judge(lists_with_large_means(rng, {1000}), false);
  judge(lists_with_outliers(rng, 1), false);
  judge(lists_of_any_scale(rng), false);
}

CHECK_CASE("1.1 the mean of nothing is NaN", "[1.1][edge][points:1]") {
  const auto nothing = MEASURE(mean, {});
  expect_nan(nothing.call, nothing.value, "the mean of nothing is 0/0; " + because_undefined);
}

CHECK_CASE("1.1 the mean is finite wherever it is a double", "[1.1][edge][points:3]") {
  const double huge = uniform(rng, 1.6e308, 1.79e308);
  std::vector<Values> lists{{1e308, 1e308},
                            {-huge, -huge},
                            {huge, huge, huge, huge, -huge, -huge},
                            {-huge, -huge, 0},
                            {0, huge, huge}};
  lists.push_back(uniform_values(rng, 1000, 1e308, 1.79e308));
  for (const std::uint64_t n : domain::sizes(1025, rng)) {
    lists.emplace_back(n, n % 2 == 0 ? -largest_finite : largest_finite);
  }
  lists.emplace_back(1'300'000, huge);  // a sum of x 2^-20 overflows, too
  Values of_all_sizes;                  // ascending from 1e-300, and descending
  for (double exponent = -300; exponent < 300; exponent += 25) {
    of_all_sizes.push_back(std::pow(10, exponent + uniform(rng, 0, 8)));
  }
  of_all_sizes.insert(of_all_sizes.end(), {huge, huge});
  lists.push_back(of_all_sizes);
  lists.emplace_back(of_all_sizes.rbegin(), of_all_sizes.rend());
  Results means;
  for (const Values& x : lists) {
    Values smaller = x;  // scaled by 2^-24, which is exact: no sum overflows
    for (double& value : smaller) value *= 0x1p-24;
    // The last of 106 bits may exceed the largest double.
    const double exact = std::clamp(static_cast<double>(exact_mean(smaller)) * 0x1p24,
                                    -largest_finite, largest_finite);
    const auto got = MEASURE(mean, x);
    means.add_digits(got.call, got.value, exact, floor_of(static_cast<double>(x.size() + 20) * eps),
                     [=] { return overflows(x, exact); });
  }
  const auto both = MEASURE(mean, {huge, -huge, huge, -huge});
  means.add(both.call, both.value, 0, huge * 8 * eps, [=] {
    return overflows(Values{huge, -huge, huge, -huge}, 0);
  });
  const List tiny(uniform_values(rng, 100, 1e-300, 2e-300));
  const auto of_tiny = MEASURE(mean, tiny.x);
  means.add_digits(of_tiny.call, of_tiny.value, static_cast<double>(tiny.exact.mean),
                   floor_of(100 * eps),
                   [&] { return overflows(tiny.x, static_cast<double>(tiny.exact.mean)); });
  means.expect(
      "a mean lies between the smallest and the largest value, so it is finite",
      "a sum can overflow, and so can value - mean in a running mean: add value / count - mean / "
      "count; a float overflows at 3.4e38 already; means of parts of a list need their weights; a "
      "compensated sum that overflows is inf - inf");
}

CHECK_CASE("1.1 the mean of infinities and NaNs is not finite", "[1.1][edge][points:2]") {
  for (const Values& x : with_a_value_that_is_not_finite(rng)) {
    const auto got = MEASURE(mean, x);
    expect_not_finite(got.call, got.value, x);
  }
}

// What the cases above use ------------------------------------------------------------------------

/// The results of mistakes if a sum overflows.
std::vector<Suspect> overflows(std::span<const double> x, double exact) {
  const auto n = static_cast<double>(x.size());
  double sum = 0;
  for (const double value : x) sum += value;
  const bool is_below = sum < 0 && std::isinf(sum);
  return {
      {sum / n, "the sum overflows although the mean does not: then compute a running mean"_likely},
      {is_below ? sum : exact, "a sum can also overflow to -inf: test for both infinities"_likely}};
}

}  // namespace
}  // namespace mc::checks
