#pragma once
// An estimate is judged by what it saw: the points and values of the very evaluations that it made
// say, to the last digits, what it must come to. So nothing but evaluating g at random points gives
// the right answer.

#include <span>
#include <string>

#include "checks/independent/functions.hpp"
#include "checks/support/expect.hpp"
#include "checks/support/measure.hpp"

namespace mc::checks {

/// Replicates of an estimator, and what each of them saw. Points lie in the cube, values are
/// finite, and no point is one that was there before, or that another seed has.
class Traced {
 public:
  /// Asks for them. Ends the check where g was not evaluated n times for each: or once more or once
  /// less, which the check that counts evaluations has a word for.
  Traced(const Function& g, std::uint64_t n, Rng& rng, std::uint64_t replicates = 1);

  const std::string& call() const { return measured_.call; }
  std::size_t evaluations() const { return evaluations_; }  ///< for each estimate
  const std::vector<Estimate>& estimates() const { return traces_->estimates; }
  const Values& points() const { return traces_->points; }  ///< of all replicates
  const Values& values() const { return traces_->values; }
  std::span<const double> values_of(std::size_t replicate) const {
    return std::span(values()).subspan(replicate * evaluations_, evaluations_);
  }

 private:
  Measured<experiments::Traces> measured_;
  const experiments::Traces* traces_ = nullptr;
  std::size_t evaluations_ = 0;
};

/// `value` is the mean of these values, but for what n additions lose.
void expect_mean_of(const std::string& call, double value, std::span<const double> values,
                    const std::vector<Suspect>& suspects = {});

/// `standard_error` is s / sqrt(n) of these values, with the digits that a one-pass variance keeps.
void expect_standard_error(const std::string& call, double standard_error,
                           std::span<const double> values,
                           const std::vector<Suspect>& suspects = {});

/// Numbers that have to be random ones: `most` at the most were there before.
void expect_distinct(const std::string& call, const std::string& what, Values numbers, double most,
                     const std::string& hint);

/// The same of two generators: at least half of the numbers are others.
void expect_nothing_in_common(const std::string& call, const std::string& what, Values numbers,
                              Values of_another_seed);

/// Estimates of a smooth integrand, one after the other from one generator, all differ.
void expect_new_numbers(const std::string& call, const Values& estimates);

}  // namespace mc::checks
