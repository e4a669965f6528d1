#include "checks/blue_noise/point_sets.hpp"

#include <algorithm>
#include <array>
#include <numbers>

#include <fmt/format.h>

#include "checks/support/battery.hpp"
#include "checks/support/distributions.hpp"
#include "checks/support/expect.hpp"

namespace mc::checks {
namespace {

bool same(const Set& a, const Set& b) {
  return std::equal(a.x.begin(), a.x.end(), b.x.begin(), b.x.end()) &&
         std::equal(a.y.begin(), a.y.end(), b.y.begin(), b.y.end());
}

/// What a pattern keeps when it is shifted, turned by a right angle or mirrored: how many points it
/// has, and power summed over frequencies that go over into each other.
std::array<double, 4> invariants(const Set& set) {
  const auto power = [&](double kx, double ky) {
    double real = 0, imaginary = 0;
    for (std::size_t i = 0; i < set.x.size(); ++i) {
      const double angle = 2 * std::numbers::pi * (kx * set.x[i] + ky * set.y[i]);
      real += std::cos(angle);
      imaginary += std::sin(angle);
    }
    return (real * real + imaginary * imaginary) / static_cast<double>(set.x.size());
  };
  const auto over = [&](double a, double b) {
    return power(a, b) + power(b, a) + power(a, -b) + power(b, -a);
  };
  return {static_cast<double>(set.x.size()), over(1, 2), over(1, 3), over(2, 3)};
}

/// No set is another one, as it is or moved about.
void require_fresh(const std::string& call, std::span<const Set> sets) {
  for (std::size_t set = 1; set < sets.size(); ++set) {
    if (!same(sets[set - 1], sets[set])) continue;
    expect_that(false, fmt::format("{}: sets {} and {} are the same", call, set - 1, set),
                "a fresh set from each call", "the generator has moved on between the two",
                "draw from the generator that is passed in: a copy of it, or one with a seed of "
                "its own, starts again each time");
  }
  std::vector<std::array<double, 4>> all;
  for (const Set& set : sets) {
    if (set.x.size() < 3) continue;  // one point is like any other
    const auto numbers = invariants(set);
    const bool nothing = numbers[1] + numbers[2] + numbers[3] < 1e-6;  // a lattice: see below
    if (!nothing) all.push_back(numbers);
  }
  std::sort(all.begin(), all.end());
  for (std::size_t k = 1; k < all.size(); ++k) {
    // Three continuous numbers agree to nine digits: for 400 sets by chance once in 10^20.
    bool equal = true;
    for (std::size_t i = 0; i < 4; ++i) {
      equal = equal && std::abs(all[k][i] - all[k - 1][i]) <= 1e-9 * all[k][0];
    }
    expect_that(!equal, fmt::format("{}: two sets are one pattern, moved about", call),
                "a fresh set from each call", "each point of each set is drawn anew",
                "a pattern that is made once and then shifted, turned or mirrored is one pattern");
  }
}

/// No point is in two sets, or twice in one: random points never are.
void require_distinct(const std::string& call, std::span<const Set> sets) {
  struct Place {
    double x, y;
    std::size_t set, index;
  };
  std::vector<Place> all;
  for (std::size_t set = 0; set < sets.size(); ++set) {
    for (std::size_t i = 0; i < sets[set].x.size(); ++i) {
      all.push_back({sets[set].x[i], sets[set].y[i], set, i});
    }
  }
  std::sort(all.begin(), all.end(),
            [](const Place& a, const Place& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
  for (std::size_t k = 1; k < all.size(); ++k) {
    const Place &a = all[k - 1], &b = all[k];
    if (a.x != b.x || a.y != b.y) continue;
    const bool first = a.index == 0 && b.index == 0;
    expect_that(false,
                fmt::format("{}: point {} of set {} and point {} of set {} both lie at ({}, {})",
                            call, a.index, a.set, b.index, b.set, a.x, a.y),
                "points that are all different", "random points never fall on each other",
                a.x == 0 && a.y == 0 ? "a point that was never written lies at (0, 0)"
                : first              ? "the first point of a set is as random as any other"
                                     : "every point is drawn anew, and kept once");
  }
}

/// What every random set is.
void require_random(const std::string& call, std::span<const Set> sets) {
  require_fresh(call, sets);
  require_distinct(call, sets);
}

}  // namespace

std::vector<Set> sets_of(const Measured<Points>& got, std::size_t n, std::size_t sets) {
  const Points& all = got.exactly(n * sets, unit);
  std::vector<Set> parts;
  for (std::size_t set = 0; set < sets; ++set) {
    parts.push_back({View(all.x).subspan(set * n, n), View(all.y).subspan(set * n, n)});
  }
  require_random(got.call, parts);
  return parts;
}

std::vector<Set> sets_of(const Measured<Patterns>& got, double radius, std::size_t sets) {
  const auto [x, y, sizes] = patterns_due(radius, sets);
  const Patterns& all = got.list_by_list({x, y, sizes});
  const auto empty = std::find(all.sizes.begin(), all.sizes.end(), 0u);
  expect_that(empty == all.sizes.end(),
              fmt::format("{}: set {} has no points", got.call, empty - all.sizes.begin()),
              "one point at least", "", "there is always room for the first point");
  std::vector<Set> parts = taken_apart(all);
  expect_that(!parts.empty(),
              fmt::format("{}: {} points in all, and other sizes", got.call, all.x.size()),
              "sizes that add up", "", "");
  require_random(got.call, parts);
  return parts;
}

void require_fine(const std::string& call, std::span<const Set> sets) {
  const std::string few_bits = "coordinates have 53 random bits: a float has 24";
  Uniforms rest{call + ", bits of coordinates from the 17th on", 1, {}, 36};
  for (const Set& set : sets) {
    for (const View axis : {set.x, set.y}) {
      for (const double x : axis) rest.values.push_back(x * 0x1p16 - std::floor(x * 0x1p16));
    }
  }
  expect_independent_uniforms(rest,
                              {.words = "the lower bits of coordinates are uniform",
                               .alpha = alpha,
                               .otherwise = few_bits,
                               .repeated = few_bits},
                              true);
}

Spectrum mean_spectrum(std::span<const Set> sets, double n) {
  Spectrum mean{static_cast<int>(std::ceil(2 * std::sqrt(n))), {}};
  for (const Set& set : sets) {
    const Spectrum one = spectrum_of(set.x, set.y, mean.kmax);
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
  for (int ky = -mean.kmax; ky <= mean.kmax; ++ky) {
    for (int kx = -mean.kmax; kx <= mean.kmax; ++kx) {
      if ((kx == 0 && ky == 0) || mean.at(kx, ky) < limit) continue;
      expect_that(
          false,
          fmt::format("{}: power {:.1f} at k = ({}, {}), mean of {} sets", call, mean.at(kx, ky),
                      kx, ky, sets),
          fmt::format("less than {:.1f} at every k", limit),
          "random points have no period: one that comes again in every set adds up, all others "
          "average out (to 1.9 at most)",
          "points on a lattice are not random, wherever it lies");
    }
  }
  expect_that(true, "", "", "", "");
}

}  // namespace mc::checks
