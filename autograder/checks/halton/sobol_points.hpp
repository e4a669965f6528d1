#pragma once
// Sobol' points as they are defined, and what is expected of a column of them.

#include <algorithm>
#include <bit>

#include <fmt/format.h>

#include "checks/halton/expect_inverse.hpp"
#include "checks/support/expect.hpp"
#include "checks/support/sobol_exact.hpp"

namespace mc::checks {

using Directions = std::array<std::uint32_t, 32>;

inline double sobol_value(std::span<const std::uint32_t> v, std::uint64_t index) {
  return sobol_word(v, index) * 0x1p-32;
}

inline std::vector<double> sobol_points(unsigned dimension, std::uint64_t first,
                                        std::size_t count) {
  const auto v = sobol_directions(dimension);
  std::vector<double> x(count);
  for (std::size_t i = 0; i < count; ++i) x[i] = sobol_value(v, first + i);
  return x;
}

/// Which other points these are, all of them, if any that a mistake would make.
inline std::string other_sobol_hint(std::span<const double> got, unsigned dimension,
                                    std::uint64_t first, const std::string& otherwise) {
  const Directions v = sobol_directions(dimension);
  const auto are = [&](auto value_of) {
    for (std::size_t i = 0; i < got.size(); ++i) {
      if (got[i] != value_of(first + i)) return false;
    }
    return true;
  };
  const auto shifted = [&](int by) {
    Directions w{};
    for (int k = 0; k < 32; ++k)
      w[static_cast<std::size_t>(k)] = v[static_cast<std::size_t>(std::clamp(k + by, 0, 31))];
    return w;
  };
  const Directions later = shifted(1), earlier = shifted(-1);
  if (are([&](std::uint64_t n) { return sobol_value(v, n ^ n >> 1); })) {
    return "these are the points in Gray-code order: the same set, another sequence";
  }
  if (are([&](std::uint64_t n) { return sobol_value(v, n + 1); })) {
    return "this begins one index too late: point 0 is the origin";
  }
  if (are([&](std::uint64_t n) { return sobol_value(v, n - first); })) {
    return "this begins at index 0, not at `first`";
  }
  if (are([&](std::uint64_t n) { return sobol_value(later, n & 0x7fffffff); }) ||
      are([&](std::uint64_t n) { return sobol_value(earlier, n & ~std::uint64_t{1}); })) {
    return "bit k of the index, from 0, chooses m_(k+1) 2^-(k+1)";
  }
  for (unsigned other = 0; other < joe_kuo.size(); ++other) {
    const auto w = sobol_directions(other);
    if (other != dimension && are([&](std::uint64_t n) { return sobol_value(w, n); })) {
      return fmt::format("this is dimension {}: they count from 0", other);
    }
  }
  return otherwise;
}

/// Which direction number is the first that is wrong, in a column from index 0 on.
inline std::string direction_hint(std::uint64_t first_wrong, unsigned dimension) {
  const unsigned degree = joe_kuo[dimension].degree;
  if (first_wrong == 0) return "point 0 is the origin";
  const auto k = static_cast<unsigned>(std::bit_width(first_wrong));
  if (degree == 0 || k <= degree) {
    return fmt::format("m_{} is given: coordinate 2^{} is m_{} / 2^{}", k, k - 1, k, k);
  }
  return fmt::format(
      "all is right up to m_{}, and m_{} is the first that the recurrence makes of others: "
      "m_k = 2 a_1 m_(k-1) ^ 4 a_2 m_(k-2) ^ … ^ 2^s m_(k-s) ^ m_(k-s), a_1 the highest bit of "
      "`coefficients`, s = {} here",
      k - 1, k, degree);
}

inline void expect_sobol(const std::string& call, std::span<const double> got, unsigned dimension,
                         std::uint64_t first, const std::string& otherwise) {
  const auto v = sobol_directions(dimension);
  for (std::size_t i = 0; i < got.size(); ++i) {
    const double exact = sobol_value(v, first + i);
    if (got[i] == exact) continue;
    const std::string hint = first == 0 ? direction_hint(i, dimension) : otherwise;
    expect_that(false, fmt::format("{}: value {} is {}", call, i, shown_number(got[i])),
                fmt::format("{:.17g}, exactly", exact),
                fmt::format("the XOR of the direction numbers of the bits of {}", first + i),
                std::isnan(got[i]) ? never_written : other_sobol_hint(got, dimension, first, hint));
  }
  pass();
}

}  // namespace mc::checks
