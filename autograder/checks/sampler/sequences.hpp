#pragma once
// Recognizes dimensions of the Halton and Sobol' sequences in a sampler's columns, however they are
// scrambled: exactly, by the number of leading digits that any two points share. Lattices are
// recognized by differences.

#include "checks/sampler/samplers.hpp"
#include "checks/support/sobol_exact.hpp"
#include "common/lattice_vector.hpp"

namespace mc::checks {

inline constexpr std::size_t block_dims = 8;
inline constexpr std::array<unsigned, block_dims> sobol_block{0, 1, 4, 6, 16, 20, 15, 21};
inline constexpr std::array<unsigned, 16> first_primes{2,  3,  5,  7,  11, 13, 17, 19,
                                                       23, 29, 31, 37, 41, 43, 47, 53};

/// The block of eight dimensions of a coordinate, and its dimension in the block.
struct Place {
  std::size_t block, dimension;
};

/// The place of every coordinate of these uses, in the order of their first request: a next2()
/// takes a pair of dimensions, a next() half of one, and the following next() the other half.
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
    if (pair % 4 == 0) half.reset();  // an unused half of another block
    ++pair;
    places.push_back(first);
    if (use == 2) places.push_back(second);
    if (use == 1) half = second;
  }
  return places;
}

/// The first k digits of x in a base, with `power` = base^k, as an integer. Rounding may reduce a
/// digit by one, so values within 2^-49 below the next one count as that: enough for the four
/// rounding errors of 5.1's bound; a scrambled value is that close once in 1e13.
inline double digits_of(double x, unsigned base, double power) {
  return std::floor(x * power + (base == 2 ? 0 : power * 0x1p-49));
}

/// A dimension of one of the sequences, or of lattices.
class Dimension {
 public:
  Dimension(const std::string& kind, unsigned number)
      : base(kind == "halton" ? first_primes[number] : 2),
        directions_(sobol_directions(kind == "sobol" ? number : 0)),
        z_(kind == "lattice" ? lattice_vector[number] : 0) {}
  static Dimension at(const std::string& kind, std::size_t place) {
    return {kind, kind == "sobol" ? sobol_block[place] : static_cast<unsigned>(place)};
  }

  unsigned base;

  /// How many leading digits points i and j share: as many as their indices, from the lowest on; in
  /// base 2, the leading zeros of the XOR of the points.
  unsigned shared(std::size_t i, std::size_t j) const {
    if (base == 2) return static_cast<unsigned>(std::countl_zero(sobol_word(directions_, i ^ j)));
    std::size_t apart = i > j ? i - j : j - i;
    unsigned digits = 0;
    for (; apart % base == 0; apart /= base) ++digits;
    return digits;
  }
  /// Whether a and b may be scrambled values of points i and j: it keeps the number of shared
  /// digits.
  bool may_be(double a, double b, std::size_t i, std::size_t j) const {
    if (i == j) return false;
    if (z_ > 0) return may_be_folded(a, b, (value(i) - value(j)) * static_cast<double>(z_));
    const unsigned count = shared(i, j);
    if (base == 2) return shared_bits(a, b) == static_cast<int>(count);
    double power = base;
    for (unsigned k = count; k > 0; --k, power *= base) {
      if (digits_of(a, base, power) != digits_of(b, base, power)) return false;
    }
    return digits_of(a, base, power) != digits_of(b, base, power);
  }
  /// The exact value of point i, in base 2.
  double value(std::size_t i) const { return sobol_word(directions_, i) * 0x1p-32; }

 private:
  /// Whether a and b may be folded points of a lattice that are `apart` modulo 1: each has two
  /// origins. Within 2^-40, far above rounding errors and far below differences by chance.
  static bool may_be_folded(double a, double b, double apart) {
    const double fraction = std::remainder(apart, 1.0);
    const auto fits = [=](double from, double to) {
      const double off = from - to - fraction;  // above -2
      return std::abs(off - (static_cast<int>(off + 2.5) - 2)) < 0x1p-40;
    };
    return fits(a / 2, b / 2) || fits(-a / 2, b / 2) || fits(a / 2, -b / 2) || fits(-a / 2, -b / 2);
  }

  std::array<std::uint32_t, 32> directions_;
  std::uint64_t z_;
};

/// Columns and their expected dimensions.
struct Block {
  std::vector<Dimension> dimensions;
  std::vector<View> columns;

  /// Whether sample i may be point order[i], given the samples before it.
  bool fits(std::span<const std::size_t> order, std::size_t i) const {
    for (std::size_t d = 0; d < columns.size(); ++d) {
      const View x = columns[d];
      for (std::size_t j = 0; j < i; ++j) {
        if (!dimensions[d].may_be(x[i], x[j], order[i], order[j])) return false;
      }
    }
    return true;
  }
  /// Whether samples 0, 1, … are points 0, 1, …
  bool is_in_order() const {
    std::vector<std::size_t> order(columns[0].size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    for (std::size_t i = 0; i < order.size(); ++i) {
      if (!fits(order, i)) return false;
    }
    return true;
  }
};

/// Whether a nested order fits the columns of a block from sample i on, given the samples before
/// it: each bit of a sample's index is flipped or not, depending on the bits above. With its lowest
/// set bit cleared, i is an earlier sample with the same flips from that bit on upward.
inline bool has_nested_order(const Block& block, std::vector<std::size_t>& order,
                             std::size_t i = 0) {
  if (i == order.size()) return true;
  const int low = i == 0 ? static_cast<int>(std::bit_width(order.size() - 1)) : std::countr_zero(i);
  const std::size_t first = i == 0 ? 0 : (order[i & (i - 1)] >> low ^ 1) << low;
  for (std::size_t below = 0; below < std::size_t{1} << low; ++below) {
    order[i] = first | below;
    if (block.fits(order, i) && has_nested_order(block, order, i + 1)) return true;
  }
  return false;
}

/// Whether the digits of points 0, 1, … are permuted, with one permutation per position.
inline bool is_permuted(View x, unsigned base) {
  std::size_t power = 1;
  for (bool is_first = true; is_first || power < x.size(); is_first = false, power *= base) {
    std::vector<std::size_t> image(base, base), origin(base, base);  // base: none yet
    for (std::size_t i = 0; i < x.size(); ++i) {
      const double digits = digits_of(x[i], base, static_cast<double>(power * base));
      const std::size_t from = i / power % base, to = static_cast<std::size_t>(digits) % base;
      if (image[from] == base && origin[to] == base) image[from] = to, origin[to] = from;
      if (image[from] != to) return false;
    }
  }
  return true;
}

}  // namespace mc::checks
