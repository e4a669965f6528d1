// Mistakes in task 2.7.
#include "independent.hpp"

#define irradiance_area right_irradiance_area
#define irradiance_hemisphere right_irradiance_hemisphere
#include "solutions/independent.cpp"
#undef irradiance_area
#undef irradiance_hemisphere

namespace mc {
namespace {

/// The mean over uniform points of the light of value(squared distance).
template <class Value>
Estimate from_points(const RectLight& light, std::uint64_t n, Rng& rng, Value value) {
  require_samples(n);
  Moments values;
  for (std::uint64_t i = 0; i < n; ++i) {
    const double x = light.x0 + (light.x1 - light.x0) * to_unit(rng());
    const double y = light.y0 + (light.y1 - light.y0) * to_unit(rng());
    add(values, value(x * x + y * y + light.height * light.height));
  }
  return mean_of(values);
}

/// The mean over directions, given by their projection onto the ground: direction() returns its
/// radius and its angle. As if the density were cos / pi.
template <class Direction>
Estimate from_directions(const RectLight& light, std::uint64_t n, Direction direction) {
  require_samples(n);
  Moments values;
  for (std::uint64_t i = 0; i < n; ++i) {
    const auto [radius, angle] = direction();
    const double scale = light.height / std::sqrt(1 - radius * radius);
    const double x = radius * std::cos(angle) * scale;
    const double y = radius * std::sin(angle) * scale;
    const bool meets = light.x0 <= x && x <= light.x1 && light.y0 <= y && y <= light.y1;
    add(values, meets ? std::numbers::pi * light.radiance : 0);
  }
  return mean_of(values);
}

}  // namespace
}  // namespace mc

// mistake: uses one number for both coordinates of a point on the light
// hint: new and different random numbers for x and y
namespace mc::diagonal_of_the_light {
Estimate irradiance_area(const RectLight& light, std::uint64_t n, Rng& rng) {
  require_samples(n);
  const double width = light.x1 - light.x0, depth = light.y1 - light.y0;
  Moments values;
  for (std::uint64_t i = 0; i < n; ++i) {
    const double u = to_unit(rng());
    const double x = light.x0 + width * u, y = light.y0 + depth * u;
    const double distance2 = x * x + y * y + light.height * light.height;
    const double cosines = light.height * light.height / distance2;
    add(values, width * depth * light.radiance * cosines / distance2);
  }
  return mean_of(values);
}
}  // namespace mc::diagonal_of_the_light

// mistake: divides by the distance, not by its square
// hint: the distance is not squared
// hint: all values are 0
namespace mc::distance_not_squared {
Estimate irradiance_area(const RectLight& light, std::uint64_t n, Rng& rng) {
  return from_points(light, n, rng, [&](double distance2) {
    const double cosines = light.height * light.height / distance2;
    return area(light) * light.radiance * cosines / std::sqrt(distance2);
  });
}
}  // namespace mc::distance_not_squared

// mistake: draws directions over half of the azimuth only
// hint: radius sqrt(u), angle 2 pi v
namespace mc::half_the_sky {
Estimate irradiance_hemisphere(const RectLight& light, std::uint64_t n, Rng& rng) {
  return from_directions(light, n, [&] {
    const double u = to_unit(rng());
    return std::pair(std::sqrt(u), std::numbers::pi * to_unit(rng()));
  });
}
}  // namespace mc::half_the_sky

// mistake: draws the azimuth in degrees, which has 57.3 turns
// hint: radius sqrt(u), angle 2 pi v
namespace mc::azimuth_in_degrees {
Estimate irradiance_hemisphere(const RectLight& light, std::uint64_t n, Rng& rng) {
  return from_directions(light, n, [&] {
    const double u = to_unit(rng());
    return std::pair(std::sqrt(u), 360 * to_unit(rng()));
  });
}
}  // namespace mc::azimuth_in_degrees

// mistake: omits the area of the light
// hint: the area is missing
// hint: times as large as they should be
namespace mc::no_area {
Estimate irradiance_area(const RectLight& light, std::uint64_t n, Rng& rng) {
  return from_points(light, n, rng, [&](double distance2) {
    const double cosines = light.height * light.height / distance2;
    return light.radiance * cosines / distance2;
  });
}
}  // namespace mc::no_area

// mistake: omits the cosine at the light
// hint: a cosine is missing: the light is also seen at an angle
namespace mc::no_cosine_at_the_light {
Estimate irradiance_area(const RectLight& light, std::uint64_t n, Rng& rng) {
  return from_points(light, n, rng, [&](double distance2) {
    const double cosine = light.height / std::sqrt(distance2);
    return area(light) * light.radiance * cosine / distance2;
  });
}
}  // namespace mc::no_cosine_at_the_light

// mistake: uses u as the radius of a point in the disk, not its square root
// hint: radius sqrt(u), angle 2 pi v
namespace mc::radius_not_rooted {
Estimate irradiance_hemisphere(const RectLight& light, std::uint64_t n, Rng& rng) {
  return from_directions(light, n, [&] {
    const double u = to_unit(rng());
    return std::pair(u, 2 * std::numbers::pi * to_unit(rng()));
  });
}
}  // namespace mc::radius_not_rooted

// mistake: uses one number for radius and angle of a direction
// hint: from two numbers
namespace mc::spiral_of_directions {
Estimate irradiance_hemisphere(const RectLight& light, std::uint64_t n, Rng& rng) {
  return from_directions(light, n, [&] {
    const double u = to_unit(rng());
    return std::pair(std::sqrt(u), 2 * std::numbers::pi * u);
  });
}
}  // namespace mc::spiral_of_directions

// mistake: returns s as the error, in both ways
// hint: this is s, not s / sqrt(n)
namespace mc::spread_of_the_light {
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
}  // namespace mc::spread_of_the_light

// mistake: draws directions uniformly, and weights them as if their density were cos / pi
// hint: these directions are uniform on the hemisphere
namespace mc::uniform_directions {
Estimate irradiance_hemisphere(const RectLight& light, std::uint64_t n, Rng& rng) {
  return from_directions(light, n, [&] {
    const double cosine = 1 - to_unit(rng());
    return std::pair(std::sqrt(1 - cosine * cosine), 2 * std::numbers::pi * to_unit(rng()));
  });
}
}  // namespace mc::uniform_directions

// mistake: uses the cosine toward the center of the light for all its points
// hint: the distance and both cosines are those of this point
namespace mc::cosine_of_the_center {
Estimate irradiance_area(const RectLight& light, std::uint64_t n, Rng& rng) {
  const double x = (light.x0 + light.x1) / 2, y = (light.y0 + light.y1) / 2, h = light.height;
  return from_points(light, n, rng, [&](double distance2) {
    return area(light) * light.radiance * h * h / (x * x + y * y + h * h) / distance2;
  });
}
}  // namespace mc::cosine_of_the_center

// mistake: multiplies n by n - 1 in 32 bits
// hint: count in 64 bits
namespace mc::area_counts_in_32_bits {
Estimate irradiance_area(const RectLight& light, std::uint64_t n, Rng& rng) {
  Estimate estimate = right_irradiance_area(light, n, rng);
  const auto count = static_cast<std::uint32_t>(n);
  estimate.standard_error *=
      std::sqrt(static_cast<double>(n) * static_cast<double>(n - 1) / (count * (count - 1)));
  return estimate;
}
}  // namespace mc::area_counts_in_32_bits
