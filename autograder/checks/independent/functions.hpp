#pragma once
// Shared by the checks of lab 2: integrands, random numbers, and traces of estimates.

#include "2-independent/experiments.hpp"
#include "checks/support/constructions.hpp"

namespace mc::checks {

using experiments::Function;

inline constexpr double denormal = std::numeric_limits<double>::denorm_min();

/// The alpha of each of the 47 random tests of this lab; the sum is 4.7e-7.
inline constexpr double alpha = 1e-8;

inline const Likely from_rng = "take all random numbers from rng"_likely;
inline Randomness numbers_in_turn(const std::string& words) {
  return {.words = words,
          .alpha = alpha,
          .rule = "each call must continue where the last one left the generator",
          .repeated = "the generator must advance: do not use a copy of it"_likely};
}
inline const std::string no_mean = "there is no mean of 0 samples";

/// Function::g
enum : unsigned {
  constant,
  exponential,
  product,
  step,
  power,
  peak,
  normal,
  gamma,
  five,
  clamped,
  many
};

/// Sampling::p
enum : unsigned { by_uniform, by_power, by_exponential, by_holes, by_line };

inline std::size_t dims_of(const Function& g) {
  return experiments::dimensions.at(g.g);
}

/// g with a random scale and offset.
inline Function fresh(unsigned g, Rng& rng, double parameter = 0) {
  return {g, parameter, uniform(rng, 0.5, 4), uniform(rng, -3, 3)};
}

inline Values values_of(const std::string& call, const std::vector<Estimate>& estimates) {
  Values all;
  for (const Estimate& one : estimates) all.push_back(one.value);
  if (const auto what = list_failure("value", all, {all.size(), finite})) refuse(call, *what);
  return all;
}

/// The estimate of a g that is infinite or NaN everywhere is not finite.
inline void expect_not_finite(const Measured<std::vector<experiments::CountedEstimate>>& got) {
  expect_not_finite(got.call, got.exactly(1, any_number)[0].value,
                    "g is infinite or NaN: a finite estimate would hide it",
                    "use values of g unchanged");
}

/// Estimates from n and from 2n samples, with the same seed, differ: they are equal if the numbers
/// repeat after n samples. By chance they agree to 1e-11 once in 10^7 runs.
template <class Estimates>
void judge_period(std::uint64_t seed, Estimates estimates) {
  double before = nan;
  for (const std::uint64_t n : {1u << 16, 1u << 17, 1u << 18, 1u << 19}) {
    const auto got = estimates(n, seed);
    const double now = got.exactly(1, any_number)[0].value;
    expect_that(!(std::abs(now - before) <= 1e-11 * std::abs(before)),
                fmt::format("{} gave {}, as with half as many samples", got.call, now),
                "another estimate", "all samples are independent",
                "the random numbers repeat: take all of them from rng");
    before = now;
  }
}

// An estimate is compared with the points and values of its own evaluations, which determine it to
// the last digits. If the points are random, it is then unbiased and has the variance sigma^2 / n.

/// An estimate, and the points and values of its evaluations.
struct Trace {
  std::string call;
  Estimate estimate;
  Values values, points;
};

/// An estimate from n samples of g, with n evaluations (another check reports n ± 1 and 2 n).
Trace traced(const Function& g, std::uint64_t n, Rng& rng);

/// Passes a trace for each n of domain::sizes() from `least` on to `judge`, for each kind in turn.
template <class Judge>
void for_all_sizes(std::uint64_t least, const std::array<unsigned, 4>& kinds, Rng& rng,
                   Judge judge) {
  std::size_t next = 0;
  for (const std::uint64_t n : domain::sizes(65537, rng)) {
    if (n >= least) judge(n, traced(fresh(kinds[next++ % 4], rng), n, rng));
  }
}

/// Estimates are the means of their values `of` g or g / p, up to rounding errors of n additions.
void add_mean(Results& means, const Trace& seen, Results::FindSuspects suspects = {});
void judge_means(Results& means, const std::string& of);

/// Standard errors are s / sqrt(n), with the digits of a one-pass variance; NaN for one value.
void add_error(Results& errors, const Trace& seen, Results::FindSuspects suspects = {});
void judge_errors(Results& errors);

}  // namespace mc::checks
