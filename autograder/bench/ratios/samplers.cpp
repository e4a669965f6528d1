// Samplers with the interface of lab 6, ours and those of libraries, on scenes and functions:
// RMSE and time against the number of samples. All in one process and in turn, so that times can be
// compared.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <numbers>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "bench/ratios/ratios.hpp"
#include "checks/support/scenes_exact.hpp"
#include "common/rng.hpp"
#include "common/scenes.hpp"
#include "sampler.hpp"

#ifdef MC_HAVE_BOOST
#include <boost/random/sobol.hpp>
#endif
#ifdef MC_HAVE_GSL
#include <gsl/gsl_qrng.h>
#endif
#ifdef MC_HAVE_OPENQMC
#include <oqmc/lattice.h>
#include <oqmc/pmj.h>
#endif

namespace mc::ratios {
namespace {

/// A function of a sampler, and its mean.
struct Integrand {
  double mean;
  std::function<double(Sampler&)> value;
};

/// The same function for every seed, or a random one.
struct Function {
  std::string name;
  std::size_t dims;
  std::function<Integrand(std::uint64_t seed)> by_seed;
};

double uniform(Rng& rng) {
  return static_cast<double>(rng() >> 11) * 0x1p-53;
}

template <class Scene>
Function scene(const char* name, std::size_t dims) {
  return {name, dims, [](std::uint64_t) { return Integrand{checks::exact(Scene{}), Scene{}}; }};
}

/// Half-planes at all angles whose edge crosses the middle of the pixel.
Integrand half_plane(std::uint64_t seed) {
  Rng rng(seed);
  const double angle = std::numbers::pi / 2 * uniform(rng), a = std::cos(angle),
               b = std::sin(angle);
  const scenes::PixelEdge edge{a, b, (a + b) * (0.25 + 0.5 * uniform(rng))};
  return {checks::exact(edge), edge};
}
/// Disks within the pixel.
Integrand disk(std::uint64_t seed) {
  Rng rng(seed);
  const double r = 0.2 + 0.2 * uniform(rng), x = r + (1 - 2 * r) * uniform(rng),
               y = r + (1 - 2 * r) * uniform(rng);
  return {std::numbers::pi * r * r, [=](Sampler& sampler) {
            const Point2 p = sampler.next2();
            return (p.x - x) * (p.x - x) + (p.y - y) * (p.y - y) < r * r ? 1 : 0;
          }};
}

/// Of d dimensions, by next2(): exp(x_1 + …); and 1 where x_1 + … < 0.45 d: no symmetry helps.
template <std::size_t dims, class Value>
Function of_sum(const std::string& name, double mean, Value value) {
  return {name + ' ' + std::to_string(dims) + 'D', dims, [=](std::uint64_t) {
            return Integrand{mean, [=](Sampler& sampler) {
                               double sum = 0;
                               for (std::size_t d = 0; d < dims; d += 2) {
                                 const Point2 p = sampler.next2();
                                 sum += p.x + p.y;
                               }
                               return value(sum);
                             }};
          }};
}
template <std::size_t dims>
Function smooth() {
  return of_sum<dims>("smooth", std::pow(std::expm1(1.0), static_cast<double>(dims)),
                      [](double sum) { return std::exp(sum); });
}
template <std::size_t dims>
Function edge() {
  constexpr double below = 0.45 * dims;
  // The volume (Irwin and Hall): the alternating sum of binomial(d, k) (below - k)^d / d!.
  double volume = 0, term = 1 / std::tgamma(dims + 1.0);
  for (std::size_t k = 0; static_cast<double>(k) < below; ++k) {
    volume += term * std::pow(below - static_cast<double>(k), dims);
    term *= -static_cast<double>(dims - k) / static_cast<double>(k + 1);
  }
  return of_sum<dims>("edge", volume, [](double sum) { return sum < below ? 1.0 : 0.0; });
}

std::vector<Function> functions() {
  return {scene<scenes::PixelEdge>("pixel edge", 2),
          scene<scenes::RectangleLight>("rectangular light", 2),
          scene<scenes::DiskPenumbra>("penumbra of a disk", 2),
          scene<scenes::SphereOcclusion>("occlusion by a sphere", 2),
          scene<scenes::DefocusEdge>("defocused edge", 2),
          scene<scenes::MotionEdge>("moving edge", 2),
          scene<scenes::PixelTimeLens>("pixel, time, lens", 5),
          {"random half-planes", 2, half_plane},
          {"random disks", 2, disk},
          smooth<2>(),
          smooth<4>(),
          edge<4>(),
          smooth<8>(),
          edge<8>()};
}

/// The standard library's numbers, by one engine for all integrations: to seed it costs 500 ns.
class Standard final : public Sampler {
 public:
  void generate(std::size_t, std::uint64_t seed) override {
    if (!is_seeded_) engine_.seed(seed);
    is_seeded_ = true;
  }
  double next() override { return uniform_(engine_); }
  Point2 next2() override { return {next(), next()}; }  // braces: x comes first
  void advance() override {}

 private:
  bool is_seeded_ = false;
  std::mt19937_64 engine_;
  std::uniform_real_distribution<double> uniform_{0, 1};
};

/// A library's points, one after the other: restarted, and drawn into a point.
struct Sequence {
  std::function<void()> begin;
  std::function<void(std::vector<double>& point)> draw;
};

/// Such points moved by a random vector (Cranley and Patterson), for they are always the same.
class Shifted final : public Sampler {
 public:
  Shifted(std::size_t dims, Sequence points)
      : points_(std::move(points)), point_(dims), shift_(dims) {}
  void generate(std::size_t, std::uint64_t seed) override {
    Rng rng(seed);
    for (double& shift : shift_) shift = uniform(rng);
    points_.begin();
    advance();
  }
  double next() override {
    const double x = point_[next_] + shift_[next_];
    ++next_;
    return x < 1 ? x : x - 1;
  }
  Point2 next2() override { return {next(), next()}; }
  void advance() override { points_.draw(point_), next_ = 0; }

 private:
  Sequence points_;
  std::vector<double> point_, shift_;
  std::size_t next_ = 0;
};

#ifdef MC_HAVE_BOOST
Sequence boost_sobol(std::size_t dims) {
  const auto engine = std::make_shared<boost::random::sobol>(dims);
  return {[=] { engine->seed(); },
          [=](std::vector<double>& point) {
            for (double& x : point) x = static_cast<double>((*engine)()) * 0x1p-64;
          }};
}
#endif
#ifdef MC_HAVE_GSL
Sequence gsl_sobol(std::size_t dims) {
  const std::shared_ptr<gsl_qrng> all(gsl_qrng_alloc(gsl_qrng_sobol, static_cast<unsigned>(dims)),
                                      gsl_qrng_free);
  return {[=] { gsl_qrng_init(all.get()); },
          [=](std::vector<double>& point) { gsl_qrng_get(all.get(), point.data()); }};
}
#endif

#ifdef MC_HAVE_OPENQMC
/// A pixel per integration, a domain for each four dimensions, of which no more are drawn than are
/// asked for.
template <class Library>
class OpenQmc final : public Sampler {
 public:
  explicit OpenQmc(std::size_t dims) : dims_(dims) {}
  void generate(std::size_t, std::uint64_t seed) override {
    pixel_ = static_cast<int>(seed);
    index_ = 0;
    begin();
  }
  double next() override {
    if (used_ % 4 == 0) draw();
    return static_cast<double>(sample_[used_++ % 4]);
  }
  Point2 next2() override { return {next(), next()}; }
  void advance() override { ++index_, begin(); }

 private:
  void begin() {
    sampler_ = Library(pixel_ & 255, pixel_ >> 8 & 255, pixel_ >> 16, index_, cache());
    used_ = 0;
  }
  void draw() {
    const auto domain = sampler_.newDomain(static_cast<int>(used_));
    switch (std::min<std::size_t>(4, dims_ - used_)) {
      case 1:
        return domain.template drawSample<1>(sample_);
      case 2:
        return domain.template drawSample<2>(sample_);
      case 3:
        return domain.template drawSample<3>(sample_);
      default:
        return domain.template drawSample<4>(sample_);
    }
  }
  static const void* cache() {
    static const std::vector<std::byte> made = [] {
      std::vector<std::byte> bytes(Library::cacheSize + 1);
      Library::initialiseCache(bytes.data());
      return bytes;
    }();
    return made.data();
  }
  std::size_t dims_, used_ = 0;
  int pixel_ = 0, index_ = 0;
  Library sampler_;
  float sample_[4]{};
};
#endif

struct Contender {
  std::string name;
  std::function<std::unique_ptr<Sampler>(std::size_t dims)> make;
  std::size_t most = 1024;  ///< samples
};

std::vector<Contender> contenders() {
  std::vector<Contender> all;
  for (const char* kind :
       {"independent", "stratified", "blue_noise", "halton", "sobol", "lattice"}) {
    all.push_back({kind, [kind](std::size_t) { return make_sampler(kind); },
                   kind == std::string("blue_noise") ? 64u : 1024u});
  }
  all.push_back({"std::mt19937_64", [](std::size_t) { return std::make_unique<Standard>(); }});
#ifdef MC_HAVE_BOOST
  all.push_back({"Boost's Sobol'", [](std::size_t dims) {
                   return std::make_unique<Shifted>(dims, boost_sobol(dims));
                 }});
#endif
#ifdef MC_HAVE_GSL
  all.push_back({"GSL's Sobol'", [](std::size_t dims) {
                   return std::make_unique<Shifted>(dims, gsl_sobol(dims));
                 }});
#endif
#ifdef MC_HAVE_OPENQMC
  all.push_back({"OpenQMC's pmj", [](std::size_t dims) {
                   return std::make_unique<OpenQmc<oqmc::PmjSampler>>(dims);
                 }});
  all.push_back({"OpenQMC's lattice", [](std::size_t dims) {
                   return std::make_unique<OpenQmc<oqmc::LatticeSampler>>(dims);
                 }});
#endif
  return all;
}

double mean_of(const Integrand& integrand, Sampler& sampler, std::size_t n, std::uint64_t seed) {
  sampler.generate(n, seed);
  double sum = 0;
  for (std::size_t sample = 0; sample < n; ++sample, sampler.advance()) {
    sum += integrand.value(sampler);
  }
  return sum / static_cast<double>(n);
}

/// The standard error of an RMSE is 1/sqrt(2 · 4000) = 1.1 % of it, if errors are normal.
constexpr std::uint64_t replicates = 4000;
double rmse_of(const Function& function, Sampler& sampler, std::size_t n) {
  double squares = 0;
  for (std::uint64_t seed = 1; seed <= replicates; ++seed) {
    const Integrand integrand = function.by_seed(seed % 60);
    const double error = mean_of(integrand, sampler, n, seed) / integrand.mean - 1;
    squares += error * error;
  }
  return std::sqrt(squares / replicates);
}

}  // namespace

void measure_samplers() {
  const auto all = contenders();
  for (const Function& function : functions()) {
    const Integrand integrand = function.by_seed(1);
    for (const std::size_t n : {1, 2, 4, 8, 10, 16, 32, 64, 100, 128, 256, 512, 1024}) {
      std::vector<std::unique_ptr<Sampler>> samplers;
      for (const Contender& one : all) samplers.push_back(one.make(function.dims));
      // In turn, the best of fifteen.
      std::vector<double> times(all.size(), std::numeric_limits<double>::infinity());
      std::uint64_t seed = 0;
      for (int round = 0; round < 15; ++round) {
        for (std::size_t k = 0; k < all.size(); ++k) {
          if (n > all[k].most) continue;
          times[k] = std::min(
              times[k], nanoseconds([&] { sink = mean_of(integrand, *samplers[k], n, ++seed); }));
        }
      }
      for (std::size_t k = 0; k < all.size(); ++k) {
        if (n > all[k].most) continue;
        print({.lab = "sampler",
               .method = all[k].name,
               .integrand = function.name,
               .dimensions = function.dims,
               .n = n,
               .rmse = rmse_of(function, *samplers[k], n),
               .ns = times[k] / static_cast<double>(n)});
      }
    }
  }
}

}  // namespace mc::ratios
