// Mistakes in task 2.9.
#include "independent.hpp"

#define irradiance_combined right_irradiance_combined
#include "solutions/independent.cpp"
#undef irradiance_combined

namespace mc {
namespace {

/// What a direction to a point of the light has: f, and the densities of both ways to sample it.
struct Seen {
  double f, p_area, p_hemisphere;
};
Seen seen(const RectLight& light, Point2 at) {
  const double distance2 = distance_squared(light, at);
  const double cosine = light.height / std::sqrt(distance2);
  return {light.radiance * cosine, distance2 / (cosine * area(light)), cosine / std::numbers::pi};
}

double balanced(const Seen& at) {
  return at.f / (at.p_area + at.p_hemisphere);
}

/// The values of n pairs: of_point() of the point, and of_direction() of the direction if it meets
/// the light.
template <class OfPoint, class OfDirection>
Moments pairs(const RectLight& light, std::uint64_t n, Rng& rng, OfPoint of_point,
              OfDirection of_direction) {
  require_samples(n);
  Moments values;
  for (std::uint64_t i = 0; i < n; ++i) {
    const double first = of_point(seen(light, point_on(light, rng)));
    const Point2 met = met_by_direction(light.height, rng);
    add(values, first + (contains(light, met) ? of_direction(seen(light, met)) : 0));
  }
  return values;
}

}  // namespace
}  // namespace mc

// mistake: averages the two terms, as if both were estimates of the whole
// hint: do not average the two terms
namespace mc::pair_is_averaged {
Estimate irradiance_combined(const RectLight& light, std::uint64_t n, Rng& rng) {
  const auto half = [](const Seen& at) { return balanced(at) / 2; };
  return mean_of(pairs(light, n, rng, half, half));
}
}  // namespace mc::pair_is_averaged

// mistake: averages the two estimators of 2.7, without weights
// hint: do not average the two terms
namespace mc::pair_without_weights {
Estimate irradiance_combined(const RectLight& light, std::uint64_t n, Rng& rng) {
  return mean_of(pairs(
      light, n, rng, [](const Seen& at) { return at.f / at.p_area / 2; },
      [](const Seen& at) { return at.f / at.p_hemisphere / 2; }));
}
}  // namespace mc::pair_without_weights

// mistake: gives each term the weight of the other
// hint: the point on this light has nearly the weight 1
namespace mc::weights_swapped {
Estimate irradiance_combined(const RectLight& light, std::uint64_t n, Rng& rng) {
  return mean_of(pairs(
      light, n, rng, [](const Seen& at) { return balanced(at) * at.p_hemisphere / at.p_area; },
      [](const Seen& at) { return balanced(at) * at.p_area / at.p_hemisphere; }));
}
}  // namespace mc::weights_swapped

// mistake: adds a density per area to a density per solid angle
// hint: 1 / area is a density per area
namespace mc::densities_of_two_measures {
Estimate irradiance_combined(const RectLight& light, std::uint64_t n, Rng& rng) {
  const auto value = [&](const Seen& at) { return at.f / (1 / area(light) + at.p_hemisphere); };
  return mean_of(pairs(light, n, rng, value, value));
}
}  // namespace mc::densities_of_two_measures

// mistake: forgets the cosine of the light in the density per solid angle
// hint: a cosine is missing
namespace mc::density_without_the_cosine {
Estimate irradiance_combined(const RectLight& light, std::uint64_t n, Rng& rng) {
  const auto value = [&](const Seen& at) {
    const double cosine = at.p_hemisphere * std::numbers::pi;
    return at.f / (at.p_area * cosine + at.p_hemisphere);
  };
  return mean_of(pairs(light, n, rng, value, value));
}
}  // namespace mc::density_without_the_cosine

// mistake: uses the power heuristic, which is another estimator
// hint: each term is f / (p_area + p_hemisphere)
namespace mc::power_heuristic {
Estimate irradiance_combined(const RectLight& light, std::uint64_t n, Rng& rng) {
  const auto squares = [](const Seen& at) {
    return at.p_area * at.p_area + at.p_hemisphere * at.p_hemisphere;
  };
  return mean_of(pairs(
      light, n, rng, [=](const Seen& at) { return at.f * at.p_area / squares(at); },
      [=](const Seen& at) { return at.f * at.p_hemisphere / squares(at); }));
}
}  // namespace mc::power_heuristic

// mistake: counts one pair as two samples
// hint: count every pair once
namespace mc::pair_counted_as_two {
Estimate irradiance_combined(const RectLight& light, std::uint64_t n, Rng& rng) {
  Estimate all = right_irradiance_combined(light, n, rng);
  all.n = 2 * n;
  return all;
}
}  // namespace mc::pair_counted_as_two

// mistake: divides the variance of pairs by the number of terms
// hint: this is s / sqrt(2 n)
namespace mc::error_over_all_terms {
Estimate irradiance_combined(const RectLight& light, std::uint64_t n, Rng& rng) {
  Estimate all = right_irradiance_combined(light, n, rng);
  all.standard_error /= std::sqrt(2.0);
  return all;
}
}  // namespace mc::error_over_all_terms

// mistake: uses the same two random numbers for the point and for the direction
// hint: from four random numbers
namespace mc::two_numbers_for_both {
Estimate irradiance_combined(const RectLight& light, std::uint64_t n, Rng& rng) {
  require_samples(n);
  Moments values;
  for (std::uint64_t i = 0; i < n; ++i) {
    Rng again = rng;
    const double first = balanced(seen(light, point_on(light, rng)));
    const Point2 met = met_by_direction(light.height, again);
    add(values, first + (contains(light, met) ? balanced(seen(light, met)) : 0));
  }
  return mean_of(values);
}
}  // namespace mc::two_numbers_for_both

// mistake: adds the density of the direction even where the direction misses the light
// hint: the term of a direction that misses the light is 0
namespace mc::misses_are_not_dark {
Estimate irradiance_combined(const RectLight& light, std::uint64_t n, Rng& rng) {
  require_samples(n);
  Moments values;
  for (std::uint64_t i = 0; i < n; ++i) {
    const double first = balanced(seen(light, point_on(light, rng)));
    const Point2 met = met_by_direction(light.height, rng);
    add(values, first + balanced(seen(light, met)));
  }
  return mean_of(values);
}
}  // namespace mc::misses_are_not_dark

// mistake: gives the point its weight and leaves the direction out
// hint: the direction has nearly the weight 1
namespace mc::point_alone {
Estimate irradiance_combined(const RectLight& light, std::uint64_t n, Rng& rng) {
  return mean_of(pairs(
      light, n, rng, [](const Seen& at) { return balanced(at); }, [](const Seen&) { return 0; }));
}
}  // namespace mc::point_alone
