#pragma once
// The integrands and densities of lab 2's experiments, which a request selects by number.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

#include "common/estimation.hpp"
#include "common/normal_quantile.hpp"
#include "runner/text.hpp"
#include "runner/wire.hpp"

namespace mc::experiments {

/// The integrand scale * g + offset, where `g` is an index into function_names.
struct Function {
  unsigned g = 0;
  double parameter = 0, scale = 1, offset = 0;
};
MC_FIELDS(Function, g, parameter, scale, offset)

/// The formulas of g; {} is the parameter.
inline constexpr std::array<std::string_view, 11> function_names{
    "1",
    "exp(x)",
    "x y",
    "(1 if x < {}, else 0)",
    "x^{}",
    "exp(-((x - 0.3)^2 + (y - 0.7)^2) / (2 {}^2))",
    "normal_quantile(x)",
    "x exp(-x)",
    "v w x y z",
    "min(x^-0.75, {})",
    "(the sum of 40 coordinates)"};
/// The number of dimensions of each g.
inline constexpr std::array<std::size_t, 11> dimensions{1, 1, 2, 1, 1, 2, 1, 1, 5, 1, 40};

/// A density for importance sampling: `p` is an index into sampling_names.
struct Sampling {
  unsigned p = 0;
  double parameter = 0;
};
MC_FIELDS(Sampling, p, parameter)

/// The formulas of p; {} is the parameter. Numbers 1 and 2 are the submission's own functions of
/// 2.3. Number 3 samples the uniform density but reports a pdf of 0 or infinity for some points:
/// these must contribute 0 to the estimate (2.4).
inline constexpr std::array<std::string_view, 5> sampling_names{
    "1 on [0, 1]", "({} + 1) x^{} on [0, 1]", "{} exp(-{} x) for x >= 0",
    "1 on [0, 1], reported as 0 below {} / 2 and as infinite from there to {}",
    "1 + {} (2 x - 1) on [0, 1]"};

/// The formula of an integrand, such as "2 * x^0.5 + 1", and of a density.
inline std::string spelled(const Function& function) {
  std::string all(text::filled(function_names.at(function.g), text::print(function.parameter)));
  if (function.scale != 1) all = text::print(function.scale) + " * " + all;
  if (function.offset < 0) return all + " - " + text::print(-function.offset);
  return function.offset == 0 ? all : all + " + " + text::print(function.offset);
}
inline std::string spelled(const Sampling& sampling) {
  return "p(x) = " + text::filled(sampling_names.at(sampling.p), text::print(sampling.parameter));
}

inline double value_of(const Function& function, std::span<const double> x) {
  switch (function.g) {
    case 0:
      return 1;
    case 1:
      return std::exp(x[0]);
    case 2:
      return x[0] * x[1];
    case 3:
      return x[0] < function.parameter ? 1 : 0;
    case 4:
      return std::pow(x[0], function.parameter);
    case 5: {
      const double dx = x[0] - 0.3, dy = x[1] - 0.7;
      return std::exp(-(dx * dx + dy * dy) / (2 * function.parameter * function.parameter));
    }
    case 6:
      return normal_quantile(x[0]);
    case 7:
      return x[0] * std::exp(-x[0]);
    case 8:
      return x[0] * x[1] * x[2] * x[3] * x[4];
    case 9:
      return std::min(std::pow(x[0], -0.75), function.parameter);
    default:
      return std::accumulate(x.begin(), x.end(), 0.0);
  }
}

inline Integrand integrand(const Function& function) {
  if (function.g >= dimensions.size()) throw std::out_of_range("g: must be 0 to 10");
  const std::size_t dims = dimensions[function.g];
  return {dims, [=](std::span<const double> x) {
            if (x.size() != dims) {
              throw std::logic_error("an integrand of " + std::to_string(dims) +
                                     " dimensions was called with a point of " +
                                     std::to_string(x.size()) + " dimensions");
            }
            return function.scale * value_of(function, x) + function.offset;
          }};
}

}  // namespace mc::experiments
