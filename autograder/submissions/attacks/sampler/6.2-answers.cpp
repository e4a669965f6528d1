// Answers that the task does not give. Sections: see CONTRIBUTING.md.

#include "sampler.hpp"

//// goes_through_the_motions
// attack: makes all calls of the loop and evaluates the scene as often as it should, but elsewhere
// earns: 0
// says: evaluate the scene once
// says: pixel (column, row) has the index

#include <stdexcept>

#include "common/todo.hpp"

namespace mc {

class Half : public Sampler {
 public:
  void generate(std::size_t, std::uint64_t) override {}
  double next() override { return 0.5; }
  Point2 next2() override { return {0.5, 0.5}; }
  void advance() override {}
};

std::unique_ptr<Sampler> make_sampler(std::string_view) {
  throw todo("6.1");
}

double integrate(const Scene& scene, Sampler& sampler, std::size_t samples, std::uint64_t seed) {
  if (samples == 0) throw std::invalid_argument("samples: must be positive");
  sampler.generate(samples, seed);
  Half half;
  double sum = 0;
  for (std::size_t i = 0; i < samples; ++i, sampler.advance()) {
    sampler.next();
    sum += scene.sample(half);
  }
  return sum / static_cast<double>(samples);
}

Image render(const PixelScene& scene, Sampler& sampler, std::size_t spp, std::uint64_t seed) {
  if (spp == 0) throw std::invalid_argument("spp: must be positive");
  if (scene.width > 0 && scene.height > most_samples / scene.width) {
    throw std::invalid_argument("scene: too many pixels");
  }
  Image image{scene.width, scene.height, {}};
  Half half;
  for (std::size_t k = 0; k < scene.width * scene.height; ++k) {
    sampler.generate(spp, mix_bits(mix_bits(seed) + k));
    double sum = 0;
    for (std::size_t i = 0; i < spp; ++i, sampler.advance()) {
      sum += scene.sample(k % scene.width, k / scene.width, half);
    }
    image.pixels.push_back(sum / static_cast<double>(spp));
  }
  return image;
}
}  // namespace mc

//// recognises_scenes
// attack: integrate() asks which scene it has got, and knows the answer
// says: = 0.5

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
