// mistake: forgets that a point of the light stands for all of its area
// caught by: 2.7 irradiance from points
// caught by: 2.7 both estimates
// hint: the area is missing
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
    add(values, light.radiance * cosines / distance2);
  }
  return mean_of(values);
}

}  // namespace mc
