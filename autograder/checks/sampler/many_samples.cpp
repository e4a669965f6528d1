// 6.8: many samples, and what is not asked for.

#include "checks/sampler/contract.hpp"
#include "checks/support/catch.hpp"

namespace mc::checks {
namespace {

TEST_CASE("6.8 many samples are right too",
          "[6.8][main][points:2][needs:6.2][needs:6.3][needs:3]") {
  Rng rng = check_rng();
  const std::size_t n = std::size_t{1} << 17;
  for (const std::string kind : {"stratified", "sobol"}) {
    const SampleSets got = columns_of(kind, n, {fresh_seed(rng)}, {1, 2, 1});
    for (std::size_t c = 0; c < got.dims; ++c) {
      expect_one_in_each_cell(got, 0, line_of(n, c),
                              "every sample dimension is stratified, for any number of samples");
    }
  }
}

TEST_CASE("6.8 an unused sample dimension costs no memory", "[6.8][edge][points:2]") {
  // A column of so many samples is 1 GB, more than a program may have.
  for (const std::string kind : {"independent", "stratified", "halton", "sobol"}) {
    expect_contract(
        kind, {generate(most_samples, 1), advance, advance, generate(4, 1), next, next2},
        {"none of 2^27 samples was asked for, and then there are 4",
         "columns are made when they are asked for, of as many numbers as there are samples"});
  }
}

}  // namespace
}  // namespace mc::checks
