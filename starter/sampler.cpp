// Lab 6 · the sampler. labs/6-sampler/sampler.hpp states what each function promises, and
// labs/6-sampler/README.md is the handout. Write the tasks in any order and check them with
//
//   ./lab check sampler              the whole lab
//   ./lab check sampler --only 6.2   one task

#include "sampler.hpp"

#include <stdexcept>

#include "common/todo.hpp"

namespace mc {

/// A finished example: a sampler that always returns 1/2. Its pictures have no
/// noise, but they are wrong.
class [[maybe_unused]] Middle : public Sampler {
 public:
  void generate(std::size_t samples, std::uint64_t) override { left_ = samples; }
  double next() override {
    if (left_ == 0) throw std::out_of_range("next: no samples left");
    return 0.5;
  }
  Point2 next2() override { return {next(), next()}; }
  void advance() override {
    if (left_ > 0) --left_;
  }

 private:
  std::size_t left_ = 0;  ///< samples left, including the current one
};

std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  if (kind == "independent") throw todo("6.1");  // TODO(6.1): a class that derives from Sampler
  if (kind == "stratified") throw todo("6.2");   // TODO(6.2): how are its columns filled?
  if (kind == "halton") throw todo("6.3");       // TODO(6.3): the next dimension of one sequence
  if (kind == "sobol") throw todo("6.3");
  if (kind == "blue_noise") throw todo("6.7");  // TODO(6.7): its first next2() is special
  throw todo("6.1");                            // unknown kinds are refused
}

// TODO(6.4): the contract adds no function: it holds for every kind.

double integrate(const Scene& scene, Sampler& sampler, std::size_t samples, std::uint64_t seed) {
  throw todo("6.5");  // TODO(6.5): generate, and for each sample: evaluate, add up, advance
}

Image render(const PixelScene& scene, Sampler& sampler, std::size_t spp, std::uint64_t seed) {
  throw todo("6.6");  // TODO(6.6): one integration per pixel, each with its own seed
}

// TODO(6.8): a stretch task: good pairs of dimensions, the kind "lattice", and speed: measure where
// the time goes when a picture has few samples per pixel, and when it has many.

}  // namespace mc
