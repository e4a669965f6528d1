// Lab 5 · Halton and quasi-Monte Carlo: the reference solution. Speed tasks: as defined, then fast.

#include "halton.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <numeric>
#include <stdexcept>
#include <string>

namespace mc {
namespace {
constexpr double below_one = 1 - 0x1p-53;  // the largest double that is
constexpr std::uint64_t last_index = ~std::uint64_t{0};

void require_base(unsigned base) {
  if (base < 2) throw std::invalid_argument("base: there are no digits below base 2");
}

void require_indices(std::uint64_t first, std::size_t count, std::uint64_t last) {
  if (first > last || (count > 0 && count - 1 > last - first)) {
    throw std::invalid_argument("first: the indices run past the end of the sequence");
  }
}

void require_points(std::span<const double> x, const std::string& name) {
  if (x.empty()) throw std::invalid_argument(name + ": there are no points");
  const auto out = [](double value) { return !(value >= 0 && value <= 1); };
  if (std::any_of(x.begin(), x.end(), out)) throw std::invalid_argument(name + ": not in [0, 1]");
}
}  // namespace

// 5.1 --------------------------------------------------------------------------------------------
double radical_inverse(unsigned base, std::uint64_t index) {
  require_base(base);
  if (index == 0) return 0;
  // The last digit first, behind it the inverse of the others: small terms are added first, each
  // division divides the errors before it: 2 * 2^-53 are left. In base 2, 54 ones would round to 1.
  const double others = radical_inverse(base, index / base);
  return std::min(below_one, (double(index % base) + others) / base);
}

// 5.2 --------------------------------------------------------------------------------------------
namespace definition {
void radical_inverses(unsigned base, std::uint64_t first, std::span<double> column) {
  for (std::size_t i = 0; i < column.size(); ++i) column[i] = radical_inverse(base, first + i);
}
}  // namespace definition

// That divides for every digit. But in base 3, every block of 3^5 indices takes its last 5 digits
// through the same 243 values. So their radical inverses are a table, made once; the digits before
// add one number to the whole block, and these numbers are a column too, a shorter one. A load, an
// addition and a store are left for a value. 5.9 is the same with other digits.

namespace {
/// What stands at each position of a radical inverse where the index has a digit.
struct Digits {
  unsigned base;
  std::vector<unsigned> permutations;  ///< of each position, `base` digits; none: the digit itself
  double zeros = 0;                    ///< what the zeros at all positions behind come to

  double operator()(std::size_t position, std::uint64_t digit) const {
    return double(permutations.empty() ? digit : permutations[position * base + digit]);
  }
  /// As 5.1, of a number whose last digit stands at `position`.
  double inverse(std::size_t position, std::uint64_t number) const {
    if (number == 0 && position * base >= permutations.size()) return zeros;
    const double others = inverse(position + 1, number / base);
    return std::min(below_one, ((*this)(position, number % base) + others) / base);
  }
};

unsigned digits_of(std::uint64_t number, unsigned base) {
  return number == 0 ? 0 : 1 + digits_of(number / base, base);
}

/// One of the digits first … base - 1, by 48 random bits: 2^-32 from uniform at most.
unsigned any_digit(unsigned first, unsigned base, Rng& rng) {
  return first + unsigned((rng() >> 16) * (base - first) >> 48);
}

/// The radical inverses of 0, 1, … times a power of the base, which is returned: whole numbers, and
/// exact. `position` is that of the last digit, and moves past the digits in the table.
double fill_table(std::span<double> table, const Digits& digits, std::size_t& position) {
  std::size_t p = position, filled = 1;
  double size = 1;
  table[0] = 0;  // then the zeros at all positions
  for (; size < double(table.size()); size *= digits.base) {
    table[0] = table[0] * digits.base + digits(position++, 0);
  }
  for (double weight = size; filled < table.size(); filled *= digits.base, ++p) {
    weight /= digits.base;  // what is there so far is there again with each digit but 0
    const double zero = digits(p, 0);
    const std::size_t end = std::min<std::size_t>(digits.base, (table.size() - 1) / filled + 1);
    for (std::size_t digit = 1; digit < end; ++digit) {
      const auto more = [by = (digits(p, digit) - zero) * weight](double x) { return x + by; };
      const auto from = table.first(std::min(filled, table.size() - digit * filled));
      std::transform(from.begin(), from.end(), &table[digit * filled], more);
    }
  }
  return size;
}

void fill(std::span<double> column, std::uint64_t first, const Digits& digits, std::size_t p = 0) {
  constexpr std::size_t largest = 1024;  // values of a table: a quarter of the first-level cache
  std::size_t block = 1;                 // at most half of the column
  while (block * digits.base <= std::min(largest, column.size() / 2)) block *= digits.base;
  if (block == 1) {  // too few for a table: keep what stands before the last digit
    std::uint64_t digit = first % digits.base, number = first / digits.base;
    double others = digits.inverse(p + 1, number);
    for (double& x : column) {
      if (digit == digits.base) digit = 0, others = digits.inverse(p + 1, ++number);
      x = std::min(below_one, (digits(p, digit++) + others) / digits.base);
    }
    return;
  }
  if (first == 0 && column.size() <= largest) {  // the column is the table
    const double size = fill_table(column, digits, p);
    const double behind = digits.inverse(p, 0);
    for (double& x : column) x = std::min(below_one, (x + behind) * (1 / size));
    return;
  }
  std::array<double, largest> table;
  const double scale = 1 / fill_table(std::span(table).first(block), digits, p);
  for (double& x : std::span(table).first(block)) x *= scale;
  std::size_t skip = first % block;
  std::vector<double> before((skip + column.size() + block - 1) / block);  // one for each block
  fill(before, first / block, digits, p);
  // Table, sum and what is added are wrong by e <= 3/2 + 1/2 + (e + 3/2)/block times 2^-53. So
  // e < 4, and in base 2, where scaling is exact, e <= 1.
  const double room = below_one - double(block - 1) * scale;  // above the largest in the table
  for (const double others : before) {
    const double offset = std::min(room, others * scale);
    const auto part = std::span(table).subspan(skip, std::min(block - skip, column.size()));
    std::transform(part.begin(), part.end(), column.begin(), [=](double x) { return x + offset; });
    column = column.subspan(part.size()), skip = 0;
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
    const auto divides = [n](unsigned prime) { return n % prime == 0; };
    if (std::none_of(found.begin(), found.end(), divides)) found.push_back(n);
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
  const auto bases = primes(points.dims());
  for (std::size_t d = 0; d < points.dims(); ++d) {
    const auto column = points.column(d);
    if (d > 0) radical_inverses(bases[d - 1], 0, column);
    for (std::size_t i = 0; d == 0 && i < column.size(); ++i) {
      column[i] = double(i) / double(column.size());
    }
  }
}

// 5.5 --------------------------------------------------------------------------------------------
namespace {
constexpr auto bits = [](double value) { return std::bit_cast<std::uint64_t>(value); };
constexpr auto number = [](std::uint64_t word) { return std::bit_cast<double>(word); };
constexpr auto wide = [](std::uint32_t word) { return std::uint64_t{word} << 20; };

constexpr std::uint32_t mirrored(std::uint32_t word) {
  word = (word >> 1 & 0x55555555u) | (word & 0x55555555u) << 1;
  word = (word >> 2 & 0x33333333u) | (word & 0x33333333u) << 2;
  word = (word >> 4 & 0x0f0f0f0fu) | (word & 0x0f0f0f0fu) << 4;
  return __builtin_bswap32(word);
}

using Directions = std::array<std::uint32_t, 32>;

/// Number k is what bit k of the index contributes (Bratley, Fox 1988, "Algorithm 659", eq. 2, 3).
constexpr Directions directions_of(const JoeKuo& given) {
  Directions v{};
  const unsigned s = given.degree;
  for (unsigned k = 0; k < 32; ++k) {
    if (s == 0 || k < s) {
      v[k] = (s == 0 ? 1u : given.m[k]) << (31 - k);
    } else {
      v[k] = v[k - s] ^ v[k - s] >> s;
      for (unsigned j = 1; j < s; ++j) v[k] ^= (given.coefficients >> (s - 1 - j) & 1) * v[k - j];
    }
  }
  return v;
}

/// The coordinate that the bits of `index` choose.
constexpr std::uint32_t sobol_word(const Directions& v, std::uint64_t index) {
  std::uint32_t word = 0;
  for (unsigned k = 0; index >> k != 0; ++k) {
    if (index >> k & 1) word ^= v[k];
  }
  return word;
}

struct SobolTable {
  Directions v;
  alignas(64) std::array<std::uint64_t, 64> words;  ///< of the first indices
  std::array<std::uint64_t, 27> steps;              ///< v_6 ^ … ^ v_(6+t), and 0 behind the end
};

constexpr auto sobol_tables = [] {
  std::array<SobolTable, joe_kuo.size()> all{};
  for (std::size_t d = 0; d < all.size(); ++d) {
    const Directions v = all[d].v = directions_of(joe_kuo[d]);
    for (std::uint64_t t = 0, sum = 0; t < 26; ++t) all[d].steps[t] = sum ^= wide(v[t + 6]);
    for (std::size_t i = 0; i < 64; ++i) all[d].words[i] = wide(sobol_word(v, i));
  }
  return all;
}();
}  // namespace

namespace definition {
void sobol(unsigned dimension, std::uint64_t first, std::span<double> column) {
  const Directions v = directions_of(joe_kuo[dimension]);
  for (std::size_t i = 0; i < column.size(); ++i) column[i] = sobol_word(v, first + i) * 0x1p-32;
}
}  // namespace definition

// As in 5.2, the last 6 bits go through the same words in every block, and the bits above bring
// one word to a whole block. From block n - 1 to n, which ends in t zeros, it changes by v_6 ^ … ^
// v_(6+t). A double in [1, 2) *is* a word: 20 zero bits behind the 32 of the coordinate, before it
// the exponent of 1. A load, an XOR, the subtraction of 1 and a store are left for a value.

void sobol(unsigned dimension, std::uint64_t first, std::span<double> column) {
  if (dimension >= joe_kuo.size()) throw std::invalid_argument("dimension: there are only 32");
  require_indices(first, column.size(), 0xffffffffu);
  const SobolTable& table = sobol_tables[dimension];
  std::uint64_t n = first / 64, above = bits(1) | wide(sobol_word(table.v, 64 * n));
  for (std::size_t skip = first % 64; !column.empty(); skip = 0) {
    const std::uint64_t* const words = table.words.data() + skip;
    double* const x = column.data();  // an array's or a span's index may be checked, one by one
    const std::size_t count = std::min(64 - skip, column.size());
    for (std::size_t i = 0; count == 64 && i < 64; ++i) x[i] = number(words[i] ^ above) - 1;
    for (std::size_t i = 0; count < 64 && i < count; ++i) x[i] = number(words[i] ^ above) - 1;
    column = column.subspan(count);
    above ^= table.steps[std::size_t(std::countr_zero(++n))];
  }
}

// 5.6 --------------------------------------------------------------------------------------------
double star_discrepancy(std::span<const double> x) {
  require_points(x, "x");
  std::vector<double> sorted(x.begin(), x.end());
  std::sort(sorted.begin(), sorted.end());
  const double n = double(x.size());
  // The worst interval ends at a point: just before it, with i points inside, or just behind it.
  double worst = 0;
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    worst = std::max({worst, sorted[i] - double(i) / n, double(i + 1) / n - sorted[i]});
  }
  return worst;
}

double star_discrepancy(std::span<const double> x, std::span<const double> y) {
  if (x.size() != y.size()) throw std::invalid_argument("x and y: sizes differ");
  require_points(x, "x");
  require_points(y, "y");
  std::vector<std::array<double, 2>> points{{1, 1}};  // the last: where the square ends
  for (std::size_t i = 0; i < x.size(); ++i) points.push_back({x[i], y[i]});
  std::sort(points.begin(), points.end());
  // The worst box has its corner on coordinates of points, or on 1. From left to right, `ys` holds
  // the points so far, sorted: up to the k-th of them a closed box that ends at `here` has k points
  // or more; an open one that ends at `next` and the k + 1st, k or fewer. (k but for equal ones.)
  std::vector<double> ys{0, 1};
  double worst = 0, here = 0;
  for (const auto& [next, value] : points) {
    for (std::size_t k = 0; k + 1 < ys.size(); ++k) {
      const double inside = double(k) / double(x.size());
      worst = std::max(worst, std::max(inside - here * ys[k], next * ys[k + 1] - inside));
    }
    ys.insert(std::upper_bound(ys.begin() + 1, ys.end() - 1, value), value);
    here = next;
  }
  return worst;
}

// 5.7 --------------------------------------------------------------------------------------------
void random_shift(PointSet& points, Rng& rng) {
  for (std::size_t d = 0; d < points.dims(); ++d) {
    const double shift = double(rng() >> 11) * 0x1p-53;
    for (double& value : points.column(d)) {
      value += shift;
      if (value >= 1) value -= 1;  // also where the sum was rounded up to 1
    }
  }
}

// 5.8 --------------------------------------------------------------------------------------------
namespace definition {
void owen_scramble(std::span<double> column, std::uint64_t seed) {
  const std::uint64_t hashed = mix_bits(mix_bits(seed) + 1);  // seeds may follow each other
  for (double& value : column) {
    const auto word = static_cast<std::uint64_t>(value * 0x1p53) << 11;
    std::uint64_t flips = 0;
    for (unsigned k = 0; k < 53; ++k) {
      const std::uint64_t before = k == 0 ? 0 : word >> (64 - k);
      flips |= mix_bits(mix_bits(hashed ^ before) + k) >> 63 << (63 - k);
    }
    value = double((word ^ flips) >> 11) * 0x1p-53;
  }
}
}  // namespace definition

// That is 53 times two hashes. Mirror the word: now additions and multiplications flip each bit by
// those before it, since carries run upwards (Laine, Karras 2011). Two words that agree in k bits
// differ by 2^k times an odd number. z -> m z + s with a random odd m makes it *any* odd number, a
// random s moves the pair anywhere, as nested scrambling does: every variance, made of pairs, is
// Owen's. The fixed steps z -> z ^ z c, c even, break up the lattice that three words would lie on
// (Vegdahl 2021; the handout has the kurtosis). Vector registers multiply 32 bits at a time: a hash
// of these flips the 21 behind, which Sobol' points do not have.

void owen_scramble(std::span<double> column, std::uint64_t seed) {
  Rng rng(seed);
  const std::uint64_t one = rng(), two = rng();
  const std::uint32_t m = std::uint32_t(one) | 1, s = std::uint32_t(one >> 32);
  const std::uint32_t a = std::uint32_t(two) | 1, b = std::uint32_t(two >> 32);
  const auto scrambled = [=](std::uint32_t z) {  // the first 32 bits, mirrored
    z ^= z * 0x3d20adeau;
    z = z * m + s;
    z ^= z * 0x05526c56u;
    return z ^ z * 0x53a22864u;
  };
  const auto behind = [=](std::uint32_t z) {  // a hash of them: its upper 21 bits flip those behind
    z = (z ^ z >> 16) * a;
    return (z ^ z >> 15) * 0x846ca68bu + b;
  };
  const auto rest = [](double x) { return x - ((x + 0x1p20) - 0x1p20); };  // past 32 bits, rounded
  constexpr std::size_t block = 256;  // short loops fill a processor's registers better
  std::uint32_t words[block], flips[block];
  for (; !column.empty(); column = column.subspan(std::min(block, column.size()))) {
    double* const x = column.data();
    const std::size_t size = std::min(block, column.size());
    std::uint64_t longer = 0;
    for (std::size_t i = 0; i < size; ++i) {
      words[i] = std::uint32_t(bits(x[i] + 0x1p20));
      longer |= bits(rest(x[i]));
    }
    const std::size_t rests = longer == 0 ? 0 : size;  // Sobol' points have none
    for (std::size_t i = 0; i < rests; ++i) words[i] -= rest(x[i]) < 0;
    for (std::size_t i = 0; i < size; ++i) words[i] = mirrored(words[i]);
    for (std::size_t i = 0; i < size; ++i) words[i] = scrambled(words[i]);
    for (std::size_t i = 0; i < size; ++i) flips[i] = behind(words[i]);
    for (std::size_t i = 0; i < rests; ++i) {  // nested too: zeros behind stay zeros
      const std::uint32_t last = std::uint32_t(bits(rest(x[i]) + 0.75)) << 11;
      flips[i] ^= mirrored(mirrored(last) * (behind(~words[i]) | 1));
    }
    for (std::size_t i = 0; i < size; ++i) words[i] = mirrored(words[i]);
    for (std::size_t i = 0; i < size; ++i) {
      x[i] = number(bits(1) | wide(words[i])) - 1.5 + number(bits(0.5) | flips[i] >> 11);
    }
  }
}

// 5.9 --------------------------------------------------------------------------------------------
// A permutation for each position; at most of them, a column has zeros only. What zeros become are
// digits of one uniform number, drawn first; what is left of it behind those in use is `zeros`.

void radical_inverses_scrambled(unsigned base, std::uint64_t first, std::span<double> column,
                                std::uint64_t seed) {
  require_base(base);
  if (base > 65536) throw std::invalid_argument("base: more than 2^16 digits to permute");
  require_indices(first, column.size(), last_index);
  Rng rng(mix_bits(seed ^ mix_bits(base)));
  const unsigned used = std::max(1u, digits_of(first + (column.size() - 1), base));
  Digits digits{base, std::vector<unsigned>(std::size_t{used} * base)};
  digits.zeros = double(rng() >> 11) * 0x1p-53;
  for (auto row = digits.permutations.begin(); row != digits.permutations.end(); row += base) {
    std::iota(row, row + base, 0u);
    digits.zeros *= base;
    const auto of_zero = unsigned(digits.zeros);
    digits.zeros -= of_zero;
    std::swap(row[0], row[of_zero]);
    for (unsigned i = 1; i + 1 < base; ++i) std::swap(row[i], row[any_digit(i, base, rng)]);
  }
  fill(column, first, digits);
}

}  // namespace mc
