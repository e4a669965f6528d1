// attack: asks for a terabyte in generate()
// says: did not end within 2 s of CPU time and 512 MB of memory
// limit: memory

#include <vector>

#include "common/todo.hpp"
#include "sampler.hpp"

namespace mc {
namespace {

class Attack final : public Sampler {
 public:
  void generate(std::size_t, std::uint64_t) override { numbers_.resize(std::size_t{1} << 37); }
  double next() override { return 0.5; }
  Point2 next2() override { return {0.5, 0.5}; }
  void advance() override {}

 private:
  std::vector<double> numbers_;
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
