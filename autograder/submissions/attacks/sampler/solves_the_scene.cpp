// attack: integrate() looks at the scene through a sampler of its own, as often as it likes
// earns: 8
// says: the scene was evaluated 4096 times

#include "common/todo.hpp"
#include "sampler.hpp"

namespace mc {
namespace {

/// Midpoints of a fine grid in the first two coordinates.
class Probe final : public Sampler {
 public:
  double first = 0, second = 0;
  void generate(std::size_t, std::uint64_t) override {}
  double next() override { return used_++ == 0 ? first : second; }
  Point2 next2() override { return {first, second}; }
  void advance() override { used_ = 0; }

 private:
  int used_ = 0;
};

class Independent final : public Sampler {
 public:
  void generate(std::size_t, std::uint64_t seed) override { rng_ = Rng(seed); }
  double next() override { return to_unit(rng_()); }
  Point2 next2() override {
    const double x = next();
    return {x, next()};
  }
  void advance() override {}

 private:
  Rng rng_{0};
};

}  // namespace

std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  if (kind != "independent") throw todo("6.2");
  return std::make_unique<Independent>();
}

double integrate(const Scene& scene, Sampler& sampler, std::size_t samples, std::uint64_t seed) {
  sampler.generate(samples, seed);
  Probe probe;
  double sum = 0;
  for (int i = 0; i < 64; ++i) {
    for (int j = 0; j < 64; ++j, probe.advance()) {
      probe.first = (i + 0.5) / 64;
      probe.second = (j + 0.5) / 64;
      sum += scene.sample(probe);
    }
  }
  for (std::size_t i = 0; i < samples; ++i) sampler.advance();
  return sum / 4096;
}

Image render(const PixelScene&, Sampler&, std::size_t, std::uint64_t) {
  throw todo("6.6");
}

}  // namespace mc
