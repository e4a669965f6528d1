// mistake: sums in blocks and lanes about the first value, which may be far from all others
// caught by: 1.8 the moments keep their digits beside outliers
// hint: is everything measured from a value that may lie far
#include "variance.hpp"
#define moments right_moments
#include "solutions/variance.cpp"
#undef moments

namespace mc {

Moments moments(std::span<const double> x) {
  if (x.empty()) return {};
  Moments all;
  for (std::size_t first = 0; first < x.size(); first += block_size) {
    const std::size_t size = std::min(block_size, x.size() - first);
    all = merge(all, moments_from(x[0], x.subspan(first, size)));
  }
  all.mean += x[0];
  return all;
}

}  // namespace mc
