#pragma once
// The search that found lattice_vector, component by component.

#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

namespace mc::measurements {

/// e^2 for N = 4, 8, … 65,536, as common/lattice_vector.hpp defines it.
using WorstCase = std::vector<double>;

class LatticeSearch {
 public:
  LatticeSearch() : factors_(most), products_(most / 2 + 1, 1) {
    for (std::uint64_t k = 0; k < most; ++k) {
      const double x = static_cast<double>(k) / most;
      factors_[k] = 1 + 0.1 * std::numbers::pi * std::numbers::pi * (x * x - x + 1. / 6);
    }
  }

  /// Appends the best candidate for the next dimension, and returns it.
  std::uint64_t next() {
    std::uint64_t best = 1;
    double least = 0;
    for (std::uint64_t z = 60'001; !is_first_ && z < most; z += 2) {
      if (!is_prime(z)) continue;
      double logarithms = 0;
      for (const double square : worst_case_with(z)) logarithms += std::log(square);
      if (best == 1 || logarithms < least) best = z, least = logarithms;
    }
    worst_ = worst_case_with(best);
    for (std::uint64_t i = 0; i <= most / 2; ++i) products_[i] *= factors_[i * best % most];
    is_first_ = false;
    return best;
  }
  /// Of the dimensions so far.
  const WorstCase& worst_case() const { return worst_; }

 private:
  static constexpr std::uint64_t most = 65'536;

  static bool is_prime(std::uint64_t odd) {
    for (std::uint64_t d = 3; d * d <= odd; d += 2) {
      if (odd % d == 0) return false;
    }
    return true;
  }

  /// The points of N are those of 2N with an even number, so that one sum over all points of the
  /// largest N has all others as its parts. Points i and N - i contribute the same.
  WorstCase worst_case_with(std::uint64_t z) const {
    const auto term = [&](std::uint64_t i) { return products_[i] * factors_[i * z % most]; };
    WorstCase squares;
    double sum = term(0) + term(most / 2);
    for (std::uint64_t n = 4; n <= most; n *= 2) {
      const std::uint64_t step = most / n;
      double more = 0;
      for (std::uint64_t i = step; i < most / 2; i += 2 * step) more += term(i);
      sum += 2 * more;
      squares.push_back(sum / static_cast<double>(n) - 1);
    }
    return squares;
  }

  std::vector<double> factors_;   ///< 1 + w(k / most) / 20
  std::vector<double> products_;  ///< over the dimensions so far, of point i
  WorstCase worst_;
  bool is_first_ = true;
};

}  // namespace mc::measurements
