// attack: numbers that a judge would count in cells past the last one: 1, 1e300, -1, NaN
// says: gave [0] = 1
// says: numbers in [0, 1)

#include <cmath>

#include "common/todo.hpp"
#include "sampler.hpp"

namespace mc {
namespace {

class Attack final : public Sampler {
 public:
  void generate(std::size_t, std::uint64_t) override {}
  double next() override {
    const double numbers[] = {1.0, 1e300, -1.0, std::nan("")};
    return numbers[asked_++ % 4];
  }
  Point2 next2() override { return {next(), next()}; }
  void advance() override {}

 private:
  std::size_t asked_ = 0;
};

}  // namespace

std::unique_ptr<Sampler> make_sampler(std::string_view) {
  return std::make_unique<Attack>();
}

double integrate(const Scene&, Sampler&, std::size_t, std::uint64_t) {
  return 1e300;
}

Image render(const PixelScene& scene, Sampler&, std::size_t, std::uint64_t) {
  return {scene.width, scene.height, std::vector<double>(scene.width * scene.height, 1e300)};
}

}  // namespace mc
