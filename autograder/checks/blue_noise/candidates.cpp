// 4.2
//
// "Blue" is judged by bounds on means over at least 40 sets of about 256 points. Their distances
// from correct and wrong answers, in standard deviations of the judged mean (from 200 sets of each
// kind; for Poisson disks see poisson_disks.cpp):
//
//                             best candidate   fixed 10   jittered   Halton   bound
//   low band, mean            .0890            .1912      .3254      .2654    < .13
//   low band, sd of one set   .0075            .0192      .0367      0
//   sd of the mean of 64      .0009            .0024      .0046
//   to the bound              44 sigma         25 sigma   42 sigma   certain
//   relative radius, mean     .667             .453       .118       .344     > .6
//   sd of one set, of 64      .014, .0018      .042, .0053
//   to the bound              37 sigma         28 sigma
//   Poisson disks have .76, and are not best candidates: < .72, 29 sigma away
// A Gaussian exceeds 7 sigma once in 10^12.

#include "checks/blue_noise/random_sets.hpp"
#include "checks/support/disks.hpp"

namespace mc::checks {

namespace {

/// Tests the number of candidates of each point in a few sets.
void judge_candidates(std::size_t n, double c, std::size_t sets, Rng& rng, std::size_t rows = 500);

CHECK_CASE("4.2 each point is the best of its candidates", "[4.2][main][points:8][needs:4.1]") {
  // Only c = 1 distinguishes a missing candidate from c i rounded down.
  // If candidates are stratified along an axis, the distribution is 0.03 to 0.05 off.
  judge_candidates(5, 1, 4000, rng, 200);
  judge_candidates(5, uniform(rng, 2.5, 3), 400, rng);
  judge_candidates(8, 0.5, 200, rng);
  judge_candidates(65, 0.1, 12, rng);
}

CHECK_CASE("4.2 any number of points and candidates", "[4.2][edge][points:3][needs:4.1]") {
  judge_candidates(5, 1 + 1e-12, 400, rng);  // a float c or a tolerance loses a candidate
  judge_candidates(3, 20, 200, rng);
  judge_candidates(17, 1e-12, 60, rng);
  judge_candidates(2, 1, 400, rng);
  // More candidates than 16 bits can count; finer rows, because 1/70,000 of the square is left.
  judge_candidates(2, 69999, 20, rng, 300000);
  const auto got = MEASURE(best_candidate, 1, 1, 2000, fresh_seed(rng));
  const SampleSets first = random_sets(got, 1, 2000);
  expect_independent_uniforms({got.call, 2, first.values()},
                              {.words = "the first point is uniform in the square",
                               .rule = "it has one candidate, uniform in the square"});
}

CHECK_CASE("4.2 also among a thousand points", "[4.2][points:2][needs:4.1]") {
  const double c = uniform(rng, 0.08, 0.12);  // three loops make 3e7 to 4e7 comparisons
  const SampleSets all = in_four_calls(
      [&] { return random_sets(MEASURE(best_candidate, 1000, c, 1, fresh_seed(rng)), 1000, 1); });
  judge_points(all, c, 10, 60, 50, rng);  // in a grid for all points, most cells are empty here
  judge_points(all, c, 60, 1000, 100, rng);
}

CHECK_CASE("4.2 best candidates are blue", "[4.2][points:6][needs:4.1]") {
  constexpr std::size_t n = 256, sets = 64;
  const SampleSets all = in_four_calls([&] {
    return random_sets(MEASURE(best_candidate, n, 1, sets / 4, fresh_seed(rng)), n, sets / 4);
  });
  double radius = 0;
  for (std::size_t set = 0; set < sets; ++set) {
    radius += least_distance(all.column(set, 0), all.column(set, 1)) / lattice_distance(n) / sets;
  }
  const Spectrum mean = mean_spectrum(all, n);
  const double low = low_band(mean, n);
  const std::string rule =
      "each point is the candidate, of ceil(c i) + 1, that is farthest from all earlier points "
      "on the torus";
  expect_that(
      low < 0.13,
      fmt::format("{}: mean power {:.4f} over 0 < |k| <= 8, mean of {} sets", all.call, low, sets),
      "less than 0.13; 0.088 on average",
      "independent points have 1, jittered ones 0.32, ten candidates for every point 0.19", rule);
  expect_that(
      radius > 0.6 && radius < 0.72,
      fmt::format("{}: the relative radius is {:.3f}, mean of {} sets", all.call, radius, sets),
      "0.6 to 0.72; 0.67 on average",
      "with a fixed number of candidates, the last points come close: 0.46", rule);
  expect_no_lattice(all.call, mean, sets);
  require_everywhere(all);
}

/// For some points of each set, the fraction of the square that is closer to earlier points.
struct Nearness {
  std::vector<std::size_t> points;  ///< their indices, the same in each set
  Values parts = {};                ///< set by set
};

/// How nearness is measured, as in a correct answer or a wrong one.
struct Metric {
  bool on_torus = true, to_last_only = false;
};

/// Areas are computed along `rows` lines with a random offset.
Nearness nearness(const SampleSets& sets, std::vector<std::size_t> points, std::size_t rows,
                  Rng& rng, Metric metric = {}) {
  Nearness all{std::move(points)};
  for (std::size_t set = 0; set < sets.size(); ++set) {
    const View all_x = sets.column(set, 0), all_y = sets.column(set, 1);
    std::vector<std::size_t> by_x(all_x.size());  // uncovered_area() is faster in this order
    std::iota(by_x.begin(), by_x.end(), std::size_t{0});
    std::ranges::sort(by_x, [&](auto a, auto b) { return all_x[a] < all_x[b]; });
    for (const std::size_t i : all.points) {
      const std::size_t first = metric.to_last_only ? i - 1 : 0;
      Values x, y;
      double least = infinity;
      for (const std::size_t p : by_x) {
        if (p < first || p >= i) continue;
        x.push_back(all_x[p]), y.push_back(all_y[p]);
        double dx = all_x[p] - all_x[i], dy = all_y[p] - all_y[i];
        if (metric.on_torus) dx = short_way(dx), dy = short_way(dy);
        least = std::min(least, dx * dx + dy * dy);
      }
      const double area =
          uncovered_area(x, y, std::sqrt(least), rows, uniform(rng), metric.on_torus);
      all.parts.push_back(1 - area);
    }
  }
  return all;
}

using Count = std::function<double(double)>;  ///< of candidates, for point i

Count promised(double c) {
  return [=](double i) { return std::ceil(c * i) + 1; };
}

/// Uniform candidates have a uniform nearness, and the m-th power of the largest of m uniform
/// numbers is uniform. So these numbers are uniform if each point is the best of `candidates(i)`.
Uniforms by_candidates(const std::string& call, const Nearness& all, const Count& candidates) {
  // Areas are accurate to about three digits.
  Uniforms u{call, all.points.size(), {}, 12, [points = all.points](std::size_t position) {
               return fmt::format("nearness of point {}", points[position]);
             }};
  for (std::size_t k = 0; k < all.parts.size(); ++k) {
    const auto i = static_cast<double>(all.points[k % all.points.size()]);
    u.values.push_back(std::clamp(std::pow(all.parts[k], candidates(i)), 0.0, below_one));
  }
  return u;
}

std::vector<std::size_t> later_points(std::size_t n) {
  std::vector<std::size_t> points(n - 1);
  std::iota(points.begin(), points.end(), 1);
  return points;
}

Randomness best_of_candidates(const std::string& rule) {
  return {.words = "the nearness of point i, to the power of ceil(c i) + 1, is uniform",
          .rule = rule,
          .expected = "each point i is the best of ceil(c i) + 1 uniform candidates"};
}

/// Whether each of the points is the best of this number of candidates; wrong once in 10,000 times.
bool explains(const Nearness& all, const Count& count) {
  const Uniforms u = by_candidates("", all, count);
  for (std::size_t position = 0; position < u.positions; ++position) {
    Values of_point;
    for (std::size_t r = 0; r < u.replicates(); ++r) {
      of_point.push_back(u.values[r * u.positions + position]);
    }
    const double distance = distance_from_uniform(of_point);
    if (!(kolmogorov_tails(distance, of_point.size()).upper > 1e-4)) return false;
  }
  return true;
}

/// The only well-known mistake that explains points 1, 2, … of these sets, if there is one. Needs
/// thousands of sets, because some mistakes are similar.
Likely candidates_hint(const SampleSets& sets, double c, Rng& rng) {
  const auto measured = [&](Metric metric) {
    return nearness(sets, later_points(sets.n), 200, rng, metric);
  };
  const Nearness all = measured({});
  Nearness opposite = all;
  for (double& part : opposite.parts) part = 1 - part;
  // If all points had the same number of candidates, -1 / mean(log(part)) would estimate it.
  double logarithms = 0;
  for (const double part : all.parts) logarithms -= std::log(std::max(part, 1e-300));
  const double constant = std::round(static_cast<double>(all.parts.size()) / logarithms);
  const bool is_whole = c == std::floor(c);  // then a missing candidate does not come from rounding
  struct Mistake {
    Nearness seen;
    Count count;
    Likely hint;
  };
  const Mistake mistakes[] = {
      {all, [=](double i) { return std::ceil(c * i); },
       is_whole ? "there are only ceil(c i) candidates: one is missing"_likely
                : "there are floor(c i) + 1 candidates: round c i up, with c a double"_likely},
      {all, [=](double i) { return std::ceil(c * i) + 2; },
       "there is one candidate too many"_likely},
      // Just above 1 the first mistake gives the same.
      {all, [=](double i) { return c < 1.5 ? 0 : i + 1; },
       "there are i + 1 candidates: c is unused, or rounded"_likely},
      {all, [=](double) { return constant; },
       constant == 1 ? "as irregular as uniform points: keep the farthest of several candidates, "
                       "which are new for each point"_likely
                     : "the number of candidates hardly grows: point i needs ceil(c i) + 1"_likely},
      {opposite, promised(c),
       "this keeps the candidate that is nearest to earlier points: keep the farthest"_likely},
      {measured({.on_torus = false}), promised(c),
       "distances are measured within the square: measure them on the torus"_likely},
      {measured({.to_last_only = true}), promised(c),
       "the candidates are far from the last point: they must be far from all "
       "earlier points"_likely}};
  Likely found;
  for (const Mistake& mistake : mistakes) {
    if (!explains(mistake.seen, mistake.count)) continue;
    if (found != Likely{}) return {};
    found = mistake.hint;
  }
  return found;
}

void judge_candidates(std::size_t n, double c, std::size_t sets, Rng& rng, std::size_t rows) {
  const auto got = MEASURE(best_candidate, n, c, sets, fresh_seed(rng));
  const SampleSets all = random_sets(got, n, sets);
  if (n == 5) require_fine(all);
  const Uniforms powers =
      by_candidates(got.call, nearness(all, later_points(n), rows, rng), promised(c));
  const double mean = sum_of(powers.values) / static_cast<double>(powers.values.size());
  Randomness claim = best_of_candidates(fmt::format(
      "points are {} earlier ones than the best of ceil(c i) + 1 candidates: {}; draw "
      "all candidates anew for each point, and leave the points in this order",
      mean < 0.5 ? "nearer to" : "farther from",
      mean < 0.5 ? "some are missing or not new, or the one that is kept is not the farthest from "
                   "its nearest earlier point (compare squares with squares, and "
                   "search all cells near it)"
                 : "there are too many"));
  claim.explain = [&]() -> Likely {
    constexpr std::size_t more = 4000;
    if (n != 5) return {};
    const auto again = MEASURE(best_candidate, n, c, more, fresh_seed(rng));
    return candidates_hint(random_sets(again, n, more), c, rng);
  };
  expect_independent_uniforms(powers, claim);
}

}  // namespace

void judge_points(const SampleSets& set, double c, std::size_t first, std::size_t last,
                  std::size_t count, Rng& rng) {
  std::vector<std::size_t> points;
  for (std::size_t k = 0; k < count; ++k) {  // one from each of `count` equal parts
    const std::size_t low = first + k * (last - first) / count;
    const std::size_t high = first + (k + 1) * (last - first) / count;
    points.push_back(low + rng() % std::max<std::size_t>(high - low, 1));
  }
  Uniforms u = by_candidates(set.call, nearness(set, points, c < 1 ? 150 : 300, rng), promised(c));
  u.positions = 1;  // one set: its points are the replicates
  u.name = {};
  expect_independent_uniforms(
      u, best_of_candidates(
             "the search misses the nearest point: search all cells that can contain it"));
}

}  // namespace mc::checks
