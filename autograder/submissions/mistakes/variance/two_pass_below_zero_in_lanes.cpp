// mistake: lets the correction take the variance of constant data below zero, with sums in four lanes
// caught by: 1.3 the variance of constant data is zero
// hint: the correction is rounded, and may be larger than the sum: return 0 then
#include "variance.hpp"
#define variance_two_pass right_variance_two_pass
#include "solutions/variance.cpp"
#undef variance_two_pass

namespace mc {
namespace {

constexpr std::size_t sums_at_once = 4;

template <class Term>
double sum_in_lanes(std::span<const double> x, Term term) {
  double sums[sums_at_once] = {};
  for (std::size_t i = 0; i < x.size(); ++i) sums[i % sums_at_once] += term(x[i]);
  return (sums[0] + sums[1]) + (sums[2] + sums[3]);
}

}  // namespace

double variance_two_pass(std::span<const double> x) {
  if (x.size() < 2) return nan;
  const auto n = static_cast<double>(x.size());
  const double centre = sum_in_lanes(x, [](double value) { return value; }) / n;
  const double m2 = sum_in_lanes(x, [=](double v) { return (v - centre) * (v - centre); });
  const double correction = sum_in_lanes(x, [=](double value) { return value - centre; });
  return (m2 - correction * correction / n) / (n - 1);
}

}  // namespace mc
