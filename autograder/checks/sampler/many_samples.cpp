// 6.8: many samples, and what is not asked for.

#include "checks/sampler/samplers.hpp"
#include "checks/sampler/walks.hpp"
#include "checks/support/catch.hpp"
#include "checks/support/strata.hpp"

namespace mc::checks {
namespace {

TEST_CASE("6.8 many samples are right too",
          "[6.8][main][points:2][needs:6.2][needs:6.3][needs:3]") {
  Rng rng = check_rng();
  const std::size_t n = std::size_t{1} << 17;
  for (const std::string kind : {"stratified", "sobol"}) {
    const Columns got = columns_of(kind, n, {fresh_seed(rng)}, {1, 2, 1});
    for (std::size_t c = 0; c < got.dims; ++c) {
      expect_one_in_each(got.call, fmt::format("coordinate {}", c).c_str(), got[c], n,
                         "every sample dimension is stratified, for any number of samples");
    }
  }
}

TEST_CASE("6.8 a sample dimension that nobody asks for costs no memory", "[6.8][edge][points:2]") {
  // A column of so many samples is 512 MB, all that a program may have.
  const Step advance{advance_call};
  for (const std::string kind : {"independent", "stratified", "halton", "sobol"}) {
    const Played got = played(kind, {generate(most_samples / 2, 1),
                                     advance,
                                     advance,
                                     generate(4, 1),
                                     {next_call},
                                     {next2_call}});
    for (std::size_t i = 0; i < got.steps.size(); ++i) {
      check_thrown(got, i, 0,
                   i < 3 ? "with 2^26 samples, none of them asked for"
                         : "with 4 samples, after 2^26 of which none was asked for",
                   i < 3 ? "columns are made when they are asked for, and none was"
                         : "a column has as many numbers as there are samples now");
    }
    const auto few = [&](std::size_t i) { return got.answers[i].x; };
    expect_that(is_sequence(kind) || few(4) != few(5),
                fmt::format("{}: {:.17g} for next() and for x of next2()", got.until(5), few(4)),
                "two numbers", "", "");
  }
  pass();
}

}  // namespace
}  // namespace mc::checks
