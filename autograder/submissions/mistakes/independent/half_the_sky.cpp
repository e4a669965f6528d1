// mistake: directions go half way round only
// caught by: 2.7 irradiance from directions
// hint: radius sqrt(u), angle 2 pi v
#include "independent.hpp"

#define irradiance_hemisphere right_irradiance_hemisphere
#include "solutions/independent.cpp"
#undef irradiance_hemisphere

namespace mc {

Estimate irradiance_hemisphere(const RectLight& light, std::uint64_t n, Rng& rng) {
  require_samples(n);
  Moments values;
  for (std::uint64_t i = 0; i < n; ++i) {
    const double u = to_unit(rng());
    const double radius = std::sqrt(u), angle = std::numbers::pi * to_unit(rng());
    const double scale = light.height / std::sqrt(1 - radius * radius);
    const double x = radius * std::cos(angle) * scale;
    const double y = radius * std::sin(angle) * scale;
    const bool meets = light.x0 <= x && x <= light.x1 && light.y0 <= y && y <= light.y1;
    add(values, meets ? std::numbers::pi * light.radiance : 0);
  }
  return mean_of(values);
}

}  // namespace mc
