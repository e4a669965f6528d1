// mistake: a Poisson-disk pattern of too few points, filled with random ones
// caught by: 6.7 the first next2 is blue noise
// hint: as blue as a fixed number of candidates
#include "autograder/submissions/mistakes/sampler/spoiled.hpp"

namespace mc {
namespace {

/// About 0.95 N points, then random ones.
void filled(const Use& use, std::span<double> x, std::span<double> y, Rng& rng) {
  if (use.number > 0) return stratified2(use, x, y, rng);
  const PointSet points = poisson_disk(0.859 / std::sqrt(static_cast<double>(x.size())), rng);
  for (std::size_t i = 0; i < x.size(); ++i) {
    const bool there = i < points.size();
    x[i] = there ? points.column(0)[i] : to_unit(rng());
    y[i] = there ? points.column(1)[i] : to_unit(rng());
  }
}

constexpr Kind wrong{"blue_noise", stratified1, filled};

}  // namespace

std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  return make_other_kind(wrong, kind);
}

}  // namespace mc
