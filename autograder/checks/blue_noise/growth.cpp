// 4.7, stretch: the cost of a candidate, and of a point of a pattern, does not grow with the number
// of points.
//
// Cost is judged by its growth from few to many points, in CPU time of the submission itself. The
// limits are at least 7 times what right answers need (`self_test cost blue_noise` prints that),
// and less than what plain loops need:
//
//                           few → many      right      limit   plain loops
//   a candidate             250 → 64,000    2.8 to 4.3 32          95
//   a point of a pattern    500 → 32,000    0.8 to 1.3 16          > 30

#include "checks/blue_noise/random_sets.hpp"
#include "checks/support/disks.hpp"

namespace mc::checks {
namespace {

/// A step costs at most `most` times as much among `many` points as among `few`.
struct Growth {
  std::string step;  ///< "a candidate"
  double few, many, most;
  std::string rule;
  std::function<double(double n)> steps;  ///< of a call for n points
  std::function<Call(double n, const sandbox::Limits&)> call;
};

/// The answer for many points, where a step must not cost too much more than among few.
template <class Result>
Measured<Result> expect_growth(const Growth& growth);
/// The points of a pattern in a corner of the square, scaled by 8.
SampleSets corner_of(const SampleSets& pattern);

/// About 300,000 candidates in all.
double c_for(double n) {
  return n < 1000 ? 10 : 1e-4;
}

TEST_CASE("4.7 a candidate costs the same among many points",
          "[4.7][main][stretch][needs:4.1][needs:4.2]") {
  Rng rng = check_rng();
  const Growth growth{"a candidate",
                      250,
                      64000,
                      32,
                      "compare a candidate only with points nearby: in cells of a grid, which "
                      "grows with the number of points",
                      [&](double n) {
                        double candidates = 0;
                        for (double i = 0; i < n; ++i) candidates += std::ceil(c_for(n) * i) + 1;
                        return candidates;
                      },
                      [&](double n, const sandbox::Limits& limits) {
                        return MEASURE_OUTCOME_WITH(limits, best_candidate,
                                                    static_cast<std::uint64_t>(n), c_for(n), 1,
                                                    fresh_seed(rng));
                      }};
  const auto got = expect_growth<Points>(growth);
  const auto n = static_cast<std::size_t>(growth.many);
  judge_points(random_sets(got, n, 1), c_for(growth.many), 1, n, 400, rng);
}

CHECK_CASE("4.7 a thousand best candidates", "[4.7][edge][stretch][needs:4.1][needs:4.2]") {
  const SampleSets all = in_four_calls(
      [&] { return random_sets(MEASURE(best_candidate, 1024, 1, 1, fresh_seed(rng)), 1024, 1); });
  judge_points(all, 1, 3, 53, 50, rng);  // in a grid for all points, most cells are empty here
  judge_points(all, 1, 53, 1024, 150, rng);
}

TEST_CASE("4.7 the cost of Poisson disks is linear in their number",
          "[4.7][edge][stretch][needs:4.1][needs:4.3]") {
  Rng rng = check_rng();
  const double stretch = uniform(rng, 1, 1.05);
  const Growth growth{
      "a point",
      500,
      32000,
      16,
      "compare a new point only with those in the cells around it (a cell of width radius / "
      "sqrt(2) holds at most one point), do not fill the last gaps by darts at the whole square, "
      "and move no list of points or cells as erase() does",
      [](double n) { return n < 1000 ? 3 * n : n; },  // three patterns of few points
      [&](double n, const sandbox::Limits& limits) {
        return MEASURE_OUTCOME_WITH(limits, poisson_disk, radius_for(n * stretch), n < 1000 ? 3 : 1,
                                    fresh_seed(rng));
      }};
  const auto got = expect_growth<Patterns>(growth);
  const double radius = radius_for(growth.many * stretch);
  const SampleSets set = random_sets(got, radius, 1);
  // Darts until 1,000 misses in a row leave 0.54 % +- 0.11 % uncovered for 12,000 points.
  const double uncovered =
      uncovered_area(set.column(0, 0), set.column(0, 1), radius, 1500, uniform(rng));
  expect_that(uncovered <= 0.003,
              fmt::format("{}: {:.3g} % of the square is uncovered", set.call, 100 * uncovered),
              "0.3 % at most", "", "the number of tries must grow with the number of points");
  const SampleSets corner = corner_of(set);
  expect_no_lattice(corner.call, mean_spectrum(corner, growth.many / 64), 1);
  require_everywhere(set);
}

/// Some times are far too short or too long on a busy machine, so a growth near the limit is
/// measured again, and the better one counts.
template <class Result>
Measured<Result> expect_growth(const Growth& growth) {
  const double few_steps = growth.steps(growth.few), many_steps = growth.steps(growth.many);
  double small = 0;  // seconds per step
  for (int attempt = 0;; ++attempt) {
    const Call few = growth.call(growth.few, {});
    require_value(few);
    small = std::max(small, few.outcome.cpu_seconds / few_steps);
    sandbox::Limits limits;
    limits.cpu_seconds = std::clamp(std::ceil(small * many_steps * growth.most), 1.0, 6.0);
    const Call large = growth.call(growth.many, limits);
    const bool did_end = !large.outcome.over_limit();
    const double seconds = did_end ? large.outcome.cpu_seconds : limits.cpu_seconds;
    const double ratio = seconds / many_steps / small;
    if ((!did_end || ratio > growth.most / 4) && attempt < 1) continue;
    if (did_end) record_growth(ratio, growth.most, growth.step);
    expect_that(did_end && ratio <= growth.most,
                fmt::format("{}: {}{} takes {:.3g} times as long among {} points as among {}",
                            large.text, did_end ? "" : "no answer so far, and ", growth.step, ratio,
                            growth.many, growth.few),
                fmt::format("at most {} times", growth.most),
                "with a grid, the cost does not depend on the number of points", growth.rule);
    return result_of<Result>(large);
  }
}

SampleSets corner_of(const SampleSets& pattern) {
  Points corner;
  for (std::size_t i = 0; i < pattern.n; ++i) {
    const double x = 8 * pattern.column(0, 0)[i], y = 8 * pattern.column(0, 1)[i];
    if (x < 1 && y < 1) corner.x.push_back(x), corner.y.push_back(y);
  }
  const std::uint64_t size = corner.x.size();
  return sets_from_xy(pattern.call + ", an eighth of each axis", corner.x, corner.y, {&size, 1});
}

}  // namespace
}  // namespace mc::checks
