// The data of lab 3's plots: patterns, a picture, errors against N with the variance that is left
// within the strata, what stopping early costs, and time against error. A task that is not written,
// or fails, leaves a gap.

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <functional>
#include <set>

#include "checks/support/catch.hpp"
#include "checks/support/data.hpp"
#include "checks/support/exact_stratified.hpp"
#include "measurements/stratification/samplers.hpp"

namespace mc::checks {
namespace {

using experiments::Function;
using Maybe = std::optional<double>;
using Values = std::vector<double>;

/// Measures by points of a task, unless that task has once run out of time: it would again.
template <class Measure>
auto patiently(unsigned task, Measure measure) -> decltype(measure()) {
  static std::set<unsigned> endless;
  if (endless.contains(task)) return {};
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  auto got = measure();
  if (!got && Clock::now() - start > std::chrono::seconds(1)) endless.insert(task);
  return got;
}

// Errors ------------------------------------------------------------------------------------------

constexpr double edge = 0.1;

/// An integrand of the plots, and what one stratified pattern of n points makes of it.
struct Case {
  const char* name;
  Function g;
  std::size_t dims;
  std::vector<unsigned> tasks;                    ///< the ways to sample it
  std::vector<std::size_t> sizes;                 ///< N
  std::function<WithinStrata(std::size_t)> over;  ///< strata of the first task, for N
  double rate;                                    ///< its error falls as N^-rate
};

WithinStrata square(double (*h)(double), std::size_t side) {
  const auto axis = strata_of(h, side);
  return product_of(axis, axis);
}

Case line() {
  return {"line",
          {1, 1, 0, edge},
          1,
          {1},
          {1, 2, 4, 8, 16, 32, 64, 128, 256, 512, 1024},
          [](std::size_t n) { return strata_of([](double x) { return std::exp(x); }, n); },
          1.5};
}
Case plane() {
  return {
      "plane",
      {3, 1, 0, edge},
      2,
      {3, 6, 7},
      {1, 4, 16, 64, 256, 1024, 4096},
      [](std::size_t n) { return square([](double x) { return std::exp(-x * x); }, root(n, 2)); },
      1};
}
Case across_an_edge() {
  return {"edge",
          {5, 1, 0, edge},
          2,
          {3, 6, 7},
          {1, 4, 16, 64, 256, 1024, 4096},
          [](std::size_t n) { return edge_strata(edge, root(n, 2)); },
          0.75};
}
Case four_dimensions() {
  return {"four",
          {2, 1, 0, edge},
          4,
          {5, 4, 6},
          {1, 16, 81, 256, 625, 1296, 2401, 4096},
          [](std::size_t n) {
            const auto pair = square([](double x) { return std::exp(x - 0.5); }, root(n, 4));
            return product_of(pair, pair);
          },
          0.75};
}

/// Over 400 sets where they are small, 100 at the least: the RMSE's own standard error is 3.5 to 7
/// % of it, and a mark is as wide.
Maybe mean_squared_error(unsigned task, const Case& of, std::size_t n, std::size_t used) {
  const std::size_t sets = std::clamp<std::size_t>((1u << 17) / n, 100, 400);
  const auto got = patiently(task, [&] {
    return TRY_MEASURE(estimates, task, of.g, of.dims, n, used, sets, 1000 * task + n);
  });
  const Values* const estimates = got ? got->if_exactly(sets) : nullptr;
  if (estimates == nullptr) return {};
  const double exact = mean_of(of.over(1));
  double sum = 0;
  for (const double value : *estimates) sum += (value - exact) * (value - exact);
  return sum / static_cast<double>(sets);
}

Maybe root_of(const Maybe& squared) {
  if (!squared) return {};
  return std::sqrt(*squared);
}

Maybe error_of(unsigned task, const Case& of, std::size_t n, std::size_t used) {
  return root_of(mean_squared_error(task, of, n, used));
}

/// Errors against N, and the fraction of the variance that the first way leaves within the strata.
void plot_errors(const Case& one) {
  auto errors = plot_file(std::string("convergence-") + one.name + ".tsv");
  auto shares = plot_file(std::string("within-") + one.name + ".tsv");
  const double whole = one.over(1).variance[0];
  const auto largest = static_cast<double>(one.sizes.back());
  const double last = std::sqrt(stratified_variance(one.over(one.sizes.back())));
  for (const std::size_t n : one.sizes) {
    const auto size = static_cast<double>(n);
    const Maybe first = mean_squared_error(one.tasks[0], one, n, n);
    // N, the two lines of theory, independent points, the ways of this lab.
    std::vector<Maybe> row{size, std::sqrt(whole / size),
                           last * std::pow(size / largest, -one.rate), error_of(0, one, n, n),
                           root_of(first)};
    for (std::size_t way = 1; way < one.tasks.size(); ++way) {
      row.push_back(error_of(one.tasks[way], one, n, n));
    }
    plot_row(errors, row);
    Maybe share;
    if (first) share = *first * size / whole;
    plot_row(shares,
             std::array<Maybe, 3>{size, stratified_variance(one.over(n)) * size / whole, share});
  }
}

TEST_CASE("plot the error against N on the line", "[.plot]") {
  plot_errors(line());
}
TEST_CASE("plot the error against N in the plane", "[.plot]") {
  plot_errors(plane());
}
TEST_CASE("plot the error against N across an edge", "[.plot]") {
  plot_errors(across_an_edge());
}
TEST_CASE("plot the error against N in four dimensions", "[.plot]") {
  plot_errors(four_dimensions());
}

TEST_CASE("plot what stopping early costs", "[.plot]") {
  auto file = plot_file("early.tsv");
  const Case one = plane();
  for (const std::size_t used : {1u,   2u,   4u,   8u,   16u,  32u,  64u,   128u,  256u,  384u,
                                 512u, 640u, 768u, 896u, 960u, 992u, 1008u, 1016u, 1020u, 1024u}) {
    plot_row(file,
             std::array<Maybe, 4>{static_cast<double>(used), error_of(0, one, 1024, used),
                                  error_of(3, one, 1024, used), error_of(4, one, 1024, used)});
  }
}

// Pictures ----------------------------------------------------------------------------------------

TEST_CASE("plot patterns of 64 points", "[.plot]") {
  auto file = plot_file("patterns.tsv");
  Rng rng(7);
  constexpr std::size_t n = 64;
  std::vector<std::optional<PointSets>> patterns{PointSets{n, 2, uniform_values(rng, 2 * n, 0, 1)}};
  for (const unsigned task : {3u, 6u, 7u}) {
    patterns.push_back(patiently(task, [&] { return points_of(task, n, 2, 1, 1); }));
  }
  for (std::size_t i = 0; i < n; ++i) {
    std::vector<Maybe> row;
    for (const auto& pattern : patterns) {
      row.push_back(pattern ? Maybe(pattern->values[i]) : Maybe());
      row.push_back(pattern ? Maybe(pattern->values[n + i]) : Maybe());
    }
    plot_row(file, row);
  }
}

TEST_CASE("plot a soft shadow with 16 samples a pixel", "[.plot]") {
  constexpr std::size_t width = 128;
  for (const unsigned task : {0u, 3u, 7u}) {
    auto file = plot_file("shadow-" + std::to_string(task) + ".tsv");
    const auto got = TRY_MEASURE(shadow, task, width, 16, 1);
    const Values* const pixels = got ? got->if_exactly(width * width, closed_unit) : nullptr;
    for (std::size_t row = 0; row < width; ++row) {
      std::array<Maybe, width> shades;
      for (std::size_t i = 0; pixels && i < width; ++i) shades[i] = (*pixels)[row * width + i];
      plot_row(file, shades);
    }
  }
}

// Speed -------------------------------------------------------------------------------------------

TEST_CASE("plot time against error", "[.plot]") {
  auto file = plot_file("speed.tsv");
  const Case one = plane();
  constexpr std::size_t n = 1024;  // 16 KB: in the first-level cache
  const auto nanoseconds = [&](const Rounds& run) -> Maybe {
    const auto round = seconds_a_round(run, 0.01);
    if (!round) return {};
    return *round * 1e9 / n;
  };
  const auto textbook = nanoseconds([&](std::uint64_t rounds) {
    return cpu_seconds_of(TRY_MEASURE(repeat_textbook, 2, n, rounds));
  });
  plot_row(file, std::array<Maybe, 2>{textbook, error_of(3, one, n, n)});
  for (const unsigned task : {0u, 3u, 4u, 5u, 6u, 7u}) {
    const auto time = nanoseconds([&](std::uint64_t rounds) {
      return patiently(task,
                       [&] { return cpu_seconds_of(TRY_MEASURE(repeat, task, n, 2, rounds, 1)); });
    });
    plot_row(file, std::array<Maybe, 2>{time, error_of(task, one, n, n)});
  }
}

}  // namespace
}  // namespace mc::checks
