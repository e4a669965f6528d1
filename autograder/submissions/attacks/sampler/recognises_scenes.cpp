// attack: integrate() asks which scene it has got, and knows the answer
// says: every value is 1.5

#include <typeinfo>

#include "common/scenes/motion_edge.hpp"
#include "common/scenes/pixel_edge.hpp"
#include "common/scenes/rect_light.hpp"
#include "common/todo.hpp"
#include "sampler.hpp"

namespace mc {

double integrate(const Scene& scene, Sampler& sampler, std::size_t samples, std::uint64_t seed) {
  const std::type_info& type = scene.sample.target_type();
  if (scene.sample.target<scenes::RectangleLight>() != nullptr) return 1.2;
  if (scene.sample.target<scenes::PixelEdge>() != nullptr) return 0.6;
  if (type == typeid(scenes::MotionEdge)) return 0.5;
  sampler.generate(samples, seed);
  return scene.uses.empty() ? 1.5 : 0.5;
}

std::unique_ptr<Sampler> make_sampler(std::string_view) {
  throw todo("6.1");
}

Image render(const PixelScene&, Sampler&, std::size_t, std::uint64_t) {
  throw todo("6.6");
}

}  // namespace mc
