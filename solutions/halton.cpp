// Lab 5 · Halton and quasi-Monte Carlo: the reference solution. Speed tasks: as defined, then fast.

#include "halton.hpp"
#include "common/choices.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <memory_resource>
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
  // The last digit comes first, then the inverse of the others. Small terms are added first, and
  // each division shrinks the errors so far, so that 2 * 2^-53 remain. In base 2, 54 ones would
  // round to 1.
  const double others = radical_inverse(base, index / base);
  return std::min(below_one, (double(index % base) + others) / base);
}

// 5.2 --------------------------------------------------------------------------------------------
namespace definition {
void radical_inverses(unsigned base, std::uint64_t first, std::span<double> column) {
  for (std::size_t i = 0; i < column.size(); ++i) column[i] = radical_inverse(base, first + i);
}
}  // namespace definition

// The definition divides once per digit. But k digits in base b are one digit in base b^k, so 5.1
// can take k of them in one step, (digit + others) / b^k, where `digit` is k digits, mirrored. A
// table holds all b^k of these whole numbers exactly. A block of b^k indices uses the whole table
// with one value of `others`, and the `others` of successive blocks are again a column of radical
// inverses, a shorter one.

namespace {
/// The step of 5.1 with `size` in place of the base. A sum 2^-52 size below the size is not rounded
/// up to 1. Staying there is wrong by 2 * 2^-53 at most; sum, scale and product are rounded by
/// 2 * 2^-53 more.
auto step_of(double size, double others) {
  return [rest = std::min(others, 1 - 0x1p-52 * size), scale = 1 / size](double digits) {
    return (digits + rest) * scale;
  };
}

/// The steps of a column that begins `skip` places after the beginning of a block. `digits` are
/// those of a block, mirrored. `others`, one for each block, may be at the column's end: they
/// are read before they are overwritten.
void step(std::span<double> column, std::size_t skip, std::span<const double> digits,
          std::span<const double> others) {
  for (const double other : others) {
    const auto part = digits.subspan(skip, std::min(digits.size() - skip, column.size()));
    std::transform(part.begin(), part.end(), column.begin(), step_of(double(digits.size()), other));
    column = column.subspan(part.size()), skip = 0;
  }
}
}  // namespace

void radical_inverses(unsigned base, std::uint64_t first, std::span<double> column) {
  require_base(base);
  require_indices(first, column.size(), last_index);
  constexpr std::size_t largest = 1024;  // values of a table: a quarter of the first-level cache
  if (column.size() <= 2 || base > largest) {
    return definition::radical_inverses(base, first, column);
  }
  std::array<double, largest> table;
  std::iota(&table[0], &table[base], 0);
  std::size_t block = base;
  for (; block * base <= std::min(largest, column.size()); block *= base) {
    for (unsigned digit = base; digit-- > 0;) {  // 0 comes last: it overwrites what is appended to
      const auto append = [=](double x) { return x * base + digit; };
      std::transform(&table[0], &table[block], &table[digit * block], append);
    }
  }
  const auto others = column.last((first % block + column.size() - 1) / block + 1);
  radical_inverses(base, first / block, others);
  step(column, first % block, std::span(table).first(block), others);
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
  const auto x = points.column(0);
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = double(i) / double(x.size());
  const auto bases = primes(points.dims() - 1);
  for (std::size_t d = 1; d < points.dims(); ++d) {
    radical_inverses(bases[d - 1], 0, points.column(d));
  }
}

// 5.5 --------------------------------------------------------------------------------------------
namespace definition {
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
std::uint32_t sobol_word(const Directions& v, std::uint64_t index) {
  std::uint32_t word = 0;
  for (unsigned k = 0; k < 32; ++k) word ^= v[k] & -(std::uint32_t(index) >> k & 1);
  return word;
}

void sobol(unsigned dimension, std::uint64_t first, std::span<double> column) {
  const Directions v = directions_of(joe_kuo[dimension]);
  for (std::size_t i = 0; i < column.size(); ++i) column[i] = sobol_word(v, first + i) * 0x1p-32;
}
}  // namespace definition

// As in 5.2, a table covers the last 8 bits, and the bits above them contribute one word per block.
// A double in [1, 2) consists of the exponent of 1, the 32 bits of the coordinate and 20 zeros. So
// a value takes one load, one XOR, one subtraction of 1 and one store.

namespace {
constexpr auto bits = [](double value) { return std::bit_cast<std::uint64_t>(value); };
constexpr auto number = [](std::uint64_t word) { return std::bit_cast<double>(word); };
constexpr auto wide = [](std::uint32_t word) { return std::uint64_t{word} << 20; };
/// The double whose first 32 bits after the point are `upper`, and whose last 21 bits are `lower`.
constexpr auto joined = [](std::uint64_t upper, std::uint64_t lower) {
  return number(bits(1) | upper << 20) - 1.5 + number(bits(0.5) | lower);
};

struct SobolTable {
  definition::Directions v;
  std::array<std::uint64_t, 256> words;  ///< of the first indices, with the exponent of 1
};

constexpr auto sobol_tables = [] {
  std::array<SobolTable, joe_kuo.size()> all{};
  for (std::size_t d = 0; d < all.size(); ++d) {
    auto& [v, words] = all[d];
    v = definition::directions_of(joe_kuo[d]);
    words[0] = bits(1);
    for (std::size_t i = 1; i < words.size(); ++i) {
      words[i] = words[i & (i - 1)] ^ wide(v[std::size_t(std::countr_zero(i))]);  // its lowest bit
    }
  }
  return all;
}();
}  // namespace

void sobol(unsigned dimension, std::uint64_t first, std::span<double> column) {
  if (dimension >= joe_kuo.size()) throw std::invalid_argument("dimension: there are only 32");
  require_indices(first, column.size(), 0xffffffffu);
  const auto& [v, words] = sobol_tables[dimension];
  std::uint64_t n = first / 256;
  for (std::size_t skip = first % 256; !column.empty(); skip = 0, ++n) {
    const auto part = std::span(words).subspan(skip, std::min(256 - skip, column.size()));
    const auto above = wide(definition::sobol_word(v, 256 * n));
    const auto value = [=](std::uint64_t word) { return number(word ^ above) - 1; };
    std::transform(part.begin(), part.end(), column.begin(), value);
    column = column.subspan(part.size());
  }
}

// 5.6 --------------------------------------------------------------------------------------------
double star_discrepancy(std::span<const double> x) {
  require_points(x, "x");
  std::vector<double> sorted(x.begin(), x.end());
  std::sort(sorted.begin(), sorted.end());
  const double n = double(x.size());
  // The worst interval ends at a point: just before it, with i points inside, or just after it,
  // with i + 1.
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

// The definition takes two hashes for each of 53 bits. Mirror the word instead: now additions and
// multiplications flip each bit depending on those before it, since carries propagate upward
// (Laine, Karras 2011). Two words that agree in k bits differ by 2^k times an odd number. z -> m z
// + s with a random odd m makes it *any* odd number, a random s moves the pair anywhere, as nested
// scrambling does: every variance, made of pairs, is Owen's. The fixed steps z -> z ^ z c, c even,
// break up the lattice that three words would lie on (Vegdahl 2021; the handout has the kurtosis).
// Four words are not quite independent: of the flips of the fourth bit, the product of four signs
// has the mean -1/4 in the worst case, not 0. That is in no variance, only in fourth powers of
// errors of few points. Vector registers multiply 32 bits at a time: a hash of these flips the
// remaining 21, which are zero in Sobol' points.

static constexpr std::uint32_t mirrored(std::uint32_t word) {
  word = (word >> 1 & 0x55555555u) | (word & 0x55555555u) << 1;
  word = (word >> 2 & 0x33333333u) | (word & 0x33333333u) << 2;
  word = (word >> 4 & 0x0f0f0f0fu) | (word & 0x0f0f0f0fu) << 4;
  return __builtin_bswap32(word);
}

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
  const auto lower = [=](std::uint32_t z) {  // a hash of them: its upper 21 bits flip the lower 21
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
    for (std::size_t i = 0; i < size; ++i) flips[i] = lower(words[i]);
    for (std::size_t i = 0; i < rests; ++i) {  // nested too; trailing zeros stay zeros
      const std::uint32_t last = mirrored(std::uint32_t(bits(rest(x[i]) + 0.75)) << 11);
      const std::uint64_t random = mix_bits(words[i] ^ one);
      const std::uint32_t odd = std::uint32_t(random) | 1, add = std::uint32_t(random >> 32);
      flips[i] ^= mirrored((last * odd + add) ^ add);
    }
    for (std::size_t i = 0; i < size; ++i) words[i] = mirrored(words[i]);
    for (std::size_t i = 0; i < size; ++i) {
      x[i] = joined(words[i], flips[i] >> 11);
    }
  }
}

// 5.9 --------------------------------------------------------------------------------------------
// A value is a sum of whole numbers, in units of 2^-64 and modulo 1: the value of index 0, which is
// a random word, and for each digit of the index what it adds to that. Whole numbers have the same
// sum in any order, so a value is the same to the last bit in every column. The digits of the
// random word are those that the permutations map 0 to, down to 2^-64.

namespace {
/// What the digits at one position add to a value: a random permutation, as units of 2^-64.
void fill_moves(std::span<std::uint64_t> row, std::size_t zero, unsigned __int128 unit, Rng rng) {
  std::iota(row.begin(), row.end(), 0u);
  std::swap(row[0], row[zero]);
  Choices any(rng);
  for (std::size_t k = row.size() - 1; k > 1; --k) std::swap(row[k], row[1 + any.below(k)]);
  const auto units = [=](std::uint64_t digit) { return std::uint64_t(digit * unit >> 64); };
  for (std::uint64_t& digit : row) digit = units(digit) - units(zero);
}
}  // namespace

void radical_inverses_scrambled(unsigned base, std::uint64_t first, std::span<double> column,
                                std::uint64_t seed) {
  require_base(base);
  if (base > 65536) throw std::invalid_argument("base: more than 2^16 digits to permute");
  require_indices(first, column.size(), last_index);
  if (column.empty()) return;
  const std::uint64_t hashed = mix_bits(seed ^ mix_bits(base));
  const std::uint64_t value_of_zero = Rng(hashed)();

  std::array<std::byte, 16384> stack;  // few points cost no more than a piece of memory does
  std::pmr::monotonic_buffer_resource memory(stack.data(), stack.size());
  std::pmr::vector<std::uint64_t> moves(&memory);  // of position 0, of position 1, …
  moves.reserve(4 * base);
  auto unit = ~static_cast<unsigned __int128>(0);
  auto zeros = static_cast<unsigned __int128>(value_of_zero);
  for (auto n = first + (column.size() - 1); n > 0; n /= base) {
    unit /= base;
    zeros = (zeros & last_index) * base;
    moves.resize(moves.size() + base);
    fill_moves(std::span(moves).last(base), std::size_t(zeros >> 64), unit,
               Rng(hashed + moves.size() / base));
  }

  // As in 5.2, a table has the sums for the last digits, as many as are worth it.
  constexpr std::size_t largest = 1024;
  std::pmr::vector<std::uint64_t> table({value_of_zero}, &memory);
  auto rows = std::span<const std::uint64_t>(moves);
  while (table.size() < column.size() && (table.size() == 1 || table.size() * base <= largest)) {
    const std::size_t size = table.size();
    table.resize(size * base);
    for (std::size_t digit = base; digit-- > 0;) {
      const auto append = [move = rows[digit]](std::uint64_t sum) { return sum + move; };
      std::transform(&table[0], &table[0] + size, &table[digit * size], append);
    }
    rows = rows.subspan(base);
  }
  std::uint64_t block = first / table.size();
  for (std::size_t skip = first % table.size(); !column.empty(); skip = 0, ++block) {
    std::uint64_t above = 0, position = 0;
    for (auto n = block; n > 0; n /= base) above += rows[position++ * base + n % base];
    const auto part = std::span(table).subspan(skip, std::min(table.size() - skip, column.size()));
    const auto value = [=](std::uint64_t sum) {
      return joined((sum + above) >> 32, (sum + above) >> 11 & 0x1fffff);
    };
    std::transform(part.begin(), part.end(), column.begin(), value);
    column = column.subspan(part.size());
  }
}

// 5.10 -------------------------------------------------------------------------------------------
void lattice(PointSet& points, std::uint64_t seed) {
  if (points.dims() > lattice_vector.size()) throw std::invalid_argument("points: 16 dimensions");
  const std::uint64_t n = points.size();
  for (std::size_t d = 0; d < points.dims(); ++d) {
    const auto x = points.column(d);
    for (std::uint64_t i = 0; i < n; ++i) x[i] = double(i * lattice_vector[d] % n) / double(n);
  }
  Rng rng(seed);
  random_shift(points, rng);
}

void tent(std::span<double> column) {
  for (double& x : column) x = std::min(below_one, 2 * std::min(x, 1 - x));  // of 1/2: not 1
}

}  // namespace mc
