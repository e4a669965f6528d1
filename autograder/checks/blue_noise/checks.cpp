// What lab 4 checks. All points, radii and patterns are fresh in each run, and nothing depends on
// the order in which a submission draws.
//
// Blue is judged by bounds on means over at least 40 sets of about 256 points. Where they stand
// between right and wrong, in standard deviations of the judged mean (200 sets of each kind
// measured for the figures; "poisson" keeps going until nothing fits):
//
//                             best candidate   poisson       fixed 10   jittered   Halton   bound
//   low band, mean            .0890            .0741         .1912      .3254      .2654    < .13
//   low band, sd of one set   .0075            .0068         .0192      .0367      0
//   sets; sd of their mean    64; .0009        160; .0007    64; .0024  64; .0046
//   to the bound              44 sigma         80 sigma      25 sigma   42 sigma   certain
//   relative radius, mean     .667             .763          .453       .118       .344     > .6
//   sd of one set, of 64      .014, .0018                    .042, .0053
//   to the bound              37 sigma                       28 sigma
//   peak of 160 sets, sd                       1.752, .019                      3.0  1.4 to 1.9
//   to the bounds                              18 and 8 sigma
//
// (Bridson's algorithm with its gaps filled has a peak of 1.53, seven sigma from the lower bound
// with as few as 40 sets.)
//
// At 7 sigma a Gaussian errs once in 10^12. Fourteen tests have an alpha of their own, 1e-8 each.

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <optional>

#include <fmt/format.h>

#include "4-blue-noise/experiments.hpp"
#include "checks/support/catch.hpp"
#include "checks/support/data.hpp"
#include "checks/support/discs.hpp"
#include "checks/support/distributions.hpp"
#include "checks/support/expect.hpp"
#include "checks/support/measure.hpp"
#include "checks/support/spectrum.hpp"
#include "checks/support/statistics.hpp"

namespace mc::checks {
namespace {

using experiments::Points;
using experiments::PointSets;
using Values = std::vector<double>;
using View = std::span<const double>;

constexpr double alpha = 1e-8;
constexpr double eps = std::numeric_limits<double>::epsilon();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double below_one = 1 - eps / 2;

/// The distance of neighbours in the densest pattern of n points, a triangular lattice: relative
/// radii are in parts of it (Lagae and Dutre 2008, "A comparison of methods for generating Poisson
/// disk distributions").
double lattice_distance(double n) {
  return std::sqrt(2 / (std::sqrt(3.0) * n));
}

std::uint64_t fresh_seed(Rng& rng) {
  return rng() >> 32;  // short enough to be typed again
}

Points uniform_points(Rng& rng, std::size_t n) {
  Points points;
  points.x = uniform_values(rng, n, 0, 1);
  points.y = uniform_values(rng, n, 0, 1);
  return points;
}

/// One set of several.
struct Set {
  View x, y;
};

void expect_inside(const std::string& call, View x, View y) {
  expect_that(x.size() == y.size(),
              fmt::format("{}: {} values of x, {} of y", call, x.size(), y.size()), "as many", "",
              "a point has two coordinates");
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (x[i] >= 0 && x[i] < 1 && y[i] >= 0 && y[i] < 1) continue;
    expect_that(false, fmt::format("{}: point {} at ({}, {})", call, i, x[i], y[i]),
                "coordinates in [0, 1)",
                "points lie in the unit square, which does not contain its upper edges",
                std::isnan(x[i]) || std::isnan(y[i]) ? "this point was never written"
                : x[i] == 1 || y[i] == 1             ? "a coordinate was rounded up to 1"
                                         : "what leaves the square on one side comes back on the "
                                           "other: take the whole part off");
  }
}

std::vector<Set> sets_of(const std::string& call, const PointSets& all) {
  expect_inside(call, all.x, all.y);
  std::vector<Set> sets;
  std::size_t first = 0;
  for (const std::uint64_t size : all.sizes) {
    if (size > all.x.size() - first) fail("measured  " + call + " sent sizes that do not add up");
    sets.push_back({View(all.x).subspan(first, size), View(all.y).subspan(first, size)});
    first += size;
  }
  if (sets.size() > 1) {
    expect_that(
        sets[0].x.size() != sets[1].x.size() || sets[0].x.empty() || sets[0].x[0] != sets[1].x[0],
        call + ": the first two sets begin alike", "a fresh set from each call",
        "the generator has moved on between the two",
        "draw from the generator that is handed in: a copy of it, or one with a seed of "
        "its own, starts again each time");
  }
  return sets;
}

// 4.1
// ----------------------------------------------------------------------------------------------

TEST_CASE("4.1 the distance to the nearest copy", "[4.1][points:6]") {
  Rng rng = check_rng();
  Points a = uniform_points(rng, 400), b = uniform_points(rng, 400);
  const Values edges{0, below_one, 0.5, 0.25, 0.75, uniform(rng)};
  for (const double x : edges) {
    for (const double y : edges) {
      a.x.push_back(x), a.y.push_back(y);
      b.x.push_back(y), b.y.push_back(uniform(rng) < 0.5 ? x : 0);
    }
  }
  const auto got = MEASURE(toroidal_distances_squared, a.x, a.y, b.x, b.y);
  for (std::size_t i = 0; i < a.x.size(); ++i) {
    const long double dx = static_cast<long double>(a.x[i]) - b.x[i];
    const long double dy = static_cast<long double>(a.y[i]) - b.y[i];
    const long double short_x = dx - std::round(dx), short_y = dy - std::round(dy);
    const auto exact = static_cast<double>(short_x * short_x + short_y * short_y);
    // Each shortest way is rounded twice, by eps / 4 at most, and so is wrong by eps / 2: its
    // square by eps |way|, both by 1.5 eps times the distance; the rest is relative to its square.
    expect_within(
        fmt::format("from ({}, {}) to ({}, {})", a.x[i], a.y[i], b.x[i], b.y[i]), got.value[i],
        exact, 4 * eps * std::sqrt(exact) + eps * eps,
        "coordinates are rounded to eps / 2, differences too",
        {{{static_cast<double>(dx * dx + dy * dy),
           "this is the distance within the square: the way across an edge is shorter"},
          {std::sqrt(exact), "this is the distance: its square is asked for"},
          {static_cast<double>(short_x * short_x + dy * dy), "x goes round the torus, y does not"},
          {static_cast<double>(dx * dx + short_y * short_y), "y goes round the torus, x does not"}},
         "along each axis, take the shorter of |difference| and 1 - |difference|"});
  }
}

// 4.2
// ----------------------------------------------------------------------------------------------

/// How far from its nearest predecessor a point lies, in terms of probability: the part of the
/// square that is nearer to one than the point is.
struct Nearness {
  std::size_t i = 0;  ///< which point
  double part = 0;
};

Nearness nearness(const Set& set, std::size_t i, std::size_t rows, Rng& rng) {
  const double distance = nearest_distance(set.x, set.y, i, i);
  return {i, 1 - uncovered_area(set.x.first(i), set.y.first(i), distance, rows, uniform(rng))};
}

/// Uniform candidates have a nearness that is uniform; the largest of m of them, raised to the m-th
/// power, is uniform again. So this is uniform in [0, 1) for every right way, and independent from
/// point to point, if there were `candidates(i)` of them.
Values by_candidates(std::span<const Nearness> all,
                     const std::function<double(double)>& candidates) {
  Values u;
  for (const auto& [i, part] : all) {
    u.push_back(std::clamp(std::pow(part, candidates(static_cast<double>(i))), 0.0, below_one));
  }
  return u;
}

double distance_from_uniform(Values u) {
  std::sort(u.begin(), u.end());
  double distance = 0;
  const auto n = static_cast<double>(u.size());
  for (std::size_t k = 0; k < u.size(); ++k) {
    const auto below = static_cast<double>(k) / n;
    distance = std::max({distance, u[k] - below, below + 1 / n - u[k]});
  }
  return distance;
}

/// What was done instead, if it is one of the things that are often done.
std::string candidates_hint(std::span<const Nearness> all, double c, View x, View y) {
  // 0.36 of the square lies within 0.1 of its edges.
  double at_edges = 0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    if (std::min({x[k], 1 - x[k], y[k], 1 - y[k]}) < 0.1) at_edges += 1;
  }
  if (at_edges / static_cast<double>(x.size()) > 0.42) {
    return "points crowd at the edges of the square, where they see no neighbour on the other "
           "side: measure distances round the torus";
  }
  const std::pair<std::function<double(double)>, std::string> guesses[] = {
      {[&](double i) { return std::floor(c * i) + 1; },
       "these are floor(c i) + 1 candidates: c i is rounded up"},
      {[&](double i) { return std::max(1.0, std::ceil(c * i)); },
       "these are ceil(c i) candidates: one is missing"},
      {[&](double i) { return std::ceil(c * i) + 2; }, "there is one candidate too many"},
      {[&](double i) { return i + 1; }, "the number of candidates does not depend on c"},
      {[&](double) { return 1; }, "one candidate, or the first of them whatever comes after"},
      {[&](double) { return 5; }, "the number of candidates is the same for all points"},
      {[&](double) { return 10; }, "the number of candidates is the same for all points"},
      {[&](double) { return 20; }, "the number of candidates is the same for all points"}};
  const double close = 2.2 / std::sqrt(static_cast<double>(all.size()));  // once in 8,000
  double closest = close;
  std::string likely;
  for (const auto& [guess, hint] : guesses) {
    const double distance = distance_from_uniform(by_candidates(all, guess));
    if (distance < closest) closest = distance, likely = hint;
  }
  if (!likely.empty()) return likely;
  Values nearest;
  for (const auto& [i, part] : all) {
    nearest.push_back(
        std::clamp(std::pow(1 - part, std::ceil(c * static_cast<double>(i)) + 1), 0.0, below_one));
  }
  if (distance_from_uniform(nearest) < close) {
    return "this keeps the candidate that is nearest to the others: keep the farthest";
  }
  return "for each candidate its nearest point, of all points before; keep the candidate for which "
         "that is farthest";
}

const std::string because_candidates =
    "the part of the square that is nearer to another point than point i, to the power of "
    "ceil(c i) + 1, is uniform";

TEST_CASE("4.2 each point is the best of its candidates", "[4.2][points:10]") {
  Rng rng = check_rng();
  // c = 1 tells a candidate that is missing from c i rounded down; for other c they are the same.
  for (const double c : {1.0, 0.4, uniform(rng, 2.5, 3)}) {
    constexpr std::size_t n = 5, sets = 400;
    const auto got = MEASURE(best_candidate, n, c, sets, fresh_seed(rng));
    const auto all = sets_of(got.call, got.value);
    std::vector<Nearness> parts;
    Values first_x, first_y;
    for (const Set& set : all) {
      first_x.push_back(set.x[0]);
      first_y.push_back(set.y[0]);
      for (std::size_t i = 1; i < n; ++i) parts.push_back(nearness(set, i, 500, rng));
    }
    const auto u = by_candidates(parts, [&](double i) { return std::ceil(c * i) + 1; });
    expect_distribution(got.call, u, [](double p) { return p; }, {because_candidates, alpha},
                        {{}, candidates_hint(parts, c, got.value.x, got.value.y)});
    const Hints anywhere{{}, "the first point has one candidate, anywhere in the square"};
    expect_distribution(
        got.call + ": x of the first points", first_x, [](double p) { return p; },
        {"the first point is uniform in the square", alpha}, anywhere);
    expect_distribution(
        got.call + ": y of the first points", first_y, [](double p) { return p; },
        {"the first point is uniform in the square", alpha}, anywhere);
  }
}

TEST_CASE("4.2 best candidates are blue", "[4.2][points:6]") {
  Rng rng = check_rng();
  constexpr std::size_t n = 256, sets = 64;
  const auto got = MEASURE(best_candidate, n, 1, sets, fresh_seed(rng));
  double low = 0, radius = 0;
  for (const Set& set : sets_of(got.call, got.value)) {
    low += low_band(spectrum_of(set.x, set.y, 8), n) / sets;
    radius += least_distance(set.x, set.y) / lattice_distance(n) / sets;
  }
  const std::string fixed =
      "as blue as a fixed number of candidates: later points need more of them, c i and one";
  const std::string white = "as white as independent points: are candidates compared at all?";
  const std::string clumps =
      "points clump: candidates must be far from all points before, not from the last one only";
  const std::string far_from_it =
      "is the distance measured round the torus, to all points before, and the farthest kept?";
  const std::string& likely = low > 1.5                  ? clumps
                              : low > 0.9                ? white
                              : low > 0.15 && low < 0.23 ? fixed
                                                         : far_from_it;
  expect_that(
      low < 0.13,
      fmt::format("{}: mean power {:.4f} over 0 < |k| <= 8, mean of {} sets", got.call, low, sets),
      "less than 0.13; 0.089 on average",
      "independent points have 1, jittered ones 0.33, ten candidates each 0.19", likely);
  expect_that(radius > 0.6,
              fmt::format("{}: the closest two are {:.3f} of the densest pattern's distance apart, "
                          "mean of {} sets",
                          got.call, radius, sets),
              "more than 0.6; 0.667 on average",
              "a fixed number of candidates lets the last points come close",
              radius > 0.4 ? fixed : far_from_it);
}

TEST_CASE("4.2 misuse of best_candidate is refused", "[4.2][points:3]") {
  Rng rng = check_rng();
  const auto got = MEASURE(best_candidate_into, 3, 3, 0.5);
  expect_inside(got.call, got.value.x, got.value.y);
  const std::string size = "points have two coordinates, and there is one of them at least";
  const std::uint64_t n = 2 + rng() % 9;
  expect_invalid_argument(MEASURE_OUTCOME(best_candidate_into, n, n + 1, 1), "x|y", size);
  expect_invalid_argument(MEASURE_OUTCOME(best_candidate_into, n, n - 1, 1), "x|y", size);
  expect_invalid_argument(MEASURE_OUTCOME(best_candidate_into, 0, 0, 1), "x|y", size);
  for (const double c : {0.0, -uniform(rng, 0.5, 2), nan, infinity}) {
    expect_invalid_argument(MEASURE_OUTCOME(best_candidate_into, n, n, c), "c",
                            "c is candidates a point: positive and finite");
  }
}

// 4.3
// ----------------------------------------------------------------------------------------------

/// The radius at which a pattern that takes no further point has about n: 0.763 of the densest
/// one's distance (measured: .767 at n = 64, .759 at 1024).
double radius_for(double n) {
  return 0.763 * lattice_distance(n);
}

TEST_CASE("4.3 no two points are closer than the radius", "[4.3][points:7]") {
  Rng rng = check_rng();
  const std::pair<double, std::size_t> cases[] = {{uniform(rng, 0.5, 0.7), 20},
                                                  {uniform(rng, 0.2, 0.4), 20},
                                                  {uniform(rng, 0.05, 0.1), 5},
                                                  {uniform(rng, 0.025, 0.03), 1}};
  for (const auto& [radius, sets] : cases) {
    const auto got = MEASURE(poisson_disk, radius, sets, fresh_seed(rng));
    for (const Set& set : sets_of(got.call, got.value)) {
      expect_that(!set.x.empty(), got.call + ": a set without points", "one point at least", "",
                  "there is always room for the first point");
      const double least = least_distance(set.x, set.y);
      double within = infinity;  // of the square, not round the torus
      for (std::size_t i = 0; i < set.x.size() && set.x.size() < 1000; ++i) {
        for (std::size_t k = 0; k < i; ++k) {
          const double dx = set.x[i] - set.x[k], dy = set.y[i] - set.y[k];
          within = std::min(within, dx * dx + dy * dy);
        }
      }
      within = std::sqrt(within);
      expect_that(
          least >= radius - 4 * eps, fmt::format("{}: two points {} apart", got.call, least),
          fmt::format("{} or more", radius),
          "every point has a disc of that radius to itself, but for rounding (4 eps of the square)",
          within >= radius && set.x.size() < 1000
              ? "they are close only across an edge: the square is a torus"
          : least >= radius / 2 - 4 * eps && least < 0.6 * radius
              ? "half the radius is kept: it is the distance of two points, and not the radius of "
                "discs that may touch"
              : "is each new point compared with all near it, two cells of radius / sqrt(2) away "
                "and round the torus?");
    }
  }
}

TEST_CASE("4.3 hardly any room is left", "[4.3][points:7]") {
  Rng rng = check_rng();
  const std::pair<double, std::size_t> cases[] = {{uniform(rng, 0.28, 0.32), 60},
                                                  {uniform(rng, 0.14, 0.16), 40},
                                                  {uniform(rng, 0.04, 0.05), 6},
                                                  {uniform(rng, 0.025, 0.03), 1},
                                                  {uniform(rng, 0.61, 0.65), 200}};
  for (const auto& [radius, sets] : cases) {
    const auto got = MEASURE(poisson_disk, radius, sets, fresh_seed(rng));
    double uncovered = 0, size = 0;
    for (const Set& set : sets_of(got.call, got.value)) {
      const auto parts = static_cast<double>(sets);
      uncovered += uncovered_area(set.x, set.y, radius, 1000, uniform(rng)) / parts;
      size += static_cast<double>(set.x.size()) / parts;
    }
    expect_that(
        uncovered <= 0.003,
        fmt::format("{}: {:.3g} % of the square is farther than the radius from every point, mean "
                    "of {} sets of {:.4g} points",
                    got.call, 100 * uncovered, sets, size),
        "0.3 % at most",
        "where no disc reaches there is room for another point (computed along 1000 lines; right "
        "to 0.01 %)",
        uncovered > 0.05 ? "it stops early: many gaps are left"
        : radius > 0.1
            ? "tries around each point miss narrow gaps, and at large radii one gap is "
              "much of the square: look for what is left in the end"
            : "gaps are left: a fixed number of misses in a row is no proof that nothing "
              "fits");
  }
}

TEST_CASE("4.3 Poisson disks are blue", "[4.3][points:5]") {
  Rng rng = check_rng();
  constexpr std::size_t sets = 160, calls = 4;  // so many that the peak of the mean is known well
  const double radius = radius_for(256);
  std::vector<Measured<PointSets>> parts;
  double size = 0;
  for (std::size_t call = 0; call < calls; ++call) {
    parts.push_back(MEASURE(poisson_disk, radius, sets / calls, fresh_seed(rng)));
    size += static_cast<double>(parts.back().value.x.size()) / sets;
  }
  const auto& got = parts[0];
  // The densest pattern has 440 points here; a spectrum beyond that is not of a Poisson disk.
  expect_that(size > 100 && size < 500,
              fmt::format("{}: {:.1f} points a set on average", got.call, size), "about 256",
              "discs of half the radius cannot overlap, discs of the radius must cover",
              "no two points closer than radius, and no room for another");
  const int kmax = static_cast<int>(std::ceil(2 * std::sqrt(size)));
  Spectrum mean{kmax, {}};
  for (const auto& part : parts) {
    for (const Set& set : sets_of(part.call, part.value)) {
      const Spectrum one = spectrum_of(set.x, set.y, kmax);
      mean.power.resize(one.power.size());
      for (std::size_t k = 0; k < one.power.size(); ++k) mean.power[k] += one.power[k] / sets;
    }
  }
  const double low = low_band(mean, size), top = peak(mean, size);
  expect_that(low < 0.13,
              fmt::format("{}: mean power {:.4f} over 0 < |k| <= sqrt(N)/2", got.call, low),
              "less than 0.13; 0.076 on average", "independent points have 1, jittered ones 0.33",
              "is the distance kept, and the square filled, everywhere alike?");
  expect_that(top > 1.4 && top < 1.9,
              fmt::format("{}: the largest mean power of a ring is {:.3f}", got.call, top),
              "1.4 to 1.9; 1.75 on average",
              "points just outside each other's discs are common, but not the rule",
              top < 1.4 ? "the pattern is loose: too few neighbours at the radius"
                        : "too regular: new points lie at the rim of a disc, or on a lattice, and "
                          "not anywhere they fit");
}

TEST_CASE("4.3 a radius too large for two gives one point", "[4.3][points:3]") {
  Rng rng = check_rng();
  for (const double radius : {0.70711, uniform(rng, 0.72, 0.9), 1.0, uniform(rng, 1, 10)}) {
    const auto got = MEASURE(poisson_disk, radius, 5, fresh_seed(rng));
    for (const Set& set : sets_of(got.call, got.value)) {
      expect_that(set.x.size() == 1, fmt::format("{}: {} points", got.call, set.x.size()), "1",
                  "no two points of the torus are farther apart than sqrt(1/2)",
                  set.x.empty() ? "there is always room for the first point"
                                : "two points must not be nearer than radius, round the torus");
    }
  }
}

/// The first number of a text that lies between low and high.
std::optional<double> number_between(const std::string& text, double low, double high) {
  for (std::size_t at = 0; at < text.size(); ++at) {
    const double number = std::strtod(text.c_str() + at, nullptr);
    if (number >= low && number <= high) return number;
  }
  return {};
}

TEST_CASE("4.3 a radius that makes no sense is refused", "[4.3][points:3]") {
  Rng rng = check_rng();
  const auto got = MEASURE(poisson_disk, 0.3, 1, fresh_seed(rng));
  expect_inside(got.call, got.value.x, got.value.y);
  for (const double radius : {0.0, -uniform(rng, 0.1, 1), nan, -infinity, 1e-200}) {
    expect_invalid_argument(MEASURE_OUTCOME(poisson_disk, radius, 1, 1), "radius",
                            "a distance is positive, and memory has an end");
  }
  for (const double radius : {1e-7, uniform(rng, 1, 9) * 1e-9}) {
    const auto call = MEASURE_OUTCOME(poisson_disk, radius, 1, 1);
    expect_invalid_argument(call, "radius", "memory would not hold the points");
    const double squares = 1 / (radius * radius);
    // Discs of half the radius pack a triangular lattice at most; discs of the radius cover by the
    // thinnest covering at least (Kershner 1939).
    expect_that(
        number_between(call.outcome.bytes, 0.384 * squares, 1.155 * squares).has_value(),
        fmt::format("{} threw std::invalid_argument(\"{}\")", call.text, call.outcome.bytes),
        fmt::format("a text that says how many points it would be: about {:.2g}", 0.7 * squares),
        "between 0.385 / radius^2 (fewer discs do not cover) and 1.155 / radius^2 (more "
        "do not fit)",
        "std::to_string or %g will do: 1.5e+12");
  }
}

// 4.4
// ----------------------------------------------------------------------------------------------

/// How wrong a periodogram may be. A wave's angle, 2 pi (kx x + ky y) <= 4 pi kmax, is rounded a
/// few times, and so a wave is wrong by less than 32 (kmax + 1) eps; n additions lose n eps of n
/// waves. So the sum of n waves is wrong by n delta, and its square over n by the two terms here.
double power_tolerance(double exact, double n, int kmax) {
  const double delta = (32.0 * (kmax + 1) + n) * eps;
  return 2 * std::sqrt(n * exact) * delta + n * delta * delta;
}

void expect_power(const std::string& call, View got, std::size_t n, int kmax,
                  const std::function<double(int, int)>& exact, const std::string& because) {
  const auto size = static_cast<double>(n);
  std::size_t i = 0;
  for (int ky = -kmax; ky <= kmax; ++ky) {
    for (int kx = -kmax; kx <= kmax; ++kx, ++i) {
      const double power = exact(kx, ky);
      const bool written = !std::isnan(got[i]);
      expect_within(
          fmt::format("{}: power at k = ({}, {})", call, kx, ky), got[i], power,
          power_tolerance(power, size, kmax), because,
          {{{power * size, "this is |sum|^2: divide by the number of points"},
            {power / size, "this is divided by N twice"},
            {std::sqrt(power), "this is an amplitude: power is its square"},
            {std::sqrt(power * size), "this is |sum|: its square over N is asked for"},
            {exact(ky, kx), "kx and ky are exchanged: ky is the outer index"},
            {0, kx == 0 && ky == 0 ? "k = 0 is power like any other here: N"
                                   : "a wave is missing, or its cosine or sine"}},
           !written ? "this entry was never written"
                    : "sum exp(-2 pi i (kx x + ky y)) over the points, in double; its squared "
                      "absolute value over N"});
    }
  }
}

TEST_CASE("4.4 spectra that are known exactly", "[4.4][points:7]") {
  Rng rng = check_rng();
  for (const int kmax : {1, 2, 7, 20}) {
    const Points one = uniform_points(rng, 1);
    const auto got = MEASURE(periodogram, one.x, one.y, 1, kmax);
    expect_power(
        got.call, got.value, 1, kmax, [](int, int) { return 1; },
        "one wave has the absolute value 1");
  }
  for (const std::size_t n : {2u, 3u, 50u}) {
    const Points one = uniform_points(rng, 1);
    const Points same{Values(n, one.x[0]), Values(n, one.y[0])};
    const auto got = MEASURE(periodogram, same.x, same.y, 1, 5);
    expect_power(
        got.call, got.value, n, 5, [&](int, int) { return static_cast<double>(n); },
        "N points in one place are in phase at any k: N^2 / N");
  }
  const Points two = uniform_points(rng, 2);
  const auto pair = MEASURE(periodogram, two.x, two.y, 1, 6);
  expect_power(
      pair.call, pair.value, 2, 6,
      [&](int kx, int ky) {
        const double turns = kx * (two.x[1] - two.x[0]) + ky * (two.y[1] - two.y[0]);
        return 1 + std::cos(2 * std::numbers::pi * (turns - std::round(turns)));
      },
      "two points have |1 + exp(2 pi i k.d)|^2 / 2 = 1 + cos(2 pi k.d)");
  // A grid with an uneven number of columns and rows, at any place: N where both waves fit.
  for (const auto& [columns, rows] : {std::pair{5, 3}, std::pair{1, 4}, std::pair{8, 8}}) {
    const double x = uniform(rng, 0, 0.1), y = uniform(rng, 0, 0.1);
    Points grid;
    for (int j = 0; j < rows; ++j) {
      for (int i = 0; i < columns; ++i) {
        grid.x.push_back(x + static_cast<double>(i) / columns);
        grid.y.push_back(y + static_cast<double>(j) / rows);
      }
    }
    const auto got = MEASURE(periodogram, grid.x, grid.y, 1, 9);
    expect_power(
        fmt::format("{}, a grid of {} x {}", got.call, columns, rows), got.value, grid.x.size(), 9,
        [&, columns = columns, rows = rows](int kx, int ky) {
          return kx % columns == 0 && ky % rows == 0 ? static_cast<double>(grid.x.size()) : 0;
        },
        "a grid is in phase where its columns divide kx and its rows ky, and cancels elsewhere");
  }
}

TEST_CASE("4.4 random points by the definition", "[4.4][points:5]") {
  Rng rng = check_rng();
  const std::pair<std::size_t, int> cases[] = {{2, 1}, {17, 3}, {100, 12}, {1000, 4}};
  for (const auto& [n, kmax] : cases) {
    const Points points = uniform_points(rng, n);
    const Spectrum exact = spectrum_of(points.x, points.y, kmax);
    const auto got = MEASURE(periodogram, points.x, points.y, 1, kmax);
    expect_power(
        got.call, got.value, n, kmax, [&](int kx, int ky) { return exact.at(kx, ky); },
        "waves are right to 32 (kmax + 1) eps, sums to N eps");
  }
}

TEST_CASE("4.4 jittered points have the power they must", "[4.4][points:3]") {
  Rng rng = check_rng();
  constexpr int side = 8, kmax = 8;
  constexpr std::size_t n = side * side, sets = 100;
  Points jittered;
  for (std::size_t i = 0; i < n * sets; ++i) {
    jittered.x.push_back((static_cast<double>(i % side) + uniform(rng)) / side);
    jittered.y.push_back((static_cast<double>(i / side % side) + uniform(rng)) / side);
  }
  const auto got = MEASURE(periodogram, jittered.x, jittered.y, sets, kmax);
  const auto sinc = [](int k) {
    const double turn = std::numbers::pi * k / side;
    return k == 0 ? 1 : std::sin(turn) / turn;
  };
  // A cell's mean wave has the size sinc sinc; what cells have in common cancels, each cell's own
  // remainder does not. Sums of 64 independent terms are nearly Gaussian, so the power is nearly
  // exponential: amplitudes sqrt(P) have mean square E{P} and kurtosis E{P^2} / E{P}^2 = 2, less
  // something below 1/64 / E{P}^2, which makes the test a little stricter on itself.
  for (const auto& [kx, ky] :
       {std::pair{3, 2}, std::pair{1, 5}, std::pair{-6, 4}, std::pair{0, 8}}) {
    Values amplitudes;
    for (std::size_t set = 0; set < sets; ++set) {
      const auto at = (2 * kmax + 1) * (2 * kmax + 1) * set +
                      static_cast<std::size_t>((ky + kmax) * (2 * kmax + 1) + kx + kmax);
      amplitudes.push_back(std::sqrt(got.value[at]));
    }
    const double mean = 1 - sinc(kx) * sinc(kx) * sinc(ky) * sinc(ky);
    expect_variance(
        {fmt::format("{}: amplitudes at k = ({}, {}) of {} jittered sets", got.call, kx, ky, sets),
         amplitudes, n},
        0, mean, 2, {"jittered points have 1 - sinc(kx/n)^2 sinc(ky/n)^2 on average", alpha},
        {{{static_cast<double>(n), "this is |sum|^2: divide by the number of points"},
          {1.0 / n, "this is divided by N twice"}},
         "is this the power at this very k?"});
  }
}

TEST_CASE("4.4 misuse of periodogram is refused", "[4.4][points:3]") {
  Rng rng = check_rng();
  const auto got = MEASURE(periodogram_into, 2, 2, 1, 9);
  expect_within(got.call + "[0]", got.value.at(0), 2, 8 * eps, "two points in one place",
                {{}, "|sum|^2 / N"});
  const std::uint64_t n = 2 + rng() % 9;
  const std::string because = "points have two coordinates, and there is one of them at least";
  expect_invalid_argument(MEASURE_OUTCOME(periodogram_into, n, n + 1, 1, 9), "x|y", because);
  expect_invalid_argument(MEASURE_OUTCOME(periodogram_into, n, n - 1, 1, 9), "x|y", because);
  expect_invalid_argument(MEASURE_OUTCOME(periodogram_into, 0, 0, 1, 9), "x|y", because);
  for (const int kmax : {0, -1, -3}) {
    expect_invalid_argument(MEASURE_OUTCOME(periodogram_into, n, n, kmax, 1), "kmax",
                            "kmax is 1 at least");
  }
  for (const std::uint64_t size : {0u, 9u, 24u, 26u}) {
    expect_invalid_argument(MEASURE_OUTCOME(periodogram_into, n, n, 2, size), "power",
                            "there are (2 kmax + 1)^2 = 25 values of k");
  }
}

// 4.5
// ----------------------------------------------------------------------------------------------

TEST_CASE("4.5 the mean over each ring", "[4.5][points:5]") {
  Rng rng = check_rng();
  for (const int kmax : {5, 1, 2, 24}) {
    const auto side = static_cast<std::size_t>(2 * kmax + 1);
    const Values power = uniform_values(rng, side * side, 0, 3);
    const auto rings = static_cast<std::size_t>(kmax + 1);
    // Sums and counts of the rings, rounded, cut, and with the corners.
    std::vector<double> sum(rings), count(rings), cut(2 * rings), cut_count(2 * rings);
    double corners = 0, corner_count = 0;
    std::size_t i = 0;
    for (int ky = -kmax; ky <= kmax; ++ky) {
      for (int kx = -kmax; kx <= kmax; ++kx, ++i) {
        const double k = std::hypot(kx, ky);  // k + 1/2 has no whole square: never halfway
        cut[static_cast<std::size_t>(k)] += power[i];
        ++cut_count[static_cast<std::size_t>(k)];
        const auto ring = static_cast<std::size_t>(std::lround(k));
        if (ring < rings) sum[ring] += power[i], ++count[ring];
        if (ring >= rings) corners += power[i], ++corner_count;
      }
    }
    const auto got = MEASURE(radial_power, power, kmax);
    expect_that(got.value.size() == rings, fmt::format("{}: {} rings", got.call, got.value.size()),
                fmt::format("{}", rings), "rings 0 to kmax", "the corners belong to no ring");
    expect_that(std::isnan(got.value[0]), fmt::format("{}[0] = {}", got.call, got.value[0]), "NaN",
                "the power at k = 0 is N for any points, which says nothing about them",
                "the mean of the points is still in here: ring 0 has no meaning, so NaN");
    for (std::size_t ring = 1; ring < rings; ++ring) {
      const double exact = sum[ring] / count[ring];
      expect_within(
          fmt::format("{}[{}]", got.call, ring), got.value[ring], exact,
          (count[ring] + 2) * eps * exact, "n additions of positive numbers lose n eps at most",
          {{{cut[ring] / cut_count[ring], "abs(k) is cut here: round it to the nearest ring"},
            {sum[ring], "this is the sum over the ring: its mean is asked for"},
            {ring + 1 == rings ? (sum[ring] + corners) / (count[ring] + corner_count) : exact,
             "the corners are in the last ring: they belong to none"}},
           "the mean of all (kx, ky) whose sqrt(kx^2 + ky^2) rounds to this ring, of negative k "
           "too"});
    }
  }
}

TEST_CASE("4.5 misuse of radial_power is refused", "[4.5][points:3]") {
  const auto got = MEASURE(radial_power, Values(9, 1.0), 1);
  expect_that(got.value.size() == 2 && got.value[1] == 1, got.call + " of ones", "{NaN, 1}", "",
              "the mean of ones is 1");
  for (const int kmax : {0, -1}) {
    expect_invalid_argument(MEASURE_OUTCOME(radial_power, Values(1, 1.0), kmax), "kmax",
                            "kmax is 1 at least");
  }
  for (const std::size_t size : {0u, 9u, 24u, 26u}) {
    expect_invalid_argument(MEASURE_OUTCOME(radial_power, Values(size, 1.0), 2), "power",
                            "there are (2 kmax + 1)^2 = 25 values of k");
  }
}

// 4.6
// ----------------------------------------------------------------------------------------------

TEST_CASE("4.6 copies lie side by side", "[4.6][points:5]") {
  Rng rng = check_rng();
  for (const int copies : {1, 2, 3, 7}) {
    Points pattern = uniform_points(rng, 20);
    pattern.x[0] = below_one;
    pattern.y[1] = below_one;
    pattern.x[2] = pattern.y[3] = 0;
    const auto got = MEASURE(tile, pattern.x, pattern.y, copies);
    expect_inside(got.call, got.value.x, got.value.y);
    const auto repeats = static_cast<std::size_t>(copies);
    expect_that(got.value.x.size() == repeats * repeats * 20,
                fmt::format("{}: {} points", got.call, got.value.x.size()),
                fmt::format("{}", repeats * repeats * 20), "copies x copies patterns",
                "each copy has every point once");
    // The sum of a cell and a coordinate is rounded to eps copies / 2, the quotient to eps / 4.
    std::vector<bool> taken(got.value.x.size());
    const double seam = least_distance(got.value.x, got.value.y);
    const double inside = least_distance(pattern.x, pattern.y) / copies;
    for (int row = 0; row < copies; ++row) {
      for (int column = 0; column < copies; ++column) {
        for (std::size_t p = 0; p < 20; ++p) {
          const double x = (column + pattern.x[p]) / copies, y = (row + pattern.y[p]) / copies;
          bool found = false;
          for (std::size_t i = 0; i < taken.size() && !found; ++i) {
            found = !taken[i] && std::abs(got.value.x[i] - x) <= eps &&
                    std::abs(got.value.y[i] - y) <= eps;
            if (found) taken[i] = true;
          }
          expect_that(
              found,
              fmt::format("{}: no point at ({}, {}); the closest two are {} apart", got.call, x, y,
                          seam),
              fmt::format("point {} of the pattern in column {}, row {}; {} apart", p, column, row,
                          inside),
              "every copy is the pattern at 1/copies of its size, so seams are as its edges are "
              "on the torus",
              "a point of the copy (i, j) lies at ((i + x) / copies, (j + y) / copies)");
        }
      }
    }
  }
}

TEST_CASE("4.6 a tiled pattern has power at multiples only", "[4.6][points:3]") {
  Rng rng = check_rng();
  for (const int copies : {2, 3}) {
    const std::size_t n = 30;
    const int kmax = 3 * copies;
    const Points pattern = uniform_points(rng, n);
    const Spectrum of_pattern = spectrum_of(pattern.x, pattern.y, 3);
    const auto got = MEASURE(tile, pattern.x, pattern.y, copies);
    expect_that(
        got.value.x.size() == got.value.y.size() && !got.value.x.empty(),
        fmt::format("{}: {} and {} values", got.call, got.value.x.size(), got.value.y.size()),
        "points", "", "copies x copies patterns");
    const Spectrum tiled = spectrum_of(got.value.x, got.value.y, kmax);
    const auto size = static_cast<double>(got.value.x.size());
    for (int ky = -kmax; ky <= kmax; ++ky) {
      for (int kx = -kmax; kx <= kmax; ++kx) {
        const bool multiple = kx % copies == 0 && ky % copies == 0;
        const double exact =
            multiple ? copies * copies * of_pattern.at(kx / copies, ky / copies) : 0;
        expect_within(fmt::format("{}: power at k = ({}, {})", got.call, kx, ky), tiled.at(kx, ky),
                      exact, 2 * power_tolerance(exact, size, kmax),
                      "waves that fit the copies add up to copies^2 P(k / copies), all others "
                      "cancel; waves are right to 32 (kmax + 1) eps",
                      {{}, "the copies are not alike: nothing is turned, mirrored or moved"});
      }
    }
  }
}

TEST_CASE("4.6 misuse of tile is refused", "[4.6][points:2]") {
  const auto got = MEASURE(tile_of, 1, 2, 1);
  expect_that(got.value.x.size() == 1, fmt::format("{}: {} points", got.call, got.value.x.size()),
              "1", "", "one copy of one point");
  for (const int copies : {0, -1, -7}) {
    expect_invalid_argument(MEASURE_OUTCOME(tile_of, 3, 2, copies), "copies",
                            "there is one copy at least");
  }
  expect_invalid_argument(MEASURE_OUTCOME(tile_of, 0, 2, 3), "pattern", "there are no points");
  for (const std::uint64_t dims : {0u, 1u, 3u}) {
    expect_invalid_argument(MEASURE_OUTCOME(tile_of, 3, dims, 2), "pattern",
                            "a pattern of the square has two dimensions");
  }
}

// 4.7
// ----------------------------------------------------------------------------------------------

/// What a call brought, unless it ran out of time.
PointSets in_time(const Call& call, const std::string& hint) {
  if (call.outcome.timed_out) {
    expect_that(false, fmt::format("{} {}", call.text, call.outcome.failure), "an answer in time",
                "twice the time that a grid needs on a slow machine is twice too long", hint);
  }
  require_value(call);
  wire::Reader from(call.outcome.bytes);
  return from.get<PointSets>();
}

TEST_CASE("4.7 thousands of best candidates", "[4.7][points:7][needs:4.1][needs:4.2]") {
  Rng rng = check_rng();
  const std::string grid =
      "each candidate is compared with all points: lay a grid over the square and look at the "
      "cells around the candidate";
  const std::string wrong_cells =
      "the grid misses near points, or calls far ones near: go on to the next ring of cells until "
      "nothing nearer can be in it, round the torus";
  const auto call = MEASURE_OUTCOME(best_candidate, 4096, 1, 1, fresh_seed(rng));
  const PointSets many = in_time(call, grid);
  sets_of(call.text, many);
  const double radius = least_distance(many.x, many.y) / lattice_distance(4096);
  // 1024 points have .695 on average and .677 at least (16 sets); it grows slowly with N.
  expect_that(radius > 0.6,
              fmt::format("{}: the closest two are {:.3f} of the densest pattern's distance apart",
                          call.text, radius),
              "more than 0.6; 0.71 on average", "", wrong_cells);

  const auto got = MEASURE(best_candidate, 1024, 1, 1, fresh_seed(rng));
  const auto sets = sets_of(got.call, got.value);
  std::vector<Nearness> parts;
  for (std::size_t i = 3; i < 1024; i += i < 200 ? 3 : 9) {
    parts.push_back(nearness(sets[0], i, 1500, rng));
  }
  expect_distribution(got.call, by_candidates(parts, [](double i) { return i + 1; }),
                      [](double p) { return p; }, {because_candidates, alpha}, {{}, wrong_cells});
}

TEST_CASE("4.7 Poisson disks cost as much as they are many",
          "[4.7][points:7][needs:4.1][needs:4.3]") {
  Rng rng = check_rng();
  const std::string grid =
      "each new point is compared with all others: lay a grid of radius / sqrt(2) over the square, "
      "whose cells hold one point at most";
  double draws_a_point = 0;
  for (const double n : {2000.0, 32000.0}) {
    const double radius = radius_for(n);
    const auto call = MEASURE_OUTCOME(poisson_disk, radius, 1, fresh_seed(rng));
    const PointSets got = in_time(call, grid);
    sets_of(call.text, got);
    expect_that(least_distance(got.x, got.y) >= radius - 4 * eps,
                fmt::format("{}: two points {} apart", call.text, least_distance(got.x, got.y)),
                fmt::format("{} or more", radius), "",
                "the grid misses a neighbour: two cells on each side, and round the torus");
    const double uncovered = uncovered_area(got.x, got.y, radius, 1500, uniform(rng));
    expect_that(uncovered <= 0.003,
                fmt::format("{}: {:.3g} % of the square is uncovered", call.text, 100 * uncovered),
                "0.3 % at most", "", "a limit on tries must grow with the number of points");
    const double here = static_cast<double>(got.draws) / static_cast<double>(got.x.size());
    // Draws a point are a mean over thousands of points: they vary by a per cent or two. In
    // proportion to N log N they would grow by 1.36, to N^1.1 by 1.32.
    expect_that(draws_a_point == 0 || here <= 1.25 * draws_a_point,
                fmt::format("{}: {:.1f} random numbers a point; {:.1f} with 16 times fewer points",
                            call.text, here, draws_a_point),
                "as many random numbers a point, or 1.25 times that", "linear in N means that",
                "darts at the whole square hit its last gaps rarely, and the more rarely the more "
                "points there are: throw them where gaps are left");
    draws_a_point = here;
  }
}

}  // namespace
}  // namespace mc::checks
