#include "experiments.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "runner/experiment.hpp"

namespace mc::experiments {
namespace {

constexpr double unwritten = std::numeric_limits<double>::quiet_NaN();

Points columns_of(const PointSet& points) {
  if (points.dims() != 2) {
    throw std::logic_error("the point set has " + std::to_string(points.dims()) +
                           " dimensions, not 2");
  }
  const auto x = points.column(0), y = points.column(1);
  return {{x.begin(), x.end()}, {y.begin(), y.end()}};
}

}  // namespace

std::vector<double> toroidal_distances_squared(std::vector<double> ax, std::vector<double> ay,
                                               std::vector<double> bx, std::vector<double> by) {
  std::vector<double> distances;
  for (std::size_t i = 0; i < ax.size(); ++i) {
    distances.push_back(toroidal_distance_squared({ax[i], ay[i]}, {bx[i], by[i]}));
  }
  return distances;
}

Points best_candidate(std::uint64_t n, double c, std::uint64_t sets, std::uint64_t seed) {
  Rng rng(seed);
  Points all{std::vector<double>(n * sets, unwritten), std::vector<double>(n * sets, unwritten)};
  for (std::uint64_t set = 0; set < sets; ++set) {
    mc::best_candidate(std::span(all.x).subspan(set * n, n), std::span(all.y).subspan(set * n, n),
                       c, rng);
  }
  return all;
}

Points best_candidate_into(std::uint64_t size_x, std::uint64_t size_y, double c) {
  Rng rng(1);
  Points points{std::vector<double>(size_x, unwritten), std::vector<double>(size_y, unwritten)};
  mc::best_candidate(points.x, points.y, c, rng);
  return points;
}

Patterns poisson_disk(double radius, std::uint64_t sets, std::uint64_t seed) {
  Rng rng(seed);
  Patterns all;
  for (std::uint64_t set = 0; set < sets; ++set) {
    const Points points = columns_of(mc::poisson_disk(radius, rng));
    all.x.insert(all.x.end(), points.x.begin(), points.x.end());
    all.y.insert(all.y.end(), points.y.begin(), points.y.end());
    all.sizes.push_back(points.x.size());
  }
  return all;
}

std::vector<double> periodogram(std::vector<double> x, std::vector<double> y, std::uint64_t sets,
                                int kmax) {
  const std::size_t n = x.size() / sets, side = 2 * static_cast<std::size_t>(kmax) + 1;
  std::vector<double> all(sets * side * side, unwritten);
  for (std::uint64_t set = 0; set < sets; ++set) {
    mc::periodogram(std::span(x).subspan(set * n, n), std::span(y).subspan(set * n, n), kmax,
                    std::span(all).subspan(set * side * side, side * side));
  }
  return all;
}

std::vector<double> periodogram_into(std::uint64_t size_x, std::uint64_t size_y, int kmax,
                                     std::uint64_t size_power) {
  const std::vector<double> x(size_x), y(size_y);
  std::vector<double> power(size_power, unwritten);
  mc::periodogram(x, y, kmax, power);
  return power;
}

std::vector<double> radial_power(std::vector<double> power, int kmax) {
  return mc::radial_power(power, kmax);
}

Points tile(std::vector<double> x, std::vector<double> y, int copies) {
  PointSet pattern(x.size(), 2);
  std::ranges::copy(x, pattern.column(0).begin());
  std::ranges::copy(y, pattern.column(1).begin());
  return columns_of(mc::tile(pattern, copies));
}

Points tile_of(std::uint64_t size, std::uint64_t dims, int copies) {
  return columns_of(mc::tile(PointSet(size, dims), copies));
}

double repeat(unsigned task, std::uint64_t n, std::uint64_t rounds, std::uint64_t seed) {
  double last = unwritten;
  for (std::uint64_t round = 0; round < rounds; ++round) {
    Rng rng(seed + round);
    if (task == 2) {
      std::vector<double> x(n, unwritten), y(n, unwritten);
      mc::best_candidate(x, y, 1, rng);
      last = x.empty() ? unwritten : x.back();
    } else if (task == 3) {
      const double radius = std::sqrt(0.7 / static_cast<double>(n));
      const PointSet points = mc::poisson_disk(radius, rng);
      last = points.column(0).empty() ? unwritten : points.column(0).back();
    } else {
      throw std::out_of_range("task: must be 2 or 3");
    }
  }
  return last;
}

double repeat_plain(unsigned task, std::uint64_t n, std::uint64_t rounds, std::uint64_t seed) {
  std::vector<Point2> points;
  const auto uniform = [](Rng& rng) { return static_cast<double>(rng() >> 11) * 0x1p-53; };
  const auto nearest = [&](Point2 to) {
    double least = 1;
    for (const Point2& p : points) {
      const double dx = std::abs(p.x - to.x), dy = std::abs(p.y - to.y);
      const double tx = std::min(dx, 1 - dx), ty = std::min(dy, 1 - dy);
      least = std::min(least, tx * tx + ty * ty);
    }
    return least;
  };
  for (std::uint64_t round = 0; round < rounds; ++round) {
    Rng rng(seed + round);
    points.clear();
    for (std::uint64_t i = 0; task == 2 && i < n; ++i) {
      Point2 best{};
      double farthest = -1;
      for (std::uint64_t candidate = 0; candidate <= i; ++candidate) {
        const Point2 p{uniform(rng), uniform(rng)};
        const double distance = nearest(p);
        if (distance > farthest) farthest = distance, best = p;
      }
      points.push_back(best);
    }
    for (int misses = 0; task == 3 && misses < 10000; ++misses) {
      const Point2 dart{uniform(rng), uniform(rng)};
      if (nearest(dart) < 0.7 / static_cast<double>(n)) continue;
      points.push_back(dart);
      misses = -1;
    }
  }
  return points.empty() ? unwritten : points.back().x;
}

}  // namespace mc::experiments

std::span<const mc::runner::Experiment> mc::runner::experiments() {
  static constexpr Experiment all[] = {
      MC_EXPERIMENT(toroidal_distances_squared, "ax ay bx by",
                    "4.1  squared distances from points a to points b on the torus",
                    {.columns = "distance_squared", .index = "i"}),
      MC_EXPERIMENT(best_candidate, "n c sets seed", "4.2  sets of n points each",
                    {.sets = "sets"}),
      MC_EXPERIMENT(best_candidate_into, "size_x size_y c",
                    "4.2  points, written to an x and a y of these sizes"),
      MC_EXPERIMENT(poisson_disk, "radius sets seed",
                    "4.3  patterns, and the number of points in each"),
      MC_EXPERIMENT(periodogram, "x y sets kmax",
                    "4.4  power of each set; all sets have the same size",
                    {.columns = "power", .sets = "sets", .kmax = "kmax"}),
      MC_EXPERIMENT(periodogram_into, "size_x size_y kmax size_power",
                    "4.4  power of points at the origin; x, y, power of these sizes",
                    {.columns = "power", .kmax = "kmax"}),
      MC_EXPERIMENT(radial_power, "power kmax", "4.5  means of a periodogram over rings",
                    {.columns = "power", .index = "ring"}),
      MC_EXPERIMENT(tile, "x y copies", "4.6  a pattern, copies times along each axis"),
      MC_EXPERIMENT(tile_of, "size dims copies", "4.6  the same for size points at the origin"),
      MC_EXPERIMENT(repeat, "task n rounds seed",
                    "points of 4.2 or 4.3, rounds times; returns the last x (timing)"),
      MC_EXPERIMENT(repeat_plain, "task n rounds seed",
                    "the same by plain loops over all points (timing)"),
  };
  return all;
}

std::vector<mc::runner::Choice> mc::runner::choices() {
  return {};
}
