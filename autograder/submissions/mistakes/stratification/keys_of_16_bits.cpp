// mistake: sorts by keys of 16 bits and leaves equal ones in their order
// caught by: 3.4 permutations of many values have no trend
// hint: of which 16 are too few here
#include "stratification.hpp"

#include <utility>

#define shuffle right_shuffle
#include "solutions/stratification.cpp"
#undef shuffle

namespace mc {

void shuffle(std::span<double> x, Rng& rng) {
  std::vector<std::pair<std::uint64_t, double>> keyed;
  for (const double value : x) keyed.emplace_back(rng() >> 48, value);
  std::stable_sort(keyed.begin(), keyed.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  for (std::size_t k = 0; k < x.size(); ++k) x[k] = keyed[k].second;
}

}  // namespace mc
