#pragma once
// How a report prints the experiments of lab 6: as the calls that they make.

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "6-sampler/experiments.hpp"
#include "runner/spelling.hpp"
#include "runner/text.hpp"

namespace mc::experiments {

/// A scene and the names of its parameters, in order.
struct SceneParameters {
  std::string_view scene, parameters;
};
inline constexpr SceneParameters scene_parameters[] = {
    {"pixel_edge", "a b c"},
    {"rect_light", "x0 x1 y0 y1 height radiance"},
    {"rect_light_horizon", "distance y0 y1 z0 z1"},
    {"disk_light", "radius height offset"},
    {"sphere_light", "radius distance tilt"},
    {"penumbra_halfplane", "x0 x1 y0 y1 light_height radiance receiver edge height"},
    {"penumbra_disk", "x0 x1 y0 y1 light_height radiance x y radius height"},
    {"ao_wall", "distance height"},
    {"ao_sphere", "radius distance tilt"},
    {"ao_sphere_uniform", "radius distance tilt"},
    {"defocus_edge", "aperture focus depth offset"},
    {"motion_edge", "start speed"},
    {"pixel_time_lens", "a b speed blur c"},
    {"stripes", "top bottom rise phase"},
};

/// The names of a scene's parameters; empty if there is no such scene.
inline std::string_view parameters_of_scene(std::string_view scene) {
  for (const SceneParameters& one : scene_parameters) {
    if (one.scene == scene) return one.parameters;
  }
  return {};
}

constexpr std::size_t most_calls = 8;  // more calls are abbreviated

inline std::string spelled(const Step& step) {
  switch (step.call) {
    case 0:
      return "generate(" + text::print(step.samples) + ", " + text::print(step.seed) + ")";
    case 1:
      return "next()";
    case 2:
      return "next2()";
    default:
      return "advance()";
  }
}

/// For example: "generate(12, 7); next(); next2(); … 37 more calls".
inline std::string spelled(const std::vector<Step>& steps) {
  std::vector<std::string> calls(steps.size());
  for (std::size_t i = 0; i < steps.size() && i < most_calls; ++i) calls[i] = spelled(steps[i]);
  return text::joined(calls, "; ", most_calls, "calls");
}

/// One seed is printed as a number. Several are printed as the word "seed", and a suffix gives
/// their number: ", with each of 256 seeds".
struct SpelledSeeds {
  std::string one = "seed", suffix;
  explicit SpelledSeeds(const std::vector<std::uint64_t>& seeds) {
    if (seeds.size() == 1) {
      one = text::print(seeds[0]);
    } else {
      suffix = ", with each of " + std::to_string(seeds.size()) + " seeds";
    }
  }
};

/// Prints play and play_two.
inline std::string spelled_call(Spelling, std::string_view experiment, const std::string& kind,
                                const std::vector<Step>& steps) {
  return (experiment == "play_two" ? "two of " : "") + kind + ": " + spelled(steps);
}

/// Prints columns.
inline std::string spelled_call(Spelling, std::string_view, const std::string& kind,
                                std::uint64_t samples, const std::vector<std::uint64_t>& seeds,
                                const std::vector<unsigned>& uses) {
  std::vector<std::string> calls;
  for (const unsigned use : uses) calls.emplace_back(use == 2 ? "next2()" : "next()");
  const SpelledSeeds spelled_seeds(seeds);
  return (kind.empty() ? "\"\"" : kind) + ": generate(" + text::print(samples) + ", " +
         spelled_seeds.one +
         (uses.empty()
              ? ")"
              : "), then for each sample " + text::joined(calls, "; ", most_calls, "calls")) +
         spelled_seeds.suffix;
}

/// Prints estimates.
inline std::string spelled_call(Spelling, std::string_view, const std::string& kind,
                                const std::string& scene, const std::vector<double>& parameters,
                                double a, double b, std::uint64_t samples,
                                const std::vector<std::uint64_t>& seeds) {
  std::string of_scene = scene;
  const auto names = text::split(parameters_of_scene(scene), ' ');
  if (names.size() == parameters.size()) {
    std::vector<std::string> fields;
    for (std::size_t i = 0; i < names.size(); ++i) {
      fields.push_back(std::string(names[i]) + " = " + text::print(parameters[i]));
    }
    of_scene += '{' + text::joined(fields, ", ", fields.size(), "") + '}';
  }
  if (a != 1) of_scene = text::print(a) + " * " + of_scene;
  if (b != 0) of_scene += (b < 0 ? " - " : " + ") + text::print(b < 0 ? -b : b);
  const SpelledSeeds spelled_seeds(seeds);
  return "integrate(" + of_scene + ", " + kind + ", " + text::print(samples) + ", " +
         spelled_seeds.one + ")" + spelled_seeds.suffix;
}

}  // namespace mc::experiments
