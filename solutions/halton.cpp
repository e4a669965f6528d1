// Lab 5, the reference solution. A speed task has its definition first, then a faster version.

#include "halton.hpp"
#include "common/choices.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <numeric>
#include <stdexcept>
#include <string>

namespace mc {
namespace {
constexpr double below_one = 1 - 0x1p-53;  // the largest double below 1
constexpr std::uint64_t last_index = ~std::uint64_t{0};

void require_base(unsigned base) {
  if (base < 2) throw std::invalid_argument("base: must be at least 2");
}

void require_indices(std::uint64_t first, std::size_t count, std::uint64_t last) {
  if (first > last || (count > 0 && count - 1 > last - first))
    throw std::invalid_argument("first: the indices run past the end of the sequence");
}

void require_points(std::span<const double> x, const std::string& name) {
  if (x.empty()) throw std::invalid_argument(name + ": no points");
  const auto out = [](double value) { return !(value >= 0 && value <= 1); };
  if (std::any_of(x.begin(), x.end(), out)) throw std::invalid_argument(name + ": not in [0, 1]");
}
}  // namespace

// 5.1 --------------------------------------------------------------------------------------------
double radical_inverse(unsigned base, std::uint64_t index) {
  require_base(base);
  if (index == 0) return 0;
  // The last digit comes first, followed by the radical inverse of the others. A division shrinks
  // the earlier rounding errors: the error is below 2 * 2^-53. 54 ones would round to 1.
  const double others = radical_inverse(base, index / base);
  return std::min(below_one, (static_cast<double>(index % base) + others) / base);
}

// 5.2 --------------------------------------------------------------------------------------------
namespace definition {
void radical_inverses(unsigned base, std::uint64_t first, std::span<double> column) {
  for (std::size_t i = 0; i < column.size(); ++i) column[i] = radical_inverse(base, first + i);
}
}  // namespace definition

// The definition divides once per digit. But k digits in base b are one digit in base b^k: a table
// holds the integers that the k last digits form when they are mirrored. A block of b^k consecutive
// indices uses the whole table with one value of `others`, and those of consecutive blocks are
// radical inverses of consecutive indices: the same problem, b^k times smaller.

namespace {
/// Entries of the table of a block: at most 8 KB, a quarter of the first-level cache.
constexpr std::size_t largest_table = 1024;

/// Extends a table of `size` entries, one for each string of digits, to strings with one digit more
/// at the front. The digit 0 is last: it overwrites what the others are computed from.
template <class Entry>
void append_digit(Entry* table, std::size_t size, unsigned base, auto append) {
  for (unsigned digit = base; digit-- > 0;) {
    std::transform(table, table + size, table + digit * size, append(digit));
  }
}

/// Writes the values of consecutive indices, by blocks of table.size(); the first is at `start` in
/// its block. value_in(k), called for block k = 0, 1, … in this order, maps an entry to a value.
template <class Entry>
void fill_by_blocks(std::span<double> column, std::size_t start, std::span<const Entry> table,
                    auto value_in) {
  for (std::size_t k = 0; !column.empty(); ++k, start = 0) {
    const auto part = table.subspan(start, std::min(table.size() - start, column.size()));
    std::transform(part.begin(), part.end(), column.begin(), value_in(k));
    column = column.subspan(part.size());
  }
}
}  // namespace

void radical_inverses(unsigned base, std::uint64_t first, std::span<double> column) {
  require_base(base);
  require_indices(first, column.size(), last_index);
  if (column.size() <= 2 || base > largest_table)
    return definition::radical_inverses(base, first, column);
  std::array<double, largest_table> table;
  std::iota(table.begin(), table.begin() + base, 0);
  std::size_t size = base;
  for (; size * base <= std::min(largest_table, column.size()); size *= base) {
    append_digit(table.data(), size, base, [=](unsigned digit) {
      return [=](double digits) { return digits * base + digit; };
    });
  }
  // `others` is stored at the end of the column: each value is read before it is overwritten.
  const auto others = column.last((first % size + column.size() - 1) / size + 1);
  radical_inverses(base, first / size, others);
  // The step of 5.1 with `size` in place of the base. The sum must not be rounded up to `size`,
  // hence the minimum: it changes a value by 2 * 2^-53 at most. Three roundings add as much.
  const auto digits = std::span<const double>(table).first(size);
  fill_by_blocks(column, first % size, digits,
                 [next = others.begin(), whole = static_cast<double>(size)](std::size_t) mutable {
                   return [rest = std::min(*next++, 1 - 0x1p-52 * whole),
                           scale = 1 / whole](double last) { return (last + rest) * scale; };
                 });
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
  for (std::size_t d = 0; d < points.dims(); ++d)
    radical_inverses(bases[d], first, points.column(d));
}

// 5.4 --------------------------------------------------------------------------------------------
void hammersley(PointSet& points) {
  const auto x = points.column(0);
  std::iota(x.begin(), x.end(), 0.0);
  for (double& value : x) value /= static_cast<double>(x.size());
  const auto bases = primes(points.dims() - 1);
  for (std::size_t d = 1; d < points.dims(); ++d)
    radical_inverses(bases[d - 1], 0, points.column(d));
}

// 5.5 --------------------------------------------------------------------------------------------
namespace definition {
using Directions = std::array<std::uint32_t, 32>;

/// What bit k of the index contributes (Bratley, Fox 1988, "Algorithm 659", equations 2 and 3).
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

/// The XOR of the direction numbers of the bits that are set in `index`.
constexpr std::uint32_t sobol_word(const Directions& v, std::uint64_t index) {
  std::uint32_t word = 0;
  for (unsigned k = 0; k < 32; ++k) word ^= v[k] & -(static_cast<std::uint32_t>(index) >> k & 1);
  return word;
}

void sobol(unsigned dimension, std::uint64_t first, std::span<double> column) {
  const Directions v = directions_of(joe_kuo[dimension]);
  for (std::size_t i = 0; i < column.size(); ++i) column[i] = sobol_word(v, first + i) * 0x1p-32;
}
}  // namespace definition

// As in 5.2, a table covers the 8 lowest bits of the index, and the others contribute one word per
// block. A double in [1, 2) is the exponent of 1, the 32 bits of the coordinate, and 20 zeros.

namespace {
constexpr auto bits = [](double value) { return std::bit_cast<std::uint64_t>(value); };
constexpr auto number = [](std::uint64_t word) { return std::bit_cast<double>(word); };
constexpr auto upper_half = [](std::uint64_t w) { return static_cast<std::uint32_t>(w >> 32); };
constexpr auto lower_half = [](std::uint64_t w) { return static_cast<std::uint32_t>(w); };
constexpr auto wide = [](std::uint32_t word) { return std::uint64_t{word} << 20; };
/// The double in [0, 1) whose first 32 bits after the point are `upper`, and the next 21 `lower`.
constexpr auto joined = [](std::uint64_t upper, std::uint64_t lower) {
  return number(bits(1) | upper << 20) - 1.5 + number(bits(0.5) | lower);
};

struct SobolTable {
  definition::Directions v;
  std::array<std::uint64_t, 256> words;  ///< the doubles 1 + x of indices 0 … 255, as bits
};

constexpr auto sobol_tables = [] {
  std::array<SobolTable, joe_kuo.size()> all{};
  for (std::size_t d = 0; d < all.size(); ++d) {
    auto& [v, words] = all[d];
    v = definition::directions_of(joe_kuo[d]);
    words[0] = bits(1);
    for (std::size_t i = 1; i < words.size(); ++i)  // that without the lowest bit is known
      words[i] = words[i & (i - 1)] ^ wide(v[std::countr_zero(i)]);
  }
  return all;
}();
}  // namespace

void sobol(unsigned dimension, std::uint64_t first, std::span<double> column) {
  if (dimension >= joe_kuo.size()) throw std::invalid_argument("dimension: must be below 32");
  require_indices(first, column.size(), 0xffffffffu);
  const auto& [v, words] = sobol_tables[dimension];
  const auto value_in = [&v = v, block = first / 256](std::size_t k) {
    const auto above = wide(definition::sobol_word(v, 256 * (block + k)));
    return [=](std::uint64_t word) { return number(word ^ above) - 1; };
  };
  fill_by_blocks(column, first % 256, std::span<const std::uint64_t>(words), value_in);
}

// 5.6 --------------------------------------------------------------------------------------------
double star_discrepancy(std::span<const double> x) {
  require_points(x, "x");
  std::vector<double> sorted(x.begin(), x.end());
  std::sort(sorted.begin(), sorted.end());
  const auto n = static_cast<double>(x.size());
  // The worst interval ends at a point: [0, x_i) contains i points, [0, x_i] contains i + 1.
  double worst = 0;
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    worst = std::max({worst, sorted[i] - static_cast<double>(i) / n,
                      static_cast<double>(i + 1) / n - sorted[i]});
  }
  return worst;
}

double star_discrepancy(std::span<const double> x, std::span<const double> y) {
  if (x.size() != y.size()) throw std::invalid_argument("x and y: sizes differ");
  require_points(x, "x");
  require_points(y, "y");
  std::vector<std::array<double, 2>> points{{1, 1}};  // the corner of the square
  for (std::size_t i = 0; i < x.size(); ++i) points.push_back({x[i], y[i]});
  std::sort(points.begin(), points.end());
  // Sweep from left to right; `ys` holds the y coordinates of the points so far, sorted, after a 0
  // and before a 1. The closed box up to (here, ys[k]) contains at least k points; the open box up
  // to (next, ys[k + 1]) contains at most k. (Both contain exactly k if all coordinates differ.)
  std::vector<double> ys{0, 1};
  double worst = 0, here = 0;
  for (const auto& [next, value] : points) {
    for (std::size_t k = 0; k + 1 < ys.size(); ++k) {
      const double inside = static_cast<double>(k) / static_cast<double>(x.size());
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
    const double shift = static_cast<double>(rng() >> 11) * 0x1p-53;
    for (double& value : points.column(d)) {
      value += shift;
      if (value >= 1) value -= 1;  // also where the sum was rounded up to 1
    }
  }
}

// 5.8 --------------------------------------------------------------------------------------------
namespace definition {
void owen_scramble(std::span<double> column, std::uint64_t seed) {
  const std::uint64_t hashed = mix_bits(mix_bits(seed) + 1);  // seeds may be consecutive
  for (double& value : column) {
    const auto word = static_cast<std::uint64_t>(value * 0x1p53) << 11;
    std::uint64_t flips = 0;
    for (unsigned k = 0; k < 53; ++k) {
      const std::uint64_t before = k == 0 ? 0 : word >> (64 - k);
      flips |= mix_bits(mix_bits(hashed ^ before) + k) >> 63 << (63 - k);
    }
    value = static_cast<double>((word ^ flips) >> 11) * 0x1p-53;
  }
}
}  // namespace definition

// The definition evaluates two hashes for each of 53 bits. In a mirrored word, where the first bit
// is the lowest, sums and products flip all bits at once, each depending on the bits before it,
// because carries propagate upward (Laine, Karras 2011). One step z -> m z + s with random m and s
// makes all pairs of decisions independent, so the variance is Owen's; two of them, with a fixed
// step z -> z ^ z c between, c = 2 mod 4, all threes and fours of the first four bits. The other
// fixed step helps larger groups (Vegdahl 2021). docs/going-faster.md says why. Vector registers
// multiply 32 bits at a time: a hash of the first 32 flips the others, which are 0 in Sobol'
// points.

namespace {
constexpr std::uint32_t mirrored(std::uint32_t word) {
  word = (word >> 1 & 0x55555555u) | (word & 0x55555555u) << 1;
  word = (word >> 2 & 0x33333333u) | (word & 0x33333333u) << 2;
  word = (word >> 4 & 0x0f0f0f0fu) | (word & 0x0f0f0f0fu) << 4;
  return __builtin_bswap32(word);
}

/// Scrambles mirrored words by two random words.
struct NestedHash {
  std::uint64_t one, two;

  std::uint32_t operator()(std::uint32_t z) const {
    z ^= z * 0x3d20adeau;
    z = z * (lower_half(one) | 1) + upper_half(one);
    z ^= z * 0x05526c56u;
    return z * (lower_half(two) | 1) + upper_half(two);
  }
};
}  // namespace

void owen_scramble(std::span<double> column, std::uint64_t seed) {
  Rng rng(seed);
  const std::uint64_t one = rng(), two = rng(), three = rng();
  const NestedHash scrambled{one, two};
  const auto hash = [=](std::uint32_t z) {  // its upper 21 bits flip the lower 21 of a value
    z = (z ^ z >> 16) * (lower_half(three) | 1);
    return (z ^ z >> 15) * 0x846ca68bu + upper_half(three);
  };
  // x minus x rounded to 32 bits. It is negative if x was rounded up.
  const auto rest = [](double x) { return x - ((x + 0x1p20) - 0x1p20); };
  constexpr std::size_t block = 256;  // short loops over a block are vectorized
  std::uint32_t words[block], flips[block];
  for (; !column.empty(); column = column.subspan(std::min(block, column.size()))) {
    double* const x = column.data();
    const std::size_t size = std::min(block, column.size());
    std::uint64_t longer = 0;
    for (std::size_t i = 0; i < size; ++i) {
      words[i] = lower_half(bits(x[i] + 0x1p20));
      longer |= bits(rest(x[i]));
    }
    const std::size_t rests = longer == 0 ? 0 : size;  // 0 for Sobol' points: they have 32 bits
    for (std::size_t i = 0; i < rests; ++i) words[i] -= rest(x[i]) < 0;
    for (std::size_t i = 0; i < size; ++i) words[i] = mirrored(words[i]);
    for (std::size_t i = 0; i < size; ++i) words[i] = scrambled(words[i]);
    for (std::size_t i = 0; i < size; ++i) flips[i] = hash(words[i]);
    for (std::size_t i = 0; i < rests; ++i) {  // nested, too: by a hash for each first 32 bits
      const std::uint32_t last = mirrored(lower_half(bits(rest(x[i]) + 0.75)) << 11);
      const NestedHash of_string{mix_bits(words[i] ^ one), mix_bits(words[i] ^ two)};
      flips[i] ^= mirrored(of_string(last) ^ of_string(0));
    }
    for (std::size_t i = 0; i < size; ++i) words[i] = mirrored(words[i]);
    for (std::size_t i = 0; i < size; ++i) x[i] = joined(words[i], flips[i] >> 11);
  }
}

// 5.9 --------------------------------------------------------------------------------------------
// A value is a sum of integers in units of 2^-64, modulo 1: that of index 0, which is a random
// word, and the change that each nonzero digit makes to it. Its digits are the images of 0. Sums of
// integers do not depend on the order of their terms, so an index has one value in all columns. The
// permutations are drawn digit by digit, up to the largest that an index has: few indices need few.

namespace {
/// Writes the images of the first `count` digits of a random permutation that maps 0 to `zero`.
void permute_digits(std::span<std::uint64_t> row, unsigned count, std::size_t zero, Choices& any) {
  std::uint64_t* const image = row.data();  // a span may check every index
  std::iota(image, image + row.size(), 0u);
  std::swap(image[0], image[zero]);
  for (std::size_t k = 1; k < count; ++k) std::swap(image[k], image[k + any.below(row.size() - k)]);
}
}  // namespace

void radical_inverses_scrambled(unsigned base, std::uint64_t first, std::span<double> column,
                                std::uint64_t seed) {
  require_base(base);
  if (base > 65536) throw std::invalid_argument("base: must be at most 2^16");
  require_indices(first, column.size(), last_index);
  if (column.empty()) return;
  Rng rng(seed ^ mix_bits(base));
  const std::uint64_t value_of_zero = rng();
  Choices any(rng);
  // As in 5.2, a table of the last digits, while it is small. The moves of the digits before them
  // are stored after it. On the stack: an allocation would cost more than a few points.
  std::array<std::uint64_t, 2 * largest_table> stack;
  std::vector<std::uint64_t> heap(base > 64 ? largest_table + 12 * base : 0);
  std::uint64_t* const table = heap.empty() ? stack.data() : heap.data();
  std::uint64_t* const moves = table + std::max<std::size_t>(base, largest_table);
  table[0] = value_of_zero;
  std::size_t size = 1, used = 0;
  std::uint64_t unit = last_index, fraction = 0xffffffff;  // 1, as 64 bits and the next 32
  auto zeros = static_cast<unsigned __int128>(value_of_zero);
  for (auto n = first + (column.size() - 1); n > 0; n /= base) {
    fraction = ((unit % base) << 32 | fraction) / base;
    unit /= base;
    zeros = (zeros & last_index) * base;
    const auto zero = static_cast<std::size_t>(zeros >> 64);
    const auto count = static_cast<unsigned>(std::min<std::uint64_t>(n, base - 1)) + 1;
    std::uint64_t* const row = moves + used;
    permute_digits({row, base}, count, zero, any);
    const auto worth = [=](std::uint64_t digit) { return digit * unit + (digit * fraction >> 32); };
    for (std::size_t k = 0; k < count; ++k) row[k] = worth(row[k]) - worth(zero);
    if (used == 0 && size < column.size() && (size == 1 || size * base <= largest_table)) {
      append_digit(table, size, count, [=](unsigned digit) {
        return [move = row[digit]](std::uint64_t sum) { return sum + move; };
      });
      size *= count;
    } else {
      used += base;
    }
  }
  const auto value_in = [=, block = first / size](std::size_t k) {
    std::uint64_t above = 0, position = 0;
    for (auto n = block + k; n > 0; n /= base) above += moves[position++ * base + n % base];
    return [=](std::uint64_t sum) {
      return joined((sum + above) >> 32, (sum + above) >> 11 & 0x1fffff);
    };
  };
  fill_by_blocks(column, first % size, std::span<const std::uint64_t>(table, size), value_in);
}

// 5.10 -------------------------------------------------------------------------------------------
void lattice(PointSet& points, std::uint64_t seed) {
  if (points.dims() > lattice_vector.size())
    throw std::invalid_argument("points: more than 16 dimensions");
  const std::uint64_t n = points.size();
  for (std::size_t d = 0; d < points.dims(); ++d) {
    for (std::uint64_t i = 0; double& x : points.column(d))
      x = static_cast<double>(i++ * lattice_vector[d] % n) / static_cast<double>(n);
  }
  Rng rng(seed);
  random_shift(points, rng);
}

void tent(std::span<double> column) {
  for (double& x : column) x = std::min(below_one, 2 * std::min(x, 1 - x));  // 1/2 gives no 1
}

}  // namespace mc
