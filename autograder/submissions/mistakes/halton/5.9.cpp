// Mistakes in task 5.9.
#include "halton.hpp"

#include <cmath>

#define radical_inverses_scrambled right_radical_inverses_scrambled
#include "solutions/halton.cpp"
#undef radical_inverses_scrambled

namespace mc {
namespace {

using Row = std::vector<double>::iterator;

/// A row of digits for each position; permute(row, position) makes a permutation of it.
template <class Permute>
std::vector<double> rows_of(unsigned base, Permute permute) {
  std::vector<double> rows((1 + static_cast<std::size_t>(64 / std::log2(base))) * base);
  std::size_t position = 0;
  for (Row row = rows.begin(); row != rows.end(); row += base) {
    std::iota(row, row + base, 0);
    permute(row, position++);
  }
  return rows;
}

/// One of the digits first … base - 1.
unsigned any_digit(unsigned first, unsigned base, Rng& rng) {
  return first + static_cast<unsigned>(Choices(rng).below(base - first));
}

/// The digits of all indices, mapped by the rows.
void fill(std::span<double> column, std::uint64_t first, unsigned base,
          const std::vector<double>& rows) {
  for (std::size_t i = 0; i < column.size(); ++i) {
    std::uint64_t index = first + i;
    std::vector<double> digits;
    for (auto row = rows.begin(); row != rows.end(); row += base, index /= base) {
      digits.push_back(row[index % base]);
    }
    double value = 0;
    for (auto digit = digits.rbegin(); digit != digits.rend(); ++digit) {
      value = (*digit + value) / base;
    }
    column[i] = std::min(below_one, value);
  }
}

void require(unsigned base, std::uint64_t first, std::size_t size) {
  require_base(base);
  if (base > 65536) throw std::invalid_argument("base: must be at most 2^16");
  require_indices(first, size, last_index);
}

/// The digits of all indices, mapped by the rows that permute(row, position) makes.
template <class Permute>
void by_rows(unsigned base, std::uint64_t first, std::span<double> column, Permute permute) {
  require(base, first, column.size());
  fill(column, first, base, rows_of(base, permute));
}

}  // namespace
}  // namespace mc

#define SCRAMBLED                                                                               \
  void radical_inverses_scrambled(unsigned base, std::uint64_t first, std::span<double> column, \
                                  std::uint64_t seed)

// mistake: adds a random number to each digit, modulo the base
// hint: these are rotations
namespace mc::digits_rotated {
SCRAMBLED {
  Rng rng(seed ^ mix_bits(base));
  by_rows(base, first, column, [&](Row row, std::size_t) {
    std::rotate(row, row + static_cast<unsigned>(rng() % base), row + base);
  });
}
}  // namespace mc::digits_rotated

// mistake: permutes eleven digits and drops the others, so some indices get the same number
// hint: this position has no permutation
namespace mc::eleven_digits {
SCRAMBLED {
  require(base, first, column.size());
  std::vector<double> rows = rows_of(base, [&](Row row, std::size_t position) {
    Rng rng(mix_bits(seed ^ mix_bits(base)) + position);
    for (unsigned k = 0; k < base; ++k) std::swap(row[k], row[any_digit(k, base, rng)]);
  });
  rows.resize(std::min<std::size_t>(rows.size(), 11 * std::size_t{base}));
  fill(column, first, base, rows);
}
}  // namespace mc::eleven_digits

// mistake: swaps each digit with any digit, which favors some permutations
// hint: each value is swapped with any of the n values
namespace mc::naive_shuffle {
SCRAMBLED {
  by_rows(base, first, column, [&](Row row, std::size_t position) {
    Rng rng(mix_bits(seed ^ mix_bits(base)) + position);
    for (unsigned i = 0; i < base; ++i) std::swap(row[i], row[any_digit(0, base, rng)]);
  });
}
}  // namespace mc::naive_shuffle

// mistake: swaps each digit with a later one, never with itself (Sattolo's algorithm)
// hint: no value ever keeps its place
namespace mc::no_digit_stays {
SCRAMBLED {
  by_rows(base, first, column, [&](Row row, std::size_t position) {
    Rng rng(mix_bits(seed ^ mix_bits(base)) + position);
    for (unsigned i = 0; i + 1 < base; ++i) std::swap(row[i], row[any_digit(i + 1, base, rng)]);
  });
}
}  // namespace mc::no_digit_stays

// mistake: uses the same permutation at every position
// hint: use a different permutation for each position
namespace mc::one_permutation {
SCRAMBLED {
  by_rows(base, first, column, [&](Row row, std::size_t) {
    Rng rng(seed ^ mix_bits(base));
    std::shuffle(row, row + base, rng);
  });
}
}  // namespace mc::one_permutation

// mistake: seeds the generator of a position with seed + position
// hint: mix both by a hash, do not add them
namespace mc::position_added_to_seed {
SCRAMBLED {
  by_rows(base, first, column, [&](Row row, std::size_t position) {
    Rng rng(seed + position);
    for (unsigned i = 0; i < base; ++i) std::swap(row[i], row[any_digit(i, base, rng)]);
  });
}
}  // namespace mc::position_added_to_seed

// mistake: keeps the first index of scrambled digits in 32 bits
// hint: keep all 64 bits of an index
namespace mc::scrambled_first_of_32_bits {
SCRAMBLED {
  require_indices(first, column.size(), last_index);
  right_radical_inverses_scrambled(base, static_cast<std::uint32_t>(first), column, seed);
}
}  // namespace mc::scrambled_first_of_32_bits

// mistake: permutes only the digits of the index, not the zeros before its first digit
// hint: the zeros after the last digit are digits, too
namespace mc::zeros_stay {
SCRAMBLED {
  require(base, first, column.size());
  Rng rng(seed ^ mix_bits(base));
  const auto rows =
      rows_of(base, [&](Row row, std::size_t) { std::shuffle(row, row + base, rng); });
  for (std::size_t i = 0; i < column.size(); ++i) {
    double value = 0, part = 1;
    auto row = rows.begin();
    for (std::uint64_t index = first + i; index > 0; index /= base, row += base) {
      part /= base;
      value += part * row[static_cast<std::ptrdiff_t>(index % base)];
    }
    column[i] = std::min(below_one, value);
  }
}
}  // namespace mc::zeros_stay

// mistake: takes two digits in one step in long columns only, which rounds in another way
// hint: not even by rounding
namespace mc::steps_by_length {
SCRAMBLED {
  right_radical_inverses_scrambled(base, first, column, seed);
  if (base > 5 || column.size() < 4 * base * base) return;
  for (double& value : column) {  // one more rounding
    const double whole = std::floor(value * base);
    value = std::min(below_one, (whole + (value * base - whole)) / base);
  }
}
}  // namespace mc::steps_by_length

// mistake: refuses base 65,536, which is allowed
// hint: it may overflow, be rounded or be off by one
namespace mc::refuses_65536 {
SCRAMBLED {
  if (base >= 65536) throw std::invalid_argument("base: must be below 2^16");
  right_radical_inverses_scrambled(base, first, column, seed);
}
}  // namespace mc::refuses_65536
