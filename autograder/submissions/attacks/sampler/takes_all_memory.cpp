// attack: takes memory as long as there is any
// says: did not end within 2 s of CPU time and 512 MB of memory
// limit: memory

#include "common/todo.hpp"
#include "sampler.hpp"

namespace mc {
namespace {

class Attack final : public Sampler {
 public:
  void generate(std::size_t, std::uint64_t) override {
    for (;;) {
      volatile char* const block = new char[1 << 20];
      for (int i = 0; i < 1 << 20; i += 4096) block[i] = 1;
    }
  }
  double next() override { return 0.5; }
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
