#pragma once
// One harness for randomized constructions. A check says how to make one and how to invert it to
// the uniform numbers it was made from; the functions here choose calls and seeds, and the battery
// judges the numbers (battery.hpp).

#include "checks/support/checks.hpp"

namespace mc::checks {

using Seeds = std::vector<std::uint64_t>;

/// A construction that takes its numbers from a generator.
struct Construction {
  Randomness claim;
  /// The numbers that determine `calls` results in turn, from one generator with this seed;
  /// `positions` are those of one result.
  std::function<Uniforms(std::uint64_t seed, std::size_t calls)> numbers;
};

/// The numbers of one call, `each` per sample, to `bits` bits, are independent of each other and of
/// those with another seed.
inline void expect_random_samples(const Construction& made, std::size_t each, int bits, Rng& rng) {
  Uniforms one = made.numbers(rng(), 1), other = made.numbers(rng(), 1);
  one.positions = other.positions = each;
  one.bits = other.bits = bits;
  Randomness claim = made.claim;
  claim.words += ", of one call";
  claim.rule = "make each number by to_unit() from a new word; use no mirror image 1 - u";
  claim.repeated = "take new numbers from rng inside the loop, for each sample"_likely;
  expect_independent_uniforms(one, claim);
  Uniforms both = side_by_side(one, other);
  both.name = [each](std::size_t position) {
    return fmt::format("number {} of a sample with {}", position % each,
                       position < each ? "one seed" : "another seed");
  };
  claim.words = made.claim.words + ", from two seeds";
  claim.rule = "numbers with one seed depend on those with another";
  claim.repeated = claim.same = "take all random numbers from rng"_likely;
  expect_independent_uniforms(both, claim);
}

/// Results of calls in turn are independent; if wanted, also of those with the next seed.
inline void expect_random_calls(const Construction& made, std::size_t calls, Rng& rng,
                                bool next_seed_too = false) {
  const std::uint64_t seed = fresh_seed(rng);
  const Uniforms numbers = made.numbers(seed, calls);
  Randomness claim = made.claim;
  claim.words += ", of calls in turn";
  expect_independent_uniforms(numbers, claim);
  if (!next_seed_too) return;
  expect_independent_uniforms(side_by_side(numbers, made.numbers(seed + 1, calls)), claim);
}

/// A construction that is a function of a seed.
struct SeededConstruction {
  Randomness claim;
  /// The numbers that determine the results for these seeds; `positions` are those of one seed.
  std::function<Uniforms(const Seeds& seeds)> numbers;
  std::size_t most = 2000;  ///< seeds per call: each may seed a large generator for every digit
};

/// `measure(seeds)` returns `each` numbers in [0, 1) per seed.
template <class Measurement>
std::function<Uniforms(const Seeds&)> numbers_by(Measurement measure, std::size_t each = 1) {
  return [=](const Seeds& seeds) {
    const auto got = measure(seeds);
    return Uniforms{got.call, each, got.exactly(each * seeds.size(), unit)};
  };
}

inline Uniforms numbers_of(const SeededConstruction& made, const Seeds& seeds) {
  std::optional<Uniforms> all;
  for (auto rest = std::span(seeds); !rest.empty();) {
    const auto part = rest.first(std::min(made.most, rest.size()));
    rest = rest.subspan(part.size());
    const Uniforms some = made.numbers({part.begin(), part.end()});
    if (all) {
      append(all->values, some.values);
    } else {
      all = some;
    }
  }
  return all.value_or(Uniforms{});
}

/// The results for each of these lists of seeds are independent.
inline void expect_random_seeds(const SeededConstruction& made, const std::vector<Seeds>& lists) {
  for (const Seeds& seeds : lists) {
    expect_independent_uniforms(numbers_of(made, seeds), made.claim);
  }
}

/// For one number per seed; if digits in `base` are scrambled, that of 0. Consecutive seeds, seeds
/// that differ in one bit, and s, ~s and -s give independent numbers.
inline void expect_all_seeds(SeededConstruction made, double base, const std::string& level,
                             Rng& rng) {
  const auto expect = [&](const Seeds& seeds, const std::string& words, std::size_t positions,
                          auto name) {
    Uniforms numbers = numbers_of(made, seeds);
    numbers.positions = positions;
    numbers.name = name;
    made.claim.words = words;
    made.claim.rule = "numbers of similar seeds are independent: mix all 64 bits of the seed";
    made.claim.explain = [&, &values = numbers.values]() -> Likely {
      for (std::size_t i = 0; i + 1 < values.size(); ++i) {
        const double apart = std::remainder(base * values[i] - values[i + 1], 1.0);
        if (positions > 1 || std::abs(apart) >= 1e-9) return {};
      }
      return likely(
          "with the next seed, scrambled 0 has the same digits, shifted by one place: seed + {0} "
          "is the same for (seed, {0} + 1) and (seed + 1, {0}); hash the seed before adding the "
          "{0}",
          level);
    };
    expect_independent_uniforms(numbers, made.claim);
  };
  expect(domain::in_a_row(rng() >> 1, 6400), "neighboring seeds give independent numbers", 1,
         nullptr);
  made.claim.same = "a bit of the seed has no effect; do not truncate the seed to 32 bits"_likely;
  expect(domain::seeds_by_bit(rng, 120), "all 64 bits of the seed count", 65, [](std::size_t k) {
    return k == 0 ? std::string("the number of a seed")
                  : fmt::format("the number of the seed with bit {} flipped", k - 1);
  });
  made.claim.same = "a seed s and ~s or -s give the same numbers: mix all bits of the seed"_likely;
  expect(domain::seeds_and_opposites(rng, 300), "the seeds s, ~s and -s give independent numbers",
         3, [](std::size_t k) {
           constexpr const char* names[] = {"s", "~s", "-s"};
           return fmt::format("the number of the seed {}", names[k]);
         });
}

}  // namespace mc::checks
