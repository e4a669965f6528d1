// alternative: 1.8 by sums and sums of squares of offsets from the mean, block by block, and the
// blocks merged

#include "variance.hpp"
#define moments solution_moments
#include "solutions/variance.cpp"

#include <algorithm>
#undef moments

namespace mc {

Moments moments(std::span<const double> x) {
  if (x.empty()) return {};
  const double shift = mean(x);
  Moments all;
  for (std::size_t first = 0; first < x.size(); first += 256) {
    const auto block = x.subspan(first, std::min<std::size_t>(256, x.size() - first));
    const auto n = static_cast<double>(block.size());
    double sum = 0;
    double squares = 0;
    for (double value : block) {
      sum += value - shift;
      squares += (value - shift) * (value - shift);
    }
    all = merge(all, {block.size(), sum / n, squares - sum * sum / n});
  }
  all.mean += shift;
  return all;
}

}  // namespace mc
