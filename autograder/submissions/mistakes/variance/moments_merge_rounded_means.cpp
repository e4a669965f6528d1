// mistake: merges blocks by their means, each rounded where the data are
// caught by: 1.8 the moments keep their digits on hard data
// hint: is a mean rounded here before it is compared
#include "variance.hpp"
#define moments right_moments
#include "solutions/variance.cpp"
#undef moments

namespace mc {

Moments moments(std::span<const double> x) {
  Moments all;
  for (std::size_t first = 0; first < x.size(); first += block_size) {
    const auto block = x.subspan(first, std::min(block_size, x.size() - first));
    all = merge(all, right_moments(block));
  }
  return all;
}

}  // namespace mc
