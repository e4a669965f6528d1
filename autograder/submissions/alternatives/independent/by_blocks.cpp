// alternative: fills blocks with 2.8, takes their moments with 1.8 and merges them
#include "independent.hpp"

#define estimate right_estimate
#define irradiance_area right_irradiance_area
#include "solutions/independent.cpp"

#include <algorithm>
#include <cmath>
#undef estimate
#undef irradiance_area

namespace mc {

template <class Value>
Estimate by_blocks(std::size_t dims, std::uint64_t n, Rng& rng, Value value) {
  require_samples(n);
  constexpr std::uint64_t block = 256;
  Moments all;
  std::vector<double> u(dims * block), values(block);
  for (std::uint64_t first = 0; first < n; first += block) {
    const std::size_t size = std::min(block, n - first);
    uniforms(rng, std::span(u).first(dims * size));
    for (std::size_t i = 0; i < size; ++i) values[i] = value(&u[i * dims]);
    all = merge(all, moments(std::span(values).first(size)));
  }
  return mean_of(all);
}

Estimate estimate(const Integrand& g, std::uint64_t n, Rng& rng) {
  return by_blocks(g.dims, n, rng, [&](const double* x) { return g.f({x, g.dims}); });
}

Estimate irradiance_area(const RectLight& light, std::uint64_t n, Rng& rng) {
  const double area = (light.x1 - light.x0) * (light.y1 - light.y0);
  return by_blocks(2, n, rng, [&](const double* u) {
    const double x = std::lerp(light.x0, light.x1, u[1]), y = std::lerp(light.y0, light.y1, u[0]);
    const double distance = std::hypot(x, y, light.height), cosine = light.height / distance;
    return light.radiance * cosine * cosine / (distance * distance) * area;
  });
}

}  // namespace mc
