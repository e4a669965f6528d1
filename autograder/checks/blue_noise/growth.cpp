// 4.7
//
// What grows is judged, not how fast a machine is: the CPU time of one large set over that of as
// many small ones as cost the same, if the time grows as it should. Other work on the machine lends
// a ratio of two such times a factor of 1.5 at the worst; it is measured up to three times, and the
// least one counts.

#include <algorithm>

#include "checks/blue_noise/nearness.hpp"
#include "checks/blue_noise/poisson_disks.hpp"
#include "checks/support/catch.hpp"
#include "checks/support/statistics.hpp"

namespace mc::checks {
namespace {

/// The result, unless it ran out of time: that is growth, too.
template <class Result>
Measured<Result> in_time(const Call& call, const std::string& hint) {
  if (call.outcome.over_limit()) {
    expect_that(false, fmt::format("{} {}", call.text, call.outcome.failure), "an answer in time",
                "a grid needs a twentieth of that", hint);
  }
  require_value(call);
  try {
    wire::Reader from(call.outcome.bytes);
    auto result = from.get<Result>();
    from.end();
    return {std::move(result), call.text, call.outcome.cpu_seconds, call.outcome.peak_memory};
  } catch (const wire::malformed&) {
    fail("measured  " + call.text + " sent something that is not a result");
  }
}

void expect_growth(const std::string& large, const std::string& small, double ratio, double limit,
                   const std::string& because, const std::string& likely) {
  expect_that(ratio <= limit,
              fmt::format("{} takes {:.1f} times the CPU time of {}", large, ratio, small),
              fmt::format("about as long; {:.0f} times that at most", limit), because, likely);
}

}  // namespace

CHECK_CASE("4.7 thousands of best candidates", "[4.7][main][points:7][needs:4.1][needs:4.2]") {
  Rng rng = check_rng();
  const std::string grid =
      "each candidate is compared with all points: lay a grid over the square and look at the "
      "cells around the candidate";
  // 64 sets of 256 have as many candidates as one of 2048. Compared with all points, each of these
  // costs 8 times as much.
  constexpr std::size_t n = 2048, few = 256, sets = 64;
  std::vector<Nearness> parts;
  double ratio = infinity;
  for (int attempt = 0; attempt < 3 && ratio > 3; ++attempt) {
    const std::uint64_t seed = fresh_seed(rng);
    const auto small = in_time<Points>(MEASURE_OUTCOME(best_candidate, few, 1, sets, seed), grid);
    sets_of(small, few, sets);
    const auto large = in_time<Points>(MEASURE_OUTCOME(best_candidate, n, 1, 1, seed + 1), grid);
    const Set set = sets_of(large, n, 1)[0];
    ratio = std::min(ratio, large.cpu_seconds / small.cpu_seconds);
    if (attempt > 0) continue;
    for (std::size_t i = 3; i < n; i += i < 200 ? 6 : 9) {
      parts.push_back(nearness(set, i, 300, rng));
    }
    expect_candidates(large.call, parts, 1,
                      "near points are missed, or far ones called near: a search ends when "
                      "nothing that was not looked at can be nearer, round the torus");
  }
  expect_growth("one set of 2048", "64 sets of 256", ratio, 3,
                "they have as many candidates, 2.1 million, and each costs the same whatever the "
                "number of points",
                grid);
}

CHECK_CASE("4.7 the cost of Poisson disks is linear in their number",
           "[4.7][points:7][needs:4.1][needs:4.3]") {
  Rng rng = check_rng();
  const std::string grid =
      "each new point is compared with all others: lay a grid of radius / sqrt(2) over the square, "
      "whose cells hold one point at most";
  constexpr double few = 1024, many = 16384;  // few: what speed.cpp times
  constexpr std::size_t sets = 16;
  const double small_radius = radius_for(few), radius = radius_for(many);
  double ratio = infinity;
  for (int attempt = 0; attempt < 3 && ratio > 4; ++attempt) {
    const std::uint64_t seed = fresh_seed(rng);
    const auto small =
        in_time<Patterns>(MEASURE_OUTCOME(poisson_disk, small_radius, sets, seed), grid);
    const auto small_sets = sets_of(small, small_radius, sets);
    const auto large = in_time<Patterns>(MEASURE_OUTCOME(poisson_disk, radius, 1, seed + 1), grid);
    const Set set = sets_of(large, radius, 1)[0];
    ratio = std::min(ratio, large.cpu_seconds / small.cpu_seconds);
    if (attempt > 0) continue;
    for (const Set& one : small_sets) expect_apart(small.call, one, small_radius);
    expect_apart(large.call, set, radius);
    // Darts until 1,000 in a row have missed leave 0.54 % +- 0.11 % here.
    const double uncovered = uncovered_area(set.x, set.y, radius, 3000, uniform(rng));
    expect_that(uncovered <= 0.003,
                fmt::format("{}: {:.3g} % of the square is uncovered", large.call, 100 * uncovered),
                "0.3 % at most", "", "a limit on tries must grow with the number of points");
    expect_no_lattice(small.call, mean_spectrum(std::span(small_sets).first(1), few), 1);
    // Draws a point are a mean over thousands of points: they vary by a per cent or two. In
    // proportion to N log N they would grow by 1.4, to N^1.1 by 1.32.
    const double before = draws_a_point(small, small_radius, sets);
    const double here = draws_a_point(large, radius, 1);
    expect_that(here <= 1.25 * before,
                fmt::format("{}: {:.1f} random numbers a point; {:.1f} with 16 times fewer points",
                            large.call, here, before),
                "as many random numbers a point, or 1.25 times that", "linear in N means that",
                "darts at the whole square hit its last gaps rarely, and the more rarely the more "
                "points there are: throw them where gaps are left");
  }
  expect_growth("one pattern of 16,000 points", "16 of 1,000", ratio, 4,
                "time in proportion to the points is the same for both; compared with all points, "
                "each of these costs 16 times as much",
                grid);
}

}  // namespace mc::checks
