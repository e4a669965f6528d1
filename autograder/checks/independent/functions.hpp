#pragma once
// The integrands and densities of experiments.hpp, as the checks of lab 2 know them; and the
// random numbers that a submission uses.

#include "2-independent/experiments.hpp"
#include "checks/support/checks.hpp"

namespace mc::checks {

using Values = std::vector<double>;
using experiments::Function;

inline constexpr double eps = std::numeric_limits<double>::epsilon();
inline constexpr double denormal = std::numeric_limits<double>::denorm_min();
inline constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Of each random test. There are 47 of them in this lab, so their sum is 4.7e-7.
inline constexpr double alpha = 1e-8;

/// Function::g
enum : unsigned { constant, exponential, product, step, power, peak, normal, gamma, five };

/// Sampling::p
enum : unsigned { by_uniform, by_power, by_exponential, by_holes };

inline std::size_t dims_of(const Function& g) {
  return g.g == product || g.g == peak ? 2 : g.g == five ? 5 : 1;
}

/// g with a scale and an offset that are not known beforehand.
inline Function fresh(unsigned g, Rng& rng, double parameter = 0) {
  return {g, parameter, uniform(rng, 0.5, 4), uniform(rng, -3, 3)};
}

/// The values of estimates, one after the other: each finite.
inline Values values_of(const std::string& call, const std::vector<Estimate>& estimates) {
  Values all;
  for (const Estimate& one : estimates) all.push_back(one.value);
  if (const auto what = list_failure("value", all, {all.size(), finite})) {
    refuse(call, *what);
  }
  return all;
}

/// An estimate of a g that is infinite or NaN everywhere.
inline void expect_not_finite(const Measured<std::vector<experiments::CountedEstimate>>& got) {
  expect_not_finite(got.call, got.exactly(1, any_number)[0].value,
                    "g is infinite or NaN: a finite estimate hides it",
                    "use values of g unchanged");
}

/// The random numbers of `calls` calls for n samples each, one after the other from one generator,
/// `dims` for each sample.
struct Numbers {
  std::string words;  ///< "the points of 2.2"
  std::size_t dims;
  std::function<Uniforms(std::uint64_t n, std::uint64_t seed, std::uint64_t calls)> ask;
  std::string same = {};  ///< the hint if two numbers of a sample are equal
};

/// The numbers of one call are random, to `bits` bits; and those of another seed are others.
inline void judge_one_call(const Numbers& numbers, std::uint64_t n, int bits, Rng& rng) {
  Uniforms one = numbers.ask(n, rng(), 1), other = numbers.ask(n, rng(), 1);
  one.positions = other.positions = numbers.dims;
  one.bits = other.bits = bits;
  expect_independent_uniforms(
      one, {numbers.words + ", of one call", alpha,
            "each is to_unit() of its own word, with all of its 53 bits: none is used twice, "
            "and none is a mirror image of another",
            "take new numbers from rng inside the loop, for each sample", numbers.same});
  Uniforms both = side_by_side(one, other);
  both.name = [dims = numbers.dims](std::size_t position) {
    return fmt::format("number {} of a sample from {}", position % dims,
                       position < dims ? "one seed" : "another");
  };
  const std::string from_rng = "take the numbers from rng, and from nowhere else";
  expect_independent_uniforms(
      both, {numbers.words + ", from two seeds", alpha,
             "numbers of one seed resemble those of another", from_rng, from_rng});
}

/// So are those of many calls for few samples, one after the other.
inline void judge_calls_in_turn(const Numbers& numbers, std::uint64_t n, std::uint64_t calls,
                                Rng& rng) {
  Uniforms all = numbers.ask(n, rng(), calls);
  all.positions = numbers.dims * n;
  expect_independent_uniforms(
      all, {numbers.words + ", of calls in turn", alpha,
            "do two calls begin in the same place? Each goes on where the generator was left",
            "the generator must move on: is it copied somewhere?",
            "each sample takes new numbers from rng"});
}

// An estimate is judged by what it saw: the points and values of the very evaluations that it made
// say, to the last digits, what it must come to. So nothing but evaluating g at random points gives
// the right answer: that the estimate is unbiased, and has the variance sigma^2 / n, follows.

/// An estimate, and what it is the mean of.
struct Traced {
  std::string call;
  Estimate estimate;
  Values values, points;
};

/// Of n samples of g. Ends the check where g was not evaluated n times: or once more or once less,
/// which the check that counts evaluations has a word for.
Traced traced(const Function& g, std::uint64_t n, Rng& rng);

/// Estimates are the means of their values, but for what n additions lose: `suspects` are those of
/// one task alone.
void add_mean(Results& means, const Traced& seen, Results::FindSuspects suspects = {});
void judge_means(Results& means);

/// Standard errors are s / sqrt(n) of the values, with the digits that a one-pass variance keeps;
/// NaN for one value.
void add_error(Results& errors, const Traced& seen, Results::FindSuspects suspects = {});
void judge_errors(Results& errors);

}  // namespace mc::checks
