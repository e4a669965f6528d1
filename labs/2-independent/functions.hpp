#pragma once
// The integrands and densities that lab 2's experiments know, by number and by name. They are
// written here and not by the submission.

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

#include "common/estimation.hpp"
#include "common/normal_quantile.hpp"
#include "runner/text.hpp"
#include "runner/wire.hpp"

namespace mc::experiments {

/// scale * g + offset, g the one of these names; {} is the parameter.
struct Function {
  unsigned g = 0;
  double parameter = 0, scale = 1, offset = 0;
};
MC_FIELDS(Function, g, parameter, scale, offset)

inline constexpr std::array<std::string_view, 9> function_names{
    "1",
    "exp(x)",
    "x y",
    "(1 if x < {}, else 0)",
    "x^{}",
    "exp(-((x - 0.3)^2 + (y - 0.7)^2) / (2 {}^2))",
    "normal_quantile(x)",
    "x exp(-x)",
    "v w x y z"};
inline constexpr std::array<std::size_t, 9> dimensions{1, 1, 2, 1, 1, 2, 1, 1, 5};

/// A density to sample by, the one of these names; {} is the parameter. That of number 3 is there
/// for points that must not count.
struct Sampling {
  unsigned p = 0;
  double parameter = 0;
};
MC_FIELDS(Sampling, p, parameter)

inline constexpr std::array<std::string_view, 4> sampling_names{
    "1 on [0, 1]", "({} + 1) x^{} on [0, 1]", "{} exp(-{} x) for x >= 0",
    "1 on [0, 1], which claims to be 0 below {} / 2 and infinite from there to {}"};

/// As a formula: "2 * x^0.5 + 1".
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
    default:
      return x[0] * x[1] * x[2] * x[3] * x[4];
  }
}

inline Integrand integrand(const Function& function) {
  if (function.g >= dimensions.size()) throw std::out_of_range("g: 0 to 8");
  const std::size_t dims = dimensions[function.g];
  return {dims, [=](std::span<const double> x) {
            if (x.size() != dims) {
              throw std::logic_error("the integrand of " + std::to_string(dims) +
                                     " dimensions was given a point of " +
                                     std::to_string(x.size()));
            }
            return function.scale * value_of(function, x) + function.offset;
          }};
}

inline Density density(const Sampling& sampling) {
  const double parameter = sampling.parameter;
  switch (sampling.p) {
    case 0:
      return {[](double u) { return u; }, [](double x) { return x >= 0 && x <= 1 ? 1.0 : 0.0; }};
    case 1:
      return {[=](double u) { return std::pow(u, 1 / (parameter + 1)); },
              [=](double x) { return (parameter + 1) * std::pow(x, parameter); }};
    case 2:
      return {[=](double u) { return -std::log1p(-u) / parameter; },
              [=](double x) { return parameter * std::exp(-parameter * x); }};
    case 3:
      return {[](double u) { return u; },
              [=](double x) {
                if (x < parameter / 2) return 0.0;
                return x < parameter ? std::numeric_limits<double>::infinity() : 1.0;
              }};
    default:
      throw std::out_of_range("p: 0 to 3");
  }
}

}  // namespace mc::experiments
