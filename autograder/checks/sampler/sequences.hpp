#pragma once
// Which dimensions of the Halton and the Sobol' sequence a sampler's columns are, whatever
// scrambles them: exactly, by the leading digits that any two of their points share.

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>
#include <optional>

#include "checks/sampler/samplers.hpp"
#include "checks/support/sobol_exact.hpp"

namespace mc::checks {

inline constexpr std::size_t block_dims = 8;
inline constexpr std::array<unsigned, block_dims> sobol_block{0, 1, 4, 6, 16, 20, 15, 21};
inline constexpr unsigned first_primes[] = {2,  3,  5,  7,  11, 13, 17, 19, 23,
                                            29, 31, 37, 41, 43, 47, 53, 59, 61};

/// Where a coordinate comes from: which block of eight dimensions, and which of those.
struct Place {
  std::size_t block, dimension;
};

/// Of every coordinate of these uses, in the order in which they are first asked for: a next2()
/// takes a pair of dimensions, a next() half of one, and the next one the other half.
inline std::vector<Place> places_of(const Uses& uses) {
  std::vector<Place> places;
  std::optional<Place> half;
  std::size_t pair = 0;
  for (const unsigned use : uses) {
    if (use == 1 && half) {
      places.push_back(*half);
      half.reset();
      continue;
    }
    const Place first{pair / 4, pair % 4 * 2}, second{pair / 4, pair % 4 * 2 + 1};
    if (pair % 4 == 0) half.reset();  // what is left of another block
    ++pair;
    places.push_back(first);
    if (use == 2) places.push_back(second);
    if (use == 1) half = second;
  }
  return places;
}

/// How many leading bits two coordinates have in common, up to 32.
inline unsigned common_bits(double a, double b) {
  const auto word = [](double x) { return static_cast<std::uint32_t>(std::floor(x * 0x1p32)); };
  return static_cast<unsigned>(std::countl_zero(word(a) ^ word(b)));
}

/// Is the column that of dimension d of the Sobol' sequence, scrambled, in the sequence's own
/// order? Nested scrambling keeps how many bits any two points have in common, and nothing else.
inline bool is_scrambled_sobol(View x, unsigned d) {
  const auto directions = sobol_directions(d);
  std::vector<std::uint32_t> words;
  for (std::size_t i = 0; i < x.size(); ++i) words.push_back(sobol_word(directions, i));
  for (std::size_t i = 0; i < x.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const int exact = std::countl_zero(words[i] ^ words[j]);
      if (common_bits(x[i], x[j]) != static_cast<unsigned>(exact)) return false;
    }
  }
  return true;
}

/// How many leading digits two coordinates have in common, up to `most`. A digit that rounding may
/// have put one too low, within 2^-49 of the next, counts as that: room for the four roundings of
/// 5.1's bound, which a scrambled tail enters once in 1e13.
inline unsigned common_digits(double a, double b, unsigned base, unsigned most) {
  double power = base;
  for (unsigned digits = 0; digits < most; ++digits, power *= base) {
    const double room = power * 0x1p-49;
    if (std::floor(a * power + room) != std::floor(b * power + room)) return digits;
  }
  return most;
}

/// How often `base` divides a difference of indices: so many digits their radical inverses share.
inline unsigned shared_digits(std::size_t difference, unsigned base) {
  unsigned digits = 0;
  for (; difference % base == 0; difference /= base) ++digits;
  return digits;
}

/// Is the column that of the radical inverses of these indices in a base, scrambled (5.8 or 5.9)?
inline bool is_scrambled_halton(View x, unsigned base, std::span<const std::size_t> indices) {
  for (std::size_t i = 0; i < x.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const std::size_t apart =
          indices[i] > indices[j] ? indices[i] - indices[j] : indices[j] - indices[i];
      if (apart == 0) return false;
      const unsigned exact = shared_digits(apart, base);
      if (common_digits(x[i], x[j], base, exact + 1) != exact) return false;
    }
  }
  return true;
}

/// The same of the indices first, first + 1, …, the digit at each position permuted alike for all
/// of them, as 5.9 does.
inline bool is_permuted_halton(View x, unsigned base, std::size_t first) {
  std::size_t power = 1;
  for (unsigned position = 1; position == 1 || power < first + x.size(); ++position) {
    std::vector<std::size_t> image(base, base), origin(base, base);  // base: of none yet
    for (std::size_t i = 0; i < x.size(); ++i) {
      const std::size_t from = (first + i) / power % base;
      const double scaled = x[i] * static_cast<double>(power) * base;
      const double room = static_cast<double>(power) * base * 0x1p-49;
      const std::size_t to = static_cast<std::size_t>(std::floor(scaled + room)) % base;
      if (image[from] == base && origin[to] == base) {
        image[from] = to;
        origin[to] = from;
      }
      if (image[from] != to) return false;
    }
    power *= base;
  }
  return true;
}

/// Is the column that of the first N radical inverses in a base, scrambled? Nested scrambling has
/// no first index: those of 1 to N are the same to it. Permuted digits have, and it is 0.
inline bool is_scrambled_halton(View x, unsigned base) {
  std::vector<std::size_t> own_order(x.size());
  std::iota(own_order.begin(), own_order.end(), std::size_t{0});
  return is_scrambled_halton(x, base, own_order) &&
         (is_permuted_halton(x, base, 0) || !is_permuted_halton(x, base, 1));
}

/// In which bit of the column of a base-2 sequence are points flipped or not, depending on the bits
/// before it? None: then it is a digital shift. `exact` are the unscrambled words.
inline bool is_digital_shift(View x, std::span<const std::uint32_t> exact) {
  const auto bits = static_cast<int>(std::bit_width(x.size()) - 1);
  const auto flips = [&](std::size_t i) {
    return (static_cast<std::uint32_t>(std::floor(x[i] * 0x1p32)) ^ exact[i]) >> (32 - bits);
  };
  for (std::size_t i = 1; i < x.size(); ++i) {
    if (flips(i) != flips(0)) return false;
  }
  return true;
}

/// The columns of a whole block, or what is asked for of it, in an order that nobody knows.
using Block = std::vector<View>;

/// Are these, sample by sample, the dimensions of a block of the first 2^m Sobol' points,
/// scrambled, all in the same order? The words of these points are a group under exclusive or: so
/// how many leading bits a point shares with each of the others, in all dimensions together, is the
/// same list for every point, but for its order: that of point 0.
inline bool is_sobol_in_one_order(const Block& columns) {
  const std::size_t n = columns[0].size();
  using Shared = std::vector<unsigned>;
  std::vector<Shared> exact;
  std::vector<std::array<std::uint32_t, 32>> directions;
  for (std::size_t d = 0; d < columns.size(); ++d) {
    directions.push_back(sobol_directions(sobol_block[d]));
  }
  for (std::size_t j = 1; j < n; ++j) {
    Shared bits;
    for (const auto& of : directions) {
      bits.push_back(static_cast<unsigned>(std::countl_zero(sobol_word(of, j))));
    }
    exact.push_back(bits);
  }
  std::sort(exact.begin(), exact.end());
  for (std::size_t i = 0; i < n; ++i) {
    std::vector<Shared> shared;
    for (std::size_t j = 0; j < n; ++j) {
      if (j == i) continue;
      Shared bits;
      for (const View x : columns) bits.push_back(common_bits(x[i], x[j]));
      shared.push_back(bits);
    }
    std::sort(shared.begin(), shared.end());
    if (shared != exact) return false;
  }
  return true;
}

/// Are these dimensions 0, 1, … of the first N Halton points, scrambled, all in the same order? For
/// all eight of them and N <= 16: then any two indices but neighbours differ by a multiple of some
/// base. So neighbours are those that share no digit anywhere, which finds the order.
inline bool is_halton_in_one_order(const Block& columns) {
  const std::size_t n = columns[0].size();
  const auto are_neighbours = [&](std::size_t i, std::size_t j) {
    for (unsigned d = 0; d < columns.size(); ++d) {
      if (common_digits(columns[d][i], columns[d][j], first_primes[d], 1) > 0) return false;
    }
    return true;
  };
  std::vector<std::vector<std::size_t>> beside(n);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      if (i != j && are_neighbours(i, j)) beside[i].push_back(j);
    }
  }
  const auto end = std::find_if(beside.begin(), beside.end(),
                                [](const auto& neighbours) { return neighbours.size() == 1; });
  if (end == beside.end()) return false;
  std::vector<std::size_t> index(n, n);
  auto here = static_cast<std::size_t>(end - beside.begin());
  for (std::size_t number = 0; number < n; ++number) {
    index[here] = number;
    const auto next = std::find_if(beside[here].begin(), beside[here].end(),
                                   [&](std::size_t other) { return index[other] == n; });
    if (next == beside[here].end()) break;
    here = *next;
  }
  for (unsigned d = 0; d < columns.size(); ++d) {
    if (!is_scrambled_halton(columns[d], first_primes[d], index)) return false;
  }
  return true;
}

}  // namespace mc::checks
