// mistake: both ways give s as their error
// caught by: 2.7 both estimates
// hint: s instead of s / sqrt(n)
#include "independent.hpp"

#define irradiance_area right_irradiance_area
#define irradiance_hemisphere right_irradiance_hemisphere
#include "solutions/independent.cpp"
#undef irradiance_area
#undef irradiance_hemisphere

namespace mc {

Estimate irradiance_area(const RectLight& light, std::uint64_t n, Rng& rng) {
  Estimate result = right_irradiance_area(light, n, rng);
  result.standard_error *= std::sqrt(static_cast<double>(n));
  return result;
}

Estimate irradiance_hemisphere(const RectLight& light, std::uint64_t n, Rng& rng) {
  Estimate result = right_irradiance_hemisphere(light, n, rng);
  result.standard_error *= std::sqrt(static_cast<double>(n));
  return result;
}

}  // namespace mc
