// Mistakes in task 2.6.
#include "independent.hpp"

#define samples_for right_samples_for
#include "solutions/independent.cpp"
#undef samples_for

namespace mc {
namespace {

/// n (standard error / target)^2, if the arguments are valid.
double samples(const Estimate& pilot, double target_error) {
  right_samples_for(pilot, target_error);  // for what it refuses
  const double ratio = pilot.standard_error / target_error;
  return static_cast<double>(pilot.n) * ratio * ratio;
}

std::uint64_t at_least_one(double n) {
  return std::max<std::uint64_t>(1, static_cast<std::uint64_t>(n));
}

}  // namespace
}  // namespace mc

// mistake: returns how many more samples are needed, not how many in all
// hint: the task asks for the total number, not for additional samples
namespace mc::counts_more_samples {
std::uint64_t samples_for(const Estimate& pilot, double target_error) {
  const double more = samples(pilot, target_error) - static_cast<double>(pilot.n);
  return at_least_one(std::max(0.0, std::ceil(more)));
}
}  // namespace mc::counts_more_samples

// mistake: scales the number of samples by the ratio of the errors, not by its square
// hint: square the ratio
namespace mc::error_falls_as_one_over_n {
std::uint64_t samples_for(const Estimate& pilot, double target_error) {
  right_samples_for(pilot, target_error);  // for what it refuses
  const double ratio = pilot.standard_error / target_error;
  return at_least_one(std::ceil(static_cast<double>(pilot.n) * ratio));
}
}  // namespace mc::error_falls_as_one_over_n

// mistake: rounds the number of samples down
// hint: this is slightly too few: round up
namespace mc::rounds_down {
std::uint64_t samples_for(const Estimate& pilot, double target_error) {
  return at_least_one(samples(pilot, target_error));
}
}  // namespace mc::rounds_down

// mistake: rounds the number of samples to the nearest integer
// hint: this is slightly too few: round up
namespace mc::rounds_to_nearest {
std::uint64_t samples_for(const Estimate& pilot, double target_error) {
  return at_least_one(std::round(samples(pilot, target_error)));
}
}  // namespace mc::rounds_to_nearest

// mistake: converts the number of samples through a signed integer
// hint: rounded up
namespace mc::signed_count {
std::uint64_t samples_for(const Estimate& pilot, double target_error) {
  const double n = std::min(std::ceil(samples(pilot, target_error)), 0x1.fffffffffffffp62);
  return static_cast<std::uint64_t>(std::max<std::int64_t>(1, static_cast<std::int64_t>(n)));
}
}  // namespace mc::signed_count
