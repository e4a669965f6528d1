// What lab 3 checks. Where points must lie is exact: strata are counted, with the edges that double
// division gives. How they lie there is random: jitter is compared with uniform and independent
// numbers, orders with all orders, and mean squared errors with the exact variances at that very N
// (exact_stratified.hpp). All sets are fresh in each run, and nothing depends on the order in which
// a submission draws or visits its cells.
//
// Every random test has the same alpha; there are 55 of them. What they see nearly always (999
// times in 1000, by the quantiles of their distributions): a mean squared error 1.5 times the exact
// one, or 0.66 times (1000 replicates); an exponent off by 0.15 (500 replicates, sizes 16 times
// apart); jitter that leaves out a fiftieth of its stratum.

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <optional>

#include <fmt/format.h>

#include "3-stratification/experiments.hpp"
#include "checks/support/catch.hpp"
#include "checks/support/data.hpp"
#include "checks/support/exact_stratified.hpp"
#include "checks/support/expect.hpp"
#include "checks/support/measure.hpp"
#include "checks/support/statistics.hpp"
#include "checks/support/strata.hpp"

namespace mc::checks {
namespace {

using experiments::Function;
using experiments::Points;
using experiments::Replicated;
using Values = std::vector<double>;
using View = std::span<const double>;

constexpr double alpha = 1e-8;
constexpr std::uint64_t all_ones = ~std::uint64_t{0};

std::uint64_t fresh_seed(Rng& rng) {
  return rng() >> 32;  // short enough to be typed again
}

/// `size` of the numbers, from `first`; ends the check where there are not so many.
template <class T>
std::span<const T> part(const std::vector<T>& all, std::size_t first, std::size_t size) {
  if (first > all.size() || size > all.size() - first) {
    fail(fmt::format("measured  {} numbers\nexpected  {} at least", all.size(), first + size));
  }
  return std::span(all).subspan(first, size);
}

// Strata ------------------------------------------------------------------------------------------

/// Where x lies within its stratum: the number in [0,1) that its jitter came from.
double jitter_of(double x, std::size_t n) {
  if (!(x >= 0 && x < 1)) return 0;
  const double scaled = x * static_cast<double>(n);
  return std::clamp(scaled - std::floor(scaled), 0.0, 1 - 0x1p-53);
}

Values jitters_of(View x, std::size_t n) {
  Values jitters;
  for (const double value : x) jitters.push_back(jitter_of(value, n));
  return jitters;
}

void expect_in_order(const std::string& call, View x, const std::string& elsewhere) {
  const std::size_t n = x.size();
  expect_inside(call, "x", x);
  for (std::size_t i = 0; i < n; ++i) {
    if (stratum_of(x[i], n) == i) continue;
    const double low = static_cast<double>(i) / static_cast<double>(n);
    const double high = static_cast<double>(i + 1) / static_cast<double>(n);
    Values sorted(x.begin(), x.end());
    std::sort(sorted.begin(), sorted.end());
    bool only_order = true;
    for (std::size_t k = 0; k < n; ++k) only_order = only_order && stratum_of(sorted[k], n) == k;
    expect_that(false, fmt::format("{}: x[{}] = {}", call, i, x[i]),
                fmt::format("a value in [{}/{}, {}/{}) = [{}, {})", i, n, i + 1, n, low, high),
                "point i lies in stratum i, with edges i / N and (i+1) / N in double division",
                only_order     ? "every stratum has its point, but they do not come in order"
                : x[i] == high ? "it was rounded up to the edge: hold the point below i + 1, over N"
                : std::nextafter(x[i], 1.0) == low
                    ? "it was rounded down below the edge: 1 / N is rounded, and so is its product"
                    : elsewhere);
  }
  pass();
}

// Jitter ------------------------------------------------------------------------------------------

/// What is wrong with jitters that are not uniform and independent, from looking at them.
std::string jitter_hint(Values jitters) {
  std::sort(jitters.begin(), jitters.end());
  const double low = jitters.front(), high = jitters.back();
  if (high - low < 1e-6) {
    return fmt::format("every point lies at {:.3g} of its stratum: it wants a random place there",
                       low);
  }
  if (high - low < 0.98) {
    return fmt::format("jitter covers only [{:.2g}, {:.2g}] of the stratum: u is uniform in [0, 1)",
                       low, high);
  }
  std::size_t repeated = 0;
  for (std::size_t k = 0; k + 1 < jitters.size(); ++k) {
    if (jitters[k + 1] - jitters[k] < 1e-9) ++repeated;
  }
  if (10 * repeated > jitters.size()) {
    return "the same random numbers come again and again: draw one for every coordinate, all from "
           "the generator that is passed in";
  }
  return "each point is (i + u) / n with a u of its own, uniform in [0, 1)";
}

void expect_uniform_jitter(const std::string& call, const Values& jitters,
                           const std::string& words) {
  const double each = 1.0 / 32;
  expect_counts(call, counts_of(jitters, 32), std::span(&each, 1), {words, alpha},
                {{}, jitter_hint(jitters)});
}

/// Pairs (u, v) that should be independent and uniform: counted in 8 x 8 cells. `same` is said
/// where u equals v, or 1 - v, in more than one pair of twenty.
void expect_independent(const std::string& call, const Values& u, const Values& v,
                        const std::string& words, const std::string& same) {
  if (u.empty() || u.size() != v.size()) fail("measured  " + call + " has no pairs of numbers");
  std::vector<std::uint64_t> counts(64);
  std::size_t equal = 0;
  for (std::size_t k = 0; k < u.size(); ++k) {
    ++counts[static_cast<std::size_t>(u[k] * 8) * 8 + static_cast<std::size_t>(v[k] * 8)];
    if (std::abs(u[k] - v[k]) < 1e-6 || std::abs(u[k] + v[k] - 1) < 1e-6) ++equal;
  }
  const double each = 1.0 / 64;
  Values both = u;
  both.insert(both.end(), v.begin(), v.end());
  const auto [low, high] = std::minmax_element(both.begin(), both.end());
  const bool moves = *high - *low > 1e-6;
  expect_counts(call, counts, std::span(&each, 1), {words, alpha},
                {{}, moves && 20 * equal > u.size() ? same : jitter_hint(both)});
}

const std::string one_for_all = "the same random number moves both: draw one for every coordinate";

// Orders ------------------------------------------------------------------------------------------

/// The number, below n!, of a permutation of 0 … n-1 (Lehmer's code).
std::size_t rank_of(std::span<const std::size_t> order) {
  std::size_t rank = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const auto smaller = std::count_if(order.begin() + static_cast<std::ptrdiff_t>(i), order.end(),
                                       [&](std::size_t other) { return other < order[i]; });
    rank = rank * (order.size() - i) + static_cast<std::size_t>(smaller);
  }
  return rank;
}

/// Orders of `size` things (each a permutation, one after the other) are all equally likely.
void expect_all_orders(const std::string& call, const std::vector<std::size_t>& orders,
                       std::size_t size, const std::string& words, const std::string& always,
                       const std::string& otherwise) {
  std::size_t count = 1;
  for (std::size_t i = 2; i <= size; ++i) count *= i;
  std::vector<std::uint64_t> counts(count);
  for (std::size_t first = 0; first < orders.size(); first += size) {
    ++counts[rank_of(part(orders, first, size))];
  }
  const double each = 1 / static_cast<double>(count);
  const bool only_one = *std::max_element(counts.begin(), counts.end()) * size == orders.size();
  expect_counts(call, counts, std::span(&each, 1), {words, alpha},
                {{}, only_one ? always : otherwise});
}

/// For each set, the order of `to` where `from` is taken in order.
std::vector<std::size_t> relative_orders(const std::vector<std::size_t>& from,
                                         const std::vector<std::size_t>& to, std::size_t size) {
  std::vector<std::size_t> orders(from.size());
  for (std::size_t k = 0; k < from.size(); ++k) orders[k / size * size + from[k]] = to[k];
  return orders;
}

// Functions ---------------------------------------------------------------------------------------

double exponential(double x) {
  return std::exp(x);
}
double centred_exponential(double x) {
  return std::exp(x - 0.5);
}
double gaussian(double x) {
  return std::exp(-x * x);
}
double centred(double x) {
  return x - 0.5;
}

/// a g + b with fresh a and b: no answer can be recognised.
Function fresh_function(Rng& rng, unsigned kind) {
  return {kind, (rng() % 2 == 0 ? 1 : -1) * uniform(rng, 0.5, 2), uniform(rng, -1, 1),
          uniform(rng, 0.05, 0.15)};
}

double exact_mean_of(const Function& g, double mean) {
  return g.a * mean + g.b;
}

/// Mean squared errors of estimates(task, g, dims, n) are what they should be at N.
struct Expected {
  double mean;             ///< of g itself
  double variance;         ///< of a right estimate of g
  double kurtosis = 3;     ///< of a right estimate
  double independent = 0;  ///< variance of the mean of as many independent points
};

struct Estimates {
  std::string call;
  Values values;
};

Estimates estimates_of(Rng& rng, unsigned task, const Function& g, std::size_t dims, std::size_t n,
                       std::size_t used, std::size_t sets) {
  auto got = MEASURE(estimates, task, g, dims, n, used, sets, fresh_seed(rng));
  return {got.call, std::move(got.value)};
}

void expect_level(Rng& rng, unsigned task, const Function& g, std::size_t dims, std::size_t n,
                  std::size_t used, const Expected& expected, const std::string& words,
                  const std::string& otherwise) {
  const auto got = estimates_of(rng, task, g, dims, n, used, 1000);
  expect_variance({got.call, got.values, static_cast<double>(used)},
                  exact_mean_of(g, expected.mean), g.a * g.a * expected.variance, expected.kurtosis,
                  {words, alpha},
                  {{{expected.independent / expected.variance,
                     "that is the variance of independent points: nothing is stratified here"}},
                   otherwise});
}

void expect_slope(Rng& rng, unsigned task, const Function& g, std::size_t dims,
                  std::array<std::size_t, 2> n, const std::array<Expected, 2>& expected,
                  const std::string& words, const std::string& otherwise) {
  const auto few = estimates_of(rng, task, g, dims, n[0], n[0], 500);
  const auto many = estimates_of(rng, task, g, dims, n[1], n[1], 500);
  const auto known = [&](const Expected& at) {
    return Known{exact_mean_of(g, at.mean), g.a * g.a * at.variance, at.kurtosis};
  };
  expect_rate(
      {few.call, few.values, static_cast<double>(n[0])}, known(expected[0]),
      {many.call, many.values, static_cast<double>(n[1])}, known(expected[1]), {words, alpha},
      {{{0.5, "N^-1/2 is the rate of independent points: nothing is stratified here"}}, otherwise});
}

Expected expected_of(const WithinStrata& strata, double kurtosis = 3) {
  return {mean_of(strata), stratified_variance(strata), kurtosis,
          independent_variance(strata, strata.size())};
}

// 3.1 ---------------------------------------------------------------------------------------------

const std::string one_each = "one point in each stratum: (i + u) / N for i = 0 … N-1";

TEST_CASE("3.1 one point in each stratum and in order", "[3.1][points:3]") {
  Rng rng = check_rng();
  for (const std::size_t n : {1u, 2u, 3u, 7u, 10u, 64u, 1000u, 1009u}) {
    const auto got = MEASURE(stratified_1d, n, 3, fresh_seed(rng));
    for (std::size_t set = 0; set < 3; ++set) {
      expect_in_order(got.call, part(got.value, set * n, n), one_each);
    }
  }
}

TEST_CASE("3.1 each point is uniform in its stratum", "[3.1][points:4]") {
  Rng rng = check_rng();
  const auto many = MEASURE(stratified_1d, 16, 1000, fresh_seed(rng));
  expect_uniform_jitter(many.call, jitters_of(part(many.value, 0, 16000), 16),
                        "the points of 3.1 are uniform in their strata");
  const auto one = MEASURE(stratified_1d, 1, 8000, fresh_seed(rng));
  expect_uniform_jitter(one.call, jitters_of(part(one.value, 0, 8000), 1),
                        "one stratum is all of [0,1)");
}

TEST_CASE("3.1 the strata are independent of each other", "[3.1][points:3]") {
  Rng rng = check_rng();
  constexpr std::size_t n = 16, sets = 1000;
  const std::uint64_t seed = fresh_seed(rng);
  const auto got = MEASURE(stratified_1d, n, sets, seed);
  const auto next = MEASURE(stratified_1d, n, sets, seed + 1);
  const Values u = jitters_of(part(got.value, 0, n * sets), n);
  const Values w = jitters_of(part(next.value, 0, n * sets), n);
  Values even, odd, low, high, before, after;
  for (std::size_t k = 0; k < u.size(); ++k) {
    const std::size_t set = k / n, i = k % n;
    (i % 2 == 0 ? even : odd).push_back(u[k]);
    (set % 2 == 0 ? before : after).push_back(u[k]);
    if (i < n / 2) low.push_back(u[k]), high.push_back(u[set * n + n - 1 - i]);
  }
  expect_independent(got.call, before, after, "one set of 3.1 is independent of the next",
                     "the same numbers in every set: draw them from the generator you are given");
  expect_independent(got.call + " and the next seed", u, w,
                     "neighbouring seeds give independent points in 3.1",
                     "the same numbers for every seed: draw them from the generator you are given");
  expect_independent(got.call, even, odd, "neighbouring strata of 3.1 are independent",
                     one_for_all);
  expect_independent(got.call, low, high, "strata i and N-1-i of 3.1 are independent", one_for_all);
}

TEST_CASE("3.1 no point leaves its stratum whatever the bits", "[3.1][points:2]") {
  Rng rng = check_rng();
  for (const std::size_t n :
       {std::size_t{1}, std::size_t{2}, std::size_t{3}, std::size_t{5}, std::size_t{49},
        std::size_t{1000}, std::size_t{1009}, 2 + rng() % 5000, std::size_t{999983}}) {
    for (const std::uint64_t word : {all_ones, std::uint64_t{0}}) {
      const auto got = MEASURE(stratified_1d_constant, n, word);
      expect_in_order(got.call, part(got.value, 0, n), one_each);
    }
  }
}

TEST_CASE("3.1 the error falls as N^-1.5", "[3.1][points:3]") {
  Rng rng = check_rng();
  const std::string otherwise =
      "the variance within the strata is all that may be left: is each point uniform in its "
      "stratum, and independent of the others?";
  const auto expected = [](std::size_t n) { return expected_of(strata_of(exponential, n)); };
  expect_level(rng, 1, fresh_function(rng, 1), 1, 64, 64, expected(64),
               "estimates of a exp(x) + b over 64 strata have their exact variance", otherwise);
  expect_slope(rng, 1, fresh_function(rng, 1), 1, {16, 256}, {expected(16), expected(256)},
               "errors for a exp(x) + b fall as N^-1.5", otherwise);
}

// 3.2 ---------------------------------------------------------------------------------------------

Grid squarest(std::size_t n) {
  Grid best{n, 1};
  for (std::size_t ny = 1; ny * ny <= n; ++ny) {
    if (n % ny == 0) best = {n / ny, ny};
  }
  return best;
}

void expect_grids(const std::vector<std::uint64_t>& n) {
  const auto got = MEASURE(strata, n);
  expect_that(got.value.size() == n.size(), got.call, "a grid for each n", "", "");
  for (std::size_t k = 0; k < n.size(); ++k) {
    const Grid grid = got.value[k], best = squarest(n[k]);
    expect_that(grid.nx == best.nx && grid.ny == best.ny,
                fmt::format("strata({}) = {} x {}", n[k], grid.nx, grid.ny),
                fmt::format("{} x {}", best.nx, best.ny),
                "nx * ny = n with nx >= ny, as close to each other as the factors of n allow",
                grid.nx == best.ny && grid.ny == best.nx ? "nx is the larger one"
                : grid.nx * grid.ny != n[k]
                    ? "nx * ny must be n: a stratum too few leaves points out"
                    : "ny is the largest divisor of n that is not above its square root");
  }
}

TEST_CASE("3.2 the grid is as square as n allows", "[3.2][points:4]") {
  Rng rng = check_rng();
  std::vector<std::uint64_t> n(400);
  std::iota(n.begin(), n.end(), 1);
  expect_grids(n);
  // Squares, products of neighbours, and what lies beside them; products of many primes, of two.
  const std::uint64_t k = 2000 + rng() % 1000000;
  expect_grids({k * k, k * k - 1, k * (k + 1), 30030, 1u << 20, 1000000, 999999, 2 * 499979,
                1009 * 1013, std::uint64_t{1} << 40, 1000000000000, 2 + rng() % 1000000});
}

TEST_CASE("3.2 a prime number of cells is a row", "[3.2][points:2]") {
  expect_grids({2, 3, 5, 7, 101, 1009, 65537, 999983, 1000000007});
  expect_invalid_argument(MEASURE_OUTCOME(strata, {0}), "n|strata|cells",
                          "there is no grid without cells");
}

// 3.3 ---------------------------------------------------------------------------------------------

TEST_CASE("3.3 one point in each cell", "[3.3][points:5]") {
  Rng rng = check_rng();
  for (const Grid grid : {Grid{1, 1}, Grid{8, 8}, Grid{16, 4}, Grid{3, 5}, Grid{7, 1}, Grid{1, 11},
                          Grid{100, 10}, Grid{2 + rng() % 50, 2 + rng() % 50}}) {
    const std::size_t n = grid.nx * grid.ny;
    const auto got = MEASURE(stratified_2d, grid, 3, fresh_seed(rng));
    for (std::size_t set = 0; set < 3; ++set) {
      expect_one_in_each_cell(got.call, part(got.value.x, set * n, n),
                              part(got.value.y, set * n, n), grid);
    }
  }
}

TEST_CASE("3.3 each point is uniform in its cell", "[3.3][points:3]") {
  Rng rng = check_rng();
  const auto got = MEASURE(stratified_2d, {5, 3}, 800, fresh_seed(rng));
  expect_independent(got.call, jitters_of(got.value.x, 5), jitters_of(got.value.y, 3),
                     "the points of 3.3 are uniform in their cells",
                     "the same random number moves x and y: points lie on the cells' diagonals");
}

TEST_CASE("3.3 the cells are independent of each other", "[3.3][points:3]") {
  Rng rng = check_rng();
  constexpr std::size_t side = 4, n = side * side, sets = 1000;
  const auto got = MEASURE(stratified_2d, {side, side}, sets, fresh_seed(rng));
  Values u(n * sets), v(n * sets);  // by cell, row by row, in whatever order they came
  for (std::size_t set = 0; set < sets; ++set) {
    const auto x = part(got.value.x, set * n, n), y = part(got.value.y, set * n, n);
    const auto cells = expect_one_in_each_cell(got.call, x, y, {side, side});
    for (std::size_t k = 0; k < n; ++k) {
      u[set * n + cells[k]] = jitter_of(x[k], side);
      v[set * n + cells[k]] = jitter_of(y[k], side);
    }
  }
  // Each cell with its right-hand neighbour, with the one above it, with itself one set later; no
  // cell in two pairs of a kind.
  const auto expect_pairs = [&](std::size_t apart, const std::string& words) {
    Values u_here, u_there, v_here, v_there;
    for (std::size_t k = 0; k < n * sets; ++k) {
      if (k / apart % 2 == 1) continue;
      u_here.push_back(u[k]), u_there.push_back(u[k + apart]);
      v_here.push_back(v[k]), v_there.push_back(v[k + apart]);
    }
    expect_independent(got.call, u_here, u_there, "the x of 3.3 in " + words, one_for_all);
    expect_independent(got.call, v_here, v_there, "the y of 3.3 in " + words, one_for_all);
    expect_independent(got.call, u_here, v_there, "x and y of 3.3 in " + words, one_for_all);
  };
  expect_pairs(1, "cells side by side are independent");
  expect_pairs(side, "cells one above the other are independent");
  expect_pairs(n, "one set and the next are independent");
}

TEST_CASE("3.3 no point leaves its cell whatever the bits", "[3.3][points:2]") {
  Rng rng = check_rng();
  for (const Grid grid : {Grid{1, 1}, Grid{2, 3}, Grid{1009, 1}, Grid{1, 1009}, Grid{49, 98},
                          Grid{1 + rng() % 100, 1 + rng() % 100}}) {
    for (const std::uint64_t word : {all_ones, std::uint64_t{0}}) {
      const auto got = MEASURE(stratified_2d_constant, grid, word);
      expect_one_in_each_cell(got.call, got.value.x, got.value.y, grid);
    }
  }
}

/// Both tasks that fill a grid refuse what is none. nx * ny wraps around to 4 in the last one.
template <class Into>
void expect_refusals(Into into) {
  const Call sizes = into(6, 5, {3, 2}), product = into(6, 6, {3, 3}), few = into(6, 6, {2, 2});
  expect_invalid_argument(sizes, "x|y|size", "x and y are the coordinates of the same points");
  expect_invalid_argument(product, "grid", "six points do not fill nine cells");
  expect_invalid_argument(few, "grid", "four cells do not hold six points");
  expect_invalid_argument(into(0, 0, {0, 5}), "grid", "a grid has cells");
  expect_invalid_argument(into(0, 0, {5, 0}), "grid", "a grid has cells");
  expect_invalid_argument(into(4, 4, {(std::uint64_t{1} << 62) + 1, 4}), "grid",
                          "nx * ny = 2^64 + 4, which is 4 in 64 bits only: divide instead");
}

TEST_CASE("3.3 what is no grid of these points is refused", "[3.3][points:2]") {
  const auto fine = MEASURE(stratified_2d_into, 6, 6, {3, 2});
  expect_one_in_each_cell(fine.call, fine.value.x, fine.value.y, {3, 2});
  expect_refusals([](std::uint64_t size_x, std::uint64_t size_y, Grid grid) {
    return MEASURE_OUTCOME(stratified_2d_into, size_x, size_y, grid);
  });
}

const std::string cell_otherwise =
    "the variance within the cells is all that may be left: is each point uniform in its cell, x "
    "and y drawn apart?";

TEST_CASE("3.3 the error falls as 1/N in the plane", "[3.3][points:2]") {
  Rng rng = check_rng();
  const auto expected = [](std::size_t side) {
    const auto axis = strata_of(gaussian, side);
    return expected_of(product_of(axis, axis));
  };
  expect_level(rng, 3, fresh_function(rng, 3), 2, 64, 64, expected(8),
               "estimates of a exp(-x^2-y^2) + b over 8 x 8 cells have their exact variance",
               cell_otherwise);
  expect_slope(rng, 3, fresh_function(rng, 3), 2, {16, 256}, {expected(4), expected(16)},
               "errors for a exp(-x^2-y^2) + b fall as 1/N", cell_otherwise);
}

TEST_CASE("3.3 the error falls as N^-3/4 across an edge", "[3.3][points:2]") {
  Rng rng = check_rng();
  const Function g = fresh_function(rng, 5);
  const auto expected = [&](std::size_t side) {
    const auto cells = edge_strata(g.edge, side);
    return expected_of(cells, edge_kurtosis(cells));
  };
  expect_level(rng, 3, g, 2, 64, 64, expected(8),
               "estimates of an edge over 8 x 8 cells have their exact variance", cell_otherwise);
  expect_slope(rng, 3, g, 2, {64, 1024}, {expected(8), expected(32)},
               "only the cells that the edge cuts have any variance: errors fall as N^-3/4",
               cell_otherwise);
}

// 3.4 ---------------------------------------------------------------------------------------------

TEST_CASE("3.4 shuffle keeps every value", "[3.4][points:2]") {
  Rng rng = check_rng();
  for (const std::size_t n : {0u, 1u, 2u, 10u, 1000u, 100000u}) {
    Values x = uniform_values(rng, n, -1, 1);
    if (n > 2) x[1] = x[2];  // twice the same is no harm
    auto got = MEASURE(shuffle, x, 1, fresh_seed(rng));
    const Values order = got.value;
    std::sort(x.begin(), x.end());
    std::sort(got.value.begin(), got.value.end());
    expect_that(got.value == x, got.call + " = " + shown(order), "the same values in another order",
                "", "a shuffle swaps values; it does not copy one over another");
  }
}

std::vector<std::size_t> whole_numbers(const std::string& call, const Values& values,
                                       std::size_t below) {
  std::vector<std::size_t> numbers;
  for (const double value : values) {
    if (!(value >= 0 && value < static_cast<double>(below))) {
      fail(fmt::format("measured  {}: a value {}\nexpected  the values that were given", call,
                       value));
    }
    numbers.push_back(static_cast<std::size_t>(value));
  }
  return numbers;
}

TEST_CASE("3.4 every order is as likely as any other", "[3.4][points:4]") {
  Rng rng = check_rng();
  const std::string fair =
      "swap each value with one of those not placed yet, itself included: j from i to n-1";
  const auto few = MEASURE(shuffle, {0, 1, 2, 3, 4}, 12000, fresh_seed(rng));
  expect_all_orders(few.call, whole_numbers(few.call, few.value, 5), 5,
                    "the 120 orders of five values are equally likely",
                    "the order is always the same", fair);

  // Where the first and the last of 100 values go, in five parts: of 100 * 99 pairs of places.
  const std::size_t n = 100;
  Values x(n);
  std::iota(x.begin(), x.end(), 0.0);
  const auto many = MEASURE(shuffle, x, 4000, fresh_seed(rng));
  const auto numbers = whole_numbers(many.call, many.value, n);
  std::vector<std::uint64_t> counts(25);
  for (std::size_t first = 0; first < numbers.size(); first += n) {
    const auto order = part(numbers, first, n);
    const auto place = [&](std::size_t value) {
      const auto found = std::find(order.begin(), order.end(), value) - order.begin();
      return std::min<std::size_t>(static_cast<std::size_t>(found) / 20, 4);
    };
    ++counts[5 * place(0) + place(n - 1)];
  }
  Values probabilities(25, 20.0 * 20 / 9900);
  for (std::size_t i = 0; i < 5; ++i) probabilities[6 * i] = 20.0 * 19 / 9900;
  expect_counts(many.call, counts, probabilities,
                {"the first and the last of 100 values go to any two places", alpha}, {{}, fair});
}

TEST_CASE("3.4 every pair of dimensions is a jittered grid",
          "[3.4][points:3][needs:3.2][needs:3.3]") {
  Rng rng = check_rng();
  for (const std::size_t n : {1u, 7u, 12u, 64u, 101u}) {
    for (const std::size_t dims : {1u, 2u, 3u, 4u, 7u}) {
      const auto got = MEASURE(stratified, n, dims, 1, fresh_seed(rng));
      std::size_t d = 0;
      for (; d + 1 < dims; d += 2) {
        expect_one_in_each_cell(fmt::format("{}, dimensions {} and {}", got.call, d, d + 1),
                                part(got.value, d * n, n), part(got.value, (d + 1) * n, n),
                                squarest(n));
      }
      if (d < dims) {
        expect_one_in_each(fmt::format("{}, dimension {}", got.call, d), "x",
                           part(got.value, d * n, n), n,
                           "an odd last dimension is a pattern of 3.1");
      }
    }
  }
}

/// Which of the four strata, or of the 2 x 2 cells, each point of sets of 4 points lies in, for the
/// patterns of 5 dimensions: (0,1), (2,3) and (4).
std::array<std::vector<std::size_t>, 3> pattern_orders(const std::string& call,
                                                       const Values& values, std::size_t sets) {
  constexpr std::size_t n = 4, dims = 5;
  std::array<std::vector<std::size_t>, 3> orders;
  for (std::size_t set = 0; set < sets; ++set) {
    const auto column = [&](std::size_t d) { return part(values, (set * dims + d) * n, n); };
    for (std::size_t pair = 0; pair < 2; ++pair) {
      const auto cells =
          expect_one_in_each_cell(call, column(2 * pair), column(2 * pair + 1), {2, 2});
      orders[pair].insert(orders[pair].end(), cells.begin(), cells.end());
    }
    expect_one_in_each(call, "x", column(4), n, "an odd last dimension is a pattern of 3.1");
    for (const double x : column(4)) orders[2].push_back(*stratum_of(x, n));
  }
  return orders;
}

TEST_CASE("3.4 patterns are put side by side in independent orders", "[3.4][points:4][needs:3.3]") {
  Rng rng = check_rng();
  const auto got = MEASURE(stratified, 4, 5, 5000, fresh_seed(rng));
  const auto orders = pattern_orders(got.call, got.value, 5000);
  const char* names[] = {"dimensions (0,1)", "dimensions (2,3)", "the odd last dimension"};
  for (const auto& [one, other] : {std::pair{0, 1}, {0, 2}, {1, 2}}) {
    expect_all_orders(
        got.call, relative_orders(orders[one], orders[other], 4), 4,
        fmt::format("{} and {} come in independent orders", names[one], names[other]),
        "the patterns always meet in the same way: each wants a shuffle of its own",
        "shuffle the points of each pattern, x and y together, once for each pattern");
  }
  Values u, v;
  for (std::size_t k = 0; k < 5000 * 20; k += 20) {
    for (std::size_t i = 0; i < 4; ++i) {
      u.push_back(jitter_of(got.value[k + i], 2));
      v.push_back(jitter_of(got.value[k + 8 + i], 2));
    }
  }
  expect_independent(got.call, u, v, "dimensions 0 and 2 are jittered apart",
                     "one pattern is used for several pairs of dimensions: draw each afresh");
}

TEST_CASE("3.4 the first n of N are a fair sample", "[3.4][points:3][needs:3.3]") {
  Rng rng = check_rng();
  const auto got = MEASURE(stratified, 4, 5, 5000, fresh_seed(rng));
  const auto orders = pattern_orders(got.call, got.value, 5000);
  const char* names[] = {"dimensions (0,1)", "dimensions (2,3)", "the odd last dimension"};
  const std::string shuffled =
      "shuffle the first pattern too: who stops early must not see only "
      "the first rows of the grid";
  for (std::size_t pattern = 0; pattern < 3; ++pattern) {
    expect_all_orders(got.call, orders[pattern], 4,
                      fmt::format("the cells of {} come in any order", names[pattern]), shuffled,
                      shuffled);
  }
  const auto axis = strata_of(gaussian, 8);
  const auto cells = product_of(axis, axis);
  expect_level(rng, 4, fresh_function(rng, 3), 2, 64, 20,
               {mean_of(cells), variance_of_first(cells, 20), 3, independent_variance(cells, 20)},
               "the first 20 of 64 points are 20 strata drawn without replacement", shuffled);
}

// 3.5 ---------------------------------------------------------------------------------------------

/// The stratum of each point along each axis, as one number; nothing where a cell has not one
/// point.
std::vector<std::size_t> expect_one_in_each_box(const std::string& call, View columns,
                                                std::size_t n, std::size_t dims,
                                                std::size_t per_axis) {
  if (columns.size() != n * dims)
    fail(fmt::format("measured  {}: {} numbers", call, columns.size()));
  std::vector<std::size_t> cells(n), points(n);
  for (std::size_t d = dims; d-- > 0;) {
    const auto column = columns.subspan(d * n, n);
    expect_inside(call, fmt::format("column {}", d).c_str(), column);
    for (std::size_t k = 0; k < n; ++k) {
      cells[k] = cells[k] * per_axis + *stratum_of(column[k], per_axis);
    }
  }
  for (const std::size_t cell : cells) ++points[cell];
  for (std::size_t cell = 0; cell < n; ++cell) {
    if (points[cell] == 1) continue;
    std::string place;
    for (std::size_t d = 0, rest = cell; d < dims; ++d, rest /= per_axis) {
      place += fmt::format("{}{}", d > 0 ? ", " : "", rest % per_axis);
    }
    expect_that(false, fmt::format("{}: {} points in cell ({})", call, points[cell], place),
                "one point", "every cell of the grid over all dimensions has one, in any order",
                "point k lies in cell k: its strata are the digits of k in base per_axis");
  }
  pass();
  return cells;
}

TEST_CASE("3.5 one point in each cell of all dimensions", "[3.5][points:4]") {
  Rng rng = check_rng();
  for (const auto& [per_axis, dims] : {std::pair<std::size_t, std::size_t>{2, 4},
                                       {3, 3},
                                       {4, 2},
                                       {7, 1},
                                       {1, 3},
                                       {5, 5},
                                       {2, 10}}) {
    const auto n = static_cast<std::size_t>(std::llround(std::pow(per_axis, dims)));
    const auto got = MEASURE(stratified_nd, n, dims, per_axis, 1, fresh_seed(rng));
    expect_one_in_each_box(got.call, got.value, n, dims, per_axis);
  }
}

TEST_CASE("3.5 each point is uniform in its cell", "[3.5][points:2]") {
  Rng rng = check_rng();
  constexpr std::size_t per_axis = 2, dims = 3, n = 8, sets = 1600;
  const auto got = MEASURE(stratified_nd, n, dims, per_axis, sets, fresh_seed(rng));
  std::array<Values, dims> u;
  for (Values& axis : u) axis.resize(n * sets);
  for (std::size_t set = 0; set < sets; ++set) {
    const auto points = part(got.value, set * n * dims, n * dims);
    const auto cells = expect_one_in_each_box(got.call, points, n, dims, per_axis);
    for (std::size_t d = 0; d < dims; ++d) {
      for (std::size_t k = 0; k < n; ++k) {
        u[d][set * n + cells[k]] = jitter_of(points[d * n + k], per_axis);
      }
    }
  }
  for (const auto& [one, other] : {std::pair{0, 1}, {0, 2}, {1, 2}}) {
    expect_independent(
        got.call, u[one], u[other],
        fmt::format("jitter along axes {} and {} is uniform and independent", one, other),
        "the same random number moves the point along two axes: draw one for each");
  }
  Values here, there;  // a cell and the next one along axis 0
  for (std::size_t k = 0; k < u[0].size(); k += 2) {
    here.push_back(u[0][k]), there.push_back(u[0][k + 1]);
  }
  expect_independent(got.call, here, there, "neighbouring cells of 3.5 are independent",
                     one_for_all);
}

TEST_CASE("3.5 sizes that are no power are refused", "[3.5][points:1]") {
  const auto fine = MEASURE(stratified_nd, 8, 3, 2, 1, 1);
  expect_one_in_each_box(fine.call, fine.value, 8, 3, 2);
  const auto refuse = [](std::uint64_t n, std::uint64_t dims, std::uint64_t per_axis,
                         const std::string& because) {
    expect_invalid_argument(MEASURE_OUTCOME(stratified_nd, n, dims, per_axis, 1, 1), "per_axis",
                            because);
  };
  refuse(9, 3, 2, "2^3 is not 9");
  refuse(4, 3, 2, "2^3 is not 4");
  refuse(0, 2, 0, "an axis has strata");
  refuse(4, 2, (std::uint64_t{1} << 63) + 2,
         "per_axis^2 = 2^126 + 2^65 + 4, which is 4 in 64 bits only: divide instead");
  refuse(16, 40, 65536, "65536^40 is 0 in 64 bits");
}

TEST_CASE("3.5 the curse of dimension", "[3.5][points:3]") {
  Rng rng = check_rng();
  const auto expected = [](std::size_t per_axis) {
    const auto axis = strata_of(centred_exponential, per_axis);
    const auto plane = product_of(axis, axis);
    return expected_of(product_of(plane, plane));
  };
  const std::string otherwise =
      "the variance within the cells is all that may be left: is each point uniform in its cell, "
      "every coordinate drawn by itself?";
  expect_level(rng, 5, fresh_function(rng, 2), 4, 81, 81, expected(3),
               "estimates over 3^4 cells have their exact variance", otherwise);
  expect_slope(rng, 5, fresh_function(rng, 2), 4, {16, 625}, {expected(2), expected(5)},
               "in four dimensions errors fall as N^-1/2-1/4", otherwise);
}

// 3.6 ---------------------------------------------------------------------------------------------

TEST_CASE("3.6 every axis is stratified", "[3.6][points:4][needs:3.1]") {
  Rng rng = check_rng();
  for (const std::size_t n : {1u, 2u, 7u, 64u, 101u, 1000u}) {
    for (const std::size_t dims : {1u, 2u, 7u}) {
      const auto got = MEASURE(latin_hypercube, n, dims, 1, fresh_seed(rng));
      for (std::size_t d = 0; d < dims; ++d) {
        expect_one_in_each(fmt::format("{}, dimension {}", got.call, d), "x",
                           part(got.value, d * n, n), n, "each column is a pattern of 3.1");
      }
    }
  }
}

TEST_CASE("3.6 the orders of the axes are independent", "[3.6][points:3][needs:3.1][needs:3.4]") {
  Rng rng = check_rng();
  constexpr std::size_t n = 4, dims = 3, sets = 5000;
  const auto got = MEASURE(latin_hypercube, n, dims, sets, fresh_seed(rng));
  std::array<std::vector<std::size_t>, dims> orders;
  std::array<Values, dims> u;
  for (std::size_t set = 0; set < sets; ++set) {
    for (std::size_t d = 0; d < dims; ++d) {
      const auto column = part(got.value, (set * dims + d) * n, n);
      expect_one_in_each(got.call, "x", column, n, "each column is a pattern of 3.1");
      for (const double x : column) {
        orders[d].push_back(*stratum_of(x, n));
        u[d].push_back(jitter_of(x, n));
      }
    }
  }
  for (const auto& [one, other] : {std::pair{0, 1}, {0, 2}, {1, 2}}) {
    expect_all_orders(got.call, relative_orders(orders[one], orders[other], n), n,
                      fmt::format("axes {} and {} come in independent orders", one, other),
                      "two axes always meet in the same way: each wants a shuffle of its own",
                      "shuffle every column by itself, with the shuffle of 3.4");
  }
  expect_independent(got.call, u[0], u[1], "axes 0 and 1 are jittered apart",
                     "one column is used for two axes: draw each afresh");
}

TEST_CASE("3.6 sums gain everything and products little", "[3.6][points:3][needs:3.1][needs:3.4]") {
  Rng rng = check_rng();
  const std::string otherwise =
      "is each column uniform in its strata, in an order of its own, and drawn apart?";
  const auto sum = [](std::size_t n) {
    auto expected = expected_of(strata_of(exponential, n));  // seven of these, independent
    expected.mean *= 7, expected.variance *= 7, expected.independent *= 7;
    return expected;
  };
  const auto product = [](double (*h)(double), std::size_t n) {
    const auto axis = strata_of(h, n);
    return Expected{mean_of(axis) * mean_of(axis), shuffled_product_variance(axis, axis), 3,
                    independent_variance(product_of(axis, axis), n)};
  };
  expect_level(rng, 6, fresh_function(rng, 1), 7, 64, 64, sum(64),
               "estimates of a sum over seven axes have their exact variance", otherwise);
  expect_slope(rng, 6, fresh_function(rng, 1), 7, {16, 256}, {sum(16), sum(256)},
               "errors for a sum over seven axes fall as N^-1.5", otherwise);
  expect_level(rng, 6, fresh_function(rng, 3), 2, 64, 64, product(gaussian, 64),
               "exp(-x^2-y^2) is nearly a sum: 28 times less variance than independent points",
               otherwise);
  expect_level(rng, 6, fresh_function(rng, 4), 2, 64, 64, product(centred, 64),
               "(x-1/2)(y-1/2) is no sum at all: nothing is gained", otherwise);
}

// 3.7 ---------------------------------------------------------------------------------------------

TEST_CASE("3.7 strata of the plane and of both axes at once", "[3.7][points:5]") {
  Rng rng = check_rng();
  for (const Grid grid : {Grid{1, 1}, Grid{8, 8}, Grid{16, 4}, Grid{3, 5}, Grid{7, 1}, Grid{1, 11},
                          Grid{101, 1}, Grid{2 + rng() % 30, 2 + rng() % 30}}) {
    const std::size_t n = grid.nx * grid.ny;
    const auto got = MEASURE(multi_jittered, grid, 3, fresh_seed(rng));
    for (std::size_t set = 0; set < 3; ++set) {
      const auto x = part(got.value.x, set * n, n), y = part(got.value.y, set * n, n);
      expect_one_in_each_cell(got.call, x, y, grid);
      const std::string elsewhere =
          "a column of cells has ny strata of x, one for each of its cells; a row nx of y";
      expect_one_in_each(got.call, "x", x, n, elsewhere);
      expect_one_in_each(got.call, "y", y, n, elsewhere);
    }
  }
}

TEST_CASE("3.7 each point is uniform in its cell", "[3.7][points:4][needs:3.4]") {
  Rng rng = check_rng();
  constexpr Grid grid{4, 3};
  constexpr std::size_t n = grid.nx * grid.ny, sets = 8000;
  const auto got = MEASURE(multi_jittered, grid, sets, fresh_seed(rng));
  // Points of one set may share a permutation, so a set counts once: with one cell, the same in all
  // sets, and the one of its ny x nx parts that its point lies in.
  const std::size_t cell = rng() % n;
  std::vector<std::uint64_t> counts(n);
  Values u, v;
  for (std::size_t set = 0; set < sets; ++set) {
    const auto x = part(got.value.x, set * n, n), y = part(got.value.y, set * n, n);
    const auto cells = expect_one_in_each_cell(got.call, x, y, grid);
    const std::size_t k = std::find(cells.begin(), cells.end(), cell) - cells.begin();
    const auto part_x = static_cast<std::size_t>(jitter_of(x[k], grid.nx) * grid.ny);
    const auto part_y = static_cast<std::size_t>(jitter_of(y[k], grid.ny) * grid.nx);
    ++counts[part_x * grid.nx + part_y];
    for (std::size_t i = 0; i < 2; ++i) {
      u.push_back(jitter_of(x[i], n)), v.push_back(jitter_of(y[i], n));
    }
  }
  const double each = 1 / static_cast<double>(n);
  expect_counts(got.call, counts, std::span(&each, 1),
                {"a point of 3.7 lies in any of the ny x nx parts of its cell", alpha},
                {{},
                 "the canonical arrangement is biased, and so is shuffling x only: within each "
                 "column of cells shuffle who gets which stratum of x, within each row of y"});
  expect_independent(got.call, u, v, "the points of 3.7 are uniform in their strata of x and y",
                     "the same random number moves x and y");
}

TEST_CASE("3.7 a sum is estimated as in one dimension", "[3.7][points:2]") {
  Rng rng = check_rng();
  const auto axis = strata_of(exponential, 64);
  auto expected = expected_of(axis);  // twice, independent: one x in each of 64 strata, one y too
  expected.mean *= 2, expected.variance *= 2, expected.independent *= 2;
  expect_level(rng, 7, fresh_function(rng, 1), 2, 64, 64, expected,
               "estimates of exp(x) + exp(y) have the variance of two 1D patterns",
               "every one of the N strata of x has one point, and every one of y");
}

TEST_CASE("3.7 what is no grid of these points is refused", "[3.7][points:1]") {
  const auto fine = MEASURE(multi_jittered_into, 6, 6, {3, 2});
  expect_one_in_each_cell(fine.call, fine.value.x, fine.value.y, {3, 2});
  expect_refusals([](std::uint64_t size_x, std::uint64_t size_y, Grid grid) {
    return MEASURE_OUTCOME(multi_jittered_into, size_x, size_y, grid);
  });
}

// 3.8 ---------------------------------------------------------------------------------------------

/// Sums of at most 2000 values of size one lose 2000 eps of them; 1e-12 is twice that.
constexpr double rounding = 1e-12;

TEST_CASE("3.8 the estimate is the mean of the replicates", "[3.8][points:2]") {
  Rng rng = check_rng();
  for (const auto& [n, replicates] :
       {std::pair<std::size_t, std::size_t>{1, 2}, {7, 3}, {64, 25}, {100, 1}}) {
    const Values values = uniform_values(rng, n * replicates, -1, 1);
    const auto got = MEASURE(estimate_replicated, values, n, replicates);
    const double sum = std::accumulate(values.begin(), values.end(), 0.0);
    expect_within(got.call + ".value", got.value.value, sum / static_cast<double>(n * replicates),
                  rounding, "the mean of all values",
                  {{{sum, "this is the sum: divide it by n * replicates"},
                    {sum / static_cast<double>(n), "this is the sum of the replicates' means"},
                    {sum / static_cast<double>(replicates), "divide by n too"}},
                   "every point of every replicate counts once"});
    const auto expect_count = [&](const char* what, std::uint64_t counted, std::uint64_t expected,
                                  const std::string& hint) {
      expect_that(counted == expected, fmt::format("{}: {} {}", got.call, counted, what),
                  fmt::format("{}", expected), "", hint);
    };
    expect_count("calls of the generator", got.value.generated, replicates,
                 "each replicate has a point set of its own");
    expect_count("evaluations of the integrand", got.value.evaluated, n * replicates,
                 "the integrand is what costs: once for each point");
    expect_count("in Estimate.n", got.value.n, n * replicates,
                 "Estimate.n counts evaluations: n * replicates");
  }
  expect_invalid_argument(MEASURE_OUTCOME(estimate_replicated, {1, 2}, 0, 2), "n|point",
                          "a mean needs a point");
  expect_invalid_argument(MEASURE_OUTCOME(estimate_replicated, {1, 2}, 2, 0), "replicates",
                          "a mean needs a replicate");
}

TEST_CASE("3.8 the error bar is the spread of the replicates", "[3.8][points:3]") {
  Rng rng = check_rng();
  for (const auto& [n, replicates] :
       {std::pair<std::size_t, std::size_t>{1, 2}, {7, 3}, {64, 25}}) {
    const Values values = uniform_values(rng, n * replicates, -1, 1);
    const auto r = static_cast<double>(replicates), size = static_cast<double>(n);
    Values means;
    for (std::size_t k = 0; k < replicates; ++k) {
      const auto set = part(values, k * n, n);
      means.push_back(std::accumulate(set.begin(), set.end(), 0.0) / size);
    }
    const auto spread = [](const Values& x) {  // sum of squared deviations
      const double mean = std::accumulate(x.begin(), x.end(), 0.0) / static_cast<double>(x.size());
      double sum = 0;
      for (const double value : x) sum += (value - mean) * (value - mean);
      return sum;
    };
    const double among = spread(means), exact = std::sqrt(among / (r - 1) / r);
    const auto got = MEASURE(estimate_replicated, values, n, replicates);
    expect_within(
        got.call + ".standard_error", got.value.standard_error, exact, rounding,
        "s / sqrt(replicates), with s the sample standard deviation of the replicates' means",
        {{{std::sqrt(spread(values) / (size * r - 1) / (size * r)),
           "this is s / sqrt(n) over all points, as if they were independent: only the replicates' "
           "means are"},
          {std::sqrt(among / (r - 1)),
           "this is the spread of one mean: the mean of them all has "
           "sqrt(replicates) less"},
          {std::sqrt(among) / r,
           "this divides by replicates; a sample variance divides by "
           "replicates - 1"},
          {among / (r - 1) / r, "this is the variance of the estimate: take its root"}},
         "the replicates' means are independent of each other: lab 1 knows their variance"});
  }
  const Values values = uniform_values(rng, 10, -1, 1);
  const auto one = MEASURE(estimate_replicated, values, 10, 1);
  expect_nan(one.call + ".standard_error", one.value.standard_error,
             "one mean has no spread; what is undefined is NaN");
}

TEST_CASE("3.8 the error bar is honest for stratified points", "[3.8][points:1][needs:3.1]") {
  Rng rng = check_rng();
  constexpr std::size_t n = 16, replicates = 9, times = 500;
  const Function g = fresh_function(rng, 1);
  const auto strata = strata_of(exponential, n);
  const double exact = exact_mean_of(g, mean_of(strata));
  const double variance = g.a * g.a * stratified_variance(strata) / replicates;
  const auto got = MEASURE(estimates_replicated, 1, g, 1, n, replicates, times, fresh_seed(rng));
  Values estimates, bars;
  for (const Replicated& one : got.value) {
    estimates.push_back(one.value);
    bars.push_back(one.standard_error);
  }
  const std::string fresh = "does each replicate draw fresh points from the same generator?";
  expect_variance({got.call, estimates, n * replicates}, exact, variance, 3,
                  {"replicated estimates have 1/replicates of the exact variance", alpha},
                  {{{replicates, "all replicates are the same points: " + fresh}}, fresh});
  // A squared bar is chi-squared with replicates - 1 degrees of freedom, which is what a kurtosis
  // of 1 + 2 / (replicates - 1) stands for.
  expect_variance({got.call + ".standard_error", bars, n * replicates}, 0, variance,
                  1 + 2.0 / (replicates - 1),
                  {"squared error bars are the exact variance on average", alpha}, {{}, fresh});
}

// 3.9 ---------------------------------------------------------------------------------------------

TEST_CASE("3.9 blocks of any length have their strata", "[3.9][points:3][needs:3.1][needs:3.3]") {
  Rng rng = check_rng();
  for (const std::size_t n : {63u, 255u, 257u, 1023u, 1025u, 4099u, 65537u, 1000000u}) {
    const auto got = MEASURE(stratified_1d, n, 1, fresh_seed(rng));
    expect_in_order(got.call, part(got.value, 0, n),
                    "what is left after the last whole block is strata too");
  }
  for (const Grid grid :
       {Grid{1023, 3}, Grid{3, 1025}, Grid{4099, 1}, Grid{257, 255}, Grid{1000, 500}}) {
    const auto got = MEASURE(stratified_2d, grid, 1, fresh_seed(rng));
    expect_one_in_each_cell(got.call, got.value.x, got.value.y, grid);
  }
}

/// z of the products of jitters u[k] and v[k + lag] about 1/2, for lags first, first + 1, …:
/// standard normal for independent ones, whose products have variance 1/144.
Values lag_correlations(const Values& u, const Values& v, std::size_t first, std::size_t lags) {
  Values z;
  for (std::size_t lag = first; lag < first + lags; ++lag) {
    double sum = 0;
    for (std::size_t k = 0; k + lag < u.size(); ++k) sum += (u[k] - 0.5) * (v[k + lag] - 0.5);
    z.push_back(12 * sum / std::sqrt(static_cast<double>(u.size() - lag)));
  }
  return z;
}

TEST_CASE("3.9 fast numbers are as independent as slow ones",
          "[3.9][points:3][needs:3.1][needs:3.3]") {
  Rng rng = check_rng();
  constexpr std::size_t n = 20000, lags = 40;
  const std::string streams =
      "streams that run side by side must not be copies of each other, nor start again with each "
      "block: seed each of them with words of its own";
  const auto line = MEASURE(stratified_1d, n, 2, fresh_seed(rng));
  const Values u = jitters_of(part(line.value, 0, 2 * n), n);
  expect_uniform_jitter(line.call, u, "long patterns of 3.1 are uniform in their strata");
  expect_variance(
      {line.call + ", correlations of strata 1 to 40 apart", lag_correlations(u, u, 1, lags)}, 0, 1,
      3, {"no stratum of 3.1 knows of another one near it", alpha}, {{}, streams});
  const Grid grid{200, 100};
  const auto plane = MEASURE(stratified_2d, grid, 1, fresh_seed(rng));
  const auto cells = expect_one_in_each_cell(plane.call, plane.value.x, plane.value.y, grid);
  Values x(n), y(n);
  for (std::size_t k = 0; k < n; ++k) {
    x[cells[k]] = jitter_of(plane.value.x[k], grid.nx);
    y[cells[k]] = jitter_of(plane.value.y[k], grid.ny);
  }
  expect_independent(plane.call, x, y, "long patterns of 3.3 are uniform in their cells",
                     "the same random number moves x and y");
  Values z = lag_correlations(x, x, 1, lags);
  for (const Values& more : {lag_correlations(y, y, 1, lags), lag_correlations(x, y, 1, lags)}) {
    z.insert(z.end(), more.begin(), more.end());
  }
  expect_variance({plane.call + ", correlations of cells up to 40 apart", z}, 0, 1, 3,
                  {"no cell of 3.3 knows of another one near it", alpha}, {{}, streams});
}

}  // namespace
}  // namespace mc::checks
