// 6.4: what samplers with different seeds have to do with each other, which is nothing.

#include "checks/sampler/samplers.hpp"
#include "checks/support/catch.hpp"
#include "checks/support/expect_all_seeds.hpp"

namespace mc::checks {
namespace {

CHECK_CASE("6.4 neighbouring seeds have nothing in common",
           "[6.4][points:3][needs:6.2][needs:6.3]") {
  Rng rng = check_rng();
  for (const std::string& kind : sampler_kinds) {
    expect_all_seeds(rng, 2, "sample dimension",
                     [&](const Seeds& seeds) { return MEASURE(columns, kind, 1, seeds, {1}); });
    // Nor have other uses of other seeds: numbers that come again show where sums meet.
    const Columns got = columns_of(kind, 3, neighbours(fresh_seed(rng), 1500), repeated(3, {1, 2}));
    expect_independent_uniforms(
        got.first_samples(),
        {.words = "different seeds, even neighbors, give unrelated numbers",
         .alpha = alpha,
         .otherwise = "mix the bits of the seed before they become a state or a counter",
         .repeated = "does this number depend on the seed at all? " + same_for_seeds +
                     "; or two pairs of a seed and a sample dimension (or a counter) give one "
                     "number: their sum, say, is the same for (s, k + 1) and for (s + 1, k)"});
  }
}

}  // namespace
}  // namespace mc::checks
