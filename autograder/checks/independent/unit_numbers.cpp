// Task 2.1: a number from a word.

#include <functional>

#include <fmt/format.h>

#include "checks/independent/functions.hpp"
#include "checks/support/catch.hpp"
#include "checks/support/expect.hpp"
#include "checks/support/measure.hpp"

namespace mc::checks {
namespace {

using Word = std::uint64_t;

double as_double(Word bits) {
  return static_cast<double>(bits);
}

/// What a mistake makes of a word, and what to say then.
struct WordRule {
  std::function<double(Word)> number;
  std::string hint;
};

std::vector<WordRule> word_rules() {
  return {
      {[](Word bits) { return as_double(bits) * 0x1p-64; },
       "a word has 64 bits and a double 53: bits / 2^64 is rounded, for the largest words up to 1. "
       "Shift 11 bits out first"},
      {[](Word bits) { return as_double(bits) / 0x1.fffffffffffffp63; },
       "dividing by the largest word makes 1 a possible number"},
      {[](Word bits) { return as_double(bits >> 11) / (0x1p53 - 1); },
       "dividing by 2^53 - 1 makes 1 a possible number: divide by 2^53"},
      {[](Word bits) { return as_double(bits >> 12) * 0x1p-52; }, "these are 52 bits; 53 fit"},
      {[](Word bits) { return as_double(bits >> 32) * 0x1p-32; },
       "these are 32 bits: too few to tell 10^-10 from 0"},
      {[](Word bits) { return as_double(bits >> 40) * 0x1p-24; },
       "these are the 24 bits of a float"},
      {[](Word bits) { return as_double(bits & 0xffffffffu) * 0x1p-32; },
       "these are the lower 32 bits: is the word put into an int?"},
      {[](Word bits) { return as_double(bits & 0x1fffffffffffffu) * 0x1p-53; },
       "these are the lower 53 bits; of many generators the upper ones are the better ones"},
      {[](Word bits) { return as_double(bits >> 11) * 0x1p-52; }, "this reaches 2: times 2^-53"},
      {[](Word bits) { return (as_double(bits >> 11) + 0.5) * 0x1p-53; },
       "half a step is added: the largest words then round up to 1"},
      {[](Word) { return 0; }, "an integer divided by an integer is an integer: 0"},
  };
}

CHECK_CASE("2.1 the upper 53 bits of a word become a number", "[2.1][points:5][main]") {
  Rng rng = check_rng();
  std::vector<Word> words;
  for (int i = 0; i < 1000; ++i) words.push_back(rng() >> (rng() % 53));
  words.insert(words.end(), {0, 1, 2047, 2048, 2049, Word{1} << 63});
  const auto measured = MEASURE(to_unit, words);
  const Values& got = measured.exactly(words.size(), any_number);
  for (std::size_t i = 0; i < words.size(); ++i) {
    const double exact = as_double(words[i] >> 11) * 0x1p-53;
    if (got[i] == exact) continue;
    std::string hint = "floor(bits / 2^11) times 2^-53; both steps are exact";
    for (const WordRule& rule : word_rules()) {
      bool follows = true;
      for (std::size_t k = 0; k < words.size(); ++k) follows &= got[k] == rule.number(words[k]);
      if (follows) hint = rule.hint;
    }
    expect_that(false, fmt::format("to_unit({}) = {}", words[i], got[i]), fmt::format("{}", exact),
                "a shift, a conversion of 53 bits and a multiplication by a power of two are exact",
                hint);
  }
  pass();
}

CHECK_CASE("2.1 no word becomes one", "[2.1][points:3][edge]") {
  const Word ones = ~Word{0};
  std::vector<Word> words{0};
  for (Word below = 0; below < 4096; below += 61) words.push_back(ones - below);
  const auto measured = MEASURE(to_unit, words);
  const Values& got = measured.exactly(words.size(), any_number);
  for (std::size_t i = 0; i < words.size(); ++i) {
    const bool zero = words[i] == 0;
    expect_that(zero ? got[i] == 0 : got[i] >= 0.99 && got[i] < 1,
                fmt::format("to_unit({}) = {}", words[i], got[i]),
                zero ? "0" : "nearly 1, and never 1",
                "a table has no entry at 1, and a logarithm no value at 1 - 1",
                "(2^53 - 1) / 2^53 is the largest: is something rounded on the way?");
  }
}

}  // namespace
}  // namespace mc::checks
