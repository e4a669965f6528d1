#include "checks/blue_noise/nearness.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "checks/support/discs.hpp"
#include "checks/support/distributions.hpp"

namespace mc::checks {
namespace {

/// Whether each of the points is the best of so many candidates: one in 10,000 that is is missed.
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

}  // namespace

Nearness nearness(const SampleSets& sets, std::vector<std::size_t> points, std::size_t rows,
                  Rng& rng, Metric metric) {
  Nearness all{std::move(points)};
  for (std::size_t set = 0; set < sets.size(); ++set) {
    for (const std::size_t i : all.points) {
      const std::size_t first = metric.to_last_only ? i - 1 : 0;
      const View all_x = sets.column(set, 0), all_y = sets.column(set, 1);
      const View x = all_x.subspan(first, i - first), y = all_y.subspan(first, i - first);
      double least = infinity;
      for (std::size_t p = 0; p < x.size(); ++p) {
        const double dx = x[p] - all_x[i], dy = y[p] - all_y[i];
        least = std::min(
            least, metric.on_torus ? std::hypot(short_way(dx), short_way(dy)) : std::hypot(dx, dy));
      }
      all.parts.push_back(1 - uncovered_area(x, y, least, rows, uniform(rng), metric.on_torus));
    }
  }
  return all;
}

Uniforms by_candidates(const std::string& call, const Nearness& all, const Count& candidates) {
  // Areas are right to three digits or so.
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

Count promised(double c) {
  return [=](double i) { return std::ceil(c * i) + 1; };
}

Randomness best_of_candidates(const std::string& otherwise) {
  return {.words =
              "the fraction of the square that is nearer to an earlier point than point i, to "
              "the power of ceil(c i) + 1, is uniform",
          .alpha = alpha,
          .otherwise = otherwise,
          .expected = "each point i is the best of ceil(c i) + 1 uniform candidates"};
}

std::string candidates_hint(const SampleSets& sets, double c, Rng& rng) {
  const auto measured = [&](Metric metric) {
    return nearness(sets, later_points(sets.n), 200, rng, metric);
  };
  const Nearness all = measured({});
  Nearness opposite = all;
  for (double& part : opposite.parts) part = 1 - part;
  // Were it the same number m for all points, -1 / mean(log(part)) would estimate it.
  double logarithms = 0;
  for (const double part : all.parts) logarithms -= std::log(std::max(part, 1e-300));
  const double constant = std::round(static_cast<double>(all.parts.size()) / logarithms);
  const bool is_whole = c == std::floor(c);  // then one candidate missing is not c i rounded down
  struct Mistake {
    Nearness seen;
    Count count;
    const char* hint;
  };
  const Mistake mistakes[] = {
      {all, [=](double i) { return std::ceil(c * i); },
       is_whole ? "these are ceil(c i) candidates: one is missing"
                : "these are floor(c i) + 1 candidates: c i is rounded up"},
      {all, [=](double i) { return std::ceil(c * i) + 2; }, "there is one candidate too many"},
      {all, [](double i) { return i + 1; },
       "these are i + 1 candidates: c is not used, or rounded"},
      {all, [=](double) { return constant; },
       constant == 1 ? "these are uniform points: of several candidates, keep the farthest"
                     : "the number of candidates is the same for all points: it grows with i"},
      {opposite, promised(c),
       "this keeps the candidate that is nearest to the others: keep the farthest"},
      {measured({.on_torus = false}), promised(c),
       "these are the best candidates within the square, so points crowd at its edges: measure "
       "distances round the torus"},
      {measured({.to_last_only = true}), promised(c),
       "these candidates are far from the last point: they must be far from all points before"}};
  std::string found;
  for (const Mistake& mistake : mistakes) {
    if (!explains(mistake.seen, mistake.count)) continue;
    if (!found.empty()) return {};
    found = mistake.hint;
  }
  return found;
}

}  // namespace mc::checks
