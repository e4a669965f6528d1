#pragma once
// Recognizes dimensions of the Halton and Sobol' sequences, and of lattices, in a sampler's
// columns, however they are randomized: exactly, by the number of leading digits that two points
// share, or by their distance. Which dimension a request takes is up to the answer.

#include <map>
#include <set>

#include "checks/sampler/samplers.hpp"
#include "checks/support/sobol_exact.hpp"
#include "common/lattice_vector.hpp"

namespace mc::checks {

/// Primes up to 509: with 1,025 points each of them shows its period twice.
inline constexpr std::size_t most_primes = 97;
inline unsigned prime(unsigned number) {
  static const std::vector<unsigned> primes = [] {
    std::vector<unsigned> all;
    for (unsigned p = 2; all.size() < most_primes; ++p) {
      if (std::ranges::none_of(all, [p](unsigned q) { return p % q == 0; })) all.push_back(p);
    }
    return all;
  }();
  return primes.at(number);
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
      : base(kind == "halton" ? prime(number) : 2),
        directions_(sobol_directions(kind == "sobol" ? number : 0)),
        z_(kind.starts_with("lattice") ? lattice_vector[number] : 0),
        is_folded_(kind == "lattice") {}

  unsigned base;

  /// Whether a and b may be randomized values of points i and j: scrambling keeps the number of
  /// leading digits that they share, a shift their distance.
  bool may_be(double a, double b, std::size_t i, std::size_t j) const {
    if (i == j) return false;
    if (z_ > 0) return may_be_shifted(a, b, (value(i) - value(j)) * static_cast<double>(z_));
    if (base == 2) {
      return shared_bits(a, b) == std::countl_zero(sobol_word(directions_, i ^ j));
    }
    std::size_t apart = i > j ? i - j : j - i;
    double power = base;
    for (; apart % base == 0; apart /= base, power *= base) {
      if (digits_of(a, base, power) != digits_of(b, base, power)) return false;
    }
    return digits_of(a, base, power) != digits_of(b, base, power);
  }

  /// Whether x[0], x[1], … may be points `first`, `first` + 1, …, in this order.
  bool is_in_order(View x, std::size_t first = 0) const {
    if (base > 2) return is_permuted(x, first);
    if (z_ > 0) {
      for (std::size_t i = 1; i < x.size(); ++i) {
        if (!may_be(x[i], x[0], first + i, first)) return false;
        if (!may_be(x[i], x[i - 1], first + i, first + i - 1)) return false;
      }
      return true;
    }
    for (std::size_t i = 1; i < std::min<std::size_t>(x.size(), 16); ++i) {  // most differ here
      if (!may_be(x[i], x[i & (i - 1)], first + i, first + (i & (i - 1)))) return false;
    }
    // In a binary tree the neighbors of a sorted list determine what any two share.
    std::vector<std::pair<double, std::size_t>> sorted;
    for (std::size_t i = 0; i < x.size(); ++i) sorted.emplace_back(value(first + i), i);
    std::ranges::sort(sorted);
    for (std::size_t k = 1; k < sorted.size(); ++k) {
      const auto i = sorted[k].second, j = sorted[k - 1].second;
      if (!may_be(x[i], x[j], first + i, first + j)) return false;
    }
    return true;
  }

  /// The exact value of point i, in base 2.
  double value(std::size_t i) const { return sobol_word(directions_, i) * 0x1p-32; }

 private:
  /// Whether the digits are permuted, with one permutation per position.
  bool is_permuted(View x, std::size_t first) const {
    std::size_t power = 1;
    for (bool is_first = true; is_first || power < x.size(); is_first = false, power *= base) {
      std::vector<std::size_t> image(base, base), origin(base, base);  // base: none yet
      for (std::size_t i = 0; i < x.size(); ++i) {
        const double digits = digits_of(x[i], base, static_cast<double>(power * base));
        const std::size_t from = (first + i) / power % base,
                          to = static_cast<std::size_t>(digits) % base;
        if (image[from] == base && origin[to] == base) image[from] = to, origin[to] = from;
        if (image[from] != to) return false;
      }
    }
    return true;
  }

  /// Whether a and b may be points of a lattice that are `apart` modulo 1; a folded point has two
  /// origins. Within 2^-40, far above rounding errors and far below differences by chance.
  bool may_be_shifted(double a, double b, double apart) const {
    const double fraction = std::remainder(apart, 1.0);
    const auto fits = [=](double from, double to) {
      const double off = from - to - fraction;  // above -2
      return std::abs(off - (static_cast<int>(off + 2.5) - 2)) < 0x1p-40;
    };
    if (!is_folded_) return fits(a, b);
    return fits(a / 2, b / 2) || fits(-a / 2, b / 2) || fits(a / 2, -b / 2) || fits(-a / 2, -b / 2);
  }

  std::array<std::uint32_t, 32> directions_;
  std::uint64_t z_;
  bool is_folded_;
};

/// The dimensions of a sequence that an answer may use: of Halton's more than anybody does.
inline const std::vector<Dimension>& dimensions_of(const std::string& kind) {
  static std::map<std::string, std::vector<Dimension>> known;
  auto& all = known[kind];
  const std::size_t count = kind == "halton"              ? most_primes
                            : kind.starts_with("lattice") ? lattice_vector.size()
                                                          : 32;
  while (all.size() < count) all.emplace_back(kind, static_cast<unsigned>(all.size()));
  return all;
}

/// The dimension whose points from `first` on are in x, in their order, and that is not taken.
inline std::optional<unsigned> dimension_in(const std::string& kind, View x,
                                            const std::vector<unsigned>& taken,
                                            std::size_t first = 0) {
  const auto& all = dimensions_of(kind);
  for (unsigned d = 0; d < all.size(); ++d) {
    if (std::ranges::find(taken, d) == taken.end() && all[d].is_in_order(x, first)) return d;
  }
  return {};
}

/// The dimensions of the first coordinates of a new sampler, up to the request that starts again.
inline std::vector<unsigned> first_round(const std::string& kind, const SampleSets& got,
                                         const Uses& uses) {
  std::vector<unsigned> dimensions;
  for (const unsigned use : uses) {
    const auto before = dimensions;
    for (unsigned axis = 0; axis < use; ++axis) {
      const auto d = dimension_in(kind, got.column(0, dimensions.size()), dimensions);
      if (!d) return before;
      dimensions.push_back(*d);
    }
  }
  return dimensions;
}

/// Columns and their dimensions: does one order of the points fit all of them? Samples are tried
/// one after the other. Each is compared with a few others, which no wrong point survives for long.
struct Round {
  std::vector<Dimension> dimensions;
  std::vector<View> columns;

  bool has_order() const {
    std::vector<std::size_t> order;
    return continues(order);
  }

 private:
  bool continues(std::vector<std::size_t>& order) const {
    const std::size_t n = columns[0].size();
    if (order.size() == n) return true;
    for (std::size_t point = 0; point < std::bit_ceil(n); ++point) {
      if (!fits(order, point)) continue;
      order.push_back(point);
      if (continues(order)) return true;
      order.pop_back();
    }
    return false;
  }
  bool fits(const std::vector<std::size_t>& order, std::size_t point) const {
    const std::size_t i = order.size();
    for (std::size_t back = 1; back <= std::min<std::size_t>(i, 12); ++back) {
      const std::size_t j = back > 8 ? back - 9 : i - back;
      for (std::size_t d = 0; d < columns.size(); ++d) {
        if (!dimensions[d].may_be(columns[d][i], columns[d][j], point, order[j])) return false;
      }
    }
    return true;
  }
};

}  // namespace mc::checks
