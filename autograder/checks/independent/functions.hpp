#pragma once
// The integrands and densities of experiments.hpp, as the checks of lab 2 know them.

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "2-independent/experiments.hpp"
#include "checks/support/data.hpp"
#include "checks/support/population.hpp"

namespace mc::checks {

using Values = std::vector<double>;
using experiments::Function;

inline constexpr double eps = std::numeric_limits<double>::epsilon();
inline constexpr double denormal = std::numeric_limits<double>::denorm_min();
inline constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Of each random test. There are 56 of them in this lab, so their sum is 5.6e-7: a factor of
/// nearly two below 1e-6 for what is not exactly Gaussian about a mean of a thousand values.
inline constexpr double alpha = 1e-8;

/// Function::g
enum : unsigned { constant, exponential, product, step, power, peak, normal, gamma, five };

/// Sampling::p
enum : unsigned { by_uniform, by_power, by_exponential, by_holes };

inline std::size_t dims_of(const Function& g) {
  return g.g == product || g.g == peak ? 2 : g.g == five ? 5 : 1;
}

/// g with a scale and an offset that nobody knows beforehand.
inline Function fresh(unsigned g, Rng& rng, double parameter = 0) {
  return {g, parameter, uniform(rng, 0.5, 4), uniform(rng, -3, 3)};
}

inline Population transformed(const Population& x, const Function& function) {
  return transformed(x, function.scale, function.offset);
}
inline Population of_exponential() {  // exp(U): E{exp(kU)} = (e^k - 1) / k
  const auto moment = [](double k) { return std::expm1(k) / k; };
  return population(moment(1), moment(2), moment(3), moment(4));
}
inline Population of_product() {  // UV: 1 / (k + 1)^2
  return population(1.0 / 4, 1.0 / 9, 1.0 / 16, 1.0 / 25);
}
inline Population of_step(double p) {
  return population(p, p, p, p);
}

/// The values of estimates, one after the other.
template <class Estimates>
Values values_of(const Estimates& estimates) {
  Values all;
  for (const auto& one : estimates) all.push_back(one.value);
  return all;
}

/// Estimates that must be numbers: each value finite.
void require_finite(const std::string& call, const Values& values);

}  // namespace mc::checks
