// The project's ratios, in one process: what the reference solutions take against what one would
// write first, or call instead. A tenth of a nanosecond is measured best where nothing else stands
// between. Interleaved rounds, the best of fifteen on either side; the median of five such ratios.
// Everything is made in the same 32 KB (but for «out of cache»), as GSL makes every point in the same
// few bytes: what is timed is making numbers, not storing them.
//
// Prints a row for each ratio: name, ratio, nanoseconds of ours, of the other; separated by tabs.

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <limits>
#include <memory>
#include <random>
#include <span>
#include <string>
#include <utility>
#include <vector>

#ifdef MC_HAVE_GSL
#include <gsl/gsl_qrng.h>
#endif

#include "common/points.hpp"
#include "common/rng.hpp"
#include "halton.hpp"
#include "independent.hpp"
#include "sampler.hpp"
#include "stratification.hpp"
#include "variance.hpp"

namespace {

using Clock = std::chrono::steady_clock;
using Work = std::function<void()>;

volatile double sink = 0;

/// Nanoseconds of one call, over as many as take 0.2 ms.
double nanoseconds(const Work& work) {
  constexpr double least = 2e-4;
  for (int calls = 1;; calls *= 2) {
    const auto start = Clock::now();
    for (int i = 0; i < calls; ++i) work();
    const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
    if (seconds >= least) return seconds * 1e9 / calls;
  }
}

/// Of making `values` numbers.
void compare(const char* name, double values, const Work& ours, const Work& other) {
  std::vector<std::pair<double, std::pair<double, double>>> ratios;
  for (int time = 0; time < 5; ++time) {
    double best_ours = std::numeric_limits<double>::infinity(), best_other = best_ours;
    for (int round = 0; round < 15; ++round) {
      best_ours = std::min(best_ours, nanoseconds(ours));
      best_other = std::min(best_other, nanoseconds(other));
    }
    ratios.push_back({best_other / best_ours, {best_ours, best_other}});
  }
  std::sort(ratios.begin(), ratios.end());
  const auto& [ratio, times] = ratios[2];
  std::printf("%s\t%.4g\t%.4g\t%.4g\n", name, ratio, times.first / values, times.second / values);
  std::fflush(stdout);
}

constexpr std::size_t block = 4096;  // 32 KB

struct Sums {
  double sum = 0, squares = 0;
};
[[gnu::noinline]] Sums two_sums(std::span<const double> x) {
  Sums sums;
  for (const double value : x) {
    sums.sum += value;
    sums.squares += value * value;
  }
  return sums;
}

void moments(const char* name, std::size_t n) {
  std::vector<double> x(n);
  for (std::size_t i = 0; i < n; ++i) x[i] = 1e9 + static_cast<double>(i * 7919 % 1000) * 1e-3;
  compare(
      name, static_cast<double>(n), [&] { sink = mc::moments(x).m2; },
      [&] { sink = two_sums(x).squares; });
}

void random_numbers() {
  std::mt19937_64 engine(1);
  std::uniform_real_distribution<double> random(0.0, 1.0);
  mc::Rng rng(1);
  std::vector<double> x(block);
  compare(
      "uniforms", block,
      [&] {
        mc::uniforms(rng, x);
        sink = x.back();
      },
      [&] {
        for (double& u : x) u = random(engine);
        sink = x.back();
      });
  const auto grid = [&](const char* name, std::size_t side) {
    const std::size_t n = side * side;
    std::vector<double> px(n), py(n);
    compare(
        name, static_cast<double>(n),
        [&] {
          mc::stratified_2d(px, py, {side, side}, rng);
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
  };
  grid("stratified_2d, 64 points", 8);
  grid("stratified_2d, 1024 points", 32);
}

/// Lab 6, number by number through its interface: four dimensions by next2(), generation included.
void samplers(std::size_t n) {
  std::mt19937_64 engine(1);
  std::uniform_real_distribution<double> random(0.0, 1.0);
  for (const char* kind : {"independent", "stratified", "halton", "sobol"}) {
    const auto sampler = mc::make_sampler(kind);
    std::uint64_t seed = 0;
    const std::string name =
        std::string("sampler, ") + kind + ", " + std::to_string(n) + " samples";
    compare(
        name.c_str(), 4 * static_cast<double>(n),
        [&] {
          sampler->generate(n, ++seed);
          double sum = 0;
          for (std::size_t i = 0; i < n; ++i, sampler->advance()) {
            const mc::Point2 a = sampler->next2(), b = sampler->next2();
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

#ifdef MC_HAVE_GSL
/// Against GSL, which makes points of `dims` coordinates.
void sequences(unsigned dims) {
  const auto name = [&](const char* what) {
    return std::string(what) + ", " + std::to_string(dims) + "D";
  };
  const auto from = [&](const gsl_qrng_type* type) {
    gsl_qrng* const sequence = gsl_qrng_alloc(type, dims);
    return [=, point = std::vector<double>(dims)]() mutable {
      gsl_qrng_init(sequence);
      for (std::size_t i = 0; i < block; ++i) gsl_qrng_get(sequence, point.data());
      sink = point[0];
    };
  };
  const auto bases = mc::primes(dims);
  std::vector<double> column(block);
  const double values = static_cast<double>(block) * dims;
  const auto over_dims = [&](auto make) {
    return [&, make] {
      for (unsigned d = 0; d < dims; ++d) make(d);
      sink = column.back();
    };
  };
  compare(name("radical_inverses").c_str(), values,
          over_dims([&](unsigned d) { mc::radical_inverses(bases[d], 0, column); }),
          from(gsl_qrng_halton));
  compare(name("sobol").c_str(), values, over_dims([&](unsigned d) { mc::sobol(d, 0, column); }),
          from(gsl_qrng_sobol));
  compare(name("owen_scramble").c_str(), values, over_dims([&](unsigned d) {
            mc::sobol(d, 0, column);
            mc::owen_scramble(column, d);
          }),
          from(gsl_qrng_sobol));
}
#endif

}  // namespace

int main() {
  moments("moments, in cache", block);
  moments("moments, out of cache", std::size_t{1} << 23);  // 64 MB
  random_numbers();
  for (const std::size_t n : {std::size_t{64}, std::size_t{1024}}) samplers(n);
#ifdef MC_HAVE_GSL
  for (const unsigned dims : {2u, 4u, 8u}) sequences(dims);
#endif
}
