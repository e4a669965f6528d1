// 6.1: a sampler that is random().

#include "checks/sampler/samplers.hpp"
#include "checks/support/catch.hpp"
#include "checks/support/refusals.hpp"

namespace mc::checks {
namespace {

const Randomness fresh{
    .words = "all numbers of all samples are uniform and independent",
    .alpha = alpha,
    .otherwise = "uniforms of lab 2, fresh ones for every coordinate of every sample",
    .repeated = "the same numbers come again for another sample dimension or another sample",
    .same = "the same numbers come again for another sample dimension"};

CHECK_CASE("6.1 numbers are uniform and independent", "[6.1][main][points:4][needs:2]") {
  Rng rng = check_rng();
  for (const std::size_t n : {4096u, 1000u, 131073u}) {
    const Uses uses = n > 10000 ? Uses{1, 2} : repeated(17, {1, 2});
    const SampleSets got = columns_of("independent", n, {fresh_seed(rng)}, uses);
    Uniforms samples{got.call, got.dims};
    samples.name = [](std::size_t c) { return fmt::format("coordinate {}", c); };
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t c = 0; c < got.dims; ++c) samples.values.push_back(got.column(0, c)[i]);
    }
    expect_independent_uniforms(samples, fresh);
  }
}

CHECK_CASE("6.1 numbers of different seeds are independent", "[6.1][points:4][needs:2]") {
  Rng rng = check_rng();
  for (const std::size_t n : {1u, 100u}) {
    const SampleSets got =
        columns_of("independent", n, domain::seeds(rng, 2000), {1, 2, 1, 2, 2, 1});
    expect_independent_uniforms(sample_of(got, n - 1), fresh);
  }
}

std::vector<InvalidCall> unknown_kinds() {
  std::vector<InvalidCall> calls;
  for (const std::string kind : {"random", "", "Sobol", "sobol ", "sobo", "blue noise"}) {
    calls.push_back(
        {MEASURE_OUTCOME(columns, kind, 2, {1}, {1}), "kind", "there is no such kind of sampler"});
  }
  return calls;
}

CHECK_CASE("6.1 kinds that there are not are refused", "[6.1][edge][points:1]") {
  expect_refused(unknown_kinds());
}

CHECK_CASE("6.1 a refusal names the kinds that there are", "[6.1][edge][points:1]") {
  expect_argument_named(unknown_kinds());
  const Call refused = MEASURE_OUTCOME(columns, "random", 2, {1}, {1});
  for (const std::string& known : sampler_kinds) {
    expect_that(refused.outcome.bytes.find(known) != std::string::npos,
                fmt::format("{}: threw \"{}\"", refused.text, refused.outcome.bytes),
                fmt::format("a text that also names the kind {}", known),
                "a list of the kinds helps a user who mistypes one", "");
  }
}

}  // namespace
}  // namespace mc::checks
