#pragma once
// Where points lie within their strata: anew in every set, uniform, by enough bits, and independent
// of each other.

#include <iterator>

#include "checks/stratification/points.hpp"
#include "checks/support/inversions.hpp"
#include "checks/support/statistics.hpp"

namespace mc::checks {

/// Of every random test of lab 3. There are 100 of them at most, so that a right answer fails once
/// in two million runs.
constexpr double alpha = 5e-9;

inline const std::string one_for_all =
    "the same random number moves both: draw one for every coordinate";

inline Values jitters_of(View x, std::size_t n) {
  Values jitters;
  jitters.reserve(x.size());
  for (const double value : x) jitters.push_back(jitter_of(value, n));
  return jitters;
}

/// Of column d in all sets.
inline Values jitters_of(const Sets& sets, std::size_t d, std::size_t strata) {
  Values jitters;
  jitters.reserve(sets.n * sets.size());
  for (std::size_t set = 0; set < sets.size(); ++set) {
    for (const double value : sets.column(set, d)) jitters.push_back(jitter_of(value, strata));
  }
  return jitters;
}

inline const std::string come_again =
    "the same random numbers come again and again: draw one for every coordinate, all from the "
    "generator that is passed in";

/// What is wrong with jitters that are not uniform and independent, from looking at them.
inline std::string jitter_hint(Values jitters) {
  std::sort(jitters.begin(), jitters.end());
  const double low = jitters.front(), high = jitters.back();
  if (high - low < 1e-6) {
    return fmt::format("every point lies at {:.3g} of its stratum: place it there at random", low);
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
    return come_again;
  }
  return "each point is (i + u) / n with a u of its own, uniform in [0, 1)";
}

/// Two sets of one call, and two calls with different seeds, have nothing in common: more than half
/// of the same coordinates, in whatever order, are never there by chance. `strata` along each axis.
inline void expect_drawn_afresh(const Sets& one, const Sets& other_seed,
                                std::span<const std::size_t> strata) {
  const auto are_same = [](View a, View b) {
    Values x(a.begin(), a.end()), y(b.begin(), b.end()), common;
    std::sort(x.begin(), x.end());
    std::sort(y.begin(), y.end());
    std::set_intersection(x.begin(), x.end(), y.begin(), y.end(), std::back_inserter(common));
    return 2 * common.size() > x.size();
  };
  const auto expect_other = [&](std::size_t d, bool same, const std::string& where) {
    if (!same) return;
    const std::string always =
        "the same numbers come again: draw them all from the generator that is passed in";
    const std::string hint = jitter_hint(jitters_of(one.column(0, d), strata[d]));
    expect_that(false, fmt::format("{}: coordinate {} is the same in {}", one.call, d, where),
                "other points in every set, and for every seed",
                "a stratified point is random within its stratum, or estimates are biased",
                hint.starts_with("every point lies") ? hint : always);
  };
  for (std::size_t d = 0; d < one.dims; ++d) {
    expect_other(d, are_same(one.column(0, d), one.column(1, d)), "two sets one after the other");
    expect_other(d, are_same(one.column(0, d), other_seed.column(0, d)), "a set of another seed");
  }
  pass();
}

/// Jitter has 32 bits at least. Of M = 64,000 numbers of b random bits M^2 / 2^(b+1) meet another
/// one: 122 for 24 bits, 0.5 for 32, none for 53. So 20 are too many: a right answer has as many
/// with probability 1e-25, one of 24 bits has fewer with 1e-30 (Poisson).
inline void expect_fine(const std::string& call, Values jitters, std::size_t strata) {
  constexpr std::size_t enough = 64000, most = 19;
  jitters.resize(std::min(jitters.size(), enough));
  std::sort(jitters.begin(), jitters.end());
  std::size_t met = 0;
  for (std::size_t k = 0; k + 1 < jitters.size(); ++k) {
    if (jitters[k + 1] - jitters[k] < 0x1p-44) ++met;  // i + u of few strata: rounded by 2^-49
  }
  const std::size_t places = jitters.size() - met;
  const bool few_bits = std::all_of(jitters.begin(), jitters.end(), [](double u) {
    return std::abs(std::remainder(u * 0x1p30, 1.0)) < 1e-3;
  });
  expect_that(
      met <= most,
      fmt::format("{}: {} points lie at {} different places of their strata ({} strata)", call,
                  jitters.size(), places, strata),
      fmt::format("{} different places, or {} fewer at most", jitters.size(), most),
      "a random number of 32 bits or more is hardly ever drawn twice",
      few_bits ? "the random numbers have too few bits: to_unit has 53, a float 24" : come_again);
}

/// Jitters are uniform, and fine. `strata` along their axis; `what` they are jitters of.
inline void expect_uniform_jitter(const std::string& call, const Values& jitters,
                                  std::size_t strata, const std::string& words) {
  expect_fine(call, jitters, strata);
  const double each = 1.0 / 32;
  expect_counts(call + ", places of points within their strata, in 32 equal parts",
                counts_of(jitters, 32), std::span(&each, 1), {words, alpha},
                {{}, jitter_hint(jitters)});
}

/// Pairs (u, v) that should be independent and uniform: counted in 8 x 8 cells. `same` is said
/// where u equals v, or 1 - v, in more than one pair of twenty.
inline void expect_independent(const std::string& call, const Values& u, const Values& v,
                               const std::string& words, const std::string& same) {
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
  expect_counts(call + ", pairs of places within the strata, in 8 x 8 equal cells", counts,
                std::span(&each, 1), {words, alpha},
                {{}, moves && 20 * equal > u.size() ? same : jitter_hint(both)});
}

}  // namespace mc::checks
