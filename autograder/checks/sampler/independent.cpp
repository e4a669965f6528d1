// 6.1: a sampler that is random().

#include <algorithm>

#include "checks/sampler/samplers.hpp"
#include "checks/support/catch.hpp"
#include "checks/support/known_scenes.hpp"
#include "checks/support/refusals.hpp"

namespace mc::checks {
namespace {

CHECK_CASE("6.1 numbers are uniform and independent", "[6.1][main][points:4][needs:2]") {
  Rng rng = check_rng();
  const Randomness fresh{
      .words = "all numbers of all samples are uniform and independent",
      .alpha = alpha,
      .otherwise = "uniforms of lab 2, fresh ones for every coordinate of every sample",
      .repeated = "the same numbers come again for another sample dimension or another sample",
      .same = "the same numbers come again for another sample dimension"};
  for (const std::size_t n : {4096u, 1000u, 65537u}) {
    const Uses uses = n > 10000 ? Uses{1, 2} : repeated(17, {1, 2});
    const Columns got = columns_of("independent", n, {fresh_seed(rng)}, uses);
    Uniforms samples{got.call, got.dims};
    samples.name = [](std::size_t c) { return fmt::format("coordinate {}", c); };
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t c = 0; c < got.dims; ++c) samples.values.push_back(got[c][i]);
    }
    expect_independent_uniforms(samples, fresh);
  }
  const Columns few = columns_of("independent", 1, fresh_seeds(rng, 2000), {1, 2, 1});
  expect_independent_uniforms(few.first_samples(), fresh);
}

CHECK_CASE("6.1 the error is that of independent samples", "[6.1][points:4][needs:6.5][needs:2]") {
  Rng rng = check_rng();
  const std::uint64_t n = 16;
  const std::size_t seeds = 600;
  struct Judged {
    std::string scene;
    Values parameters;
  };
  // The edge starts inside the pixel and leaves it before the shutter closes: with one number for
  // both where and when, every sample would be white, which is 38 standard errors off or more.
  const Judged all[] = {{"rect_light", fresh_parameters("rect_light", rng)},
                        {"motion_edge", {uniform(rng, 0.05, 0.4), uniform(rng, 1, 1.4)}},
                        {"pixel_time_lens", fresh_parameters("pixel_time_lens", rng)}};
  for (const auto& [scene, parameters] : all) {
    const Known known = known_scene(scene, parameters, n);
    const auto got =
        MEASURE(estimates, "independent", scene, parameters, 1, 0, n, fresh_seeds(rng, seeds));
    const Replicates estimates{fmt::format("{}, {}", got.call, described(scene, parameters)),
                               got.exactly(seeds), n};
    const Hints hints{{{0, "far too exact for random numbers"}},
                      "every sample and every coordinate of it needs a number of its own"};
    expect_mean(estimates, known.exact, known.variance,
                {"the estimates have the scene's exact mean", alpha}, hints);
    expect_variance(estimates, known.exact, known.variance, known.kurtosis,
                    {"independent samples have the variance sigma^2 / N", alpha}, hints);
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
                fmt::format("words that also name the kind {}", known),
                "a list of the kinds helps whoever mistypes one", "");
  }
}

}  // namespace
}  // namespace mc::checks
