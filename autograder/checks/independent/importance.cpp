// 2.4: importance sampling. As in 2.2, each estimate is judged by its own evaluations: the point
// that the density returned for each u, and the values of g and the density there.

#include "checks/independent/functions.hpp"

namespace mc::checks {
namespace {

using experiments::ImportanceTraces;
using experiments::Sampling;

/// An estimate and its evaluations; `weights` has the values g / p, 0 where p is 0 or infinite.
struct WeightTrace {
  Trace weights;
  ImportanceTraces seen;
};

WeightTrace weighted(const Function& g, const Sampling& p, std::uint64_t n, Rng& rng);

struct Case {
  Function g;
  Sampling p;
  std::uint64_t n;
};

/// Estimates are the means of their weights; standard errors follow from the weights, too.
void judge_weights(const std::vector<Case>& cases, Rng& rng);

/// The u of n samples.
Construction u_of(const Sampling& p, std::uint64_t n, Rng& rng);

CHECK_CASE("2.4 the mean of g over p at samples of p", "[2.4][points:6][needs:2.1][main]") {
  std::vector<Case> cases;
  for (const std::uint64_t n : domain::sizes(4097, rng)) {
    if (n > 1) cases.push_back({fresh(exponential, rng), {by_line, uniform(rng, -0.9, 0.9)}, n});
  }
  cases.push_back({fresh(exponential, rng), {by_line, 0.2}, 65'539});  // n^2 exceeds 32 bits
  judge_weights(cases, rng);
  expect_random_samples(u_of({by_line, 0.5}, 200, rng), 1, 16, rng);
}

CHECK_CASE("2.4 one sample has no standard error", "[2.4][points:1][edge][needs:2.1]") {
  judge_weights({{fresh(exponential, rng), {by_line, uniform(rng, -0.9, 0.9)}, 1}}, rng);
}

CHECK_CASE("2.4 weights of any size and either sign", "[2.4][points:3][needs:2.1][needs:2.3]") {
  // x exp(-x) with a density r exp(-r x), r > 2: a correct estimator with an infinite variance.
  // Some of 20,000 weights are more than a hundred times the mean.
  std::vector<Case> cases{
      {{gamma, 0, uniform(rng, 1e3, 1e4), 0}, {by_exponential, uniform(rng, 3, 5)}, 20000},
      {{normal, 0, uniform(rng, 0.5, 4), 0}, {by_power, uniform(rng, -0.5, 1)}, 1000},
      {{power, uniform(rng, 0.8, 1.5), uniform(rng, 0.5, 4), 0}, {by_power, -0.3}, 1000}};
  judge_weights(cases, rng);
  // Densities that are tiny or huge wherever they are not 0.
  cases.clear();
  for (const double exponent : {-14.0, 14.0, -100.0, 100.0}) {
    const double rate = std::pow(10, exponent + uniform(rng, -1, 1));
    const double end = uniform(rng, 0.5, 1) / rate;
    cases.push_back({{step, end, uniform(rng, 0.5, 4), 0}, {by_exponential, rate}, 1000});
  }
  const double least = uniform(rng, 1, 9) * 1e-283;  // p is above 1e-300 even for the largest u
  cases.push_back({{step, 1 / least, least, 0}, {by_exponential, least}, 1000});
  judge_weights(cases, rng);
  for (const double odd_one : {nan, infinity, -infinity}) {
    const Function g{exponential, 0, 1, odd_one};
    expect_not_finite(MEASURE(importance_estimates, g, {by_line, 0.5}, 9, rng(), 1));
  }
}

CHECK_CASE("2.4 points without a usable density add nothing", "[2.4][points:2][needs:2.1]") {
  std::vector<Case> cases;
  for (const std::uint64_t n : {1000u, 100u, 4097u}) {
    cases.push_back({fresh(exponential, rng), {by_holes, uniform(rng, 0.2, 0.6)}, n});
  }
  // g is infinite below 0.49, too, where the density is 0 or infinite.
  cases.push_back({{power, -1000, 1e-200, 0}, {by_holes, 0.6}, 1000});
  judge_weights(cases, rng);
}

CHECK_CASE("2.4 the u are uniform and independent", "[2.4][points:2][needs:2.1]") {
  expect_random_samples(u_of({by_line, -0.7}, 20'000, rng), 1, 53, rng);
  expect_random_calls(u_of({by_uniform, 0}, 16, rng), 300, rng);
  judge_period(rng(), [g = fresh(exponential, rng)](std::uint64_t n, std::uint64_t seed) {
    return MEASURE(importance_estimates, g, {by_line, -0.7}, n, seed, 1);
  });
}

CHECK_CASE("2.4 the right density cures an infinite variance",
           "[2.4][points:3][needs:2.1][needs:2.3]") {
  // g = x^-0.75 has the mean 4 and an infinite variance. With p proportional to g every weight is
  // 4, a quotient of two powers of x with a few rounding errors; there are 100 values.
  Results results;
  for (int i = 0; i < 20; ++i) {
    const Function g{power, -0.75, uniform(rng, 0.5, 4), 0};
    const auto [call, estimate, weights, points] = weighted(g, {by_power, -0.75}, 100, rng).weights;
    const double tolerance = 100 * 10 * eps * 4 * g.scale;
    results.add(call + ".value", estimate.value, 4 * g.scale, tolerance);
    results.add(call + ".standard_error", estimate.standard_error, 0, tolerance);
  }
  results.expect(
      "x^-0.75 divided by its density is 4 for every x, up to a few rounding errors",
      "the mean of g(x) / p(x), x = p.sample(u); equal values have the standard error 0");
}

// What the cases above use ------------------------------------------------------------------------

bool is_usable(double density) {
  return density > 0 && std::isfinite(density);
}

WeightTrace weighted(const Function& g, const Sampling& p, std::uint64_t n, Rng& rng) {
  const auto measured = MEASURE(importance_traces, g, p, n, rng(), 1);
  expect_that(measured.if_exactly({1, 0, 0, 0, 0}, any_number) == nullptr,
              measured.call + " never called p.sample()", fmt::format("{} samples", n),
              "the points are distributed as p", "x = p.sample(u), with a new uniform u each time");
  const auto& seen = measured.list_by_list(
      {{1, any_number}, {n, unit}, {n, any_number}, {n, any_number}, {n, any_number}});
  const auto& one = seen.estimates[0];
  Values weights;
  for (std::size_t i = 0; i < n; ++i) {
    weights.push_back(is_usable(seen.densities[i]) ? seen.values[i] / seen.densities[i] : 0);
  }
  const auto usable = static_cast<std::uint64_t>(std::ranges::count_if(seen.densities, is_usable));
  expect_that(one.evaluations >= usable && one.evaluations <= n && one.n == n,
              fmt::format("{} evaluated g {} times and returned n = {}", measured.call,
                          one.evaluations, one.n),
              fmt::format("{} evaluations and n = {}", usable, n), "the caller asked for n samples",
              "evaluate g once for each sample (a tiny or huge density is valid), and count every "
              "sample, including those of weight 0");
  return {{measured.call, {one.value, one.standard_error, one.n}, weights, {}}, seen};
}

std::vector<Suspect> weight_suspects(const WeightTrace& all, const Sampling& p) {
  const Values &w = all.weights.values, &of_g = all.seen.values, &of_p = all.seen.densities;
  const std::size_t n = w.size();
  const auto pdf = [p](double x) {
    const double q = p.parameter;
    return p.p == by_power         ? (q + 1) * std::pow(x, q)
           : p.p == by_exponential ? q * std::exp(-q * x)
           : p.p == by_line        ? 1 + q * (2 * x - 1)
                                   : 1;
  };
  const auto of = [n](auto value) {
    double sum = 0;
    for (std::size_t i = 0; i < n; ++i) sum += value(i);
    return sum / static_cast<double>(n);
  };
  std::vector<Suspect> suspects{
      {of([&](auto i) { return of_g[i]; }),
       "this is the mean of g: divide each value by p, because more points lie "
       "where p is large"_likely},
      {of([&](auto i) { return w[i]; }) / of([&](auto i) { return 1 / of_p[i]; }),
       "this divides by the sum of the weights 1 / p: p is normalized, so divide by n"_likely},
      {of([&](auto i) { return is_usable(of_p[i]) ? w[i] : nan; }),
       "where the pdf is 0 or infinite, add 0, not a NaN such as inf / inf"_likely},
      {of([&](auto i) { return of_g[i] / pdf(all.seen.u[i]); }),
       "this divides by p(u): divide by p(x)"_likely}};
  for (const double most : {1.0, 10.0, 100.0, 1000.0}) {
    suspects.push_back(
        {of([&](auto i) { return std::clamp(w[i], -most, most); }),
         likely("weights beyond {} are clamped, which makes the estimate biased", most)});
  }
  return suspects;
}

void judge_weights(const std::vector<Case>& cases, Rng& rng) {
  Results means;
  Results errors;
  for (const auto& [g, p, n] : cases) {
    const WeightTrace seen = weighted(g, p, n, rng);
    add_mean(means, seen.weights, [=, p = p] { return weight_suspects(seen, p); });
    add_error(errors, seen.weights, [=]() -> std::vector<Suspect> {
      const auto of_g = exact_moments(seen.seen.values);
      return {{std::sqrt(of_g.variance / of_g.count),
               "this is the standard error of g's values: the estimate is a mean of g / p"_likely}};
    });
  }
  judge_means(means, "values of g / p, where p is 0 or infinite 0");
  judge_errors(errors);
}

Construction u_of(const Sampling& p, std::uint64_t n, Rng& rng) {
  const Function g = fresh(exponential, rng);
  return {numbers_in_turn("the u of 2.4"), [=](std::uint64_t seed, std::uint64_t calls) {
            const auto got = MEASURE(importance_traces, g, p, n, seed, calls);
            std::vector<ListSpec> lists(5, {calls * n, any_number});
            lists[0].count = calls;
            lists[1].range = unit;
            return Uniforms{got.call, n, got.list_by_list(lists).u};
          }};
}

}  // namespace
}  // namespace mc::checks
