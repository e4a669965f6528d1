#pragma once
// How randomized constructions must depend on their seeds.

#include "checks/support/checks.hpp"

namespace mc::checks {

/// The numbers that `measure(seeds)` returns, `each` per seed, for up to `most` seeds per call: an
/// answer may seed a large generator for every digit of every number.
template <class Measurement>
Uniforms numbers_of(std::span<const std::uint64_t> seeds, std::size_t most, Measurement measure,
                    std::size_t each = 1) {
  Uniforms all{"", each};
  for (; !seeds.empty(); seeds = seeds.subspan(std::min(most, seeds.size()))) {
    const auto part = seeds.first(std::min(most, seeds.size()));
    const auto got = measure(std::vector<std::uint64_t>(part.begin(), part.end()));
    append(all.values, got.exactly(each * part.size(), unit));
    all.call = got.call;
  }
  return all;
}

/// `measure(seeds)` returns one number per seed; if a construction scrambles digits in `base`, its
/// scrambled 0. Consecutive seeds, seeds that differ in one bit, and s, ~s, -s are independent.
template <class Measurement>
void expect_all_seeds(Rng& rng, double base, const std::string& level, Measurement measure) {
  const Uniforms row = numbers_of(domain::in_a_row(rng() >> 1, 6400), 2000, measure);
  const auto& values = row.values;
  bool is_next_digit = true;
  for (std::size_t i = 0; i + 1 < values.size(); ++i) {
    const double apart = std::remainder(base * values[i] - values[i + 1], 1.0);
    is_next_digit = is_next_digit && std::abs(apart) < 1e-9;
  }
  const Likely next_digit = likely(
      "with the next seed, scrambled 0 has the same digits, shifted by one place: seed + {0} is "
      "the same for (seed, {0} + 1) and (seed + 1, {0}); hash the seed before adding the {0}",
      level);
  const std::string rule = "numbers of similar seeds are independent: mix all 64 bits of the seed";
  expect_independent_uniforms(
      row, {.words = "neighboring seeds give independent numbers", .rule = rule, .explain = [&] {
              return is_next_digit ? next_digit : Likely{};
            }});
  Uniforms numbers = numbers_of(domain::seeds_by_bit(rng, 120), 2000, measure);
  numbers.positions = 65;
  numbers.name = [](std::size_t k) {
    return k == 0 ? std::string("the number of a seed")
                  : fmt::format("the number of the seed with bit {} flipped", k - 1);
  };
  expect_independent_uniforms(
      numbers,
      {.words = "all 64 bits of the seed count",
       .rule = rule,
       .same = "a bit of the seed has no effect; do not truncate the seed to 32 bits"_likely});
  Uniforms opposites = numbers_of(domain::seeds_and_opposites(rng, 300), 2000, measure);
  opposites.positions = 3;
  opposites.name = [](std::size_t k) {
    constexpr const char* names[] = {"s", "~s", "-s"};
    return fmt::format("the number of the seed {}", names[k]);
  };
  expect_independent_uniforms(
      opposites,
      {.words = "the seeds s, ~s and -s give independent numbers",
       .rule = rule,
       .same = "a seed s and ~s or -s give the same numbers: mix all bits of the seed"_likely});
}

}  // namespace mc::checks
