// Mistakes in task 2.2.
#include "independent.hpp"

#include <numeric>

#define estimate right_estimate
#include "solutions/independent.cpp"
#undef estimate

namespace mc {
namespace {

/// The values of g at n uniform points.
std::vector<double> values_of(const Integrand& g, std::uint64_t n, Rng& rng) {
  require_samples(n);
  std::vector<double> x(g.dims), values;
  for (std::uint64_t i = 0; i < n; ++i) {
    for (double& coordinate : x) coordinate = to_unit(rng());
    values.push_back(g.f(x));
  }
  return values;
}

/// The mean of g at n points, each of them made by move(i, point).
template <class Move>
Estimate mean_at(const Integrand& g, std::uint64_t n, Move move) {
  require_samples(n);
  std::vector<double> x(g.dims);
  Moments values;
  for (std::uint64_t i = 0; i < n; ++i) {
    move(i, x);
    add(values, g.f(x));
  }
  return mean_of(values);
}

}  // namespace
}  // namespace mc

// mistake: uses a copy of the generator, so every estimate has the same points
// hint: the generator must advance: do not use a copy of it
namespace mc::a_copy_of_the_generator {
Estimate estimate(const Integrand& g, std::uint64_t n, Rng& rng) {
  Rng copy = rng;
  return right_estimate(g, n, copy);
}
}  // namespace mc::a_copy_of_the_generator

// mistake: draws points from its own generator, with a fixed seed
// hint: take all random numbers from rng
namespace mc::a_fixed_generator {
Estimate estimate(const Integrand& g, std::uint64_t n, Rng&) {
  Rng own(42);
  return right_estimate(g, n, own);
}
}  // namespace mc::a_fixed_generator

// mistake: mirrors the previous point for every second one: the points are not independent
// hint: no mirror image 1 - u
// hint: nearly mirror images
namespace mc::antithetic_points {
Estimate estimate(const Integrand& g, std::uint64_t n, Rng& rng) {
  return mean_at(g, n, [&](std::uint64_t i, std::vector<double>& x) {
    for (double& u : x) u = i % 2 == 0 ? to_unit(rng()) : 1 - 0x1p-53 - u;
  });
}
}  // namespace mc::antithetic_points

// mistake: returns s / n as the standard error
// hint: this is s / n: the variance falls as 1 / n
namespace mc::error_over_n {
Estimate estimate(const Integrand& g, std::uint64_t n, Rng& rng) {
  const std::vector<double> values = values_of(g, n, rng);
  const double s = std::sqrt(variance_two_pass(values));
  return {mean(values), s / static_cast<double>(n), n};
}
}  // namespace mc::error_over_n

// mistake: stores the sum before it adds the last value
// hint: the last value is not in the sum
namespace mc::last_value_lost {
Estimate estimate(const Integrand& g, std::uint64_t n, Rng& rng) {
  const std::vector<double> values = values_of(g, n, rng);
  double sum = 0, total = 0;
  for (const double value : values) {
    total = sum;
    sum += value;
  }
  const auto size = static_cast<double>(n);
  return {total / size, std::sqrt(variance_two_pass(values) / size), n};
}
}  // namespace mc::last_value_lost

// mistake: divides the mean by n - 1 too
// hint: this divides by n - 1; only a variance does
namespace mc::mean_over_n_minus_1 {
Estimate estimate(const Integrand& g, std::uint64_t n, Rng& rng) {
  const std::vector<double> values = values_of(g, n, rng);
  double sum = 0;
  for (const double value : values) sum += value;
  const auto size = static_cast<double>(n);
  return {sum / (size - 1), std::sqrt(variance_two_pass(values) / size), n};
}
}  // namespace mc::mean_over_n_minus_1

// mistake: divides s^2 by n instead of n - 1
// hint: s^2 divides by n - 1
namespace mc::n_below_the_variance {
Estimate estimate(const Integrand& g, std::uint64_t n, Rng& rng) {
  const std::vector<double> values = values_of(g, n, rng);
  const auto size = static_cast<double>(n);
  const double center = mean(values);
  double squares = 0;
  for (const double value : values) squares += (value - center) * (value - center);
  return {center, std::sqrt(squares / size / size), n};
}
}  // namespace mc::n_below_the_variance

// mistake: uses one random number for every coordinate, so all points lie on the diagonal
// hint: the points lie on a line
namespace mc::one_number_for_all {
Estimate estimate(const Integrand& g, std::uint64_t n, Rng& rng) {
  return mean_at(g, n, [&](std::uint64_t, std::vector<double>& x) {
    std::fill(x.begin(), x.end(), to_unit(rng()));
  });
}
}  // namespace mc::one_number_for_all

// mistake: draws the point once, before the loop
// hint: draw a new random number for each
// hint: take new numbers from rng inside the loop
namespace mc::one_point {
Estimate estimate(const Integrand& g, std::uint64_t n, Rng& rng) {
  return mean_at(g, n, [&](std::uint64_t i, std::vector<double>& x) {
    if (i > 0) return;
    for (double& u : x) u = to_unit(rng());
  });
}
}  // namespace mc::one_point

// mistake: starts the loop at 1: n - 1 evaluations
// hint: the loop may begin at 1
namespace mc::one_too_few {
Estimate estimate(const Integrand& g, std::uint64_t n, Rng& rng) {
  require_samples(n);
  std::vector<double> x(g.dims);
  Moments values;
  for (std::uint64_t i = 1; i < n; ++i) {
    for (double& coordinate : x) coordinate = to_unit(rng());
    add(values, g.f(x));
  }
  return mean_of(values);
}
}  // namespace mc::one_too_few

// mistake: runs the loop to n inclusive: n + 1 evaluations, divided by n
// hint: may end at i <= n
namespace mc::one_too_many {
Estimate estimate(const Integrand& g, std::uint64_t n, Rng& rng) {
  require_samples(n);
  return mean_at(g, n + 1, [&](std::uint64_t, std::vector<double>& x) {
    for (double& u : x) u = to_unit(rng());
  });
}
}  // namespace mc::one_too_many

// mistake: makes coordinates as floats, of 24 bits
// hint: only 24 of 53
namespace mc::points_of_a_float {
Estimate estimate(const Integrand& g, std::uint64_t n, Rng& rng) {
  return mean_at(g, n, [&](std::uint64_t, std::vector<double>& x) {
    for (double& u : x) u = static_cast<float>(rng() >> 40) * 0x1p-24f;
  });
}
}  // namespace mc::points_of_a_float

// mistake: keeps its own generator from call to call, seeded by the first
// hint: a static or global variable keeps its value between calls
namespace mc::seeded_once {
Estimate estimate(const Integrand& g, std::uint64_t n, Rng& rng) {
  static Rng own(rng());
  return right_estimate(g, n, own);
}
}  // namespace mc::seeded_once

// mistake: sums with std::accumulate(..., 0), in int
// hint: added up in an int
namespace mc::sum_in_whole_numbers {
Estimate estimate(const Integrand& g, std::uint64_t n, Rng& rng) {
  const std::vector<double> values = values_of(g, n, rng);
  const auto size = static_cast<double>(n);
  const int sum = std::accumulate(values.begin(), values.end(), 0);
  return {sum / size, std::sqrt(variance_two_pass(values) / size), n};
}
}  // namespace mc::sum_in_whole_numbers

// mistake: computes the standard error from E{X^2} - E{X}^2, which cancels far from 0
// hint: E{X^2} - E{X}^2 loses digits
namespace mc::textbook_error {
Estimate estimate(const Integrand& g, std::uint64_t n, Rng& rng) {
  const std::vector<double> values = values_of(g, n, rng);
  return {mean(values), std::sqrt(variance_textbook(values) / static_cast<double>(n)), n};
}
}  // namespace mc::textbook_error

// mistake: returns s^2 / n as the standard error, without the square root
// hint: this is the variance of the mean: take the square root
namespace mc::variance_as_error {
Estimate estimate(const Integrand& g, std::uint64_t n, Rng& rng) {
  Estimate result = right_estimate(g, n, rng);
  result.standard_error *= result.standard_error;
  return result;
}
}  // namespace mc::variance_as_error

// mistake: keeps the point in an array of eight coordinates
// hint: of 40 dimensions was called with a point of 8
namespace mc::eight_coordinates_at_most {
Estimate estimate(const Integrand& g, std::uint64_t n, Rng& rng) {
  require_samples(n);
  std::array<double, 8> x{};
  const std::span point = std::span(x).first(std::min(g.dims, x.size()));
  Moments values;
  for (std::uint64_t i = 0; i < n; ++i) {
    for (double& coordinate : point) coordinate = to_unit(rng());
    add(values, g.f(point));
  }
  return mean_of(values);
}
}  // namespace mc::eight_coordinates_at_most
