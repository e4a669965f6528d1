#pragma once
// Lab 2's method of making points, its integrands, and irradiance two ways.

#include "2-independent/experiments.hpp"
#include "checks/support/rect_light_exact.hpp"
#include "measurements/support/error_sums.hpp"
#include "measurements/support/methods.hpp"

namespace mc::measurements {

using Count = std::uint64_t;

inline const Method uniform_points{
    .key = "independent",
    .task = "2.8",
    .name = "independent",
    .points =
        [](Count n, Count dims, Count count, Count seed) {
          const std::vector<Count> sizes(count, n * dims);
          return sets_of(TRY_MEASURE(uniforms, seed, sizes, 0), n, dims, count);
        },
    .rounds =
        [](Count n, Count dims, Count rounds) {
          return cpu_seconds_of(TRY_MEASURE(repeat_source, 2, n, dims * rounds, 1));
        },
    .dims = {1, 2, 4, 8},
    .same_for_all_n = true,
    .is_sequence = true};

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

/// The irradiance under a rectangular light, 2.7, by way of the area or of the hemisphere.
inline const char* const light_ways[] = {"points on the light", "directions"};
inline ErrorSums irradiance_errors(unsigned way, Count n, Count replicates, Count seed) {
  const RectLight light;
  ErrorSums errors;
  const auto got = way == 0 ? TRY_MEASURE(irradiance_area, light, n, seed, replicates)
                            : TRY_MEASURE(irradiance_hemisphere, light, n, seed, replicates);
  const auto values = lists_of(got, replicates, any_number);
  if (!values) return errors;
  for (const Estimate& one : *values) errors.add(one.value - irradiance(light));
  return errors;
}

}  // namespace mc::measurements
