#pragma once
// Lab 6's kinds of samplers as methods of making points, and the scenes to integrate.

#include "checks/sampler/samplers.hpp"
#include "checks/support/known_scenes.hpp"
#include "measurements/sampler/anova.hpp"
#include "measurements/support/integrands.hpp"
#include "measurements/support/methods.hpp"

namespace mc::measurements {

/// The last is optional: what a submission lacks is left out.
inline const std::vector<std::string> kinds = [] {
  std::vector<std::string> all(sampler_kinds.begin(), sampler_kinds.end());
  all.push_back("lattice");
  return all;
}();

/// In the order of `kinds`, and in the colors of the points that they hand out by next2().
inline const std::vector<Method> methods = [] {
  std::vector<Method> all{
      {"independent", "6.1", "independent"},   {"multi_jittered", "6.2", "stratified"},
      {"best_candidate", "6.7", "blue noise"}, {"scrambled_halton", "6.3", "Halton"},
      {"scrambled_sobol", "6.3", "Sobol'"},    {"lattice", "6.3", "lattice"}};
  for (std::size_t k = 0; k < all.size(); ++k) {
    const std::string& kind = kinds[k];
    all[k].most = kind == "blue_noise" ? 1024 : 16384;  // its time grows as n^2
    all[k].points = [=](std::uint64_t n, std::uint64_t dims, std::uint64_t count,
                        std::uint64_t seed) {
      return sets_of(TRY_MEASURE_WITH(large, columns, kind, n, domain::in_a_row(seed, count),
                                      repeated(dims / 2, {2})),
                     n, dims, count);
    };
    // What generate() does included; dims as they come.
    all[k].rounds = [=](std::uint64_t n, std::uint64_t dims, std::uint64_t rounds) {
      return cpu_seconds_of(TRY_MEASURE(repeat, kind, 2, dims, n, rounds, 1));
    };
  }
  return all;
}();

/// The scenes of plots and bench, with what a sample asks for, from one next2() to next2(), next(),
/// next2().
struct SceneRow {
  std::string name;
  std::uint64_t dims;
  bool in_plots, in_bench;
  bool has_next2 = true;  ///< without one, blue noise is stratified
};
inline const std::vector<SceneRow> scene_rows{
    {"pixel_edge", 2, true, true},     {"rect_light", 2, true, true},
    {"penumbra_disk", 2, false, true}, {"ao_sphere", 2, false, true},
    {"defocus_edge", 4, false, true},  {"motion_edge", 2, true, false, false},
    {"pixel_time_lens", 5, true, true}};

/// Errors of a kind's estimates of a scene, with seeds from `seed` on.
inline ErrorSums scene_errors(const std::string& kind, const std::string& scene, std::uint64_t n,
                              std::size_t count, std::uint64_t seed) {
  ErrorSums errors;
  const auto values = lists_of(
      TRY_MEASURE_WITH(large, estimates, kind, scene, {}, 1, 0, n, domain::in_a_row(seed, count)),
      count);
  const double exact = known_scene(scene, {}).exact;
  for (const double value : values.value_or(Values())) errors.add(value - exact);
  return errors;
}

/// A scene that asks for one next2(), as an integrand of the plane.
template <class S>
Integrand plane_integrand(const S& scene) {
  return {.name = "scene",
          .formula = "",
          .dims = 2,
          .mean = exact(scene),
          .g = [=](std::span<const double> x) {
            AtPoint sampler(x);
            return scene(sampler);
          }};
}

/// Dimensions of one Sobol' sequence, scrambled.
inline Method sobol_dimensions(const std::vector<unsigned>& dimensions) {
  return {.key = "sobol",
          .task = "5.8",
          .name = "one sequence",
          .points = [=](std::uint64_t n, std::uint64_t, std::uint64_t count, std::uint64_t seed) {
            return sets_of(TRY_MEASURE_WITH(large, sobol_columns, dimensions, n,
                                            domain::in_a_row(seed, count)),
                           n, dimensions.size(), count);
          }};
}

}  // namespace mc::measurements
