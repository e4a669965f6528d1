// Task 2.4: importance sampling. As in 2.2, each estimate is judged by what it saw: the points that
// the density made of each u, and g and the density there.

#include <algorithm>
#include <cmath>
#include <functional>

#include <fmt/format.h>

#include "checks/independent/traces.hpp"
#include "checks/support/catch.hpp"
#include "checks/support/exact.hpp"
#include "checks/support/statistics.hpp"

namespace mc::checks {
namespace {

using experiments::Counted;
using experiments::ImportanceTraces;
using experiments::Sampling;

/// Replicates of an importance estimator, and what each of them saw. Every u lies in [0, 1), and is
/// none that was there before, or that another seed has.
class Weighed {
 public:
  Weighed(const Function& g, const Sampling& p, std::uint64_t n, Rng& rng,
          std::uint64_t replicates = 1)
      : measured_(MEASURE(importance_traces, g, p, n, rng(), replicates)) {
    const auto with = [&](std::size_t samples) {
      const std::size_t all = replicates * samples;
      return measured_.if_exactly({replicates, all, all, all, all}, any_number);
    };
    for (const std::size_t samples : {n, n + 1, n - 1}) {
      if (seen_ != nullptr || samples == 0) break;
      seen_ = with(samples);
      samples_ = samples;
    }
    if (seen_ == nullptr && with(0) != nullptr) {
      expect_that(false, call() + " never asked the density for a sample",
                  fmt::format("{} samples", n), "the points are distributed as p",
                  "x = p.sample(u), with a new uniform u each time");
    }
    const std::size_t due = replicates * n;
    if (seen_ == nullptr) seen_ = &measured_.exactly({replicates, due, due, due, due}, any_number);
    for (const double u : seen_->u) {
      if (u >= 0 && u < 1) continue;
      expect_that(false, fmt::format("{}: p.sample({})", call(), u), "u in [0, 1)", "",
                  "u is to_unit() of a word");
    }
    expect_distinct(call(), "u", seen_->u, static_cast<double>(seen_->u.size()) / 2,
                    "each sample takes a new u from rng, which moves on");
    const auto other = MEASURE(importance_traces, g, p, n, rng(), 1);
    const auto* const others =
        other.if_exactly({1, samples_, samples_, samples_, samples_}, any_number);
    expect_that(others != nullptr, other.call + " asked for another number of samples",
                fmt::format("{}, as with another seed", samples_), "n is what the caller pays for",
                "one sample for each of n");
    expect_nothing_in_common(call(), "u", seen_->u, others->u);
    for (std::size_t i = 0; i < seen_->u.size(); ++i) {
      const double density = seen_->densities[i];
      const bool counts = density > 0 && std::isfinite(density);
      weights_.push_back(counts ? seen_->values[i] / density : 0);
      usable_ += counts ? 1 : 0;
    }
  }

  const std::string& call() const { return measured_.call; }
  std::size_t samples() const { return samples_; }  ///< for each estimate
  const std::vector<Counted>& estimates() const { return seen_->estimates; }
  const ImportanceTraces& seen() const { return *seen_; }
  const Values& weights() const { return weights_; }  ///< g / p, 0 where p is 0 or infinite
  double usable() const { return usable_; }           ///< points at which p is neither

 private:
  Measured<ImportanceTraces> measured_;
  const ImportanceTraces* seen_ = nullptr;
  std::size_t samples_ = 0;
  Values weights_;
  double usable_ = 0;
};

double average(std::size_t n, const std::function<double(std::size_t)>& value) {
  double sum = 0;
  for (std::size_t i = 0; i < n; ++i) sum += value(i);
  return sum / static_cast<double>(n);
}

/// The only estimate of `seen` is the mean of its weights, with their standard error.
void expect_weighed(const Weighed& seen, std::vector<Suspect> suspects = {}) {
  const Values &w = seen.weights(), &g = seen.seen().values, &p = seen.seen().densities;
  const std::size_t n = w.size();
  const double inverse = average(n, [&](std::size_t i) { return 1 / p[i]; });
  const double mean = average(n, [&](std::size_t i) { return w[i]; });
  suspects.insert(
      suspects.end(),
      {{average(n, [&](std::size_t i) { return g[i]; }),
        "this is the mean of g: where p is large, points are many, so each counts 1 / p"},
       {average(n, [&](std::size_t i) { return g[i] * p[i]; }),
        "this is the mean of g p: divide by p"},
       {mean / inverse,
        "this divides by the sum of the weights 1 / p: p is normalised, so divide by n"},
       {average(n, [&](std::size_t i) { return std::max(w[i], 0.0); }),
        "weights below 0 count, too"},
       {average(n, [&](std::size_t i) { return std::abs(w[i]); }),
        "weights below 0 count as what they are, not by their size"}});
  for (const double most : {1.0, 10.0, 100.0, 1000.0}) {
    suspects.push_back(
        {average(n, [&](std::size_t i) { return std::clamp(w[i], -most, most); }),
         fmt::format("weights beyond {} are cut off: what they carry is then missing, on average",
                     most)});
  }
  const Counted& one = seen.estimates()[0];
  expect_mean_of(seen.call(), one.value, w, suspects);
  const auto of_g = exact_moments(g);
  const std::vector<Suspect> spreads{
      {std::sqrt(of_g.variance / of_g.count),
       "this is the standard error of g's values: the estimate is a mean of g / p"}};
  expect_standard_error(seen.call(), one.standard_error, w, spreads);
}

CHECK_CASE("2.4 the mean of g over p at samples of p", "[2.4][points:4][needs:2.1][main]") {
  Rng rng = check_rng();
  for (const std::uint64_t n : {1000u, 10u, 2u}) {
    const double a = uniform(rng, -0.6, 0.3);
    const Function g = fresh(exponential, rng);
    const Weighed seen(g, {by_power, a}, n, rng);
    const Counted& one = seen.estimates()[0];
    expect_that(seen.samples() == n && one.evaluations == n && one.n == n,
                fmt::format("{} drew {} samples, evaluated g {} times and says n = {}", seen.call(),
                            seen.samples(), one.evaluations, one.n),
                fmt::format("{0}, {0} and {0}", n), "n is what the caller pays for",
                "one point and one value of g for each sample");
    const Values &u = seen.seen().u, &x = seen.seen().points;
    const auto g_at = [&](double at) { return g.scale * std::exp(at) + g.offset; };
    const auto p_at = [&](double at) { return (a + 1) * std::pow(at, a); };
    expect_weighed(seen, {{average(n, [&](std::size_t i) { return g_at(x[i]) / p_at(u[i]); }),
                           "this divides by p at u: the density belongs to x"},
                          {average(n, [&](std::size_t i) { return g_at(u[i]) / p_at(x[i]); }),
                           "this is g at u over p at x: g, too, is evaluated at x"},
                          {average(n, [&](std::size_t i) { return g_at(u[i]) / p_at(u[i]); }),
                           "this is g / p at u: both are evaluated at x = p.sample(u)"}});
  }
}

CHECK_CASE("2.4 one sample has no standard error", "[2.4][points:1][edge][needs:2.1]") {
  Rng rng = check_rng();
  const Weighed one(fresh(exponential, rng), {by_power, uniform(rng, -0.6, 0.3)}, 1, rng);
  expect_nan(one.call() + ".standard_error", one.estimates()[0].standard_error,
             "one value says nothing about how values vary");
}

CHECK_CASE("2.4 no samples are refused", "[2.4][points:1][edge]") {
  expect_invalid_argument(
      MEASURE_OUTCOME(importance_estimates, {exponential, 0, 1, 0}, {by_uniform, 0}, 0, 1, 1), "",
      "the mean of nothing is no estimate");
}

CHECK_CASE("2.4 weights of any size and either sign", "[2.4][points:1][needs:2.1]") {
  Rng rng = check_rng();
  const std::uint64_t n = 1000;
  // x exp(-x) by a density with lighter tails, r exp(-r x) with r > 2: a right estimator, whose
  // weights grow without bound; the variance of g/p is infinite. What a run saw, it has to count.
  expect_weighed(
      Weighed({gamma, 0, uniform(rng, 1e3, 1e4), 0}, {by_exponential, uniform(rng, 3, 5)}, n, rng));
  // Densities that are tiny, or huge, wherever they are not 0.
  for (const double rate :
       {std::pow(10, uniform(rng, -15, -13)), std::pow(10, uniform(rng, 12, 15))}) {
    const double end = uniform(rng, 0.5, 1) / rate;
    expect_weighed(
        Weighed({step, end, uniform(rng, 0.5, 4), 0}, {by_exponential, rate}, n, rng),
        {{0, "every weight was taken for 0: a density may be tiny, or huge, and still count"}});
  }
  // Of both signs, with the mean 0.
  expect_weighed(
      Weighed({normal, 0, uniform(rng, 0.5, 4), 0}, {by_power, uniform(rng, -0.5, 1)}, n, rng));
}

CHECK_CASE("2.4 points without a usable density add nothing", "[2.4][points:1][needs:2.1]") {
  Rng rng = check_rng();
  const std::uint64_t n = 1000;
  const Weighed seen(fresh(exponential, rng), {by_holes, uniform(rng, 0.2, 0.6)}, n, rng);
  const Counted& one = seen.estimates()[0];
  const double sum = static_cast<double>(exact_mean(seen.weights())) * static_cast<double>(n);
  const std::string because =
      fmt::format("the pdf is 0 or infinite for {} of {} points, which add 0 to the sum",
                  static_cast<double>(n) - seen.usable(), n);
  const std::string for_nan = "0 · inf, or inf - inf: where the pdf is 0 or infinite, add 0";
  double sizes = 0;
  for (const double weight : seen.weights()) sizes += std::abs(weight);
  expect_that(one.n == n, fmt::format("{} says n = {}", seen.call(), one.n), fmt::format("{}", n),
              "a point that adds 0 was paid for all the same",
              "every sample counts, also one of weight 0");
  expect_within(seen.call() + ".value", one.value, sum / static_cast<double>(n), 10 * eps * sizes,
                because,
                {{{sum / seen.usable(), "divide by all n samples, not by those that counted"}},
                 "g / 0 is no weight: where the pdf is 0 or infinite, add 0",
                 for_nan});
  expect_standard_error(seen.call(), one.standard_error, seen.weights());
}

CHECK_CASE("2.4 the estimate is unbiased with the variance of g over p",
           "[2.4][points:3][needs:2.1]") {
  Rng rng = check_rng();
  const std::uint64_t n = 64, replicates = 400;
  const double scale = uniform(rng, 0.5, 4);

  // x^q by p = (a+1) x^a: weights w = x^(q-a) / (a+1), E{w^k} = (a+1)^(1-k) / (k (q-a) + a + 1).
  // They are bounded for q > a, so that their means are nearly Gaussian.
  const double q = uniform(rng, 0.8, 1.5), a = uniform(rng, -0.6, 0.3);
  const auto power_moment = [&](double k) {
    return std::pow(a + 1, 1 - k) / (k * (q - a) + a + 1);
  };
  // x exp(-x) by p = r exp(-r x): w = x exp(-(1-r) x) / r,
  // E{w^k} = r^(1-k) k! / (k (1-r) + r)^(k+1).
  const double r = uniform(rng, 0.3, 0.8);
  const auto gamma_moment = [&](double k) {
    return std::pow(r, 1 - k) * std::tgamma(k + 1) / std::pow(k * (1 - r) + r, k + 1);
  };
  struct Case {
    Function g;
    Sampling p;
    std::function<double(double)> moment;
    std::string name;
  };
  const Case cases[] = {{{power, q, scale, 0}, {by_power, a}, power_moment, "a power"},
                        {{gamma, 0, scale, 0}, {by_exponential, r}, gamma_moment, "x exp(-x)"}};
  for (const Case& one : cases) {
    const Weighed seen(one.g, one.p, n, rng, replicates);
    const Values values = values_of(seen.estimates());
    require_finite(seen.call(), values);
    const auto& m = one.moment;
    const Known known = mean_of(transformed(population(m(1), m(2), m(3), m(4)), one.g), n);
    expect_distribution(seen.call() + ", u", seen.seen().u, [](double u) { return u; },
                        {"the u for samples of " + one.name + " are uniform", alpha},
                        {{}, "x = p.sample(u), with a new uniform u each time"});
    expect_mean({seen.call(), values, n}, known.exact, known.variance,
                {"importance estimates of " + one.name + " have the mean of the integral", alpha},
                {{}, "the mean of g(x) / p(x), x = p.sample(u)"});
    expect_variance(
        {seen.call(), values, n}, known.exact, known.variance, known.kurtosis,
        {"importance estimates of " + one.name + " have the variance Var{g/p} / n", alpha},
        {{}, "n independent points from p"});
  }
}

CHECK_CASE("2.4 the right density cures an infinite variance", "[2.4][points:2][needs:2.1]") {
  Rng rng = check_rng();
  // g = x^-0.75 has the mean 4 and no variance. With p proportional to g every weight is 4.
  const std::uint64_t n = 100, replicates = 20;
  const Function g{power, -0.75, uniform(rng, 0.5, 4), 0};
  const Weighed seen(g, {by_power, -0.75}, n, rng, replicates);
  // A weight is the quotient of two powers of the same x: a few roundings of 4 each.
  const double tolerance = 100 * 10 * eps * 4 * g.scale;
  for (const Counted& one : seen.estimates()) {
    const std::string because =
        "x^-0.75 over its own density is 4 at every x, up to a few roundings of two powers";
    expect_within(seen.call() + ".value", one.value, 4 * g.scale, tolerance, because,
                  {{}, "the mean of g(x) / p(x), x = p.sample(u)"});
    expect_within(seen.call() + ".standard_error", one.standard_error, 0, tolerance, because,
                  {{}, "what has no spread has no standard error"});
  }
}

}  // namespace
}  // namespace mc::checks
