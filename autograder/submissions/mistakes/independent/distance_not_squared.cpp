// mistake: divides by the distance, not by its square
// caught by: 2.7 irradiance from points
// caught by: 2.7 both estimates
// hint: the distance is not squared
#include "independent.hpp"

#define irradiance_area right_irradiance_area
#include "solutions/independent.cpp"
#undef irradiance_area

namespace mc {

Estimate irradiance_area(const RectLight& light, std::uint64_t n, Rng& rng) {
  require_samples(n);
  const double width = light.x1 - light.x0, depth = light.y1 - light.y0;
  Moments values;
  for (std::uint64_t i = 0; i < n; ++i) {
    const double x = light.x0 + width * to_unit(rng());
    const double y = light.y0 + depth * to_unit(rng());
    const double distance2 = x * x + y * y + light.height * light.height;
    const double cosines = light.height * light.height / distance2;
    add(values, width * depth * light.radiance * cosines / std::sqrt(distance2));
  }
  return mean_of(values);
}

}  // namespace mc
