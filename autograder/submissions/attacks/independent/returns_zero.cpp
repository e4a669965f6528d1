// attack: returns zero from every function: a check must not be content with what costs nothing
// says: an integer divided by an integer is an integer: 0
#include "independent.hpp"
namespace mc {
double to_unit(std::uint64_t) {
  return 0;
}
Estimate estimate(const Integrand&, std::uint64_t, Rng&) {
  return {};
}
double sample_exponential(double, double) {
  return 0;
}
double sample_power(double, double) {
  return 0;
}
double pdf_exponential(double, double) {
  return 0;
}
double pdf_power(double, double) {
  return 0;
}
Estimate estimate_importance(const Integrand&, const Density&, std::uint64_t, Rng&) {
  return {};
}
Interval confidence_interval(const Estimate&, double) {
  return {};
}
std::uint64_t samples_for(const Estimate&, double) {
  return 0;
}
Estimate irradiance_area(const RectLight&, std::uint64_t, Rng&) {
  return {};
}
Estimate irradiance_hemisphere(const RectLight&, std::uint64_t, Rng&) {
  return {};
}
void uniforms(Rng&, std::span<double> out) {
  for (double& u : out) u = 0;
}
}  // namespace mc
