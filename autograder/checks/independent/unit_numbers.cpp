// Task 2.1: a number from a word.

#include "checks/independent/functions.hpp"
#include "checks/support/catch.hpp"
#include "checks/support/domain.hpp"

namespace mc::checks {
namespace {

using Words = std::vector<std::uint64_t>;

double as_double(std::uint64_t bits) {
  return static_cast<double>(bits);
}

template <class Number>
Curve curve(const Words& words, const std::string& hint, Number number) {
  Curve all{{}, hint};
  for (const std::uint64_t word : words) all.values.push_back(number(word));
  return all;
}

void judge_words(const Words& words) {
  using Word = std::uint64_t;
  const auto got = MEASURE(to_unit, words);
  Comparison exact{curve(words, "", [](Word w) { return as_double(w >> 11) * 0x1p-53; }).values};
  exact.because =
      "a shift, a conversion of 53 bits and a multiplication by a power of two are exact; the "
      "largest is (2^53 - 1) / 2^53: a logarithm has no value at 1 - 1";
  exact.otherwise = "floor(bits / 2^11) times 2^-53; both steps are exact";
  exact.separate_calls = true;
  exact.name = [&](std::size_t i) { return fmt::format("to_unit({})", words[i]); };
  exact.suspects = {
      curve(words,
            "a word has 64 bits and a double 53: bits / 2^64 is rounded, for the largest words up "
            "to 1. Shift 11 bits out first",
            [](Word w) { return as_double(w) * 0x1p-64; }),
      curve(words, "dividing by the largest word makes 1 a possible number",
            [](Word w) { return as_double(w) / 0x1.fffffffffffffp63; }),
      curve(words, "dividing by 2^53 - 1 makes 1 a possible number: divide by 2^53",
            [](Word w) { return as_double(w >> 11) / (0x1p53 - 1); }),
      curve(words, "these are 52 bits; 53 fit",
            [](Word w) { return as_double(w >> 12) * 0x1p-52; }),
      curve(words, "these are 32 bits: too few to tell 10^-10 from 0",
            [](Word w) { return as_double(w >> 32) * 0x1p-32; }),
      curve(words, "these are the 24 bits of a float",
            [](Word w) { return as_double(w >> 40) * 0x1p-24; }),
      curve(words, "these are the lower 32 bits: is the word put into an int?",
            [](Word w) { return as_double(w & 0xffffffffu) * 0x1p-32; }),
      curve(words,
            "these are the lower 53 bits; of many generators the upper ones are the better ones",
            [](Word w) { return as_double(w & 0x1fffffffffffffu) * 0x1p-53; }),
      curve(words, "half a step is added: the largest words then round up to 1",
            [](Word w) { return (as_double(w >> 11) + 0.5) * 0x1p-53; }),
      curve(words, "an integer divided by an integer is an integer: 0", [](Word) { return 0; })};
  expect_each({got.call, got.exactly(words.size(), any_number)}, exact);
}

CHECK_CASE("2.1 the upper 53 bits of a word become a number", "[2.1][points:5][main]") {
  Rng rng = check_rng();
  Words words;
  for (int i = 0; i < 1000; ++i) words.push_back(rng() >> (rng() % 53));
  judge_words(words);
}

CHECK_CASE("2.1 words at both ends and powers of two", "[2.1][points:3][edge]") {
  Rng rng = check_rng();
  Words words = domain::words(~std::uint64_t{0}, rng);
  for (std::uint64_t below = 0; below < 4096; below += 61) words.push_back(~below);
  judge_words(words);
}

}  // namespace
}  // namespace mc::checks
