// Lab 6, number by number through its interface: four dimensions by next2(), generation included.

#include <random>
#include <string>

#include "bench/ratios/compare.hpp"
#include "sampler.hpp"

namespace mc::ratios {
namespace {

void samplers(std::size_t n, double wanted) {
  std::mt19937_64 engine(1);
  std::uniform_real_distribution<double> random(0.0, 1.0);
  for (const char* kind : {"independent", "stratified", "halton", "sobol"}) {
    const auto sampler = make_sampler(kind);
    std::uint64_t seed = 0;
    compare(
        {std::string("sampler, ") + kind + ", " + std::to_string(n) + " samples",
         "a loop over `mt19937_64`, `uniform_real_distribution`", wanted,
         4 * static_cast<double>(n)},
        [&] {
          sampler->generate(n, ++seed);
          double sum = 0;
          for (std::size_t i = 0; i < n; ++i, sampler->advance()) {
            const Point2 a = sampler->next2(), b = sampler->next2();
            sum += a.x + a.y + b.x + b.y;
          }
          sink = sum;
        },
        [&] {
          double sum = 0;
          for (std::size_t i = 0; i < 4 * n; ++i) sum += random(engine);
          sink = sum;
        });
  }
}

const Measurements here(6, [] {
  samplers(64, 0);
  samplers(1024, 2);
});

}  // namespace
}  // namespace mc::ratios
