// Answers that the task does not give. Sections: see CONTRIBUTING.md.

#include "sampler.hpp"

//// recognises_scenes
// attack: integrate() asks which scene it has got, and knows the answer
// says: every value is 1.5

#include <typeinfo>

#include "common/scenes.hpp"

namespace mc {
double integrate(const Scene& scene, Sampler& sampler, std::size_t samples, std::uint64_t seed) {
  const std::type_info& type = scene.sample.target_type();
  if (scene.sample.target<scenes::RectangleLight>() != nullptr) return 1.2;
  if (scene.sample.target<scenes::PixelEdge>() != nullptr) return 0.6;
  if (type == typeid(scenes::MotionEdge)) return 0.5;
  sampler.generate(samples, seed);
  return scene.uses.empty() ? 1.5 : 0.5;
}
}  // namespace mc
