#include <map>

#include "checks/blue_noise/random_sets.hpp"
#include "checks/support/disks.hpp"

namespace mc::checks {
namespace {

/// The distances of a point to its three nearest neighbors, in units of 1e-9: a copy that was
/// moved, rotated or mirrored has the same ones.
struct Neighborhood {
  std::array<std::int64_t, 3> distances;
  std::size_t set, point;
};

/// For all points of small sets and about 1,000 of large ones, except those with two equal
/// distances (see expect_no_lattice()) or at the place of another point (see below).
void add_neighborhoods(const SampleSets& sets, std::size_t set, std::vector<Neighborhood>& all) {
  const View x = sets.column(set, 0), y = sets.column(set, 1);
  const std::size_t n = x.size();
  for (std::size_t p = 0; p < n && n > 3; ++p) {
    if (n > 4096 && mix_bits(p) % (n / 1024) != 0) continue;
    std::array<double, 4> least{1, 1, 1, 0};  // squared, ascending, and a place for the next
    for (std::size_t q = 0; q < n; ++q) {
      const double dx = short_way(x[q] - x[p]), dy = short_way(y[q] - y[p]);
      least[3] = dx * dx + dy * dy;
      for (std::size_t k = 3; k > 0 && q != p && least[k] < least[k - 1]; --k) {
        std::swap(least[k], least[k - 1]);
      }
    }
    Neighborhood one{{}, set, p};
    for (std::size_t k = 0; k < 3; ++k) one.distances[k] = std::llround(std::sqrt(least[k]) * 1e9);
    const auto [a, b, c] = one.distances;
    if (a > 0 && b - a > 1 && c - b > 1) all.push_back(one);
  }
}

/// No neighborhood occurs twice, in one set or two: among 40,000 random points, three continuous
/// numbers agree to eight digits only once in 10^12 runs.
void require_fresh(const SampleSets& sets) {
  std::vector<Neighborhood> all;
  for (std::size_t set = 0; set < sets.size(); ++set) add_neighborhoods(sets, set, all);
  std::ranges::sort(all, [](const auto& a, const auto& b) { return a.distances < b.distances; });
  const auto twice = std::ranges::adjacent_find(
      all, [](const auto& a, const auto& b) { return a.distances == b.distances; });
  if (twice == all.end()) return;
  fail(Failure{
      fmt::format("{}: point {} of set {} and point {} of set {} have the same neighborhood",
                  sets.call, twice->point, twice->set, (twice + 1)->point, (twice + 1)->set),
      "different neighborhoods",
      "every point of every set is random",
      {},
      "draw every point from the generator that is passed in: a copy of it, or a generator with "
      "its own seed, starts again each time; copies of a pattern, even mirrored, are not new"});
}

/// No two points, of one set or two, are equal.
void require_distinct(const SampleSets& sets) {
  std::map<std::pair<double, double>, std::pair<std::size_t, std::size_t>> seen;  // set and index
  for (std::size_t set = 0; set < sets.size(); ++set) {
    for (std::size_t i = 0; i < sets.points(set); ++i) {
      const double x = sets.column(set, 0)[i], y = sets.column(set, 1)[i];
      const auto [at, is_new] = seen.try_emplace({x, y}, set, i);
      if (is_new) continue;
      const auto [other_set, other_i] = at->second;
      fail(Failure{fmt::format("{}: point {} of set {} and point {} of set {} both lie at ({}, {})",
                               sets.call, other_i, other_set, i, set, x, y),
                   "points that are all different",
                   "random points are never equal",
                   {},
                   i == 0 && other_i == 0
                       ? "the first point of a set must be random, too"
                       : "draw every point anew, and keep it once; use 53 random bits"});
    }
  }
}

SampleSets require_random(SampleSets sets) {
  require_fresh(sets);
  require_distinct(sets);
  return sets;
}

/// The hint if two points are closer than the radius.
Likely too_close_hint(View x, View y, double radius, double least) {
  const auto n = static_cast<double>(x.size());
  if (least >= radius / 2 - 4 * eps && least < 0.55 * radius && n * radius * radius > 1.155) {
    return "half the radius is kept: it is the distance of points, not a disk's radius"_likely;
  }
  // Of pairs that are close by chance, at most a fraction of 4/pi radius lies across an edge: if
  // all of them do, it is by chance once in 10,000 patterns.
  std::size_t pairs = 0, across = 0;
  for (std::size_t i = 0; i < x.size() && n < 5000; ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      const double dx = x[i] - x[k], dy = y[i] - y[k];
      if (std::hypot(short_way(dx), short_way(dy)) >= radius - 4 * eps) continue;
      ++pairs;
      across += std::hypot(dx, dy) >= radius - 4 * eps;
    }
  }
  const double by_chance = 4 / std::numbers::pi * radius;
  if (across == pairs && static_cast<double>(pairs) * std::log(by_chance) < std::log(1e-4)) {
    return "they are close only across an edge: measure distances on the torus"_likely;
  }
  return {};
}

/// No two points are closer than the radius, except for rounding. If the distance is too small by a
/// fraction d, 28 d N pairs are too close (measured for small d): with the 148,000 points of 4.3
/// and 4.7 together, d = 2e-6 is missed once in 1,000 runs.
void require_apart(const SampleSets& sets, double radius) {
  for (std::size_t set = 0; set < sets.size(); ++set) {
    const View x = sets.column(set, 0), y = sets.column(set, 1);
    const double least = least_distance(x, y);
    const bool holds = least >= radius - 4 * eps;
    expect_that(holds, fmt::format("{}: two points {} apart", sets.call, least),
                fmt::format("{} or more", radius),
                "no two points are closer than the radius, except for rounding (4 eps)",
                "compare each new point with all points near it on the torus, also up to sqrt(1/2) "
                "away; a cell must not have room for two",
                holds ? ""_likely : too_close_hint(x, y, radius, least));
  }
}

}  // namespace

SampleSets random_sets(const Measured<Points>& got, std::size_t n, std::size_t sets) {
  return require_random(sets_from_xy(got, {n, 1}, sets));
}

SampleSets random_sets(const Measured<Patterns>& got, double radius, std::size_t sets) {
  const Patterns& all = got.list_by_list(patterns_spec(radius, sets));
  SampleSets patterns = patterns_in(got.call, all);
  expect_that(
      patterns.size() == sets && std::ranges::count(all.sizes, 0u) == 0,
      fmt::format("{}: {} points in sets of sizes {}", got.call, all.x.size(), shown(all.sizes)),
      "sizes of at least 1 that add up to the number of points", "the first point always fits", "");
  require_apart(patterns, radius);
  return require_random(std::move(patterns));
}

void require_fine(const SampleSets& sets) {
  Uniforms rest{sets.call + ", bits of coordinates from the 17th on", 1, {}, 36};
  for (const double x : sets.values()) rest.values.push_back(x * 0x1p16 - std::floor(x * 0x1p16));
  expect_independent_uniforms(rest,
                              {.words = "the lower bits of coordinates are uniform",
                               .rule = "all 53 bits must be random: use no float, and do not clamp",
                               .expected = "independent random bits in each coordinate"},
                              true);
}

void require_everywhere(const SampleSets& sets) {
  for (const std::size_t d : {0u, 1u}) {
    Values all;
    for (std::size_t set = 0; set < sets.size(); ++set) append(all, sets.column(set, d));
    std::ranges::sort(all);
    const double most = 40 / static_cast<double>(all.size());
    for (std::size_t k = 0; k < all.size(); ++k) {
      const double next = k + 1 < all.size() ? all[k + 1] : all[0] + 1;
      if (next - all[k] < most) continue;
      fail(Failure{fmt::format("{}: none of {} points has {} between {} and {}", sets.call,
                               all.size(), d == 0 ? "x" : "y", all[k], next),
                   fmt::format("a point at least every {:.3g}", most),
                   "over many points or sets, all places are equally likely",
                   {},
                   "points must fall anywhere on the torus, including near the edges"});
    }
  }
}

Spectrum mean_spectrum(const SampleSets& sets, double n) {
  Spectrum mean{static_cast<int>(std::ceil(2 * std::sqrt(n))), {}};
  for (std::size_t set = 0; set < sets.size(); ++set) {
    const Spectrum one = spectrum_of(sets.column(set, 0), sets.column(set, 1), mean.kmax);
    mean.power.resize(one.power.size());
    for (std::size_t k = 0; k < one.power.size(); ++k) {
      mean.power[k] += one.power[k] / static_cast<double>(sets.size());
    }
  }
  return mean;
}

void expect_no_lattice(const std::string& call, const Spectrum& mean, std::size_t sets) {
  constexpr double largest_mean = 1.9, frequencies = 10000, false_fails = 1e-9;
  const auto degrees = 2 * static_cast<double>(sets);
  const double limit =
      central_interval(
          [&](double x) { return chi_squared_tails(x / largest_mean * degrees, degrees); },
          2 * false_fails / frequencies, 0, 200)
          .high;
  std::pair<double, std::array<int, 2>> most{0, {0, 0}};
  for (int ky = -mean.kmax; ky <= mean.kmax; ++ky) {
    for (int kx = -mean.kmax; kx <= mean.kmax; ++kx) {
      if (kx != 0 || ky != 0) most = std::max(most, {mean.at(kx, ky), {kx, ky}});
    }
  }
  expect_that(
      most.first < limit,
      fmt::format("{}: power {:.1f} at k = ({}, {}), mean of {} sets", call, most.first,
                  most.second[0], most.second[1], sets),
      fmt::format("less than {:.1f} at every k", limit),
      "where points may fall anywhere that is free, no power has a mean above 1.9",
      "points must fall anywhere that is free: not on a lattice, even if it is shifted, not only "
      "into a part of each cell or on the rims of disks");
}

}  // namespace mc::checks
