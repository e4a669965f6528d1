// Lab 5 · Halton and quasi-Monte Carlo: the reference solution. Each function is its definition
// first; where a faster way stands below, its reason stands with it.

#include "halton.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace mc {
namespace {

constexpr double below_one = 1 - 0x1p-53;  // the largest double that is

void require_base(unsigned base) {
  if (base < 2) throw std::invalid_argument("base: there are no digits below base 2");
}

void require_indices(std::uint64_t first, std::size_t count, std::uint64_t last) {
  if (first > last || (count > 0 && count - 1 > last - first)) {
    throw std::invalid_argument("first: the indices run past the end of the sequence");
  }
}

constexpr std::uint64_t last_index = std::numeric_limits<std::uint64_t>::max();

}  // namespace

// 5.1 --------------------------------------------------------------------------------------------

double radical_inverse(unsigned base, std::uint64_t index) {
  require_base(base);
  if (index == 0) return 0;
  // The last digit first, behind it the radical inverse of all the others. So small terms are added
  // before large ones, and each division by the base divides the errors made before it too: no more
  // than 2 * 2^-53 are left. In base 2, more than 53 ones would round up to 1.
  const double others = radical_inverse(base, index / base);
  return std::min(below_one, (static_cast<double>(index % base) + others) / base);
}

// 5.2 --------------------------------------------------------------------------------------------
//
// The definition would be
//
//   for (std::size_t i = 0; i < column.size(); ++i) column[i] = radical_inverse(base, first + i);
//
// with a division of integers and one of doubles for every digit of every index. But indices that
// follow each other differ in their last digits only, and in all their ways: in base 3, every block
// of 3^5 indices takes the last five digits through the same 243 values. So
//
// * the radical inverses of the last digits are a table, made once;
// * the digits before them add one number, the same for the whole block;
// * these numbers belong to consecutive indices too, so they are a column as well, a shorter one.
//
// One load, one addition, one store are left for a value, four values to a vector register.
//
// 5.9 is the same with other digits, so it is written for any digits.

namespace {

/// What stands at each position of a radical inverse in place of the index's digit there.
struct Digits {
  unsigned base;
  std::vector<unsigned> permutations;  ///< one of `base` digits for each position; none: the digit
  double zeros = 0;                    ///< what the zeros at all positions behind them come to

  double operator()(std::size_t position, std::uint64_t digit) const {
    return static_cast<double>(permutations.empty() ? digit
                                                    : permutations[position * base + digit]);
  }

  /// Whether all digits from `position` on are zeros.
  bool end_at(std::size_t position, std::uint64_t number) const {
    return permutations.empty() ? number == 0 : position * base == permutations.size();
  }
};

/// As 5.1, of a number whose last digit stands at `position`.
double inverse(const Digits& digits, unsigned position, std::uint64_t number) {
  if (digits.end_at(position, number)) return digits.zeros;
  const double others = inverse(digits, position + 1, number / digits.base);
  return std::min(below_one, (digits(position, number % digits.base) + others) / digits.base);
}

/// Where only the last digit is worth keeping: the same for consecutive indices, in runs.
void fill_by_runs(std::span<double> column, std::uint64_t first, const Digits& digits,
                  unsigned position) {
  for (std::size_t done = 0; done < column.size();) {
    const std::uint64_t number = first + done;
    const double others = inverse(digits, position + 1, number / digits.base);
    for (auto digit = number % digits.base; digit < digits.base && done < column.size(); ++digit) {
      column[done++] = std::min(below_one, (digits(position, digit) + others) / digits.base);
    }
  }
}

constexpr std::size_t largest = 1024;  // values of a table: a quarter of the first-level cache

/// The first values of a sequence, so few that they are the table themselves: what is there for the
/// digits so far is there again with one more. Whole numbers, and exact, up to the last line.
void fill_few(std::span<double> column, const Digits& digits) {
  double size = digits.base;
  while (size < static_cast<double>(column.size())) size *= digits.base;
  double weight = size;
  column[0] = 0;
  std::size_t filled = 1;
  unsigned position = 0;
  for (; weight > 1; ++position, filled *= digits.base) {
    weight /= digits.base;
    for (std::size_t digit = std::min<std::size_t>(digits.base - 1, (column.size() - 1) / filled);
         digit > 0; --digit) {
      const double more = digits(position, digit) * weight;
      const auto to = column.subspan(digit * filled);
      for (std::size_t k = 0; k < std::min(filled, to.size()); ++k) to[k] = column[k] + more;
    }
    const double more = digits(position, 0) * weight;
    for (double& x : column.first(std::min(filled, column.size()))) x += more;
  }
  const double behind = inverse(digits, position, 0);
  for (double& x : column) x = std::min(below_one, (x + behind) * (1 / size));
}

void fill(std::span<double> column, std::uint64_t first, const Digits& digits,
          unsigned position = 0) {
  if (first == 0 && position == 0 && !column.empty() && column.size() <= largest) {
    return fill_few(column, digits);
  }
  // At most half of the column.
  std::size_t block = 1;
  unsigned low = 0;
  for (; block * digits.base <= std::min(largest, column.size() / 2); ++low) block *= digits.base;
  if (low == 0) return fill_by_runs(column, first, digits, position);

  // What is there for the digits so far is there `base` times with one more, each time with another
  // number added: whole numbers, and exact, up to the one multiplication.
  std::array<double, largest> table;
  table[0] = 0;
  const auto size = static_cast<double>(block);
  double weight = size;
  std::size_t filled = 1;
  for (unsigned i = 0; i < low; ++i, filled *= digits.base) {
    weight /= digits.base;
    for (unsigned digit = digits.base; digit-- > 0;) {  // digit 0 last: it overwrites what is read
      const double more = digits(position + i, digit) * weight;
      double* const to = table.data() + digit * filled;
      for (std::size_t k = 0; k < filled; ++k) to[k] = table[k] + more;
    }
  }
  const double scale = 1 / size;
  for (std::size_t k = 0; k < block; ++k) table[k] *= scale;

  std::size_t skip = first % block;
  std::vector<double> before((skip + column.size() + block - 1) / block);  // one for each block
  fill(before, first / block, digits, position + low);
  // Each value is wrong by e <= 3/2 + 1/2 + (e + 3/2)/block: table, sum, and what is added, in units
  // of 2^-53. So e < 4, and in base 2, where scaling is exact, e <= 1.
  const double room = below_one - (size - 1) * scale;  // above the largest value in the table
  double* to = column.data();
  std::size_t left = column.size();
  for (const double others : before) {
    const double offset = std::min(room, others * scale);
    const std::size_t count = std::min(block - skip, left);
    for (std::size_t i = 0; i < count; ++i) to[i] = table[skip + i] + offset;
    to += count;
    left -= count;
    skip = 0;
  }
}

}  // namespace

void radical_inverses(unsigned base, std::uint64_t first, std::span<double> column) {
  require_base(base);
  require_indices(first, column.size(), last_index);
  fill(column, first, {base, {}});
}

// 5.3 --------------------------------------------------------------------------------------------

std::vector<unsigned> primes(std::size_t count) {
  std::vector<unsigned> found;
  for (unsigned n = 2; found.size() < count; ++n) {
    const bool composite =
        std::any_of(found.begin(), found.end(), [&](unsigned prime) { return n % prime == 0; });
    if (!composite) found.push_back(n);
  }
  return found;
}

void halton(PointSet& points, std::uint64_t first) {
  require_indices(first, points.size(), last_index);
  const auto bases = primes(points.dims());
  for (std::size_t d = 0; d < points.dims(); ++d) {
    radical_inverses(bases[d], first, points.column(d));
  }
}

// 5.4 --------------------------------------------------------------------------------------------

void hammersley(PointSet& points) {
  if (points.dims() == 0) return;
  const auto size = static_cast<double>(points.size());
  const auto column = points.column(0);
  for (std::size_t i = 0; i < points.size(); ++i) column[i] = static_cast<double>(i) / size;
  const auto bases = primes(points.dims() - 1);
  for (std::size_t d = 1; d < points.dims(); ++d) {
    radical_inverses(bases[d - 1], 0, points.column(d));
  }
}

// 5.5 --------------------------------------------------------------------------------------------

namespace {

using Directions = std::array<std::uint32_t, 32>;

/// The direction numbers of a dimension: number k is what bit k of the index contributes. Bratley
/// and Fox 1988, "Algorithm 659", eq. 2 and 3.
constexpr Directions directions_of(const JoeKuo& given) {
  Directions v{};
  const unsigned s = given.degree;
  for (unsigned k = 0; k < 32; ++k) {
    if (s == 0 || k < s) {
      v[k] = (s == 0 ? 1u : given.m[k]) << (31 - k);
      continue;
    }
    v[k] = v[k - s] ^ (v[k - s] >> s);
    for (unsigned j = 1; j < s; ++j) {
      if (given.coefficients >> (s - 1 - j) & 1) v[k] ^= v[k - j];
    }
  }
  return v;
}

constexpr auto all_directions = [] {
  std::array<Directions, joe_kuo.size()> all{};
  for (std::size_t d = 0; d < all.size(); ++d) all[d] = directions_of(joe_kuo[d]);
  return all;
}();

/// The coordinate that the bits of `index` choose: the definition. All 32 of them, and no branch,
/// so that eight go at a time.
std::uint32_t sobol_word(const Directions& v, std::uint32_t index) {
  std::uint32_t word = 0;
  for (unsigned k = 0; k < 32; ++k) word ^= v[k] & (0 - (index >> k & 1));
  return word;
}

}  // namespace

// The definition would be column[i] = sobol_word(v, first + i) * 2^-32. As in 5.2, the low bits of
// the index go through the same table in every block, and the bits above contribute one word to the
// whole block. From block number n to n + 1 a run of ones at the end of n becomes zeros and the
// zero before it a one: the word changes by v_0 ^ v_1 ^ … ^ v_t, t being the zeros at the end of
// n + 1. Exclusive or works on whole words, and a double in [1, 2) *is* a word: 20 zero bits behind
// the 32 of the coordinate, the exponent of 1 before them. So the table holds such doubles, and
// what is left for a value is one load, one exclusive or, the subtraction of 1 and one store.

void sobol(unsigned dimension, std::uint64_t first, std::span<double> column) {
  if (dimension >= joe_kuo.size()) {
    throw std::invalid_argument("dimension: there are direction numbers for 32 of them");
  }
  require_indices(first, column.size(), 0xffffffffu);
  const Directions& v = all_directions[dimension];

  constexpr unsigned low = 6;
  constexpr std::size_t block = std::size_t{1} << low;
  std::array<std::uint64_t, block> table;
  table[0] = std::bit_cast<std::uint64_t>(1.0);
  for (unsigned k = 0; k < low; ++k) {
    const std::size_t size = std::size_t{1} << k;
    for (std::size_t i = 0; i < size; ++i) table[size + i] = table[i] ^ std::uint64_t{v[k]} << 20;
  }
  std::array<std::uint64_t, 33 - low> step{};  // v_low ^ v_(low+1) ^ …; behind the last block: 0
  std::uint64_t sum = 0;
  for (unsigned t = 0; low + t < 32; ++t) step[t] = sum ^= std::uint64_t{v[low + t]} << 20;

  std::uint64_t number = first >> low;
  std::uint64_t above = std::uint64_t{sobol_word(v, static_cast<std::uint32_t>(number << low))}
                        << 20;
  double* to = column.data();
  const auto put = [&](std::size_t skip, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      to[i] = std::bit_cast<double>(table[skip + i] ^ above) - 1;
    }
    to += count;
    above ^= step[static_cast<std::size_t>(std::countr_zero(++number))];
  };
  // Whole blocks by themselves: their size is known to the compiler, and their loop unrolled.
  const std::size_t skip = first % block;
  const std::size_t head = std::min(column.size(), (block - skip) % block);
  const std::size_t whole = (column.size() - head) / block;
  if (head > 0) put(skip, head);
  for (std::size_t k = 0; k < whole; ++k) put(0, block);
  put(0, column.size() - head - whole * block);
}

// 5.6 --------------------------------------------------------------------------------------------

namespace {

void require_points(std::span<const double> x, const char* name) {
  if (x.empty()) throw std::invalid_argument(std::string(name) + ": there are no points");
  for (const double value : x) {
    if (!(value >= 0 && value <= 1)) {
      throw std::invalid_argument(std::string(name) + ": a value lies outside [0, 1]");
    }
  }
}

}  // namespace

double star_discrepancy(std::span<const double> x) {
  require_points(x, "x");
  std::vector<double> sorted(x.begin(), x.end());
  std::sort(sorted.begin(), sorted.end());
  const auto n = static_cast<double>(x.size());
  // The worst interval ends at a point: just before it, with i points inside, or just behind it.
  double worst = 0;
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    const auto inside = static_cast<double>(i);
    worst = std::max({worst, sorted[i] - inside / n, (inside + 1) / n - sorted[i]});
  }
  return worst;
}

double star_discrepancy(std::span<const double> x, std::span<const double> y) {
  if (x.size() != y.size()) throw std::invalid_argument("x and y: sizes differ");
  require_points(x, "x");
  require_points(y, "y");
  std::vector<std::size_t> order(x.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return x[a] < x[b]; });

  // The worst box has its corner on the coordinates of points, or on 1. From left to right, `ys`
  // are the points so far, sorted: up to the k-th of them a closed box that ends at `here` holds
  // k points or more, and an open one that ends at `next` and at the k + 1st, k or fewer. (They
  // are more and fewer only where coordinates repeat, and there the last of the equal ones has
  // them all.)
  const auto n = static_cast<double>(x.size());
  std::vector<double> ys{0, 1};
  ys.reserve(x.size() + 2);
  double worst = 0;
  for (std::size_t seen = 0; seen <= x.size(); ++seen) {
    const double here = seen == 0 ? 0 : x[order[seen - 1]];
    const double next = seen == x.size() ? 1 : x[order[seen]];
    for (std::size_t k = 0; k <= seen; ++k) {
      const double inside = static_cast<double>(k) / n;
      worst = std::max(worst, std::max(inside - here * ys[k], next * ys[k + 1] - inside));
    }
    if (seen == x.size()) break;
    const double value = y[order[seen]];
    ys.insert(std::upper_bound(ys.begin() + 1, ys.end() - 1, value), value);
  }
  return worst;
}

// 5.7 --------------------------------------------------------------------------------------------

void random_shift(PointSet& points, Rng& rng) {
  for (std::size_t d = 0; d < points.dims(); ++d) {
    const double shift = static_cast<double>(rng() >> 11) * 0x1p-53;
    for (double& value : points.column(d)) {
      value += shift;
      if (value >= 1) value -= 1;  // also where the sum was rounded up to 1
    }
  }
}

// 5.8 --------------------------------------------------------------------------------------------
//
// The definition, for one value:
//
//   for (int k = 0; k < 53; ++k) {
//     const std::uint64_t before = k == 0 ? 0 : word >> (64 - k);
//     flips |= (mix_bits(mix_bits(seed ^ before) + k) >> 63) << (63 - k);
//   }
//   word ^= flips;
//
// 53 times two hashes. Mirror the word, so that its first bit becomes the lowest: now whatever is
// made of additions and multiplications flips each bit depending on those before it only, since
// carries run upwards (Laine, Karras 2011, "Stratified sampling for stochastic transparency").
//
// Which additions and multiplications? Take z -> m z + s with a random odd m and a random s. Two
// words that agree in their first k bits and differ in the next have a difference of 2^k times an
// odd number; m makes it 2^k times *any* odd number with equal chance, and s moves the pair anywhere.
// That is just what nested uniform scrambling does to two points. The variance of an estimate is
// made of pairs, so it is Owen's, for every integrand and every set of points. But m and s alone
// leave three points and more on a lattice: most errors are tiny then, and a few are huge. So fixed
// steps stand around them, z -> z ^ z c with an even c: a bit is changed by those below it, and
// pairs keep what they have in common. The constants are those of Vegdahl's search (2021, "Building
// a better LK hash"). What is measured: in one dimension the error of exp(x) has a kurtosis between
// 2.92 and 3.02 for N = 16 … 16,384, a Gaussian's is 3; with one fixed step it is 4.4 at N = 16 and
// 50 at 1,024.
//
// Vector registers multiply eight words of 32 bits at a time, and none of 64. So the first 32 bits
// are scrambled as above, and the 21 behind them, which for Sobol' points are zeros, are flipped by a
// hash of all that is before.

namespace {

constexpr std::uint32_t mirrored(std::uint32_t word) {
  word = (word >> 1 & 0x55555555u) | (word & 0x55555555u) << 1;
  word = (word >> 2 & 0x33333333u) | (word & 0x33333333u) << 2;
  word = (word >> 4 & 0x0f0f0f0fu) | (word & 0x0f0f0f0fu) << 4;
  return __builtin_bswap32(word);
}

/// A double of one binade, read as an integer, counts its last places: of one near 2^20 they are
/// 2^-32, of one near 1/2 they are 2^-53.
constexpr std::uint64_t bits(double value) {
  return std::bit_cast<std::uint64_t>(value);
}

/// What a seed chooses.
struct OwenHash {
  std::uint32_t m, s, a, b;

  explicit OwenHash(std::uint64_t seed) {
    Rng rng(seed);
    const std::uint64_t one = rng(), two = rng();
    m = static_cast<std::uint32_t>(one) | 1;
    s = static_cast<std::uint32_t>(one >> 32);
    a = static_cast<std::uint32_t>(two) | 1;
    b = static_cast<std::uint32_t>(two >> 32);
  }

  /// The first 32 bits, mirrored.
  std::uint32_t scrambled(std::uint32_t z) const {
    z ^= z * 0x3d20adeau;
    z = z * m + s;
    z ^= z * 0x05526c56u;
    z ^= z * 0x53a22864u;
    return z;
  }

  /// A hash of them, in whose upper 21 bits stand the flips of the bits behind.
  std::uint32_t behind(std::uint32_t z) const {
    z = (z ^ z >> 16) * a;
    return (z ^ z >> 15) * 0x846ca68bu + b;
  }
};

/// In short loops, which fill the registers of a processor better than a long one.
constexpr std::size_t owen_block = 256;

void owen_scramble_block(std::span<double> x, const OwenHash& hash) {
  std::array<std::uint32_t, owen_block> words, flips;
  const std::size_t n = x.size();
  std::uint64_t longer = 0;  // than 32 bits: then the sum below is rounded
  for (std::size_t i = 0; i < n; ++i) {
    const double sum = x[i] + 0x1p20;
    words[i] = static_cast<std::uint32_t>(bits(sum));
    longer |= bits(sum - 0x1p20 - x[i]);
  }
  if (longer != 0) {
    for (std::size_t i = 0; i < n; ++i) {
      words[i] = static_cast<std::uint32_t>(static_cast<std::uint64_t>(x[i] * 0x1p32));
    }
  }
  for (std::size_t i = 0; i < n; ++i) words[i] = mirrored(words[i]);
  for (std::size_t i = 0; i < n; ++i) words[i] = hash.scrambled(words[i]);
  for (std::size_t i = 0; i < n; ++i) flips[i] = hash.behind(words[i]);
  if (longer != 0) {
    for (std::size_t i = 0; i < n; ++i) {  // those behind, nested too: their zeros stay zeros
      const auto rest = static_cast<std::uint32_t>(static_cast<std::uint64_t>(x[i] * 0x1p53) << 11);
      const std::uint32_t odd = hash.behind(~words[i]) | 1;
      flips[i] ^= mirrored(mirrored(rest) * odd);
    }
  }
  for (std::size_t i = 0; i < n; ++i) words[i] = mirrored(words[i]);
  for (std::size_t i = 0; i < n; ++i) {
    const double first = std::bit_cast<double>(bits(1) | std::uint64_t{words[i]} << 20);
    const double last = std::bit_cast<double>(bits(0.5) | flips[i] >> 11);
    x[i] = (first - 1.5) + last;
  }
}

}  // namespace

void owen_scramble(std::span<double> column, std::uint64_t seed) {
  const OwenHash hash(seed);
  for (std::size_t first = 0; first < column.size(); first += owen_block) {
    const std::size_t size = std::min(owen_block, column.size() - first);
    owen_scramble_block(column.subspan(first, size), hash);
  }
}

// 5.9 --------------------------------------------------------------------------------------------
//
// A permutation for each of the 64 digits that an index may have in base 2, of which a column of a
// thousand uses ten: in the others it has nothing but zeros. What a zero becomes is a random digit,
// independently at each position: together these are the digits of one number, uniform in [0, 1). So
// that is drawn first, and what is left of it behind the digits in use is what all the zeros behind
// them come to.

namespace {

/// One of the digits first … base - 1, by 48 random bits: 2^-32 from uniform at most.
unsigned any_digit(unsigned first, unsigned base, Rng& rng) {
  return first + static_cast<unsigned>((rng() >> 16) * (base - first) >> 48);
}

unsigned digits_of(std::uint64_t number, unsigned base) {
  unsigned count = 0;
  for (; number > 0; number /= base) ++count;
  return count;
}

}  // namespace

void radical_inverses_scrambled(unsigned base, std::uint64_t first, std::span<double> column,
                                std::uint64_t seed) {
  require_base(base);
  if (base > 65536) throw std::invalid_argument("base: more than 2^16 digits to permute");
  require_indices(first, column.size(), last_index);
  if (column.empty()) return;
  Rng rng(mix_bits(seed ^ mix_bits(base)));
  const unsigned used = std::max(1u, digits_of(first + (column.size() - 1), base));
  Digits digits{base, std::vector<unsigned>(std::size_t{used} * base)};
  digits.zeros = static_cast<double>(rng() >> 11) * 0x1p-53;
  for (unsigned position = 0; position < used; ++position) {
    unsigned* const row = digits.permutations.data() + std::size_t{position} * base;
    std::iota(row, row + base, 0u);
    digits.zeros *= base;
    const auto of_zero = static_cast<unsigned>(digits.zeros);
    digits.zeros -= of_zero;
    std::swap(row[0], row[of_zero]);
    for (unsigned i = 1; i + 1 < base; ++i) std::swap(row[i], row[any_digit(i, base, rng)]);
  }
  fill(column, first, digits);
}

}  // namespace mc
