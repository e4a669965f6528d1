// attack: leaves next() for a function that has returned long ago
// says: called exit(0) instead of returning

#include <unistd.h>
#include <csetjmp>

#include "common/todo.hpp"
#include "sampler.hpp"

namespace mc {
namespace {
std::jmp_buf back;

class Attack final : public Sampler {
 public:
  void generate(std::size_t, std::uint64_t) override {
    if (setjmp(back) != 0) _exit(0);
  }
  double next() override { std::longjmp(back, 1); }
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
