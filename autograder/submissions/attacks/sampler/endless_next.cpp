// attack: a number that never comes
// says: did not end within 2 s of CPU time and 512 MB of memory
// limit: time

#include "common/todo.hpp"
#include "sampler.hpp"

namespace mc {
namespace {

class Attack final : public Sampler {
 public:
  void generate(std::size_t, std::uint64_t) override {}
  double next() override {
    for (volatile int i = 0;;) {
      i = i + 1;
    }
  }
  Point2 next2() override { return {0.5, 0.5}; }
  void advance() override {}
};

}  // namespace

std::unique_ptr<Sampler> make_sampler(std::string_view) {
  return std::make_unique<Attack>();
}

double integrate(const Scene&, Sampler&, std::size_t, std::uint64_t) {
  throw todo("6.5");
}

Image render(const PixelScene&, Sampler&, std::size_t, std::uint64_t) {
  throw todo("6.6");
}

}  // namespace mc
