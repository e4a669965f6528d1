// 6.5: the renderer's loop.

#include <cmath>
#include <numeric>
#include <set>

#include "checks/sampler/samplers.hpp"
#include "checks/support/catch.hpp"
#include "checks/support/compare.hpp"
#include "checks/support/known_scenes.hpp"
#include "checks/support/refusals.hpp"

namespace mc::checks {
namespace {

using experiments::Recorded;

/// What integrate() did: a number, one integration, n samples.
template <class Measured>
const Recorded& one_integration(const Measured& got, std::size_t n) {
  return got.exactly({1, 1, 1, n}, any_number);
}

CHECK_CASE("6.5 integrate is the mean over the samples", "[6.5][main][points:3]") {
  Rng rng = check_rng();
  Results results;
  results.is_tame = true;
  for (const std::size_t size : domain::sizes(70000, rng)) {
    const auto n = static_cast<double>(size);
    const double low = size % 2 == 0 ? 1 : -2;
    const Values dealt = uniform_values(rng, size, low, low + 1);
    const auto got = MEASURE(integrate_recorded, dealt, size, fresh_seed(rng));
    const double sum = std::accumulate(dealt.begin(), dealt.end(), 0.0);
    const auto suspects = [=]() -> std::vector<Suspect> {
      double whole = 0;
      for (const double value : dealt) whole = std::trunc(whole + value);
      return {{sum, "divide by the number of samples"},
              {dealt[0], "advance() moves on to the next sample"},
              {whole / n, "the values were added up in an int, which cuts off the fraction"},
              {sum / (n - 1), "divide by N: this is over N - 1"},
              {(sum - dealt[0]) / n, "the first sample is left out"},
              {(sum - dealt.back()) / n, "the last sample is left out"}};
    };
    results.add(got.call, one_integration(got, size).values[0], sum / n, 2 * n * 0x1p-52, suspects);
  }
  results.expect("the mean of what the scene had for each sample; n roundings of a sum below 2n",
                 "every sample counts once");
}

CHECK_CASE("6.5 integrate walks through the samples once", "[6.5][points:1]") {
  Rng rng = check_rng();
  const std::size_t n = 5 + rng() % 20;
  const auto got = MEASURE(integrate_recorded, uniform_values(rng, n, 0, 1), n, fresh_seed(rng));
  const Recorded& record = one_integration(got, n);
  expect_that(record.generates == 1 && record.samples == Seeds{n},
              fmt::format("{}: {} calls of generate(), the first with {} samples", got.call,
                          record.generates, record.samples[0]),
              fmt::format("one, with {} samples", n), "all samples belong to one point set",
              "generate() once before the loop, advance() at the end of each round");
  expect_that(record.evaluations == n && record.positions == neighbours(0, n),
              fmt::format("{}: the scene was evaluated {} times, the last time for sample {}",
                          got.call, record.evaluations, record.positions.back()),
              fmt::format("{} times: once for each sample, 0 1 2 …", n),
              "so many samples were paid for", "advance() once after each sample");
}

CHECK_CASE("6.5 the seed of integrate decides about the samples", "[6.5][points:1]") {
  Rng rng = check_rng();
  const Seeds given = domain::seeds_by_bit(rng);
  std::set<std::uint64_t> used;
  for (const std::uint64_t seed : given) {
    used.insert(one_integration(MEASURE(integrate_recorded, {1, 2, 3}, 3, seed), 3).seeds[0]);
    if (used.size() == 1 && seed != given[0]) break;
  }
  expect_that(used.size() == given.size(),
              fmt::format("integrate with seed {}, and with seeds that differ from it in one bit: "
                          "generate() was called with {} different seeds",
                          given[0], used.size()),
              fmt::format("{}", given.size()), "the seed decides about the samples",
              used.size() == 1 ? "pass the seed on to generate()"
                               : "seeds have 64 bits: was the seed cut to 32 bits?");
}

CHECK_CASE("6.5 no samples are refused", "[6.5][edge][points:1]") {
  const std::vector<InvalidCall> calls{{MEASURE_OUTCOME(integrate_recorded, {}, 0, 1), "samples",
                                        "a mean of no samples is nothing"}};
  expect_refused(calls);
  expect_argument_named(calls);
}

// No kind may have more than e times the variance of independent samples: that is the most a
// scrambled (0,m,s)-net can have (Owen 1997), and the others have less. Within six standard
// deviations of that: once in 5e8 even for one that had it, and there are 70 of them; those that do
// have less are never near it.

CHECK_CASE("6.5 every kind is unbiased on every scene", "[6.5][points:2][needs:6.3][needs:6.7]") {
  Rng rng = check_rng();
  const std::uint64_t n = 16;
  const std::size_t replicates = 200;
  for (const std::string& kind : sampler_kinds) {
    for (const KnownScene& one : known_scenes) {
      const std::string scene(one.name);
      const auto parameters = fresh_parameters(scene, rng);
      const Known known = known_scene(scene, parameters, static_cast<double>(n));
      const double a = uniform(rng, 0.5, 2), b = uniform(rng, -1, 1);
      const auto got =
          MEASURE(estimates, kind, scene, parameters, a, b, n, domain::seeds(rng, replicates));
      double mean = 0;
      for (const double value : got.exactly(replicates)) mean += value / 200;
      const double sigma = a * std::sqrt(std::exp(1) * known.variance / replicates);
      expect_within(fmt::format("{}, {}: the mean of {} estimates", got.call,
                                described(scene, parameters), replicates),
                    mean, a * known.exact + b, 6 * sigma,
                    "six standard deviations of it, if the points were e times worse than "
                    "independent ones",
                    {{}, "is each coordinate uniform in [0, 1) on its own?"});
    }
  }
}

}  // namespace
}  // namespace mc::checks
