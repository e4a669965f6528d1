#pragma once
// The search that found lattice_vector, component by component.

#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <vector>

namespace mc::measurements {

class LatticeSearch {
 public:
  /// Appends the best candidate for the next dimension, and returns it: 1, then primes.
  std::uint64_t next() {
    std::uint64_t best = 1;
    double least = std::numeric_limits<double>::infinity();
    for (std::uint64_t z = 60'001; !worst_.empty() && z < most; z += 2) {
      if (!is_prime(z)) continue;
      double logarithms = 0;
      for (const double square : worst_case_with(z)) logarithms += std::log(square);
      if (logarithms < least) best = z, least = logarithms;
    }
    worst_ = worst_case_with(best);
    for (std::uint64_t i = 0; i <= most / 2; ++i) products_[i] *= factor(i * best);
    return best;
  }
  /// e^2 for N = 4, 8, … 65,536, as common/lattice_vector.hpp defines it; of the dimensions so far.
  const std::vector<double>& worst_case() const { return worst_; }

 private:
  static constexpr std::uint64_t most = 65'536;

  static bool is_prime(std::uint64_t odd) {
    for (std::uint64_t d = 3; d * d <= odd; d += 2) {
      if (odd % d == 0) return false;
    }
    return true;
  }

  /// 1 + w(k / most) / 20
  static double factor(std::uint64_t k) {
    const double x = static_cast<double>(k % most) / most;
    return 1 + 0.1 * std::numbers::pi * std::numbers::pi * (x * x - x + 1. / 6);
  }

  /// The points of N are those of 2N with an even number, so that one sum over all points of the
  /// largest N has all others as its parts. Points i and N - i contribute the same.
  std::vector<double> worst_case_with(std::uint64_t z) const {
    const auto term = [&](std::uint64_t i) { return products_[i] * factor(i * z); };
    std::vector<double> squares;
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

  std::vector<double> products_ = std::vector<double>(most / 2 + 1, 1);  ///< of point i
  std::vector<double> worst_;
};

}  // namespace mc::measurements
