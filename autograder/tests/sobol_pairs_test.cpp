// The pairs of Sobol' dimensions that 6.3 uses: a search over all pairs of the table.

#include <algorithm>
#include <utility>
#include <vector>

#include "checks/sampler/sequences.hpp"
#include "checks/support/catch.hpp"

namespace mc::checks {
namespace {

/// The number of empty cells in the square grid of 4^m cells for the first 4^m points of two
/// dimensions.
std::size_t empty_cells(unsigned a, unsigned b, unsigned m) {
  const auto x = sobol_directions(a), y = sobol_directions(b);
  std::vector<bool> taken(std::size_t{1} << 2 * m);
  for (std::size_t i = 0; i < taken.size(); ++i) {
    const std::uint32_t column = sobol_word(x, i) >> (32 - m), row = sobol_word(y, i) >> (32 - m);
    taken[column << m | row] = true;
  }
  return static_cast<std::size_t>(std::count(taken.begin(), taken.end(), false));
}

using Pair = std::pair<unsigned, unsigned>;

TEST_CASE("6.3 uses four of the eight pairs of Sobol' dimensions without empty cells") {
  std::vector<Pair> good;
  for (unsigned a = 0; a < joe_kuo.size(); ++a) {
    for (unsigned b = a + 1; b < joe_kuo.size(); ++b) {
      bool fills_all = true;
      for (unsigned m = 1; m <= 5; ++m) fills_all = fills_all && empty_cells(a, b, m) == 0;
      if (fills_all) good.emplace_back(a, b);
    }
  }
  const std::vector<Pair> all{{0, 1},  {0, 12},  {0, 13},  {4, 6},
                              {7, 13}, {10, 20}, {15, 21}, {16, 20}};
  CHECK(good == all);
  for (std::size_t k = 0; k < block_dims; k += 2) {
    const Pair pair{sobol_block[k], sobol_block[k + 1]};
    CHECK(std::find(good.begin(), good.end(), pair) != good.end());
  }
  CHECK(empty_cells(6, 7, 2) == 12);
  CHECK(empty_cells(2, 3, 5) == 512);
}

}  // namespace
}  // namespace mc::checks
