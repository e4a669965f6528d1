// What lab 5 checks. The points of this lab are not random, so most of it is exact: radical
// inverses digit by digit in 106 bits, Sobol' words bit by bit, discrepancies from fractions, boxes
// by counting. Indices, bases, seeds and sets are fresh in each run.
//
// What is random about the randomised forms is tested against distributions that are exact too: the
// variance of a scrambled net is Owen's (1997, "Monte Carlo variance of scrambled net quadrature",
// theorem 2), with the gain of every pair of scales counted over the pairs of the net's points.
//
// Every random test has the same alpha; there are fewer than thirty of them.

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <numeric>

#include <fmt/format.h>

#include "5-halton/experiments.hpp"
#include "checks/support/catch.hpp"
#include "checks/support/data.hpp"
#include "checks/support/exact.hpp"
#include "checks/support/expect.hpp"
#include "checks/support/measure.hpp"
#include "checks/support/sobol_exact.hpp"
#include "checks/support/statistics.hpp"

namespace mc::checks {
namespace {

using Values = std::vector<double>;
using View = std::span<const double>;
using Indices = std::vector<std::uint64_t>;

constexpr double alpha = 1e-8;
constexpr double ulp = 0x1p-53;  // half a unit in the last place of 1
constexpr double tolerance = 4 * ulp;
constexpr std::uint64_t last_index = std::numeric_limits<std::uint64_t>::max();

std::uint64_t below(Rng& rng, std::uint64_t bound) {
  return rng() % bound;
}

Indices fresh_seeds(Rng& rng, std::size_t count) {
  Indices seeds(count);
  for (auto& seed : seeds) seed = rng();
  return seeds;
}

View part(const Values& all, std::size_t number, std::size_t size) {
  return std::span(all).subspan(number * size, size);
}

void expect_size(const std::string& call, std::size_t got, std::size_t expected) {
  expect_that(got == expected, fmt::format("{}: {} values", call, got), fmt::format("{}", expected),
              "", "");
}

void expect_inside(const std::string& call, View x) {
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (x[i] >= 0 && x[i] < 1) continue;
    expect_that(false, fmt::format("{}: value {} is {:.17g}", call, i, x[i]), "values in [0, 1)",
                "points lie in the unit cube, which does not contain its upper faces",
                x[i] == 1 ? "it was rounded up to 1: the largest double below 1 is nearer than the "
                            "tolerance"
                          : "");
  }
  pass();
}

// Radical inverses
// --------------------------------------------------------------------------------------------

/// The radical inverse, right to 100 bits: from the first digit of the index to the last.
Exact exact_inverse(unsigned base, std::uint64_t index) {
  std::vector<unsigned> digits;
  for (; index > 0; index /= base) digits.push_back(static_cast<unsigned>(index % base));
  Exact value;
  for (auto digit = digits.rbegin(); digit != digits.rend(); ++digit) {
    value = (value + Exact(*digit)) / Exact(base);
  }
  return value;
}

double inverse(unsigned base, std::uint64_t index) {
  return static_cast<double>(exact_inverse(base, index));
}

/// The digits of `index` not mirrored: 6 = 110 in base 2 as .110.
double unmirrored(unsigned base, std::uint64_t index) {
  double size = 1;
  for (std::uint64_t rest = index; rest > 0; rest /= base) size *= base;
  return static_cast<double>(index) / size;
}

/// Mirrored digits in 32 bits, as a careless program has them.
double inverse_in_32_bits(unsigned base, std::uint64_t index) {
  std::uint32_t mirrored = 0;
  double size = 1;
  for (std::uint64_t rest = index; rest > 0; rest /= base, size *= base) {
    mirrored = mirrored * base + static_cast<std::uint32_t>(rest % base);
  }
  return mirrored / size;
}

std::string inverse_hint(double got, unsigned base, std::uint64_t index,
                         const std::string& otherwise) {
  const std::pair<double, const char*> suspects[] = {
      {unmirrored(base, index),
       "the digits are not mirrored: the last digit of the index comes "
       "first behind the point"},
      {inverse(base, index + 1), "this belongs to the next index: indices count from 0"},
      {inverse(base, index - 1), "this belongs to the index before"},
      {inverse(base, index & 0xffffffffu), "the index has 64 bits, of which 32 were kept"},
      {inverse_in_32_bits(base, index),
       "the mirrored digits do not fit in 32 bits: 64 are not "
       "enough for every index either"}};
  for (const auto& [value, hint] : suspects) {
    const bool tells = std::abs(value - inverse(base, index)) > 1e-14;
    if (tells && std::abs(got - value) <= 1e-14) return hint;
  }
  if (got >= 1) return "it was rounded up to 1: hold it below";
  const double error = std::abs(got - inverse(base, index));
  if (error < 1e-5 && error > 1e-9) return "these are the seven digits of a float";
  return otherwise;
}

const std::string because_inverse =
    "the exact fraction, digit by digit; adding the smallest terms first keeps the error to "
    "2 * 2^-53, 4 * 2^-53 are allowed";

void expect_inverse(const std::string& call, double got, unsigned base, std::uint64_t index,
                    double allowed = tolerance, const std::string& otherwise = "") {
  const Exact exact = exact_inverse(base, index);
  if (std::abs(static_cast<double>(Exact(got) - exact)) <= allowed && got < 1 && got >= 0) {
    return pass();
  }
  expect_that(false, fmt::format("{}: {:.17g} for index {} in base {}", call, got, index, base),
              fmt::format("{:.17g}, within {} * 2^-53, and below 1", static_cast<double>(exact),
                          allowed / ulp),
              because_inverse, inverse_hint(got, base, index, otherwise));
}

void expect_column(const std::string& call, View got, unsigned base, std::uint64_t first,
                   const std::string& otherwise) {
  for (std::size_t i = 0; i < got.size(); ++i) {
    expect_inverse(fmt::format("{}, value {}", call, i), got[i], base, first + i, tolerance,
                   otherwise);
  }
}

// 5.1
// ----------------------------------------------------------------------------------------------

TEST_CASE("5.1 the radical inverse mirrors the digits of the index", "[5.1][points:5]") {
  Rng rng = check_rng();
  // Wider than promised: a bound on 15 digits added up in any order, half an ulp each and more.
  // What the order is worth has a check of its own.
  constexpr double room = 15 * ulp;
  // The lecture's: 74 is 1001010 in base 2, so .0101001 = 41/128.
  const auto binary = MEASURE(radical_inverse, 2, {74});
  expect_size(binary.call, binary.value.size(), 1);
  expect_within(binary.call, binary.value[0], 41. / 128, 0, "74 = 1001010, so .0101001 = 41/128",
                {{{74. / 128, "the digits are not mirrored: the last one comes first"}},
                 "take the digits off the end of the index and put them behind the point"});
  for (const unsigned base : {2u, 3u, 5u, 7u, 10u, 29u}) {
    Indices indices(40);
    std::iota(indices.begin(), indices.end(), std::uint64_t{0});
    for (int i = 0; i < 40; ++i) indices.push_back(below(rng, base * base * base));
    const auto got = MEASURE(radical_inverse, base, indices);
    expect_size(got.call, got.value.size(), indices.size());
    for (std::size_t i = 0; i < indices.size(); ++i) {
      expect_inverse(got.call, got.value[i], base, indices[i], room,
                     "the digit at position k, from 0, counts base^-(k+1)");
    }
  }
}

TEST_CASE("5.1 every index of 64 bits in every base", "[5.1][points:4]") {
  Rng rng = check_rng();
  constexpr double room = 64 * ulp;  // 64 digits in any order
  const std::string otherwise = "an index has up to 64 digits: does some power overflow?";
  std::map<unsigned, Indices> asked{{7919, {}}, {1u << 16, {}}, {4294967295u, {}}};
  // The first indices whose mirrored digits do not fit in 32 bits.
  const std::pair<unsigned, std::uint64_t> overflowing[] = {
      {3, 3486784403}, {5, 1220703129}, {7, 1977326746},  {11, 2357947693}, {13, 815730727},
      {17, 410338684}, {19, 893871744}, {23, 3404825449}, {29, 594823329},  {31, 887503686}};
  for (const auto& [base, index] : overflowing) asked[base].push_back(index);
  for (int i = 0; i < 10; ++i) asked[2 + static_cast<unsigned>(below(rng, 4294967294u))];
  asked[2];
  for (auto& [base, indices] : asked) {
    for (const std::uint64_t index : {std::uint64_t{1} << 63, last_index, std::uint64_t{1} << 32}) {
      indices.push_back(index);
      indices.push_back(index - below(rng, 1000));
    }
    for (int i = 0; i < 20; ++i) indices.push_back(rng() >> below(rng, 32));
    const auto got = MEASURE(radical_inverse, base, indices);
    expect_size(got.call, got.value.size(), indices.size());
    for (std::size_t i = 0; i < indices.size(); ++i) {
      const double value = got.value[i];
      // That it stays below 1 has a check of its own.
      expect_inverse(got.call, value == 1 ? 1 - ulp : value, base, indices[i], room, otherwise);
    }
  }
}

/// Indices whose digits, added as they come off the index, the large ones first, are wrong by more
/// than `tolerance`: of 200,000 random ones, 136 in base 3, 464 in base 5, 724 in 6 and 1,124 in 7.
/// (In bases 29 and 31 none was: an index has few digits there.)
Indices hard_indices(Rng& rng, unsigned base, std::size_t count) {
  Indices hard;
  while (hard.size() < count) {
    const std::uint64_t index = rng();
    double sum = 0, part = 1;
    for (std::uint64_t rest = index; rest > 0; rest /= base) {
      part /= base;
      sum += part * static_cast<double>(rest % base);
    }
    const auto error = static_cast<double>(Exact(sum) - exact_inverse(base, index));
    if (std::abs(error) > tolerance) hard.push_back(index);
  }
  return hard;
}

TEST_CASE("5.1 the last digit is added last", "[5.1][points:2]") {
  Rng rng = check_rng();
  std::map<unsigned, Indices> asked{{3, {2419277}}};  // the handout's, the first in base 3
  for (const unsigned base : {3u, 5u, 6u, 7u}) {
    const auto hard = hard_indices(rng, base, 5);
    asked[base].insert(asked[base].end(), hard.begin(), hard.end());
  }
  for (const unsigned base : {3u, 5u, 29u}) {
    for (int i = 0; i < 100; ++i) asked[base].push_back(rng());
  }
  for (const auto& [base, indices] : asked) {
    const auto got = MEASURE(radical_inverse, base, indices);
    expect_size(got.call, got.value.size(), indices.size());
    for (std::size_t i = 0; i < indices.size(); ++i) {
      const double value = got.value[i];
      expect_inverse(got.call, value == 1 ? 1 - ulp : value, base, indices[i], tolerance,
                     "each sum is rounded: add the smallest terms first, or the digits as a whole "
                     "number with one division at the end");
    }
  }
}

TEST_CASE("5.1 the radical inverse is below 1", "[5.1][points:2]") {
  for (const unsigned base : {2u, 3u, 5u, 7u, 11u, 13u, 29u, 31u, 7919u}) {
    Indices ones;  // base^k - 1: every digit the largest
    for (std::uint64_t index = base - 1;; index = index * base + (base - 1)) {
      ones.push_back(index);
      if (index > (last_index - (base - 1)) / base) break;
    }
    ones.push_back(last_index);
    const auto got = MEASURE(radical_inverse, base, ones);
    expect_size(got.call, got.value.size(), ones.size());
    expect_inside(got.call, got.value);
  }
}

TEST_CASE("5.1 a base below 2 is refused", "[5.1][points:1]") {
  const auto fine = MEASURE(radical_inverse, 2, {1});
  expect_size(fine.call, fine.value.size(), 1);
  expect_within(fine.call, fine.value[0], 0.5, 0, "1 in base 2 is .1 mirrored", {{}, ""});
  for (const unsigned base : {0u, 1u}) {
    expect_invalid_argument(MEASURE_OUTCOME(radical_inverse, base, {5}), "base",
                            "there are no digits below base 2");
  }
}

// 5.2
// ----------------------------------------------------------------------------------------------

TEST_CASE("5.2 a column has the radical inverses of 0 1 2 and so on",
          "[5.2][points:5][needs:5.1]") {
  Rng rng = check_rng();
  for (const unsigned base : {2u, 3u, 5u, 29u, 31u, 131u, 7919u, 4294967295u}) {
    for (const std::uint64_t count :
         {std::uint64_t{1}, std::uint64_t{7}, 1 + below(rng, 300), std::uint64_t{4096}}) {
      const auto got = MEASURE(radical_inverses, base, 0, count);
      expect_size(got.call, got.value.size(), count);
      expect_column(got.call, got.value, base, 0, "5.1 says what every value must be");
    }
  }
  const auto none = MEASURE(radical_inverses, 2, 5, 0);
  expect_size(none.call, none.value.size(), 0);
}

TEST_CASE("5.2 a column may begin anywhere", "[5.2][points:4][needs:5.1]") {
  Rng rng = check_rng();
  const std::string otherwise =
      "the block that `first` lies in is not begun at its beginning: mind both ends";
  for (const unsigned base : {2u, 3u, 7u, 31u, 7919u}) {
    Indices firsts{1 + below(rng, 5000), (std::uint64_t{1} << 32) - 1 - below(rng, 100),
                   (std::uint64_t{1} << 63) - 1 - below(rng, 100), rng() >> 1,
                   last_index - 599};  // the last index of all is the last value
    std::uint64_t power = base;
    while (power < 1000000000) power *= base;
    firsts.push_back(power - 1 - below(rng, 300));  // nine digits or more change at once
    for (const std::uint64_t first : firsts) {
      const std::uint64_t count = first == last_index - 599 ? 600 : 300 + below(rng, 1500);
      const auto got = MEASURE(radical_inverses, base, first, count);
      expect_size(got.call, got.value.size(), count);
      Values values = got.value;  // that they stay below 1 has a check of its own
      for (double& value : values) value = value == 1 ? 1 - ulp : value;
      expect_column(got.call, values, base, first, otherwise);
    }
  }
}

TEST_CASE("5.2 every value of a column is below 1", "[5.2][points:2][needs:5.1]") {
  for (const unsigned base : {2u, 5u, 11u, 29u, 31u}) {
    std::uint64_t power = 1;
    for (int digit = 0; power <= last_index / base; ++digit) {
      power *= base;
      if (std::log2(power) < 50) continue;
      const auto got = MEASURE(radical_inverses, base, power - 1050, 1050);
      expect_inside(got.call, got.value);
    }
  }
  const auto last = MEASURE(radical_inverses, 2, last_index - 2047, 2048);
  expect_inside(last.call, last.value);
}

TEST_CASE("5.2 a column past the last index is refused", "[5.2][points:1]") {
  const auto fine = MEASURE(radical_inverses, 2, last_index - 1, 2);
  expect_size(fine.call, fine.value.size(), 2);
  expect_column(fine.call, fine.value, 2, last_index - 1, "the last index of all is 2^64 - 1");
  for (const unsigned base : {0u, 1u}) {
    expect_invalid_argument(MEASURE_OUTCOME(radical_inverses, base, 0, 10), "base",
                            "there are no digits below base 2");
  }
  expect_invalid_argument(MEASURE_OUTCOME(radical_inverses, 3, last_index - 1, 3), "first",
                          "the third index would be 2^64");
}

// 5.3
// ----------------------------------------------------------------------------------------------

std::vector<unsigned> sieved_primes(unsigned limit) {
  std::vector<bool> composite(limit);
  std::vector<unsigned> found;
  for (unsigned n = 2; n < limit; ++n) {
    if (composite[n]) continue;
    found.push_back(n);
    for (unsigned multiple = 2 * n; multiple < limit; multiple += n) composite[multiple] = true;
  }
  return found;
}

/// What the first n points of a sequence make of four integrals over the unit square.
struct Estimates {
  std::size_t n;
  double bilinear, gauss, disk, exponential;
};

/// The estimates themselves are known, with their errors: averages over the exact fractions, in 30
/// digits; xy and the disk as fractions, for example 13/64 of 16 Halton points.
void expect_estimates(const std::string& call, const Values& got, const Estimates& known,
                      const std::string& otherwise) {
  struct Integrand {
    const char* name;
    double (*f)(double, double);
    double Estimates::*estimate;
  };
  static constexpr Integrand integrands[] = {
      {"xy", [](double x, double y) { return x * y; }, &Estimates::bilinear},
      {"exp(-x^2 - y^2)", [](double x, double y) { return std::exp(-x * x - y * y); },
       &Estimates::gauss},
      {"1 inside the circle of radius 0.4 about the centre",
       [](double x, double y) {
         return (x - 0.5) * (x - 0.5) + (y - 0.5) * (y - 0.5) < 0.16 ? 1. : 0.;
       },
       &Estimates::disk},
      {"exp(x + y)", [](double x, double y) { return std::exp(x + y); }, &Estimates::exponential}};
  expect_size(call, got.size(), 2 * known.n);
  for (const auto& [name, f, estimate] : integrands) {
    Exact sum;
    for (std::size_t i = 0; i < known.n; ++i) sum = sum + Exact(f(got[i], got[known.n + i]));
    const auto mean = static_cast<double>(sum / Exact(static_cast<double>(known.n)));
    expect_within(
        fmt::format("{}, average of {}", call, name), mean, known.*estimate, 1e-14,
        "the average over the exact points; coordinates within 4 * 2^-53 move it by 2 e^2 "
        "times that at most, and no point is that near to the circle",
        {{}, otherwise});
  }
}

TEST_CASE("5.3 the first primes", "[5.3][points:2]") {
  Rng rng = check_rng();
  const auto exact = sieved_primes(20000);
  for (const std::uint64_t count : {std::uint64_t{1}, std::uint64_t{10}, below(rng, 2000)}) {
    const auto got = MEASURE(primes, count);
    expect_size(got.call, got.value.size(), count);
    for (std::size_t i = 0; i < count; ++i) {
      expect_that(got.value[i] == exact[i], fmt::format("{}[{}] = {}", got.call, i, got.value[i]),
                  fmt::format("{}", exact[i]), "the primes in order: 2, 3, 5, 7, 11, …",
                  got.value[i] == 1 ? "1 is no prime" : "a prime has no divisor but 1 and itself");
    }
  }
}

/// The columns of Halton points, or of some radical inverses that stand for them.
void expect_axes(const std::string& call, const Values& got, std::span<const unsigned> bases,
                 std::size_t n, std::uint64_t first) {
  for (std::size_t d = 0; d < bases.size(); ++d) {
    const View column = part(got, d, n);
    const auto is_in = [&](unsigned base, std::uint64_t from) {
      for (std::size_t i = 0; i < n; ++i) {
        if (std::abs(column[i] - inverse(base, from + i)) > 1e-12) return false;
      }
      return true;
    };
    std::string hint = fmt::format("axis {} is the radical inverse in base {}", d, bases[d]);
    if (!is_in(bases[d], first)) {
      for (unsigned base = 2; base < 60; ++base) {
        if (base != bases[d] && is_in(base, first)) {
          hint = fmt::format("this axis is in base {}: one prime an axis, in order", base);
        }
      }
      if (is_in(bases[d], first + 1)) hint = "this begins one index too late: count from `first`";
      if (first > 0 && is_in(bases[d], 0)) hint = "this begins at index 0, not at `first`";
    }
    for (std::size_t i = 0; i < n; ++i) {
      const double exact = inverse(bases[d], first + i);
      if (std::abs(column[i] - exact) <= tolerance && column[i] < 1) continue;
      expect_that(false,
                  fmt::format("{}: coordinate {} of point {} is {:.17g}", call, d, i, column[i]),
                  fmt::format("{:.17g}", exact),
                  fmt::format("the radical inverse of {} in base {}", first + i, bases[d]), hint);
    }
    pass();
  }
}

TEST_CASE("5.3 Halton points have one prime an axis", "[5.3][points:3][needs:5.2]") {
  Rng rng = check_rng();
  const auto primes = sieved_primes(100);
  for (const std::uint64_t dims : {1u, 2u, 3u, 12u}) {
    for (const std::uint64_t first : {std::uint64_t{0}, 1 + below(rng, 1000), rng() >> 8}) {
      const std::uint64_t n = 30 + below(rng, 300);
      const auto got = MEASURE(halton, n, dims, first);
      expect_size(got.call, got.value.size(), n * dims);
      expect_axes(got.call, got.value, std::span(primes).first(dims), n, first);
    }
  }
  expect_invalid_argument(MEASURE_OUTCOME(halton, 3, 2, last_index - 1), "first",
                          "the third index would be 2^64");
}

/// In which of `cells` equal parts x lies, where x is within 1e-12 of a whole multiple of 1/grid,
/// cells a divisor of grid: by rounding to that multiple, since x itself may be rounded below it.
std::size_t cell_of(double x, std::size_t grid, std::size_t cells) {
  const auto multiple = static_cast<std::size_t>(std::llround(x * static_cast<double>(grid)));
  return multiple / (grid / cells);
}

TEST_CASE("5.3 every box of Halton points gets its share", "[5.3][points:2][needs:5.2]") {
  Rng rng = check_rng();
  // Of 2^4 3^3 consecutive points, one lies in each of the 16 x 27 boxes. To a whole multiple of
  // 2^-30 the first coordinate is exact; the second is rounded to multiples of 3^-19.
  const std::size_t nx = 16, ny = 27, n = nx * ny;
  const std::uint64_t first = n * below(rng, 1000);
  const auto got = MEASURE(halton, n, 2, first);
  expect_size(got.call, got.value.size(), 2 * n);
  expect_inside(got.call, got.value);
  const std::size_t grid_x = std::size_t{1} << 30, grid_y = 1162261467;  // 3^19
  std::vector<int> points(n);
  for (std::size_t i = 0; i < n; ++i) {
    ++points[cell_of(got.value[i], grid_x, nx) * ny + cell_of(got.value[n + i], grid_y, ny)];
  }
  for (std::size_t cell = 0; cell < n; ++cell) {
    expect_that(points[cell] == 1,
                fmt::format("{}: {} points in box ({}, {}) of 16 x 27", got.call, points[cell],
                            cell / ny, cell % ny),
                "one point",
                "432 consecutive indices go through all last four binary digits and "
                "all last three ternary ones, in every combination",
                "bases 2 and 3, from `first` on");
  }
}

TEST_CASE("5.3 integrals by Halton points", "[5.3][points:1][needs:5.2]") {
  const Estimates known[] = {
      {16, 13. / 64, 0.60910969847097418, 5. / 8, 2.648121968809563},
      {256, 244367. / 995328, 0.56165686217700495, 129. / 256, 2.9264176047586425},
      {4096, 1144897861. / 4586471424, 0.55805132661770473, 513. / 1024, 2.9503483693180392}};
  for (const auto& each : known) {
    const auto got = MEASURE(halton, each.n, 2, 0);
    expect_estimates(got.call, got.value, each, "bases 2 and 3, from index 0 on");
  }
}

// 5.4
// ----------------------------------------------------------------------------------------------

TEST_CASE("5.4 Hammersley points", "[5.4][points:5][needs:5.2]") {
  Rng rng = check_rng();
  const auto primes = sieved_primes(100);
  for (const std::uint64_t dims : {1u, 2u, 3u, 9u}) {
    for (const std::uint64_t n : {std::uint64_t{1}, std::uint64_t{256}, 2 + below(rng, 1000)}) {
      const auto got = MEASURE(hammersley, n, dims);
      expect_size(got.call, got.value.size(), n * dims);
      const auto size = static_cast<double>(n);
      for (std::size_t i = 0; i < n; ++i) {
        const auto index = static_cast<double>(i);
        expect_within(fmt::format("{}: coordinate 0 of point {}", got.call, i), got.value[i],
                      index / size, 2 * ulp, "coordinate 0 is i / N",
                      {{{(index + 1) / size, "points count from 0: i / N, not (i + 1) / N"},
                        {(index + 0.5) / size, "this is the centred variant: i / N"},
                        {inverse(2, i), "this is Halton's first axis: Hammersley's is i / N"}},
                       "i / N in double division"});
      }
      expect_axes(got.call,
                  Values(got.value.begin() + static_cast<std::ptrdiff_t>(n), got.value.end()),
                  std::span(primes).first(dims - 1), n, 0);
    }
  }
}

TEST_CASE("5.4 integrals by Hammersley points", "[5.4][points:1][needs:5.2]") {
  const Estimates known[] = {
      {16, 257. / 1024, 0.59996611391993993, 1. / 2, 2.8591728486142411},
      {256, 66049. / 262144, 0.56120375868220918, 65. / 128, 2.9524073863838791},
      {4096, 16793601. / 67108864, 0.5580113546545965, 1035. / 2048, 2.9528479361167372}};
  for (const auto& each : known) {
    const auto got = MEASURE(hammersley, each.n, 2);
    expect_estimates(got.call, got.value, each, "i / N and base 2");
  }
}

// 5.5
// ----------------------------------------------------------------------------------------------

double sobol_value(std::span<const std::uint32_t> v, std::uint64_t index) {
  return sobol_word(v, index) * 0x1p-32;
}

Values sobol_points(unsigned dimension, std::uint64_t first, std::size_t count) {
  const auto v = sobol_directions(dimension);
  Values x(count);
  for (std::size_t i = 0; i < count; ++i) x[i] = sobol_value(v, first + i);
  return x;
}

void expect_sobol(const std::string& call, View got, unsigned dimension, std::uint64_t first,
                  const std::string& otherwise) {
  const auto v = sobol_directions(dimension);
  const auto is = [&](auto value_of) {
    std::size_t same = 0;
    for (std::size_t i = 0; i < got.size(); ++i) same += got[i] == value_of(first + i) ? 1u : 0u;
    return same == got.size();
  };
  for (std::size_t i = 0; i < got.size(); ++i) {
    const double exact = sobol_value(v, first + i);
    if (got[i] == exact) continue;
    std::string hint = otherwise;
    const auto shifted = [&](int by) {
      std::array<std::uint32_t, 32> w{};
      for (int k = 0; k < 32; ++k) w[k] = v[std::clamp(k + by, 0, 31)];
      return w;
    };
    const auto later = shifted(1), earlier = shifted(-1);
    if (is([&](std::uint64_t n) { return sobol_value(v, n ^ n >> 1); })) {
      hint = "these are the points in Gray-code order: the same set, another sequence";
    } else if (is([&](std::uint64_t n) { return sobol_value(v, n + 1); })) {
      hint = "this begins one index too late: point 0 is the origin";
    } else if (is([&](std::uint64_t n) { return sobol_value(later, n & 0x7fffffff); }) ||
               is([&](std::uint64_t n) { return sobol_value(earlier, n & ~std::uint64_t{1}); })) {
      hint = "bit k of the index, from 0, chooses m_(k+1) 2^-(k+1)";
    }
    for (unsigned other = 0; other < joe_kuo.size(); ++other) {
      const auto w = sobol_directions(other);
      if (other != dimension && is([&](std::uint64_t n) { return sobol_value(w, n); })) {
        hint = fmt::format("this is dimension {}: they count from 0", other);
      }
    }
    expect_that(
        false, fmt::format("{}: value {} is {:.17g}", call, i, got[i]),
        fmt::format("{:.17g}, exactly", exact),
        fmt::format("the exclusive or of the direction numbers of the bits of {}", first + i),
        hint);
  }
  pass();
}

TEST_CASE("5.5 the first points of all 32 dimensions", "[5.5][points:4]") {
  for (unsigned d = 0; d < joe_kuo.size(); ++d) {
    const auto got = MEASURE(sobol, d, 0, 600);
    expect_size(got.call, got.value.size(), 600);
    expect_sobol(got.call, got.value, d, 0,
                 "m_k = 2 a_1 m_(k-1) ^ 4 a_2 m_(k-2) ^ … ^ 2^s m_(k-s) ^ m_(k-s), a_1 the highest "
                 "bit of `coefficients`");
  }
}

TEST_CASE("5.5 a column of Sobol' points may begin anywhere", "[5.5][points:4]") {
  Rng rng = check_rng();
  const std::uint64_t end = std::uint64_t{1} << 32;
  for (int i = 0; i < 12; ++i) {
    const auto dimension = static_cast<unsigned>(below(rng, joe_kuo.size()));
    const std::uint64_t count = 300 + below(rng, 3000);
    const std::uint64_t first = i == 0   ? end - count
                                : i == 1 ? end / 2 - below(rng, count)
                                : i < 7  ? below(rng, 5000)
                                         : below(rng, end - count);
    const auto got = MEASURE(sobol, dimension, first, count);
    expect_size(got.call, got.value.size(), count);
    expect_sobol(got.call, got.value, dimension, first,
                 "right from 0 on, and not from here? Mind where blocks begin and end");
  }
  const auto none = MEASURE(sobol, 3, 7, 0);
  expect_size(none.call, none.value.size(), 0);
}

TEST_CASE("5.5 the first two dimensions are a net", "[5.5][points:3]") {
  Rng rng = check_rng();
  constexpr unsigned m = 8;
  constexpr std::uint64_t n = 1u << m;
  const std::uint64_t first = n * below(rng, (std::uint64_t{1} << 32) / n);
  const auto x = MEASURE(sobol, 0, first, n), y = MEASURE(sobol, 1, first, n);
  expect_size(x.call, x.value.size(), n);
  expect_size(y.call, y.value.size(), n);
  expect_inside(x.call, x.value);
  expect_inside(y.call, y.value);
  for (unsigned k = 0; k <= m; ++k) {  // boxes of 2^-k by 2^-(m-k); powers of two multiply exactly
    const double nx = std::ldexp(1, static_cast<int>(k)), ny = n / nx;
    std::vector<int> points(n);
    for (std::size_t i = 0; i < n; ++i) {
      ++points[static_cast<std::size_t>(x.value[i] * nx) * static_cast<std::size_t>(ny) +
               static_cast<std::size_t>(y.value[i] * ny)];
    }
    const auto odd =
        std::find_if(points.begin(), points.end(), [](int count) { return count != 1; });
    expect_that(odd == points.end(),
                fmt::format("{} and dimension 1: {} points in one of {} x {} boxes", x.call,
                            odd == points.end() ? 1 : *odd, nx, ny),
                "one point in each", "dimensions 0 and 1 are a (0,m,2)-net in base 2",
                "dimension 0 is the van der Corput sequence; dimension 1 has m_k = 1, 3, 5, 15, …");
  }
}

TEST_CASE("5.5 Sobol' points that do not exist are refused", "[5.5][points:2]") {
  const std::uint64_t end = std::uint64_t{1} << 32;
  const auto fine = MEASURE(sobol, 31, end - 2, 2);
  expect_size(fine.call, fine.value.size(), 2);
  expect_sobol(fine.call, fine.value, 31, end - 2, "the last point has the index 2^32 - 1");
  for (const unsigned dimension : {32u, 4294967295u}) {
    expect_invalid_argument(MEASURE_OUTCOME(sobol, dimension, 0, 4), "dimension",
                            "the table has 32 dimensions, from 0 to 31");
  }
  expect_invalid_argument(MEASURE_OUTCOME(sobol, 0, end - 2, 3), "first",
                          "the third index would be 2^32");
  expect_invalid_argument(MEASURE_OUTCOME(sobol, 0, last_index, 2), "first",
                          "no index has more than 32 bits");
}

TEST_CASE("5.5 integrals by Sobol' points", "[5.5][points:1]") {
  const Estimates known[] = {
      {16, 113. / 512, 0.58792582336016108, 3. / 4, 2.7746497629458409},
      {256, 32513. / 131072, 0.55959439866573157, 131. / 256, 2.9410041658562869},
      {4096, 8384641. / 33554432, 0.55786294647667745, 2057. / 4096, 2.95178215259374}};
  for (const auto& each : known) {
    const auto x = MEASURE(sobol, 0, 0, each.n), y = MEASURE(sobol, 1, 0, each.n);
    expect_size(x.call, x.value.size(), each.n);
    Values points = x.value;
    points.insert(points.end(), y.value.begin(), y.value.end());
    expect_estimates(x.call + " and dimension 1", points, each,
                     "dimensions 0 and 1, from the origin on");
  }
}

// 5.6
// ----------------------------------------------------------------------------------------------

/// The definition: every box that ends on coordinates of points or on 1, open and closed.
double exact_discrepancy(View x, View y, bool open = true, bool closed = true) {
  const auto n = static_cast<double>(x.size());
  Values xs(x.begin(), x.end()), ys(y.begin(), y.end());
  xs.push_back(1);
  ys.push_back(1);
  double worst = 0;
  for (const double a : xs) {
    for (const double b : ys) {
      double inside = 0, at_most = 0;
      for (std::size_t i = 0; i < x.size(); ++i) {
        inside += x[i] < a && y[i] < b ? 1 : 0;
        at_most += x[i] <= a && y[i] <= b ? 1 : 0;
      }
      if (open) worst = std::max(worst, a * b - inside / n);
      if (closed) worst = std::max(worst, at_most / n - a * b);
    }
  }
  return worst;
}

/// The same on the line.
double exact_discrepancy(View x, bool open = true, bool closed = true) {
  const auto n = static_cast<double>(x.size());
  Values ends(x.begin(), x.end());
  ends.push_back(1);
  double worst = 0;
  for (const double a : ends) {
    const auto inside = std::count_if(x.begin(), x.end(), [&](double value) { return value < a; });
    const auto at_most =
        std::count_if(x.begin(), x.end(), [&](double value) { return value <= a; });
    if (open) worst = std::max(worst, a - static_cast<double>(inside) / n);
    if (closed) worst = std::max(worst, static_cast<double>(at_most) / n - a);
  }
  return worst;
}

constexpr double discrepancy_tolerance = 1e-14;
const std::string because_discrepancy =
    "the largest of |volume - part of the points inside| over all boxes; rounding costs a few eps";

Hints discrepancy_hints(double open, double closed) {
  const std::string corners =
      "the box may end at a point or at 1, just before it or just behind it";
  return {{{open, "only open boxes were looked at: those that end just behind a point count too"},
           {closed,
            "only closed boxes were looked at: those that end just before a point count "
            "too"}},
          corners};
}

void expect_discrepancy(const Values& x) {
  const auto got = MEASURE(star_discrepancy_1d, x);
  expect_within(
      got.call, got.value, exact_discrepancy(x), discrepancy_tolerance, because_discrepancy,
      discrepancy_hints(exact_discrepancy(x, true, false), exact_discrepancy(x, false, true)));
}

void expect_discrepancy(const Values& x, const Values& y) {
  const auto got = MEASURE(star_discrepancy_2d, x, y);
  expect_within(got.call, got.value, exact_discrepancy(x, y), discrepancy_tolerance,
                because_discrepancy,
                discrepancy_hints(exact_discrepancy(x, y, true, false),
                                  exact_discrepancy(x, y, false, true)));
}

Values inverses(unsigned base, std::uint64_t first, std::size_t n) {
  Values x(n);
  for (std::size_t i = 0; i < n; ++i) x[i] = inverse(base, first + i);
  return x;
}

TEST_CASE("5.6 the star discrepancy of points of the line", "[5.6][points:4]") {
  Rng rng = check_rng();
  struct Known {
    std::size_t n;
    double base_2, base_3;
  };
  // Exact fractions of van der Corput's sequence.
  const Known known[] = {{1, 1, 1},
                         {3, 1. / 2, 1. / 3},
                         {10, 7. / 40, 17. / 90},
                         {64, 1. / 64, 221. / 5184},
                         {100, 37. / 1600, 239. / 8100},
                         {1000, 157. / 64000, 1267. / 364500}};
  const Hints hints{{}, "the worst interval ends at a point: just before it or just behind it"};
  for (const auto& [n, base_2, base_3] : known) {
    for (const unsigned base : {2u, 3u}) {
      Values x = inverses(base, 0, n);
      std::shuffle(x.begin(), x.end(), rng);
      const auto got = MEASURE(star_discrepancy_1d, x);
      expect_within(
          got.call, got.value, base == 2 ? base_2 : base_3, discrepancy_tolerance,
          fmt::format("the first {} of van der Corput's points in base {}", n, base),
          discrepancy_hints(exact_discrepancy(x, true, false), exact_discrepancy(x, false, true)));
    }
    Values centred(n);
    for (std::size_t i = 0; i < n; ++i) {
      centred[i] = (static_cast<double>(i) + 0.5) / static_cast<double>(n);
    }
    const auto got = MEASURE(star_discrepancy_1d, centred);
    expect_within(got.call, got.value, 0.5 / static_cast<double>(n), discrepancy_tolerance,
                  "no N points do better than 1/(2N), and the centres of N strata do it", hints);
  }
  for (const std::size_t n : {1u, 2u, 7u, 60u}) expect_discrepancy(uniform_values(rng, n, 0, 1));
}

TEST_CASE("5.6 the star discrepancy of points of the plane", "[5.6][points:4]") {
  Rng rng = check_rng();
  struct Known {
    const char* name;
    Values x, y;
    double exact;
  };
  const auto strata = [](std::size_t n) {
    Values x(n);
    for (std::size_t i = 0; i < n; ++i) x[i] = static_cast<double>(i) / static_cast<double>(n);
    return x;
  };
  const Known known[] = {
      {"Halton from 0", inverses(2, 0, 16), inverses(3, 0, 16), 29. / 144},
      {"Halton from 1", inverses(2, 1, 16), inverses(3, 1, 16), 25. / 144},
      {"Halton from 0", inverses(2, 0, 64), inverses(3, 0, 64), 5. / 96},
      {"Halton from 0", inverses(2, 0, 216), inverses(3, 0, 216), 3. / 128},
      {"Hammersley", strata(4), inverses(2, 0, 4), 1. / 2},
      {"Hammersley", strata(16), inverses(2, 0, 16), 11. / 64},
      {"Hammersley", strata(64), inverses(2, 0, 64), 55. / 1024},
      {"Hammersley", strata(256), inverses(2, 0, 256), 263. / 16384},
      {"Sobol'", sobol_points(0, 0, 256), sobol_points(1, 0, 256), 239. / 16384}};
  for (const auto& [name, x, y, exact] : known) {
    const auto got = MEASURE(star_discrepancy_2d, x, y);
    expect_within(fmt::format("{}, {} points", got.call, x.size()), got.value, exact,
                  discrepancy_tolerance,
                  fmt::format("{}, {} points: {} as an exact fraction", name, x.size(), exact),
                  discrepancy_hints(exact_discrepancy(x, y, true, false),
                                    exact_discrepancy(x, y, false, true)));
  }
  for (const std::size_t n : {1u, 2u, 5u, 30u, 100u}) {
    expect_discrepancy(uniform_values(rng, n, 0, 1), uniform_values(rng, n, 0, 1));
  }
}

TEST_CASE("5.6 points that share coordinates or lie on the border", "[5.6][points:2]") {
  Rng rng = check_rng();
  expect_discrepancy({0});
  expect_discrepancy({1});
  expect_discrepancy({0, 1, 1, 0.5, 0.5, 0.5});
  expect_discrepancy({0}, {0});
  expect_discrepancy({1}, {1});
  expect_discrepancy({1, 1, 0}, {0, 1, 1});
  for (const int side : {4, 8}) {  // corners of a grid: 7/16 and 15/64
    Values x, y;
    for (int i = 0; i < side * side; ++i) {
      x.push_back(static_cast<double>(i % side) / side);
      y.push_back(static_cast<double>(i / side) / side);
    }
    expect_discrepancy(x, y);
  }
  for (int set = 0; set < 10; ++set) {
    Values x, y;
    for (std::size_t i = 0; i < 3 + below(rng, 30); ++i) {
      x.push_back(static_cast<double>(below(rng, 6)) / 5);
      y.push_back(static_cast<double>(below(rng, 6)) / 5);
    }
    expect_discrepancy(x, y);
    expect_discrepancy(x);
  }
}

/// A box [0, a) x [0, b), or a closed one, and by how much its area and its part of the points
/// differ: a witness that D* is no less.
struct Box {
  double a = 1, b = 1, difference = 0;
};

/// The worst box of those with the height b.
Box worst_width(View x, View y, double b, bool closed) {
  Values inside;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (y[i] < b || (closed && y[i] == b)) inside.push_back(x[i]);
  }
  std::sort(inside.begin(), inside.end());
  const auto n = static_cast<double>(x.size());
  const auto all = static_cast<double>(inside.size());
  Box worst{1, b, closed ? all / n - b : b - all / n};
  for (std::size_t i = 0; i < inside.size(); ++i) {  // up to the i-th, without it or with it
    const double area = inside[i] * b;
    const auto rank = static_cast<double>(i);
    const double difference = closed ? (rank + 1) / n - area : area - rank / n;
    if (difference > worst.difference) worst = {inside[i], b, difference};
  }
  return worst;
}

/// A bad box, if not the worst: from twenty heights, by turns the worst width and the worst height.
Box bad_box(Rng& rng, View x, View y) {
  Box worst;
  for (int start = 0; start < 40; ++start) {
    const bool closed = start % 2 == 0;
    Box box{1, y[below(rng, y.size())], 0};
    for (int turn = 0; turn < 4; ++turn) {
      box = worst_width(x, y, box.b, closed);
      const Box turned = worst_width(y, x, box.a, closed);
      box = {turned.b, turned.a, turned.difference};
    }
    if (box.difference > worst.difference) worst = box;
  }
  return worst;
}

TEST_CASE("5.6 no error exceeds variation times discrepancy",
          "[5.6][points:2][needs:5.3][needs:5.4][needs:5.5]") {
  Rng rng = check_rng();
  constexpr std::size_t n = 600;
  const auto halton = MEASURE(halton, n, 2, below(rng, 1000));
  const auto hammersley = MEASURE(hammersley, n, 2);
  const auto sobol_x = MEASURE(sobol, 0, 0, n), sobol_y = MEASURE(sobol, 1, 0, n);
  expect_size(sobol_x.call, sobol_x.value.size(), n);
  expect_size(sobol_y.call, sobol_y.value.size(), n);
  struct Set {
    std::string name;
    Values x, y;
  };
  const auto columns = [&](const char* name, const auto& got) {
    expect_size(got.call, got.value.size(), 2 * n);
    const auto middle = got.value.begin() + n;
    return Set{name, Values(got.value.begin(), middle), Values(middle, got.value.end())};
  };
  const Set sets[] = {columns("Halton", halton),
                      columns("Hammersley", hammersley),
                      {"Sobol'", sobol_x.value, sobol_y.value},
                      {"random", uniform_values(rng, n, 0, 1), uniform_values(rng, n, 0, 1)}};
  // Products g(x) g(y). Hardy and Krause add the variation over the square and that along its two
  // upper edges: T^2 + 2 T |g(1)|, T being the variation of g.
  struct Factor {
    const char* name;
    double (*g)(double);
    double integral, variation;
  };
  const Factor factors[] = {
      {"x y", [](double x) { return x; }, 0.5, 1},
      {"(1 - x)(1 - y)", [](double x) { return 1 - x; }, 0.5, 1},
      {"exp(x + y)", [](double x) { return std::exp(x); }, std::exp(1.) - 1, std::exp(1.) - 1},
      {"|x - 1/2| |y - 1/2|", [](double x) { return std::abs(x - 0.5); }, 0.25, 1}};
  constexpr double rounding = 1e-12;  // of sums of 600 numbers below e^2, and more
  for (const auto& [name, x, y] : sets) {
    const auto got = MEASURE(star_discrepancy_2d, x, y);
    const auto expect_bound = [&, &name = name](const std::string& integrand, double error,
                                                double variation) {
      expect_that(std::abs(error) <= variation * got.value + rounding,
                  fmt::format("{} of {} {} points = {:.6g}, but the integral of {} by them is "
                              "wrong by {:.6g}",
                              got.call, n, name, got.value, integrand, error),
                  fmt::format("{:.6g} times D* at most", variation),
                  "|error| <= V D*, for any points (Koksma, Hlawka)",
                  "D* is too small: some box was not looked at");
    };
    for (const auto& [integrand, g, integral, variation] : factors) {
      double sum = 0;
      for (std::size_t i = 0; i < n; ++i) sum += g(x[i]) * g(y[i]);
      expect_bound(integrand, sum / n - integral * integral,
                   variation * variation + 2 * variation * std::abs(g(1)));
    }
    // A box has the variation 1, and the worst box an error of just D*.
    const Box box = bad_box(rng, x, y);
    expect_bound(fmt::format("the box to ({:.17g}, {:.17g})", box.a, box.b), box.difference, 1);
  }
}

TEST_CASE("5.6 what is no point of the unit square is refused", "[5.6][points:2]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto line = MEASURE(star_discrepancy_1d, {0.5});
  expect_within(line.call, line.value, 0.5, discrepancy_tolerance, "[0, 1/2) is empty", {{}, ""});
  const auto plane = MEASURE(star_discrepancy_2d, {0.5}, {0.5});
  expect_within(plane.call, plane.value, 0.75, discrepancy_tolerance,
                "[0, 1/2] x [0, 1/2] has a quarter of the area and the only point", {{}, ""});
  const std::string because = "a box from the origin knows only points of the unit square";
  for (const double outside : {-0.1, 1.1, nan}) {
    expect_invalid_argument(MEASURE_OUTCOME(star_discrepancy_1d, {0.5, outside}), "x", because);
    expect_invalid_argument(MEASURE_OUTCOME(star_discrepancy_2d, {0.5, 0.1}, {0.2, outside}), "y",
                            because);
    expect_invalid_argument(MEASURE_OUTCOME(star_discrepancy_2d, {outside, 0.1}, {0.2, 0.3}), "x",
                            because);
  }
  expect_invalid_argument(MEASURE_OUTCOME(star_discrepancy_1d, {}), "x|points",
                          "of no points there is no part inside a box");
  expect_invalid_argument(MEASURE_OUTCOME(star_discrepancy_2d, {}, {}), "x|y|points",
                          "of no points there is no part inside a box");
  expect_invalid_argument(MEASURE_OUTCOME(star_discrepancy_2d, {0.1, 0.2}, {0.3}), "x|y",
                          "there are no points where the sizes differ");
}

// 5.7
// ----------------------------------------------------------------------------------------------

double wrapped(double x) {
  return x - std::floor(x);
}

/// The distance of two numbers on the circle of length 1.
double around(double a, double b) {
  const double apart = wrapped(a - b);
  return std::min(apart, 1 - apart);
}

double uniform_cdf(double x) {
  return std::clamp(x, 0.0, 1.0);
}

TEST_CASE("5.7 one shift moves all points and wraps around", "[5.7][points:3]") {
  Rng rng = check_rng();
  constexpr std::size_t n = 50, dims = 3;
  const auto points = uniform_values(rng, n * dims, 0, 1);
  const auto got = MEASURE(random_shift, points, dims, 4, rng());
  expect_size(got.call, got.value.size(), 4 * n * dims);
  for (std::size_t set = 0; set < 4; ++set) {
    for (std::size_t d = 0; d < dims; ++d) {
      const View column = part(got.value, set * dims + d, n);
      const double shift = wrapped(column[0] - points[d * n]);
      for (std::size_t i = 0; i < n; ++i) {
        const double value = column[i];
        if (value >= 0 && value <= 1 && around(value - points[d * n + i], shift) <= 16 * ulp)
          continue;
        expect_that(false,
                    fmt::format("{}: coordinate {} of point {} went from {:.6g} to {:.6g}, that of "
                                "point 0 by {:.6g}",
                                got.call, d, i, points[d * n + i], value, shift),
                    fmt::format("{:.6g}", wrapped(points[d * n + i] + shift)),
                    "all points move by the same vector, around the unit cube",
                    value > 1 || value < 0 ? "it left the unit interval: take 1 off where the sum "
                                             "reaches it"
                                           : "one random number for an axis, not one for a point");
      }
      pass();
    }
  }
}

TEST_CASE("5.7 the shift is uniform and of its own for each axis", "[5.7][points:3]") {
  Rng rng = check_rng();
  constexpr std::size_t times = 2000, dims = 2;
  const auto got = MEASURE(random_shift, {0, 0}, dims, times, rng());
  expect_size(got.call, got.value.size(), times * dims);
  expect_inside(got.call, got.value);
  Values x, y, apart;
  std::size_t equal = 0, still = 0;
  for (std::size_t i = 0; i < times; ++i) {
    x.push_back(got.value[2 * i]);
    y.push_back(got.value[2 * i + 1]);
    apart.push_back(wrapped(x[i] - y[i]));
    equal += x[i] == y[i] ? 1u : 0u;
    still += i > 0 && x[i] == x[i - 1] ? 1u : 0u;
  }
  const Hints hints{{},
                    still > 1   ? "the shift is the same each time: draw it from the generator "
                                  "that is passed in"
                    : equal > 1 ? "one shift for every axis: points only move along the diagonal"
                                : "a uniform number in [0, 1) for each axis"};
  expect_distribution(got.call + ", x", x, uniform_cdf, {"the shift along x is uniform", alpha},
                      hints);
  expect_distribution(got.call + ", y", y, uniform_cdf, {"the shift along y is uniform", alpha},
                      hints);
  expect_distribution(got.call + ", x - y", apart, uniform_cdf,
                      {"the shifts along x and y are independent", alpha}, hints);
}

TEST_CASE("5.7 shifted points stay in the unit cube", "[5.7][points:2]") {
  Rng rng = check_rng();
  const auto got =
      MEASURE(random_shift, {0, 0.5, 1 - ulp, 1 - 2 * ulp, 1 - 3 * ulp}, 1, 1000, rng());
  expect_size(got.call, got.value.size(), 5000);
  expect_inside(got.call, got.value);
  // For every shift the point just below 1 goes to just below the shift.
  for (std::size_t i = 0; i < 5000; i += 5) {
    expect_that(
        around(got.value[i + 2], got.value[i]) <= 4 * ulp,
        fmt::format("{}: 0 went to {}, 1 - 2^-53 to {}", got.call, got.value[i], got.value[i + 2]),
        "the same, on the circle", "1 and 0 are the same place there",
        "wrap around: take 1 off where the sum reaches it");
  }
}

// 5.8
// ----------------------------------------------------------------------------------------------

std::uint64_t bits_of(double x) {
  return static_cast<std::uint64_t>(x * 0x1p53);
}

/// How many leading bits of 53 two values share.
int shared_bits(double a, double b) {
  return std::countl_zero((bits_of(a) ^ bits_of(b)) << 11 | 1u << 10);
}

TEST_CASE("5.8 scrambled values share the bits that the values share", "[5.8][points:3]") {
  Rng rng = check_rng();
  // Pairs that share k bits exactly, for every k; and one value three times.
  Values x;
  for (int k = 0; k < 53; ++k) {
    const std::uint64_t word = rng() >> 11;
    const std::uint64_t other =
        (word ^ std::uint64_t{1} << (52 - k)) ^ (rng() & ((std::uint64_t{1} << (52 - k)) - 1));
    x.push_back(static_cast<double>(word) * ulp);
    x.push_back(static_cast<double>(other) * ulp);
  }
  x.insert(x.end(), {0, x[0], x[0], 1 - ulp});
  const auto seeds = fresh_seeds(rng, 3);
  const auto got = MEASURE(owen_scramble, x, seeds);
  expect_size(got.call, got.value.size(), 3 * x.size());
  expect_inside(got.call, got.value);
  for (std::size_t set = 0; set < 3; ++set) {
    const View column = part(got.value, set, x.size());
    for (std::size_t k = 0; k < 53; ++k) {
      const int shared = shared_bits(column[2 * k], column[2 * k + 1]);
      const double whole = column[2 * k] * 0x1p53;
      expect_that(
          shared == static_cast<int>(k) && whole == std::floor(whole),
          fmt::format("{}: {:.17g} and {:.17g} became {:.17g} and {:.17g}, which share {} bits",
                      got.call, x[2 * k], x[2 * k + 1], column[2 * k], column[2 * k + 1], shared),
          fmt::format("{} bits, of 53, as the values themselves", k),
          "the flip of a bit depends on the bits before it: those two share; they differ in the "
          "next, "
          "which is flipped in both or in neither. So a net stays a net",
          k >= 31 ? "53 bits of a value are scrambled, not 32"
                  : "bits that stand behind a bit must not decide about it");
    }
    expect_that(column[107] == column[0] && column[108] == column[0],
                fmt::format("{}: {:.17g} became {:.17g}, {:.17g} and {:.17g}", got.call, x[0],
                            column[0], column[107], column[108]),
                "the same number three times", "a function of value and seed alone",
                "where a value stands in its column must not matter");
  }
  const auto alone = MEASURE(owen_scramble, {x[50]}, {seeds[1]});
  expect_size(alone.call, alone.value.size(), 1);
  expect_that(alone.value[0] == got.value[x.size() + 50],
              fmt::format("{} = {:.17g}", alone.call, alone.value[0]),
              fmt::format("{:.17g}, as in a longer column", got.value[x.size() + 50]),
              "a function of value and seed alone",
              "neither the column before nor its size must matter");
}

TEST_CASE("5.8 each bit is flipped by chance for each string before it", "[5.8][points:3]") {
  Rng rng = check_rng();
  constexpr std::size_t count = 4000;
  // Two values for the first bit, and in each half two of the second: 0, 1/4, 1/2.
  const auto got = MEASURE(owen_scramble, {0, 0.5}, fresh_seeds(rng, count));
  expect_size(got.call, got.value.size(), 2 * count);
  expect_inside(got.call, got.value);
  Values zero, fine, apart;
  std::vector<std::uint64_t> flips(8);
  std::size_t same_second = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint64_t a = bits_of(got.value[2 * i]), b = bits_of(got.value[2 * i + 1]);
    zero.push_back(got.value[2 * i]);
    fine.push_back(static_cast<double>(a & 0xfffff) * 0x1p-20);  // bits 33 to 52
    apart.push_back(static_cast<double>((a ^ b) & ((std::uint64_t{1} << 52) - 1)) * 0x1p-52);
    ++flips[(a >> 52 & 1) << 2 | (a >> 51 & 1) << 1 | (b >> 51 & 1)];
    same_second += (a >> 51 & 1) == (b >> 51 & 1) ? 1u : 0u;
  }
  const bool alike = same_second == count;
  const std::string shift =
      "every bit is flipped alike in both halves: that is a digital shift, one flip for a level; "
      "nested scrambling draws one for each string of bits before";
  const Hints hints{{}, alike ? shift : "each bit of 53 is flipped with probability 1/2"};
  expect_distribution(got.call + ", of 0", zero, uniform_cdf,
                      {"a scrambled value is uniform", alpha}, hints);
  expect_distribution(got.call + ", bits 33 to 52 of it", fine, uniform_cdf,
                      {"the last 20 bits of a scrambled value are uniform", alpha},
                      {{}, "53 bits of a value are scrambled, not 32"});
  const double eighth = 0.125;
  expect_counts(got.call + ", flips of bit 0, of bit 1 behind 0 and of bit 1 behind 1", flips,
                std::span(&eighth, 1), {"flips behind different strings are independent", alpha},
                hints);
  expect_distribution(got.call + ", bits 1 to 52 of 0 against those of 1/2", apart, uniform_cdf,
                      {"flips behind different strings are independent", alpha}, hints);
}

/// The variance of the mean of c (x - 1/2)(y - 1/2) over 2^m points that are a net in base 2 along
/// each axis, scrambled: the sum over scales (j, k) of gain times the function's variance there,
/// over N. That variance is 4^-j/16 times 4^-k/16, which add up to 1/144; the gain is counted over
/// all pairs of points (Owen 1997, eq. 3.7), and is 1 from scale m on, where a pair is one point.
double scrambled_variance(const Values& x, const Values& y) {
  const std::size_t n = x.size();
  const int m = std::countr_zero(n);
  Values gain(static_cast<std::size_t>(m * m));
  const auto factor = [](int scale, int shared) {  // 2 [share scale + 1 bits] - [share scale bits]
    return shared > scale ? 1 : shared == scale ? -1 : 0;
  };
  for (std::size_t a = 0; a < n; ++a) {
    for (std::size_t b = 0; b < n; ++b) {
      const int in_x = shared_bits(x[a], x[b]), in_y = shared_bits(y[a], y[b]);
      for (int j = 0; j < m && j <= in_x; ++j) {
        for (int k = 0; k < m && k <= in_y; ++k) {
          gain[static_cast<std::size_t>(j * m + k)] += factor(j, in_x) * factor(k, in_y);
        }
      }
    }
  }
  const auto size = static_cast<double>(n);
  double sum = 1. / 144;
  for (int j = 0; j < m; ++j) {
    for (int k = 0; k < m; ++k) {
      sum += (gain[static_cast<std::size_t>(j * m + k)] / size - 1) * std::pow(4, -j - k) / 256;
    }
  }
  return sum / size;
}

/// What a scrambled net is judged by: one function, at two sizes.
struct Scrambled {
  std::string call;
  Values estimates;
  double exact = 0, variance = 0;
};

/// a x + b y + c (x - 1/2)(y - 1/2) over scrambled Sobol' points. Along an axis, N points that are
/// a net become one in each of N strata, uniform and independent there: a^2 / (12 N^3).
Scrambled scrambled_estimates(Rng& rng, std::size_t n, std::size_t replicates) {
  const double a = 1, b = -2, c = 12;
  const std::uint64_t first = n * below(rng, 1000);
  const auto x = sobol_points(0, first, n), y = sobol_points(1, first, n);
  const auto along_x = MEASURE(owen_scramble, x, fresh_seeds(rng, replicates));
  const auto along_y = MEASURE(owen_scramble, y, fresh_seeds(rng, replicates));
  expect_size(along_x.call, along_x.value.size(), n * replicates);
  expect_size(along_y.call, along_y.value.size(), n * replicates);
  Scrambled result;
  result.call = along_x.call;
  const auto size = static_cast<double>(n);
  result.exact = (a + b) / 2;
  result.variance = (a * a + b * b) / (12 * size * size * size) + c * c * scrambled_variance(x, y);
  for (std::size_t replicate = 0; replicate < replicates; ++replicate) {
    const View u = part(along_x.value, replicate, n), v = part(along_y.value, replicate, n);
    double sum = 0;
    for (std::size_t i = 0; i < n; ++i) {
      sum += a * u[i] + b * v[i] + c * (u[i] - 0.5) * (v[i] - 0.5);
    }
    result.estimates.push_back(sum / size);
  }
  return result;
}

TEST_CASE("5.8 a scrambled net has Owen's variance", "[5.8][points:4]") {
  Rng rng = check_rng();
  constexpr std::size_t replicates = 600;
  // Exactly 3.026 and 3.230 where all flips are independent: fourth moments of all quadruples of
  // points, from the first bit to the last (a flip shared by an odd number of factors averages out,
  // and points that differ in a bit go on independently). A short hash has flips that are only
  // pairwise independent, hence Owen's variance and longer tails: 3.38 and 3.91 with that of the
  // reference (6e6 and 4e7 replicates). If there were one of 4.5, its alpha would be 1e-7.
  constexpr double kurtosis_of_few = 3.5, kurtosis_of_many = 4;
  const auto few = scrambled_estimates(rng, 16, replicates);
  const auto many = scrambled_estimates(rng, 256, replicates);
  const Replicates of_few{few.call, few.estimates, 16}, of_many{many.call, many.estimates, 256};
  const std::string otherwise = "nested uniform scrambling in base 2, of all 53 bits";
  // A digital shift moves all N points of an axis by the same amount within their strata.
  const Hints hints{{{1.0,
                      "an error that falls as 1/N is that of a digital shift: the flip of a bit "
                      "must depend on the bits before it"},
                     {0.5, "an error that falls as N^-1/2 is that of independent points"}},
                    otherwise};
  expect_rate(of_few, {few.exact, few.variance, kurtosis_of_few}, of_many,
              {many.exact, many.variance, kurtosis_of_many},
              {"the error of a scrambled net falls by Owen's rate", alpha}, hints);
  for (const auto* each : {&few, &many}) {
    const Replicates estimates{each->call, each->estimates, each == &few ? 16. : 256.};
    expect_mean(estimates, each->exact, each->variance, {"a scrambled net is unbiased", alpha},
                {{}, otherwise});
    expect_variance(estimates, each->exact, each->variance,
                    each == &few ? kurtosis_of_few : kurtosis_of_many,
                    {"the variance of a scrambled net is Owen's", alpha}, {{}, otherwise});
  }
}

TEST_CASE("5.8 all 64 bits of the seed count", "[5.8][points:2]") {
  Rng rng = check_rng();
  const std::uint64_t seed = rng();
  Indices seeds{seed};
  for (int bit = 0; bit < 64; ++bit) seeds.push_back(seed ^ std::uint64_t{1} << bit);
  const auto got = MEASURE(owen_scramble, {0.25}, seeds);
  expect_size(got.call, got.value.size(), 65);
  for (int bit = 0; bit < 64; ++bit) {
    expect_that(got.value[0] != got.value[1 + static_cast<std::size_t>(bit)],
                fmt::format("{} gave {:.17g} twice: bit {} of the seed does nothing", got.call,
                            got.value[0], bit),
                "different numbers for different seeds", "all 64 bits of the seed are hashed",
                "was the seed cut to 32 bits?");
  }
  // Neighbouring seeds, as axes and pixels have them, are strangers to each other.
  constexpr std::size_t count = 2000;
  Indices row(count + 1);
  std::iota(row.begin(), row.end(), rng() >> 1);
  const auto neighbours = MEASURE(owen_scramble, {0, 0.625}, row);
  expect_size(neighbours.call, neighbours.value.size(), 2 * (count + 1));
  expect_inside(neighbours.call, neighbours.value);
  Values apart, crossed;
  for (std::size_t i = 0; i < count; ++i) {
    const View here = part(neighbours.value, i, 2), there = part(neighbours.value, i + 1, 2);
    apart.push_back(wrapped(here[0] - there[0]));
    const std::uint64_t flips = bits_of(here[1]) ^ bits_of(there[1]);
    crossed.push_back(static_cast<double>(flips) * ulp);
  }
  const Hints hints{{}, "hash the seed (Rng(seed) does) before it meets the bits"};
  expect_distribution(neighbours.call + ", 0 by a seed and by the next", apart, uniform_cdf,
                      {"neighbouring seeds give independent numbers", alpha}, hints);
  expect_distribution(neighbours.call + ", flips by a seed against those by the next", crossed,
                      uniform_cdf, {"neighbouring seeds give independent flips", alpha}, hints);
}

// 5.9
// ----------------------------------------------------------------------------------------------

/// Positions whose digit moves a value by more than 2^-53.
unsigned positions_of(unsigned base) {
  return static_cast<unsigned>(std::ceil(53 / std::log2(base)));
}

TEST_CASE("5.9 each position has a permutation of its digits", "[5.9][points:3]") {
  Rng rng = check_rng();
  for (const unsigned base : {2u, 3u, 5u, 29u, 31u, 257u}) {
    const std::uint64_t seed = rng();
    // Of base^2 consecutive indices, one value lies in each of as many parts.
    const std::uint64_t n = base * base;
    const std::uint64_t first = n * below(rng, 1000000);
    const auto got = MEASURE(radical_inverses_scrambled, base, first, n, {seed});
    expect_size(got.call, got.value.size(), n);
    expect_inside(got.call, got.value);
    // Digits behind the second add the same to all of them, so the smallest is in the first part.
    const double least = *std::min_element(got.value.begin(), got.value.end());
    std::vector<int> points(n);
    for (const double value : got.value) {
      const double part = (value - least) * static_cast<double>(n);
      const auto whole = static_cast<std::size_t>(std::llround(part));
      const bool close = std::abs(part - std::round(part)) < 1e-6;
      if (close && whole < n) ++points[whole];
    }
    expect_that(least < 1 / static_cast<double>(n) &&
                    std::all_of(points.begin(), points.end(), [](int k) { return k == 1; }),
                fmt::format("{}: not one value in each of {} parts", got.call, n),
                "one value in each of base^2 parts, all at the same place in their part",
                "the last two digits take all their combinations, and so do their permutations",
                "a permutation is a bijection, one for each position and not one for each digit "
                "before it");
    // Each digit's own contribution: index 0 has a permuted zero at every position, and changing
    // the digit at one position changes the value by what that digit is worth, whatever the others.
    std::uint64_t index = rng() >> 20;
    const auto value_at = [&](std::uint64_t at) {
      const auto one = MEASURE(radical_inverses_scrambled, base, at, 1, {seed});
      expect_size(one.call, one.value.size(), 1);
      return one.value[0];
    };
    const double zero = value_at(0), whole = value_at(index);
    double sum = zero;
    double terms = 1;
    std::uint64_t power = 1;
    for (unsigned position = 0; position < positions_of(base) && index > 0; ++position) {
      const std::uint64_t digit = index % base;
      if (digit > 0) sum += value_at(digit * power) - zero, ++terms;
      index /= base;
      power *= base;
    }
    expect_within(fmt::format("{}, digit by digit", got.call), whole, sum,
                  (2 * terms + 2) * tolerance,
                  "a digit contributes by its position alone; each value is within 4 * 2^-53",
                  {{}, "one permutation for each position, the same for all indices"});
  }
}

TEST_CASE("5.9 permutations are random for every position and seed", "[5.9][points:3]") {
  Rng rng = check_rng();
  constexpr std::size_t count = 3000;
  const unsigned base = 3;
  const auto got = MEASURE(radical_inverses_scrambled, base, 0, 3, fresh_seeds(rng, count));
  expect_size(got.call, got.value.size(), 3 * count);
  expect_inside(got.call, got.value);
  Values zero, rest;
  std::vector<std::uint64_t> orders(9), pairs(9);
  for (std::size_t i = 0; i < count; ++i) {
    const View three = part(got.value, i, 3);
    const auto digit = [&](std::size_t k) { return static_cast<std::size_t>(three[k] * 3); };
    zero.push_back(three[0]);
    rest.push_back(wrapped(three[0] * 3));
    ++orders[digit(0) * 3 + digit(1)];
    ++pairs[digit(0) * 3 + static_cast<std::size_t>(rest.back() * 3)];
  }
  const bool zeros_stay =
      std::all_of(rest.begin(), rest.end(), [](double value) { return value < 1e-9; });
  const bool pairs_alike = pairs[0] + pairs[4] + pairs[8] == count;
  const Hints hints{
      {},
      zeros_stay    ? "the zeros behind the last digit are digits too: permute them, to 2^-53"
      : pairs_alike ? "one permutation for all positions: each has its own"
                    : "a random permutation for each position, from a hash of seed and position"};
  expect_distribution(got.call + ", of index 0", zero, uniform_cdf,
                      {"the scrambled value of index 0 is uniform", alpha}, hints);
  expect_distribution(got.call + ", of index 0 behind its first digit", rest, uniform_cdf,
                      {"the digits behind the last one are permuted", alpha}, hints);
  std::vector<std::uint64_t> six;
  for (const std::size_t cell : {1u, 2u, 3u, 5u, 6u, 7u}) six.push_back(orders[cell]);
  expect_that(orders[0] + orders[4] + orders[8] == 0, got.call + ": two digits became the same",
              "a permutation", "no two indices below the base share a first digit",
              hints.otherwise);
  const double sixth = 1. / 6, ninth = 1. / 9;
  expect_counts(got.call + ", orders of three digits", six, std::span(&sixth, 1),
                {"all six permutations are equally likely", alpha}, hints);
  expect_counts(got.call + ", the first and second digit of index 0", pairs, std::span(&ninth, 1),
                {"the permutations of two positions are independent", alpha}, hints);
  // Different bases with one seed, and neighbouring seeds.
  Indices row(count + 1);
  std::iota(row.begin(), row.end(), rng() >> 1);
  const auto neighbours = MEASURE(radical_inverses_scrambled, 5, 7, 1, row);
  expect_size(neighbours.call, neighbours.value.size(), count + 1);
  Values apart;
  for (std::size_t i = 0; i < count; ++i) {
    apart.push_back(wrapped(neighbours.value[i] - neighbours.value[i + 1]));
  }
  expect_distribution(neighbours.call + ", by a seed and by the next", apart, uniform_cdf,
                      {"neighbouring seeds give independent permutations", alpha},
                      {{}, "hash the seed (Rng(seed) does) before it chooses permutations"});
}

TEST_CASE("5.9 permuted digits cure the bad pair 29 and 31", "[5.9][points:3]") {
  Rng rng = check_rng();
  constexpr std::size_t n = 64, count = 400;
  const auto x = MEASURE(radical_inverses_scrambled, 29, 0, n, fresh_seeds(rng, count));
  const auto y = MEASURE(radical_inverses_scrambled, 31, 0, n, fresh_seeds(rng, count));
  expect_size(x.call, x.value.size(), n * count);
  expect_size(y.call, y.value.size(), n * count);
  expect_inside(x.call, x.value);
  expect_inside(y.call, y.value);
  double empty = 0;
  for (std::size_t set = 0; set < count; ++set) {
    std::vector<bool> taken(64);
    for (std::size_t i = 0; i < n; ++i) {
      taken[static_cast<std::size_t>(x.value[set * n + i] * 8) * 8 +
            static_cast<std::size_t>(y.value[set * n + i] * 8)] = true;
    }
    empty += static_cast<double>(std::count(taken.begin(), taken.end(), false)) / count;
  }
  // 64 independent points leave 64 (63/64)^64 = 23.4 of 64 cells empty on average, these 20;
  // unpermuted, 47. With numbers of empty cells between 0 and 63, a mean of 400 lies 12 above its
  // expectation less than once in 10^12 runs (Hoeffding).
  expect_that(
      empty <= 33,
      fmt::format("{} and base 31: of 8 x 8 cells, 64 points leave {:.1f} empty", x.call, empty),
      "about 20, and 33 at most",
      "64 points in the plane of bases 29 and 31 lie on a few lines, and leave 47 cells empty; "
      "digits in random order do not",
      "a shift or a flip of bits moves the lines; permuting the digits breaks them");
}

TEST_CASE("5.9 a scrambled column depends on index and seed alone", "[5.9][points:3]") {
  Rng rng = check_rng();
  for (const unsigned base : {2u, 3u, 29u, 7919u, 65536u}) {
    const std::uint64_t seed = rng(), first = rng() >> (rng() % 40 + 1);
    const std::uint64_t count = 500 + below(rng, 2000), skip = below(rng, 400);
    const auto whole = MEASURE(radical_inverses_scrambled, base, first, count, {seed});
    const auto later = MEASURE(radical_inverses_scrambled, base, first + skip, 50, {seed});
    expect_size(whole.call, whole.value.size(), count);
    expect_size(later.call, later.value.size(), 50);
    expect_inside(whole.call, whole.value);
    for (std::size_t i = 0; i < 50; ++i) {
      expect_within(fmt::format("{}, value {}", later.call, i), later.value[i],
                    whole.value[skip + i], 2 * tolerance,
                    fmt::format("the same index as value {} of {}; each is within 4 * 2^-53",
                                skip + i, whole.call),
                    {{}, "where a column begins must not matter"});
    }
  }
  const auto last = MEASURE(radical_inverses_scrambled, 2, last_index - 599, 600, {rng()});
  expect_size(last.call, last.value.size(), 600);
  expect_inside(last.call, last.value);
  for (const unsigned base : {0u, 1u, 65537u}) {
    expect_invalid_argument(MEASURE_OUTCOME(radical_inverses_scrambled, base, 0, 10, {1}), "base",
                            "bases from 2 to 2^16");
  }
  expect_invalid_argument(MEASURE_OUTCOME(radical_inverses_scrambled, 3, last_index - 1, 3, {1}),
                          "first", "the third index would be 2^64");
}

}  // namespace
}  // namespace mc::checks
