// Mistakes in task 3.8.
#include "stratification.hpp"

#include <cmath>

#define estimate_replicated right_estimate_replicated
#include "solutions/stratification.cpp"
#undef estimate_replicated

// mistake: returns s / sqrt(n) over all points, as if they were independent
// hint: as if they were independent
namespace mc::bar_of_independent_points {
Estimate estimate_replicated(const Integrand& g, const Generator& generator, std::uint64_t n,
                             std::uint64_t replicates, Rng& rng) {
  if (n == 0) throw std::invalid_argument("n: must be positive");
  if (replicates == 0) throw std::invalid_argument("replicates: must be positive");
  PointSet points(n, g.dims);
  std::vector<double> point(g.dims);
  Moments values;
  for (std::uint64_t replicate = 0; replicate < replicates; ++replicate) {
    generator(points, rng);
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t d = 0; d < g.dims; ++d) point[d] = points.column(d)[i];
      add(values, g.f(point));
    }
  }
  return {values.mean, std::sqrt(variance(values) / static_cast<double>(values.count)),
          values.count};
}
}  // namespace mc::bar_of_independent_points

// mistake: returns the standard deviation of one replicate as the error of the mean
// hint: this is the standard deviation of one mean
namespace mc::bar_of_one_replicate {
Estimate estimate_replicated(const Integrand& g, const Generator& generator, std::uint64_t n,
                             std::uint64_t replicates, Rng& rng) {
  Estimate estimate = right_estimate_replicated(g, generator, n, replicates, rng);
  estimate.standard_error *= std::sqrt(static_cast<double>(replicates));
  return estimate;
}
}  // namespace mc::bar_of_one_replicate

// mistake: divides the standard deviation of the means by sqrt(n replicates)
// hint: divide by sqrt(replicates)
namespace mc::bar_over_all_points {
Estimate estimate_replicated(const Integrand& g, const Generator& generator, std::uint64_t n,
                             std::uint64_t replicates, Rng& rng) {
  Estimate estimate = right_estimate_replicated(g, generator, n, replicates, rng);
  estimate.standard_error /= std::sqrt(static_cast<double>(n));
  return estimate;
}
}  // namespace mc::bar_over_all_points

// mistake: divides the squared deviations by replicates instead of replicates - 1
// hint: a sample variance divides by replicates - 1
namespace mc::bar_over_replicates {
Estimate estimate_replicated(const Integrand& g, const Generator& generator, std::uint64_t n,
                             std::uint64_t replicates, Rng& rng) {
  Estimate estimate = right_estimate_replicated(g, generator, n, replicates, rng);
  const auto r = static_cast<double>(replicates);
  estimate.standard_error *= std::sqrt((r - 1) / r);
  return estimate;
}
}  // namespace mc::bar_over_replicates

// mistake: returns an error of zero for one replicate
// hint: so the result is undefined
namespace mc::certain_of_one {
Estimate estimate_replicated(const Integrand& g, const Generator& generator, std::uint64_t n,
                             std::uint64_t replicates, Rng& rng) {
  Estimate estimate = right_estimate_replicated(g, generator, n, replicates, rng);
  if (replicates == 1) estimate.standard_error = 0;
  return estimate;
}
}  // namespace mc::certain_of_one

// mistake: returns the number of replicates in Estimate::n
// hint: Estimate.n counts evaluations
namespace mc::counts_replicates {
Estimate estimate_replicated(const Integrand& g, const Generator& generator, std::uint64_t n,
                             std::uint64_t replicates, Rng& rng) {
  Estimate estimate = right_estimate_replicated(g, generator, n, replicates, rng);
  estimate.n = replicates;
  return estimate;
}
}  // namespace mc::counts_replicates

// mistake: cuts one large point set into replicates
// hint: made in one call
namespace mc::one_set_for_all {
Estimate estimate_replicated(const Integrand& g, const Generator& generator, std::uint64_t n,
                             std::uint64_t replicates, Rng& rng) {
  if (n == 0 || replicates == 0) {
    return right_estimate_replicated(g, generator, n, replicates, rng);
  }
  PointSet all(n * replicates, g.dims);
  generator(all, rng);
  std::uint64_t first = 0;
  const Generator parts = [&](PointSet& points, Rng&) {
    for (std::size_t d = 0; d < g.dims; ++d) {
      std::ranges::copy(all.column(d).subspan(first, n), points.column(d).begin());
    }
    first += n;
  };
  return right_estimate_replicated(g, parts, n, replicates, rng);
}
}  // namespace mc::one_set_for_all

// mistake: makes one coordinate per point, whatever the dimensions of g
// hint: the generator got a set of
namespace mc::points_of_one_dimension {
Estimate estimate_replicated(const Integrand& g, const Generator& generator, std::uint64_t n,
                             std::uint64_t replicates, Rng& rng) {
  const Generator flat = [&](PointSet& points, Rng& from) {
    PointSet line(points.size(), 1);
    generator(line, from);
    for (std::size_t d = 0; d < points.dims(); ++d) {
      std::ranges::copy(line.column(0), points.column(d).begin());
    }
  };
  return right_estimate_replicated(g, flat, n, replicates, rng);
}
}  // namespace mc::points_of_one_dimension

// mistake: computes the spread of the means by E{X^2} - E{X}^2, which cancels
// hint: compute the variance with lab 1
namespace mc::textbook_bar {
Estimate estimate_replicated(const Integrand& g, const Generator& generator, std::uint64_t n,
                             std::uint64_t replicates, Rng& rng) {
  double sum = 0, squares = 0;
  const Generator watched = [&](PointSet& points, Rng& from) { generator(points, from); };
  if (n == 0 || replicates == 0) return right_estimate_replicated(g, watched, n, replicates, rng);
  for (std::uint64_t k = 0; k < replicates; ++k) {
    const double mean = right_estimate_replicated(g, watched, n, 1, rng).value;
    sum += mean, squares += mean * mean;
  }
  const auto r = static_cast<double>(replicates);
  const double variance = std::max(0.0, squares / r - sum / r * (sum / r)) * r / (r - 1);
  return {sum / r, std::sqrt(variance / r), n * replicates};
}
}  // namespace mc::textbook_bar

// mistake: starts every replicate with a copy of the same generator
// hint: fresh points from the same generator
namespace mc::the_same_replicate {
Estimate estimate_replicated(const Integrand& g, const Generator& generator, std::uint64_t n,
                             std::uint64_t replicates, Rng& rng) {
  const Generator same = [&](PointSet& points, Rng&) {
    Rng copy = rng;
    generator(points, copy);
  };
  return right_estimate_replicated(g, same, n, replicates, rng);
}
}  // namespace mc::the_same_replicate

// mistake: draws from a copy of the generator, so the next estimate has the same points
// hint: from the same generator, not from a copy
namespace mc::copies_the_generator {
Estimate estimate_replicated(const Integrand& g, const Generator& generator, std::uint64_t n,
                             std::uint64_t replicates, Rng& rng) {
  Rng copy = rng;
  return right_estimate_replicated(g, generator, n, replicates, copy);
}
}  // namespace mc::copies_the_generator

// mistake: keeps the points of the last call, unless n differs
// hint: a static or global variable keeps its value between calls
namespace mc::keeps_its_points {
Estimate estimate_replicated(const Integrand& g, const Generator& generator, std::uint64_t n,
                             std::uint64_t replicates, Rng& rng) {
  static PointSet kept(0, 0);
  if (kept.size() != n) kept = PointSet(n, g.dims);
  const Generator into_kept = [&](PointSet& points, Rng& from) {
    generator(kept, from);
    for (std::size_t d = 0; d < std::min(points.dims(), kept.dims()); ++d) {
      std::copy(kept.column(d).begin(), kept.column(d).end(), points.column(d).begin());
    }
  };
  return right_estimate_replicated(g, into_kept, n, replicates, rng);
}
}  // namespace mc::keeps_its_points
