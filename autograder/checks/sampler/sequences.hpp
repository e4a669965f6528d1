#pragma once
// Which dimensions of the Halton and the Sobol' sequence a sampler's columns are, whatever
// scrambles them: exactly, by how many leading digits any two of their points share. And of
// lattices, by how far apart they are.

#include "checks/sampler/samplers.hpp"
#include "checks/support/sobol_exact.hpp"
#include "common/lattice_vector.hpp"

namespace mc::checks {

inline constexpr std::size_t block_dims = 8;
inline constexpr std::array<unsigned, block_dims> sobol_block{0, 1, 4, 6, 16, 20, 15, 21};
inline constexpr std::array<unsigned, 16> first_primes{2,  3,  5,  7,  11, 13, 17, 19,
                                                       23, 29, 31, 37, 41, 43, 47, 53};

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

/// The first digits of x in a base, as many as `power` = base^k has, as a whole number. A digit
/// that rounding may have put one too low, within 2^-49 of the next, counts as that: room for the
/// four roundings of 5.1's bound, which a scrambled tail enters once in 1e13. In base 2 nothing is
/// rounded.
inline double digits_of(double x, unsigned base, double power) {
  return std::floor(x * power + (base == 2 ? 0 : power * 0x1p-49));
}

/// A dimension of one of the two sequences, or of lattices.
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

  /// How many leading digits points i and j share: as many as their indices do, from the lowest on,
  /// or as the exclusive or of their indices has zeros.
  unsigned shared(std::size_t i, std::size_t j) const {
    if (base == 2) {
      return static_cast<unsigned>(std::countl_zero(sobol_word(directions_, i ^ j)));
    }
    std::size_t apart = i > j ? i - j : j - i;
    unsigned digits = 0;
    for (; apart % base == 0; apart /= base) ++digits;
    return digits;
  }
  /// May a and b be scrambled values of points i and j? Scrambling keeps how many leading digits
  /// two points share, and nothing else.
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
  /// May a and b be points of a lattice that are `apart` modulo 1, folded? Each has two origins. To
  /// 2^-40, which is far above all rounding, and far below what chance brings together.
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

/// Columns, and the dimensions that they should be.
struct Block {
  std::vector<Dimension> dimensions;
  std::vector<View> columns;

  /// May sample i be point order[i], as far as the samples before it show?
  bool fits(std::span<const std::size_t> order, std::size_t i) const {
    for (std::size_t d = 0; d < columns.size(); ++d) {
      const View x = columns[d];
      for (std::size_t j = 0; j < i; ++j) {
        if (!dimensions[d].may_be(x[i], x[j], order[i], order[j])) return false;
      }
    }
    return true;
  }
  /// Are samples 0, 1, … points 0, 1, …?
  bool is_in_order() const {
    std::vector<std::size_t> order(columns[0].size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    for (std::size_t i = 0; i < order.size(); ++i) {
      if (!fits(order, i)) return false;
    }
    return true;
  }
};

/// A nested order that fits the columns of a block: each bit of the index of a point is that of the
/// sample's number or not, depending on the bits above. Empty where there is none.
class NestedOrder {
 public:
  explicit NestedOrder(const Block& block)
      : block_(block), order_(block.columns[0].size()), exists_(place(0)) {}
  bool exists() const { return exists_; }

 private:
  /// With the lowest one of its bits cleared, i is a sample before it: from that bit on upward the
  /// flips are that sample's, and those below are free.
  bool place(std::size_t i) {
    if (i == order_.size()) return true;
    const int low =
        i == 0 ? static_cast<int>(std::bit_width(order_.size() - 1)) : std::countr_zero(i);
    const std::size_t first = i == 0 ? 0 : (order_[i & (i - 1)] >> low ^ 1) << low;
    for (std::size_t below = 0; below < std::size_t{1} << low; ++below) {
      order_[i] = first | below;
      if (block_.fits(order_, i) && place(i + 1)) return true;
    }
    return false;
  }

  const Block& block_;
  std::vector<std::size_t> order_;
  bool exists_;
};

/// The same with digits permuted: each position has one permutation for all points.
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
