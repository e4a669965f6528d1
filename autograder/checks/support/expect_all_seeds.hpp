#pragma once
// What randomized constructions promise of their seeds.

#include "checks/support/checks.hpp"

namespace mc::checks {

/// Labs have 40 such tests at most in a run.
inline constexpr double one_alpha = 1e-8;

/// The numbers of these seeds, of which `measure(seeds)` gives one each, for `most` seeds at a
/// time: an answer may seed a large generator for every digit of every number.
template <class Measurement>
Uniforms numbers_of(std::span<const std::uint64_t> seeds, std::size_t most, Measurement measure) {
  Uniforms all;
  for (; !seeds.empty(); seeds = seeds.subspan(std::min(most, seeds.size()))) {
    const auto part = seeds.first(std::min(most, seeds.size()));
    const auto got = measure(std::vector<std::uint64_t>(part.begin(), part.end()));
    const auto& values = got.exactly(part.size(), unit);
    all.call = got.call;
    all.values.insert(all.values.end(), values.begin(), values.end());
  }
  return all;
}

/// `measure(seeds)` gives one number for each of them: where a construction has digits in `base`,
/// of 0 scrambled. Seeds that follow each other, as those of axes and pixels do, and seeds that
/// differ in one bit, give unrelated numbers.
template <class Measurement>
void expect_all_seeds(Rng& rng, double base, const std::string& level, Measurement measure) {
  const Uniforms row = numbers_of(domain::in_a_row(rng() >> 1, 6400), 2000, measure);
  const auto& values = row.values;
  bool is_next_digit = true;
  for (std::size_t i = 0; i + 1 < values.size(); ++i) {
    const double apart = std::remainder(base * values[i] - values[i + 1], 1.0);
    is_next_digit = is_next_digit && std::abs(apart) < 1e-9;
  }
  const std::string next_digit =
      "scrambled 0 shows at the next seed what it shows one digit later at this one: seed + " +
      level + " is the same for a seed and the next " + level +
      ", and for the next seed and this " + level + "; hash the seed before the " + level +
      " is added";
  const std::string otherwise =
      "seeds that differ a little give numbers that are not independent: mix all 64 bits of the "
      "seed before they meet anything else";
  const Randomness in_a_row{.words = "neighboring seeds give independent numbers",
                            .alpha = one_alpha,
                            .otherwise = is_next_digit ? next_digit : otherwise};
  expect_independent_uniforms(row, in_a_row);
  Uniforms numbers = numbers_of(domain::seeds_by_bit(rng, 120), 2000, measure);
  numbers.positions = 65;
  numbers.name = [](std::size_t k) {
    return k == 0 ? std::string("the number of a seed")
                  : "that of the seed with bit " + std::to_string(k - 1) + " changed";
  };
  expect_independent_uniforms(numbers, {.words = "all 64 bits of the seed count",
                                        .alpha = one_alpha,
                                        .otherwise = otherwise,
                                        .same = "a bit of the seed does nothing; was the seed cut "
                                                "to 32 bits?"});
}

}  // namespace mc::checks
