// The project's ratios, measured in one process: the reference solutions against the strongest code
// that a good engineer writes in ten lines, and against the library that one would call instead,
// where it is installed. Nothing else may run between the two sides, because the differences are
// tenths of a nanosecond. Prints rows (protocol/rows.hpp); with the word "samplers", those of the
// samplers on scenes (samplers.cpp).

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <random>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "bench/ratios/ratios.hpp"
#include "common/rng.hpp"
#include "halton.hpp"
#include "independent.hpp"
#include "sampler.hpp"
#include "stratification.hpp"
#include "variance.hpp"

#ifdef MC_HAVE_GSL
#include <gsl/gsl_qrng.h>
#include <gsl/gsl_statistics_double.h>
#endif
#ifdef MC_HAVE_OPENQMC
#include <oqmc/lattice.h>
#include <oqmc/pmj.h>
#include <oqmc/pmjbn.h>
#endif

namespace mc::ratios {
namespace {

/// All output goes to the same 32 KB (except for «out of cache»), as a library writes every point
/// to the same few bytes: this times the generation of numbers, not their storage.
constexpr std::size_t block = 4096;

struct Opponent {
  std::string name;
  Work work;
};

/// Interleaved rounds against each opponent, the best of fifteen on either side, five times: rows
/// of ours and of the other in turn. One call of any side makes `values` numbers.
void compare(const std::string& name, double values, const Work& ours,
             const std::vector<Opponent>& opponents) {
  for (const Opponent& opponent : opponents) {
    for (int turn = 0; turn < 5; ++turn) {
      double best = std::numeric_limits<double>::infinity(), other = best;
      for (int round = 0; round < 15; ++round) {
        best = std::min(best, nanoseconds(ours));
        other = std::min(other, nanoseconds(opponent.work));
      }
      print({.task = name, .ns = best / values});
      print({.method = opponent.name, .task = name, .ns = other / values});
    }
  }
}

// Lab 1. The loop returns one number: GCC keeps the sums in memory where they are returned.
[[gnu::noinline]] double variance_by_two_sums(std::span<const double> x) {
  double sum = 0, squares = 0;
  for (const double value : x) {
    sum += value;
    squares += value * value;
  }
  const auto n = static_cast<double>(x.size());
  return (squares - sum * sum / n) / (n - 1);
}

void moments_of(const char* name, std::size_t n) {
  std::vector<double> x(n);
  for (std::size_t i = 0; i < n; ++i) x[i] = 1e9 + static_cast<double>(i * 7919 % 1000) * 1e-3;
  std::vector<Opponent> all{{"two sums in a loop", [&] { sink = variance_by_two_sums(x); }}};
#ifdef MC_HAVE_GSL
  all.push_back({"`gsl_stats_variance`", [&] { sink = gsl_stats_variance(x.data(), 1, n); }});
#endif
  compare(
      name, static_cast<double>(n), [&] { sink = moments(x).m2; }, all);
}

// Labs 2 and 3: the conversion of 2.1, or the standard library's distribution.
using Engine = std::mt19937_64;
struct Converted {
  double operator()(Engine& engine) const { return to_unit(engine()); }
};
using Distributed = std::uniform_real_distribution<double>;
constexpr const char *plainly = "`to_unit` of `mt19937_64`",
                     *library = "`uniform_real_distribution` of `mt19937_64`";

/// The same loop with either.
template <class Loop>
std::vector<Opponent> loops(Loop loop) {
  return {{plainly, [=, engine = Engine(1)]() mutable { loop(engine, Converted{}); }},
          {library, [=, engine = Engine(1)]() mutable { loop(engine, Distributed(0, 1)); }}};
}

void blocks_of_uniforms() {
  std::vector<double> x(block);
  Rng rng(1);
  const auto ours = [&] {
    uniforms(rng, x);
    sink = x.back();
  };
  compare("uniforms", block, ours, loops([&](Engine& engine, auto random) {
            for (double& u : x) u = random(engine);
            sink = x.back();
          }));
}

void jittered(const char* name, std::size_t side) {
  std::vector<double> x(side * side), y(side * side);
  Rng rng(1);
  const auto ours = [&] {
    stratified_2d(x, y, {side, side}, rng);
    sink = y.back();
  };
  const double scale = 1 / static_cast<double>(side);
  compare(name, static_cast<double>(side * side), ours,
          loops([&, scale](Engine& engine, auto random) {
            for (std::size_t j = 0, k = 0; j < side; ++j) {
              for (std::size_t i = 0; i < side; ++i, ++k) {
                x[k] = (static_cast<double>(i) + random(engine)) * scale;
                y[k] = (static_cast<double>(j) + random(engine)) * scale;
              }
            }
            sink = y.back();
          }));
}

#ifdef MC_HAVE_OPENQMC
/// Number by number through the interface: four dimensions by next2(), generation included.
Work sampled(const char* kind, std::size_t n) {
  return [sampler = std::shared_ptr<Sampler>(make_sampler(kind)), n,
          seed = std::uint64_t{0}]() mutable {
    sampler->generate(n, ++seed);
    double sum = 0;
    for (std::size_t i = 0; i < n; ++i, sampler->advance()) {
      const Point2 a = sampler->next2(), b = sampler->next2();
      sum += a.x + a.y + b.x + b.y;
    }
    sink = sum;
  };
}

std::string name_of(const char* kind, std::size_t n) {
  return std::string("sampler, ") + kind + ", " + std::to_string(n) + " samples";
}

/// One domain of four dimensions, in floats, pixel after pixel. Its tables are made beforehand.
template <class Library>
Opponent drawn(const char* name, std::size_t n) {
  const auto cache = std::make_shared<std::vector<std::byte>>(Library::cacheSize + 1);
  Library::initialiseCache(cache->data());
  return {name, [=, pixel = 0]() mutable {
            ++pixel;
            double sum = 0;
            for (int i = 0; i < static_cast<int>(n); ++i) {
              const Library sampler(pixel & 255, pixel >> 8 & 255, 0, i, cache->data());
              float sample[4];
              sampler.newDomain(0).template drawSample<4>(sample);
              for (const float u : sample) sum += static_cast<double>(u);
            }
            sink = sum;
          }};
}

/// Few samples beside OpenQMC.
void few_samples(std::size_t n) {
  const auto pmj = drawn<oqmc::PmjSampler>("OpenQMC's pmj", n);
  const std::pair<const char*, std::vector<Opponent>> races[] = {
      {"stratified", {pmj}},
      {"halton", {pmj}},
      {"sobol", {pmj, drawn<oqmc::PmjBnSampler>("OpenQMC's pmjbn", n)}},
      {"lattice", {drawn<oqmc::LatticeSampler>("OpenQMC's lattice", n)}}};
  for (const auto& [kind, opponents] : races) {
    compare(name_of(kind, n), 4 * static_cast<double>(n), sampled(kind, n), opponents);
  }
}
#endif

// Lab 5. Index i = d len + k with the leading digit d has one step more than i - len: from the
// first values of a column all others follow, in loops without divisions.
void inverses_by_blocks(unsigned base, double* x, std::size_t size) {
  double step = 1.0 / base;
  x[0] = 0;
  for (std::size_t len = 1; len < size; len *= base, step /= base) {
    const std::size_t end = std::min(len * base, size);
    for (std::size_t i = len; i < end; ++i) x[i] = x[i - len] + step;
  }
}

/// The same in base 2, with the direction numbers of a dimension.
struct SobolByBlocks {
  std::vector<std::uint32_t> directions = std::vector<std::uint32_t>(12),
                             bits = std::vector<std::uint32_t>(block);
  explicit SobolByBlocks(unsigned dimension) {
    for (std::size_t k = 0; k < directions.size(); ++k) {
      std::vector<double> one(1);
      sobol(dimension, std::uint64_t{1} << k, one);
      directions[k] = static_cast<std::uint32_t>(one[0] * 0x1p32);
    }
  }
  template <class Last>
  void operator()(double* x, Last last) {
    std::uint32_t* const first = bits.data();
    for (std::size_t k = 0, len = 1; k < directions.size(); ++k, len *= 2) {
      const std::uint32_t direction = directions[k];
      for (std::size_t i = 0; i < len; ++i) first[len + i] = first[i] ^ direction;
    }
    // Half of a word is a signed one, which a vector register converts.
    for (std::size_t i = 0; i < block; ++i) {
      x[i] = static_cast<std::int32_t>(last(first[i]) >> 1) * 0x1p-31;
    }
  }
};

std::uint32_t mirrored(std::uint32_t z) {
  z = __builtin_bswap32(z);
  z = (z >> 4 & 0x0f0f0f0fu) | (z & 0x0f0f0f0fu) << 4;
  z = (z >> 2 & 0x33333333u) | (z & 0x33333333u) << 2;
  return (z >> 1 & 0x55555555u) | (z & 0x55555555u) << 1;
}
/// 32 bits at once (Laine, Karras 2011, with the constants of Burley 2020).
std::uint32_t hashed(std::uint32_t value, std::uint32_t seed) {
  std::uint32_t z = mirrored(value) + seed;
  z ^= z * 0x6c50b47cu;
  z ^= z * 0xb82f1e52u;
  z ^= z * 0xc7afe638u;
  z ^= z * 0x8d22f6e6u;
  return mirrored(z);
}

void sequences(unsigned dims) {
  const auto bases = primes(dims);
  std::vector<double> x(block);
  std::vector<SobolByBlocks> plain;
  for (unsigned d = 0; d < dims; ++d) plain.emplace_back(d);
  const auto columns = [&](auto make) -> Work {
    return [&, make] {
      for (unsigned d = 0; d < dims; ++d) make(d);
      sink = x.back();
    };
  };
  const auto race = [&](const char* what, const Work& ours, const char* against, const Work& other,
                        [[maybe_unused]] const char* kind) {
    std::vector<Opponent> all{{against, other}};
#ifdef MC_HAVE_GSL
    const auto type = kind == std::string("Halton") ? gsl_qrng_halton : gsl_qrng_sobol;
    all.push_back(
        {std::string("GSL's ") + kind + " points",
         [sequence = gsl_qrng_alloc(type, dims), point = std::vector<double>(dims)]() mutable {
           gsl_qrng_init(sequence);
           for (std::size_t i = 0; i < block; ++i) gsl_qrng_get(sequence, point.data());
           sink = point[0];
         }});
#endif
    compare(std::string(what) + ", " + std::to_string(dims) + "D",
            static_cast<double>(block) * dims, ours, all);
  };
  race("radical_inverses", columns([&](unsigned d) { radical_inverses(bases[d], 0, x); }),
       "blocks, each a step from the one before",
       columns([&](unsigned d) { inverses_by_blocks(bases[d], x.data(), block); }), "Halton");
  const auto plain_columns =
      columns([&](unsigned d) { plain[d](x.data(), [](std::uint32_t value) { return value; }); });
  race("sobol", columns([&](unsigned d) { sobol(d, 0, x); }), "blocks, each by one XOR",
       plain_columns, "Sobol'");
  race("owen_scramble", columns([&](unsigned d) {
         sobol(d, 0, x);
         owen_scramble(x, d);
       }),
       "those blocks, 32 bits scrambled by a hash", columns([&](unsigned d) {
         plain[d](x.data(), [d](std::uint32_t value) { return hashed(value, d); });
       }),
       "Sobol'");
}

}  // namespace
}  // namespace mc::ratios

int main(int argc, char**) {
  using namespace mc::ratios;
  if (argc > 1) {
    measure_samplers();
    return 0;
  }
  moments_of("moments, in cache", block);
  moments_of("moments, out of cache", std::size_t{1} << 23);  // 64 MB
  blocks_of_uniforms();
  jittered("stratified_2d, 64 points", 8);
  jittered("stratified_2d, 1024 points", 32);
#ifdef MC_HAVE_OPENQMC
  for (const std::size_t n : {1u, 4u, 16u, 64u}) few_samples(n);
#endif
  for (const unsigned dims : {2u, 8u}) sequences(dims);
}
