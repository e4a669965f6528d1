#pragma once
// What is expected of Halton and Hammersley points: axis by axis, and of what they make of
// integrals.

#include "checks/halton/expect_inverse.hpp"

namespace mc::checks {

/// Which other radical inverses these are, if any: of another base, or from another index on.
inline std::string other_axis_hint(std::span<const double> column, unsigned base,
                                   std::uint64_t first) {
  const auto are = [&](unsigned of, std::uint64_t from) {
    for (std::size_t i = 0; i < column.size(); ++i) {
      if (!(std::abs(column[i] - inverse(of, from + i)) <= 1e-12)) return false;
    }
    return true;
  };
  for (const auto& [from, hint] :
       {std::pair{first + 1, "this begins one index too late: count from `first`"},
        {std::uint64_t{0}, "this begins at index 0, not at `first`"},
        {first & 0xffffffffu, "`first` has 64 bits, of which 32 were kept"}}) {
    if (from != first && are(base, from)) return hint;
  }
  for (unsigned other = 2; other < 300; ++other) {
    if (other != base && are(other, first)) {
      return fmt::format("this axis is in base {}: one prime an axis, in order", other);
    }
  }
  return fmt::format("this axis is the radical inverse in base {}", base);
}

/// `columns`, each of n values, are the radical inverses in `bases`: coordinates `from_axis` … of
/// points first, first + 1, …
inline void expect_axes(const std::string& call, std::span<const double> columns,
                        std::span<const unsigned> bases, std::size_t n, std::uint64_t first,
                        std::size_t from_axis = 0) {
  for (std::size_t d = 0; d < bases.size(); ++d) {
    const auto column = columns.subspan(d * n, n);
    for (std::size_t i = 0; i < n; ++i) {
      const double exact = inverse(bases[d], first + i);
      if (std::abs(column[i] - exact) <= inverse_tolerance && column[i] < 1) continue;
      expect_that(false,
                  fmt::format("{}: coordinate {} of point {} is {}", call, from_axis + d, i,
                              shown_number(column[i])),
                  fmt::format("{:.17g}", exact),
                  fmt::format("the radical inverse of {} in base {}", first + i, bases[d]),
                  std::isnan(column[i]) ? never_written : other_axis_hint(column, bases[d], first));
    }
    pass();
  }
}

/// What the first n points of a sequence make of four integrals over the unit square.
struct Estimates {
  std::size_t n;
  double bilinear, gauss, disk, exponential;
};

/// The estimates themselves are known, with their errors: averages over the exact fractions, in 30
/// digits; xy and the disk as fractions, for example 13/64 of 16 Halton points.
inline void expect_estimates(const std::string& call, std::span<const double> x,
                             std::span<const double> y, const Estimates& known,
                             const std::string& otherwise) {
  struct Integrand {
    const char* name;
    double (*f)(double, double);
    double Estimates::*estimate;
  };
  static constexpr Integrand integrands[] = {
      {"xy", [](double u, double v) { return u * v; }, &Estimates::bilinear},
      {"exp(-x^2 - y^2)", [](double u, double v) { return std::exp(-u * u - v * v); },
       &Estimates::gauss},
      {"1 inside the circle of radius 0.4 about the centre",
       [](double u, double v) {
         return (u - 0.5) * (u - 0.5) + (v - 0.5) * (v - 0.5) < 0.16 ? 1. : 0.;
       },
       &Estimates::disk},
      {"exp(x + y)", [](double u, double v) { return std::exp(u + v); }, &Estimates::exponential}};
  for (const auto& [name, f, estimate] : integrands) {
    Exact sum;
    for (std::size_t i = 0; i < known.n; ++i) sum = sum + Exact(f(x[i], y[i]));
    const auto mean = static_cast<double>(sum / Exact(static_cast<double>(known.n)));
    expect_within(
        fmt::format("{}, average of {}", call, name), mean, known.*estimate, 1e-14,
        "the average over the exact points; coordinates within 4 * 2^-53 move it by 2 e^2 "
        "times that at most, and no point is that near to the circle",
        {{}, otherwise});
  }
}

}  // namespace mc::checks
