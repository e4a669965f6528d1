#include "checks/blue_noise/nearness.hpp"

#include <algorithm>
#include <cmath>

#include "checks/support/discs.hpp"
#include "checks/support/distributions.hpp"
#include "checks/support/statistics.hpp"

namespace mc::checks {
namespace {

using Count = std::function<double(double)>;  ///< of candidates, for point i

/// Do these values follow the uniform distribution? One in 10,000 that do is missed.
bool are_uniform(Values u) {
  std::sort(u.begin(), u.end());
  double distance = 0;
  const auto n = static_cast<double>(u.size());
  for (std::size_t k = 0; k < u.size(); ++k) {
    const auto below = static_cast<double>(k) / n;
    distance = std::max({distance, u[k] - below, below + 1 / n - u[k]});
  }
  return kolmogorov_tails(distance, u.size()).upper > 1e-4;
}

/// Which points the nearest one is looked for among, and how distances are measured.
struct Way {
  bool torus, to_last_only;
};

std::vector<Nearness> measured(std::span<const Set> sets, Way way) {
  constexpr std::size_t rows = 200;
  std::vector<Nearness> all;
  for (const Set& set : sets) {
    for (std::size_t i = 1; i < set.x.size(); ++i) {
      const std::size_t first = way.to_last_only ? i - 1 : 0;
      const View x = set.x.subspan(first, i - first), y = set.y.subspan(first, i - first);
      double least = infinity;
      for (std::size_t p = 0; p < x.size(); ++p) {
        const double dx = x[p] - set.x[i], dy = y[p] - set.y[i];
        least = std::min(least,
                         way.torus ? std::hypot(short_way(dx), short_way(dy)) : std::hypot(dx, dy));
      }
      all.push_back({i, 1 - uncovered_area(x, y, least, rows, 0.5, way.torus)});
    }
  }
  return all;
}

}  // namespace

Nearness nearness(const Set& set, std::size_t i, std::size_t rows, Rng& rng) {
  const double distance = nearest_distance(set.x, set.y, i, i);
  return {i, 1 - uncovered_area(set.x.first(i), set.y.first(i), distance, rows, uniform(rng))};
}

Values by_candidates(std::span<const Nearness> all, const Count& candidates) {
  Values u;
  for (const auto& [i, part] : all) {
    u.push_back(std::clamp(std::pow(part, candidates(static_cast<double>(i))), 0.0, below_one));
  }
  return u;
}

void expect_candidates(const std::string& call, std::span<const Nearness> all, double c,
                       const std::string& likely) {
  const auto u = by_candidates(all, [&](double i) { return std::ceil(c * i) + 1; });
  expect_distribution(
      call, u, [](double p) { return p; },
      {"the fraction of the square that is nearer to another point than point i, to the power of "
       "ceil(c i) + 1, is uniform",
       alpha},
      {{}, likely});
}

bool have_candidates(std::span<const Nearness> all, const Count& candidates) {
  return are_uniform(by_candidates(all, candidates));
}

std::string candidates_hint(std::span<const Set> sets, double c) {
  const std::vector<Nearness> all = measured(sets, {true, false});
  const auto explains = [](std::span<const Nearness> parts, const Count& count) {
    for (std::size_t i = 1; i <= parts.back().i; ++i) {
      std::vector<Nearness> of_point;
      for (const Nearness& one : parts) {
        if (one.i == i) of_point.push_back(one);
      }
      if (!have_candidates(of_point, count)) return false;
    }
    return true;
  };
  const Count right = [=](double i) { return std::ceil(c * i) + 1; };
  // Were it the same number m for all points, -1 / mean(log(part)) would estimate it.
  double logarithms = 0;
  for (const auto& [i, part] : all) logarithms -= std::log(std::max(part, 1e-300));
  const double constant = std::round(static_cast<double>(all.size()) / logarithms);
  std::vector<std::string> found;
  const auto suspect = [&](std::span<const Nearness> parts, const Count& count, const char* hint) {
    if (explains(parts, count)) found.emplace_back(hint);
  };
  if (c == std::floor(c)) {  // else these two are one
    suspect(
        all, [=](double i) { return c * i; }, "these are ceil(c i) candidates: one is missing");
  } else {
    suspect(
        all, [=](double i) { return std::floor(c * i) + 1; },
        "these are floor(c i) + 1 candidates: c i is rounded up");
  }
  suspect(
      all, [=](double i) { return std::ceil(c * i) + 2; }, "there is one candidate too many");
  suspect(
      all, [](double i) { return i + 1; }, "the number of candidates does not depend on c");
  suspect(
      all, [=](double) { return constant; },
      constant == 1 ? "these are uniform points: of several candidates, keep the farthest"
                    : "the number of candidates is the same for all points: it grows with i");
  std::vector<Nearness> other = all;
  for (Nearness& one : other) one.part = 1 - one.part;
  suspect(other, right,
          "this keeps the candidate that is nearest to the others: keep the farthest");
  suspect(measured(sets, {false, false}), right,
          "these are the best candidates within the square, so points crowd at its edges: measure "
          "distances round the torus");
  suspect(measured(sets, {true, true}), right,
          "these candidates are far from the last point: they must be far from all points before");
  if (found.size() == 1) return found[0];
  return "for each candidate its nearest point, of all points before; keep the candidate for which "
         "that is farthest";
}

}  // namespace mc::checks
