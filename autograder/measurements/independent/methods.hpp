#pragma once
// Lab 2's method of making points, its integrands, and irradiance two ways.

#include "2-independent/experiments.hpp"
#include "checks/support/rect_light_exact.hpp"
#include "measurements/support/error_sums.hpp"
#include "measurements/support/methods.hpp"

namespace mc::measurements {

inline const Methods methods = [] {
  const auto points = [](Count n, Count dims, Count count, Count seed) {
    const std::vector<Count> sizes(count, n * dims);
    return sets_of(TRY_MEASURE(uniforms, seed, sizes, 0), n, dims, count);
  };
  return Methods{{"independent", "2.8", "independent", points,
                  ROUNDS_BY(repeat_source, 2, n, (dims * rounds), 1),
                  in_bench({1, 2, 4, 8}, {.same_for_all_n = true, .is_sequence = true})}};
}();

inline const std::vector<SpeedTask> speed_tasks{
    {"2.8", "uniforms", 4096, methods["independent"].rounds_of(4096, 1), {}, 0, [](Count rounds) {
       return TRY_MEASURE(repeat_source, 1, 4096, rounds, 1);
     }}};

/// An integrand of 2.2, as the experiments know it, and its mean.
struct LineIntegrand {
  const char* name;
  experiments::Function g;
  double mean;
};
inline const double sqrt_half = std::sqrt(0.5);
inline const std::vector<LineIntegrand> line_integrands{
    {"exp(x)", {1, 0, 1, 0}, std::expm1(1.0)}, {"x < √½", {3, sqrt_half, 1, 0}, sqrt_half},
    {"x < 0.01", {3, 0.01, 1, 0}, 0.01},       {"x^-0.4", {4, -0.4, 1, 0}, 1 / 0.6},
    {"x^-0.75", {4, -0.75, 1, 0}, 4},          {"normal", {6, 0, 1, 0}, 0}};

/// Estimates of one of them.
inline std::vector<experiments::CountedEstimate> estimates_of(const LineIntegrand& integrand,
                                                              Count n, Count replicates) {
  return values_of(TRY_MEASURE(estimates, integrand.g, n, 1, replicates), replicates);
}

/// A way to the irradiance under a rectangular light, 2.7 or 2.9.
struct LightWay {
  unsigned number;
  const char *key, *name;

  ErrorSums errors(Count n, Count replicates, Count seed) const {
    const RectLight light;
    const auto got = number == 0   ? TRY_MEASURE(irradiance_area, light, n, seed, replicates)
                     : number == 1 ? TRY_MEASURE(irradiance_hemisphere, light, n, seed, replicates)
                                   : TRY_MEASURE(irradiance_combined, light, n, seed, replicates);
    ErrorSums errors;
    for (const Estimate& one : values_of(got, replicates, any_number)) {
      errors.add(one.value - irradiance(light));
    }
    return errors;
  }
  /// Of 4,096 samples.
  Rounds rounds() const {
    return
        [way = number](Count rounds) { return TRY_MEASURE(repeat_irradiance, way, 4096, rounds); };
  }
};
inline constexpr LightWay light_ways[] = {{0, "area", "points on the light"},
                                          {1, "hemisphere", "directions"},
                                          {2, "combined", "pairs of both"}};

}  // namespace mc::measurements
