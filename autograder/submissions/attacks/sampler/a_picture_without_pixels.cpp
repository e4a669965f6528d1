// attack: pictures of the right size that have no pixels, and some that have too many
// says: gave 0 values in

#include "common/todo.hpp"
#include "sampler.hpp"

namespace mc {

std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  if (kind != "independent") throw todo("6.2");
  throw todo("6.1");
}

double integrate(const Scene&, Sampler&, std::size_t, std::uint64_t) {
  throw todo("6.5");
}

Image render(const PixelScene& scene, Sampler&, std::size_t spp, std::uint64_t) {
  const std::size_t pixels = scene.width * scene.height;
  return {scene.width, scene.height, std::vector<double>(spp < 5 ? 0 : 2 * (pixels % 100'000))};
}

}  // namespace mc
