// The data of lab 3's plots: patterns, a picture, errors against N, the variance that is left
// within the strata, what stopping early costs, and time against error.

#include <array>
#include <cmath>
#include <functional>

#include "3-stratification/experiments.hpp"
#include "checks/support/catch.hpp"
#include "checks/support/data.hpp"
#include "checks/support/exact_stratified.hpp"
#include "checks/support/plot_data.hpp"

namespace mc::checks {
namespace {

using experiments::Function;
using Maybe = std::optional<double>;
using Values = std::vector<double>;

constexpr double edge = 0.1;

double exponential(double x) {
  return std::exp(x);
}
double centred_exponential(double x) {
  return std::exp(x - 0.5);
}
double gaussian(double x) {
  return std::exp(-x * x);
}

/// An integrand of the plots, and what one stratified pattern of n points makes of it.
struct Case {
  const char* name;
  Function g;
  std::size_t dims;
  std::vector<unsigned> tasks;                         ///< the ways to sample it
  std::vector<std::size_t> sizes;                      ///< N
  std::function<WithinStrata(std::size_t)> over = {};  ///< strata of the first task, for N
  double rate = 0.5;                                   ///< its error falls as N^-rate
};

std::size_t root(std::size_t n, double d) {
  return static_cast<std::size_t>(std::llround(std::pow(static_cast<double>(n), 1 / d)));
}

std::vector<Case> cases() {
  const auto square = [](double (*h)(double), std::size_t side) {
    const auto axis = strata_of(h, side);
    return product_of(axis, axis);
  };
  return {{"line",
           {1, 1, 0, edge},
           1,
           {1},
           {1, 2, 4, 8, 16, 32, 64, 128, 256, 512, 1024},
           [](std::size_t n) { return strata_of(exponential, n); },
           1.5},
          {"plane",
           {3, 1, 0, edge},
           2,
           {3, 6, 7},
           {1, 4, 16, 64, 256, 1024, 4096},
           [=](std::size_t n) { return square(gaussian, root(n, 2)); },
           1},
          {"edge",
           {5, 1, 0, edge},
           2,
           {3, 6, 7},
           {1, 4, 16, 64, 256, 1024, 4096},
           [](std::size_t n) { return edge_strata(edge, root(n, 2)); },
           0.75},
          {"four",
           {2, 1, 0, edge},
           4,
           {5, 4, 6},
           {1, 16, 81, 256, 625, 1296, 2401, 4096},
           [=](std::size_t n) {
             const auto plane = square(centred_exponential, root(n, 4));
             return product_of(plane, plane);
           },
           0.75}};
}

Maybe mean_squared_error(unsigned task, const Case& of, std::size_t n, std::size_t used,
                         std::size_t sets) {
  const auto got = TRY_MEASURE(estimates, task, of.g, of.dims, n, used, sets, 1000 * task + n);
  if (!got) return {};
  const double exact = mean_of(of.over(1));
  double sum = 0;
  for (const double value : got->value) sum += (value - exact) * (value - exact);
  return sum / static_cast<double>(sets);
}

Maybe error_of(unsigned task, const Case& of, std::size_t n, std::size_t used) {
  const auto squared = mean_squared_error(task, of, n, used, 400);
  if (!squared) return {};
  return std::sqrt(*squared);
}

TEST_CASE("plot patterns of 64 points", "[.plot]") {
  auto file = plot_file("patterns.tsv");
  Rng rng(7);
  constexpr std::size_t n = 64;
  Values columns[8] = {uniform_values(rng, n, 0, 1), uniform_values(rng, n, 0, 1)};
  if (const auto got = TRY_MEASURE(stratified_2d, {8, 8}, 1, 1)) {
    columns[2] = got->value.x, columns[3] = got->value.y;
  }
  if (const auto got = TRY_MEASURE(latin_hypercube, n, 2, 1, 1)) {
    columns[4].assign(got->value.begin(), got->value.begin() + n);
    columns[5].assign(got->value.begin() + n, got->value.end());
  }
  if (const auto got = TRY_MEASURE(multi_jittered, {8, 8}, 1, 1)) {
    columns[6] = got->value.x, columns[7] = got->value.y;
  }
  for (std::size_t i = 0; i < n; ++i) {
    std::array<Maybe, 8> row;
    for (std::size_t c = 0; c < 8; ++c) {
      if (i < columns[c].size()) row[c] = columns[c][i];
    }
    plot_row(file, row);
  }
}

TEST_CASE("plot a soft shadow with 16 samples a pixel", "[.plot]") {
  constexpr std::size_t width = 128;
  for (const unsigned task : {0u, 3u, 7u}) {
    auto file = plot_file("shadow-" + std::to_string(task) + ".tsv");
    const auto got = TRY_MEASURE(shadow, task, width, 16, 1);
    for (std::size_t row = 0; row < width; ++row) {
      std::array<Maybe, width> pixels;
      for (std::size_t i = 0; got && i < width; ++i) pixels[i] = got->value[row * width + i];
      plot_row(file, pixels);
    }
  }
}

TEST_CASE("plot the error against N", "[.plot]") {
  for (const Case& one : cases()) {
    auto file = plot_file(std::string("convergence-") + one.name + ".tsv");
    const auto whole = one.over(1);
    const auto largest = static_cast<double>(one.sizes.back());
    const double last = std::sqrt(stratified_variance(one.over(one.sizes.back())));
    for (const std::size_t n : one.sizes) {
      const auto size = static_cast<double>(n);
      // N, the two lines of theory, independent points, the ways of this lab.
      std::vector<Maybe> row{size, std::sqrt(whole.variance[0] / size),
                             last * std::pow(size / largest, -one.rate), error_of(0, one, n, n)};
      for (const unsigned task : one.tasks) row.push_back(error_of(task, one, n, n));
      plot_row(file, row);
    }
  }
}

TEST_CASE("plot the variance within the strata", "[.plot]") {
  for (const Case& one : cases()) {
    auto file = plot_file(std::string("within-") + one.name + ".tsv");
    const double whole = one.over(1).variance[0];
    for (const std::size_t n : one.sizes) {
      const auto squared = mean_squared_error(one.tasks[0], one, n, n, 400);
      Maybe share;
      if (squared) share = *squared * static_cast<double>(n) / whole;
      const double exact = stratified_variance(one.over(n)) * static_cast<double>(n) / whole;
      plot_row(file, std::array<Maybe, 3>{static_cast<double>(n), exact, share});
    }
  }
}

TEST_CASE("plot what stopping early costs", "[.plot]") {
  auto file = plot_file("early.tsv");
  const Case plane = cases()[1];
  for (const std::size_t used : {1u,   2u,   4u,   8u,   16u,  32u,  64u,   128u,  256u,  384u,
                                 512u, 640u, 768u, 896u, 960u, 992u, 1008u, 1016u, 1020u, 1024u}) {
    plot_row(file,
             std::array<Maybe, 4>{static_cast<double>(used), error_of(0, plane, 1024, used),
                                  error_of(3, plane, 1024, used), error_of(4, plane, 1024, used)});
  }
}

TEST_CASE("plot time against error", "[.plot]") {
  auto file = plot_file("speed.tsv");
  const Case plane = cases()[1];
  constexpr std::size_t n = 1024;  // 16 KB: in the first-level cache
  const auto nanoseconds = [&](const std::function<Maybe(std::uint64_t)>& run) -> Maybe {
    const auto round = seconds_a_round(run);
    if (!round) return {};
    return *round * 1e9 / n;
  };
  const auto textbook = nanoseconds([&](std::uint64_t rounds) -> Maybe {
    const auto got = TRY_MEASURE(repeat_textbook, 2, n, rounds);
    if (!got) return {};
    return got->cpu_seconds;
  });
  plot_row(file, std::array<Maybe, 2>{textbook, error_of(3, plane, n, n)});
  for (const unsigned task : {0u, 3u, 4u, 5u, 6u, 7u}) {
    const auto time = nanoseconds([&](std::uint64_t rounds) -> Maybe {
      const auto got = TRY_MEASURE(repeat, task, n, 2, rounds);
      if (!got) return {};
      return got->cpu_seconds;
    });
    plot_row(file, std::array<Maybe, 2>{time, error_of(task, plane, n, n)});
  }
}

}  // namespace
}  // namespace mc::checks
