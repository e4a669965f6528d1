// Labs 2 and 3: random numbers and jittered points against the standard library's.

#include <random>
#include <vector>

#include "bench/ratios/compare.hpp"
#include "common/rng.hpp"
#include "independent.hpp"
#include "stratification.hpp"

namespace mc::ratios {
namespace {

void jittered(const char* name, double wanted, std::size_t side) {
  std::mt19937_64 engine(1);
  std::uniform_real_distribution<double> random(0.0, 1.0);
  Rng rng(1);
  const std::size_t n = side * side;
  std::vector<double> px(n), py(n);
  compare(
      {name, "a textbook's loop over `mt19937_64`", wanted, static_cast<double>(n)},
      [&] {
        stratified_2d(px, py, {side, side}, rng);
        sink = py.back();
      },
      [&] {
        for (std::size_t j = 0; j < side; ++j) {
          for (std::size_t i = 0; i < side; ++i) {
            px[j * side + i] =
                (static_cast<double>(i) + random(engine)) / static_cast<double>(side);
            py[j * side + i] =
                (static_cast<double>(j) + random(engine)) / static_cast<double>(side);
          }
        }
        sink = py.back();
      });
}

const Measurements here(2, [] {
  std::mt19937_64 engine(1);
  std::uniform_real_distribution<double> random(0.0, 1.0);
  Rng rng(1);
  std::vector<double> x(block);
  compare(
      {"uniforms", "`mt19937_64`, `uniform_real_distribution`", 10, block},
      [&] {
        uniforms(rng, x);
        sink = x.back();
      },
      [&] {
        for (double& u : x) u = random(engine);
        sink = x.back();
      });
  jittered("stratified_2d, 64 points", 0, 8);
  jittered("stratified_2d, 1024 points", 5, 32);
});

}  // namespace
}  // namespace mc::ratios
