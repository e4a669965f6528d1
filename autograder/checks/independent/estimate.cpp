// 2.2: an estimate, judged by the points and values of its evaluations.

#include "checks/independent/functions.hpp"

namespace mc::checks {
namespace {

/// The coordinates of n points at which a random integrand is evaluated.
Construction points_of(unsigned g, std::uint64_t n, Rng& rng);

CHECK_CASE("2.2 the estimate is the mean of its values", "[2.2][points:4][needs:2.1][main]") {
  Results means;
  for_all_sizes(1, {normal, exponential, product, five}, rng,
                [&](std::uint64_t, const Trace& seen) { add_mean(means, seen); });
  add_mean(means, traced(fresh(many, rng), 100, rng));  // more coordinates than a fixed array has
  judge_means(means, "values of g");
  for (const double odd_one : {nan, infinity, -infinity}) {
    const Function g{exponential, 0, 1, odd_one};
    expect_not_finite(MEASURE(estimates, g, 9, rng(), 1));
  }
  // A coarse test of randomness; another check tests independence.
  expect_random_samples(points_of(exponential, 200, rng), 1, 16, rng);
}

CHECK_CASE("2.2 exactly n evaluations inside the unit cube", "[2.2][points:5][needs:2.1]") {
  for_all_sizes(
      1, {exponential, product, five, constant}, rng, [](std::uint64_t n, const Trace& seen) {
        expect_equal(seen.call + ": evaluations of g", seen.values.size(), n,
                     "the caller asked for n evaluations",
                     "if one is missing, the loop may begin at 1; if there is one too many, it may "
                     "end at i <= n");
        expect_equal(seen.call + ": n", seen.estimate.n, n,
                     "the n of an Estimate counts evaluations", "count every sample once");
      });
}

CHECK_CASE("2.2 the standard error is s over root n", "[2.2][points:5][needs:2.1]") {
  Results errors, far;
  for_all_sizes(2, {normal, exponential, product, five}, rng,
                [&](std::uint64_t, const Trace& seen) { add_error(errors, seen); });
  judge_errors(errors);
  for (const std::uint64_t n : {1000u, 10u}) {
    Function g = fresh(exponential, rng);
    g.offset = uniform(rng, 1e9, 2e9);
    add_error(far, traced(g, n, rng));
  }
  judge_errors(far);
}

CHECK_CASE("2.2 a constant has the standard error 0", "[2.2][points:1][needs:2.1]") {
  const std::uint64_t n = 1000;
  std::vector<Function> constants;
  for (int i = 0; i < 50; ++i) constants.push_back({constant, 0, uniform(rng, 0.1, 1e6), 0});
  const auto got = MEASURE(estimates_in_turn, constants, n, domain::seeds(rng, 50));
  const auto& estimates = got.exactly(50, any_number);
  Results errors;
  for (std::size_t i = 0; i < 50; ++i) {
    errors.add(fmt::format("{}[{}].standard_error", got.call, i), estimates[i].standard_error, 0,
               std::sqrt(static_cast<double>(n)) * eps * constants[i].scale);
  }
  errors.expect(
      "a constant has variance 0, and lab 1's algorithms compute at most (n eps c)^2",
      "do not use E{X^2} - E{X}^2: it is larger here, or negative, without a square root");
}

CHECK_CASE("2.2 one sample has no standard error", "[2.2][points:1][edge][needs:2.1]") {
  Results errors;
  add_error(errors, traced(fresh(product, rng), 1, rng));
  judge_errors(errors);
}

CHECK_CASE("2.2 the points are uniform and independent", "[2.2][points:8][needs:2.1]") {
  expect_random_samples(points_of(product, 20'000, rng), 2, 53, rng);
  expect_random_calls(points_of(five, 3, rng), 1000, rng);
  expect_random_calls(points_of(exponential, 33, rng), 300, rng);
  // With only a million different streams, one would occur twice here.
  expect_random_calls(points_of(exponential, 1, rng), 10'000, rng);
  judge_period(rng(), [g = fresh(exponential, rng)](std::uint64_t n, std::uint64_t seed) {
    return MEASURE(estimates, g, n, seed, 1);
  });
}

// What the cases above use ------------------------------------------------------------------------

Construction points_of(unsigned g, std::uint64_t n, Rng& rng) {
  const Function function = fresh(g, rng);
  const std::size_t dims = dims_of(function);
  Randomness claim = numbers_in_turn("the points of 2.2");
  claim.same =
      "draw a number for each dimension: with one number for both, the points lie on a line"_likely;
  return {claim, [=](std::uint64_t seed, std::uint64_t calls) {
            const auto got = MEASURE(traces, function, n, seed, calls);
            const auto& seen = got.list_by_list(
                {{calls, any_number}, {calls * n * dims, unit}, {calls * n, any_number}});
            return Uniforms{got.call, n * dims, seen.points};
          }};
}

}  // namespace
}  // namespace mc::checks
