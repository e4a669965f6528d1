// Mistakes in task 2.3.
#include "independent.hpp"

#define pdf_power right_pdf_power
#define pdf_exponential right_pdf_exponential
#define sample_exponential right_sample_exponential
#define sample_power right_sample_power
#include "solutions/independent.cpp"
#undef pdf_power
#undef pdf_exponential
#undef sample_exponential
#undef sample_power

// mistake: omits the factor a + 1 from the density of the power distribution
// hint: x^a alone gives 1 / (a + 1)
namespace mc::density_not_normalised {
double pdf_power(double x, double a) {
  require_power(a);
  return x < 0 || x > 1 ? 0 : std::pow(x, a);
}
}  // namespace mc::density_not_normalised

// mistake: gives the exponential a positive density below 0
// hint: the density is 0 for x < 0
namespace mc::density_outside {
double pdf_exponential(double x, double rate) {
  require_rate(rate);
  return rate * std::exp(-rate * x);
}
}  // namespace mc::density_outside

// mistake: computes -log(1 - u) / rate, where 1 - u loses the digits of a small u
// hint: 1 - u loses the last digits of a small u
namespace mc::forgets_small_u {
double sample_exponential(double u, double rate) {
  require_rate(rate);
  return -std::log(1 - u) / rate;
}
}  // namespace mc::forgets_small_u

// mistake: computes -log(u) / rate: correctly distributed, but decreasing, and infinite at u = 0
// hint: it decreases in u, and is infinite at u = 0
namespace mc::log_of_zero {
double sample_exponential(double u, double rate) {
  require_rate(rate);
  return -std::log(u) / rate;
}
}  // namespace mc::log_of_zero

// mistake: computes -log(u) / rate, with a guard for u = 0
// hint: this is -log(u) / rate: it decreases in u
namespace mc::log_with_a_guard {
double sample_exponential(double u, double rate) {
  require_rate(rate);
  return -std::log(std::max(u, 1e-12)) / rate;
}
}  // namespace mc::log_with_a_guard

// mistake: throws std::domain_error
// hint: threw
namespace mc::other_exception {
double sample_exponential(double u, double rate) {
  if (!(rate > 0)) throw std::domain_error("rate");
  return right_sample_exponential(u, rate);
}
}  // namespace mc::other_exception

// mistake: takes the a-th root instead of the (a + 1)-th
// hint: integrating x^a raises the exponent
namespace mc::root_of_a {
double sample_power(double u, double a) {
  require_power(a);
  return std::pow(u, 1 / a);
}
}  // namespace mc::root_of_a

// mistake: multiplies by the rate instead of dividing
// hint: divide by the rate
namespace mc::times_the_rate {
double sample_exponential(double u, double rate) {
  require_rate(rate);
  return -std::log1p(-u) * rate;
}
}  // namespace mc::times_the_rate

// mistake: treats an exponent near 0 as 0
// hint: solve x^(a+1) = u for x
namespace mc::small_exponent_is_zero {
double sample_power(double u, double a) {
  return std::abs(a) < 1e-3 ? u : right_sample_power(u, a);
}
}  // namespace mc::small_exponent_is_zero
