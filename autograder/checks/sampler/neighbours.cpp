// 6.4: what samplers with different seeds have to do with each other, which is nothing.

#include <map>

#include "checks/sampler/relations.hpp"
#include "checks/sampler/samplers.hpp"
#include "checks/support/catch.hpp"

namespace mc::checks {
namespace {

/// Where a number was handed out.
struct HandedOut {
  std::uint64_t seed;
  std::size_t coordinate, sample;
};

std::string likely_of(const HandedOut& before, const HandedOut& here) {
  if (before.coordinate != here.coordinate || before.sample != here.sample) {
    return "two pairs of a seed and a sample dimension (or a counter) give one number: their sum, "
           "say, is the same for (s, k + 1) and for (s + 1, k)";
  }
  return here.seed - before.seed >= std::uint64_t{1} << 32
             ? "was the seed cut to 32 bits?"
             : "does this number depend on the seed at all? " + same_for_seeds;
}

CHECK_CASE("6.4 neighbouring seeds have nothing in common",
           "[6.4][points:3][needs:6.2][needs:6.3]") {
  Rng rng = check_rng();
  for (const std::string& kind : sampler_kinds) {
    const Columns got = columns_of(kind, 1, neighbours(fresh_seed(rng), 2 * 800), {1});
    Values before, after;
    for (std::size_t set = 0; set < got.sets(); set += 2) {
      before.push_back(got(set, 0)[0]);
      after.push_back(got(set + 1, 0)[0]);
    }
    expect_uniform_pairs(got.call + ", pairs of a seed's number and the next seed's", before, after,
                         "seeds s and s + 1 give unrelated numbers",
                         "mix the bits of the seed before they become a state or a counter");
  }
  // Nor have other uses of other seeds, near or far. 1,274 numbers of 53 bits for each kind: two of
  // them are the same once in 1e10 runs.
  const Uses uses{1, 2, 1, 2, 1};
  for (const std::string& kind : sampler_kinds) {
    const std::uint64_t first = fresh_seed(rng);
    Seeds seeds = neighbours(first, 32);
    for (unsigned bit = 5; bit < 64; ++bit) seeds.push_back(first + (std::uint64_t{1} << bit));
    const Columns got = columns_of(kind, 2, seeds, uses);
    std::map<double, HandedOut> places;
    for (std::size_t set = 0; set < got.sets(); ++set) {
      for (std::size_t c = 0; c < got.dims; ++c) {
        for (std::size_t i = 0; i < got.n; ++i) {
          const double x = got(set, c)[i];
          const HandedOut here{seeds[set], c, i};
          const HandedOut before = places.insert({x, here}).first->second;
          if (before.seed == here.seed) continue;
          expect_that(false,
                      fmt::format("{}: {:.17g} is coordinate {} of sample {} with seed {}, and "
                                  "coordinate {} of sample {} with seed {}",
                                  got.call, x, before.coordinate, before.sample, before.seed,
                                  here.coordinate, here.sample, here.seed),
                      "another number", "different seeds, even neighbours, give unrelated numbers",
                      likely_of(before, here));
        }
      }
    }
  }
  pass();
}

}  // namespace
}  // namespace mc::checks
