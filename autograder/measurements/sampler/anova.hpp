#pragma once
// The variance of a scene by order: how much of it comes from one dimension at a time, from two
// together, and so on (the ANOVA decomposition; Hoeffding 1948, "A class of statistics with
// asymptotically normal distribution"; Sobol' 1993, "Sensitivity estimates for nonlinear
// mathematical models").

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "checks/support/domain.hpp"
#include "runner/text.hpp"
#include "sampler.hpp"

namespace mc::checks {

struct Anova {
  std::vector<double> by_order;  ///< fractions of the variance: [0] of one dimension, [1] of two, …
  double within_uses = 0;        ///< the fraction that no two uses (next(), next2()) have together
};

/// Hands out the coordinates of one point in turn.
class AtPoint final : public Sampler {
 public:
  explicit AtPoint(std::span<const double> x) : x_(x) {}
  void generate(std::size_t, std::uint64_t) override {}
  double next() override { return x_[next_++]; }
  Point2 next2() override { return {next(), next()}; }  // braces: x comes first
  void advance() override { next_ = 0; }

 private:
  std::span<const double> x_;
  std::size_t next_ = 0;
};

/// From `samples` pairs of independent points. Of a set u of dimensions, the part of the variance
/// that u and its subsets make is the covariance of f(x) and f of the point that shares x's
/// coordinates in u and has the other point's elsewhere; it is estimated as by Janon et al. (2014,
/// "Asymptotic normality and efficiency of two Sobol index estimators"). What u makes beyond its
/// subsets follows by inclusion and exclusion.
template <class S>
Anova anova_of(const S& scene, std::size_t samples, Rng& rng) {
  std::vector<std::size_t> uses;  // each a set of dimensions
  std::size_t dims = 0;
  for (const std::string_view use : text::split(S::uses, ' ')) {
    const std::size_t count = use == "next2" ? 2 : 1;
    uses.push_back(((std::size_t{1} << count) - 1) << dims);
    dims += count;
  }
  const std::size_t sets = std::size_t{1} << dims;
  std::vector<double> sums(sets), squares(sets), products(sets), x(dims), z(dims), point(dims);
  for (std::size_t i = 0; i < samples; ++i) {
    for (double& value : x) value = uniform(rng);
    for (double& value : z) value = uniform(rng);
    AtPoint whole(x);
    const double f = scene(whole);
    for (std::size_t u = 0; u < sets; ++u) {
      for (std::size_t d = 0; d < dims; ++d) point[d] = (u >> d & 1u) != 0 ? x[d] : z[d];
      AtPoint shared(point);
      const double value = scene(shared);
      sums[u] += (f + value) / 2;
      squares[u] += (f * f + value * value) / 2;
      products[u] += f * value;
    }
  }
  const auto n = static_cast<double>(samples);
  std::vector<double> parts(sets);  // of the variance: of u and its subsets; the empty set has none
  for (std::size_t u = 1; u < sets; ++u) {
    const double mean = sums[u] / n;
    parts[u] = (products[u] / n - mean * mean) / (squares[u] / n - mean * mean);
  }
  Anova anova{std::vector<double>(dims)};
  for (const std::size_t use : uses) anova.within_uses += parts[use];
  for (std::size_t d = 1; d < sets; d *= 2) {  // takes away those of subsets without d
    for (std::size_t u = 0; u < sets; ++u) parts[u] -= (u & d) != 0 ? parts[u ^ d] : 0;
  }
  for (std::size_t u = 1; u < sets; ++u) {
    anova.by_order[static_cast<std::size_t>(std::popcount(u)) - 1] += parts[u];
  }
  return anova;
}

}  // namespace mc::checks
