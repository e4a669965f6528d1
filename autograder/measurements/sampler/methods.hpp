#pragma once
// Lab 6's kinds of samplers as methods of making points, and the scenes to integrate.

#include "checks/sampler/samplers.hpp"
#include "checks/support/known_scenes.hpp"
#include "measurements/sampler/anova.hpp"
#include "measurements/support/integrands.hpp"
#include "measurements/support/methods.hpp"

namespace mc::measurements {

/// In the colors of the points that they hand out by next2(). The last is optional: what a
/// submission lacks is left out.
inline const Methods methods = [] {
  Methods all{{"independent", "6.1", "independent"},   {"multi_jittered", "6.2", "stratified"},
              {"best_candidate", "6.7", "blue noise"}, {"scrambled_halton", "6.3", "Halton"},
              {"scrambled_sobol", "6.3", "Sobol'"},    {"lattice", "6.8", "lattice"}};
  for (std::size_t k = 0; k < all.size(); ++k) {
    Method& one = all.at(k);
    const std::string kind = k < sampler_kinds.size() ? sampler_kinds[k] : "lattice";
    one.kind = kind;
    one.traits.most = kind == "blue_noise" ? 1024 : 16384;  // its time grows as n^2
    one.points = POINTS_WITH(large, columns, kind, n, domain::in_a_row(seed, count),
                             repeated(dims / 2, {2}));
    // What generate() does included; dims as they come.
    one.rounds = ROUNDS_BY(repeat, kind, 2, dims, n, rounds, 1);
  }
  return all;
}();

/// Four dimensions of a pixel with 16 samples, and with 64; of the required kinds.
inline const std::vector<SpeedTask> speed_tasks = [] {
  std::vector<SpeedTask> all;
  for (const Method& one : methods) {
    if (one.kind == "blue_noise" || one.kind == "lattice") continue;
    for (const Count n : {16u, 64u}) {
      all.push_back({"6.8",
                     fmt::format("a number, {}, {} samples", one.kind, n),
                     4 * n,
                     one.rounds_of(n, 4),
                     {},
                     0,
                     [=](Count rounds) { return TRY_MEASURE(repeat_textbook, 4, n, rounds); }});
    }
  }
  return all;
}();

/// Errors of a kind's estimates of a scene, with seeds from `seed` on.
inline ErrorSums scene_errors(const std::string& kind, const std::string& scene, Count n,
                              std::size_t count, Count seed) {
  ErrorSums errors;
  const double exact = known_scene(scene, {}).exact;
  const auto got =
      TRY_MEASURE_WITH(large, estimates, kind, scene, {}, 1, 0, n, domain::in_a_row(seed, count));
  for (const double value : values_of(got, count)) errors.add(value - exact);
  return errors;
}
inline Rounds scene_rounds(const std::string& kind, const std::string& scene, Count n) {
  return [=](Count rounds) { return TRY_MEASURE(repeat_scene, kind, scene, n, rounds, 1); };
}

/// A scene that asks for one next2(), as an integrand of the plane.
template <class S>
Integrand plane_integrand(const S& scene) {
  return {"scene", 2, exact(scene), [=](View x) {
            AtPoint sampler(x);
            return scene(sampler);
          }};
}

/// Dimensions of one Sobol' sequence, scrambled.
inline Method sobol_dimensions(const std::vector<unsigned>& dimensions) {
  return {"sobol", "5.8", "one sequence",
          POINTS_WITH(large, sobol_columns, dimensions, n, domain::in_a_row(seed, count))};
}

}  // namespace mc::measurements
