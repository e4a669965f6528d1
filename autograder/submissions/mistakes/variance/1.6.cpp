// Mistakes in task 1.6.
#include "variance.hpp"

#define covariance right_covariance
#include "solutions/variance.cpp"
#undef covariance

// mistake: returns the correlation instead of the covariance
// hint: this is the correlation
namespace mc::correlation {
double covariance(std::span<const double> x, std::span<const double> y) {
  return right_covariance(x, y) / std::sqrt(variance_two_pass(x) * variance_two_pass(y));
}
}  // namespace mc::correlation

// mistake: computes the covariance from Var{X + Y}, in which the larger variance swamps the smaller
// hint: as in Var{X + Y}
namespace mc::covariance_by_polarisation {
double covariance(std::span<const double> x, std::span<const double> y) {
  if (x.size() != y.size()) throw std::invalid_argument("x and y: sizes differ");
  std::vector<double> sum(x.begin(), x.end());
  for (std::size_t i = 0; i < x.size(); ++i) sum[i] += y[i];
  return (variance_two_pass(sum) - variance_two_pass(x) - variance_two_pass(y)) / 2;
}
}  // namespace mc::covariance_by_polarisation

// mistake: uses E{XY} - E{X} E{Y}, the textbook formula of the covariance
// hint: E{XY} - E{X}E{Y} is the textbook formula again
namespace mc::covariance_is_textbook {
double covariance(std::span<const double> x, std::span<const double> y) {
  if (x.size() != y.size()) throw std::invalid_argument("x and y: sizes differ");
  if (x.size() < 2) return nan;
  const auto n = static_cast<double>(x.size());
  double products = 0;
  for (std::size_t i = 0; i < x.size(); ++i) products += x[i] * y[i];
  return (products / n - mean(x) * mean(y)) * (n / (n - 1));
}
}  // namespace mc::covariance_is_textbook

// mistake: uses the shorter size if the sizes differ
// hint: refuse this argument by std::invalid_argument
namespace mc::covariance_of_fewer_pairs {
double covariance(std::span<const double> x, std::span<const double> y) {
  const std::size_t pairs = std::min(x.size(), y.size());
  return right_covariance(x.first(pairs), y.first(pairs));
}
}  // namespace mc::covariance_of_fewer_pairs

// mistake: divides by n instead of n - 1
// hint: this divides by n; a sample covariance divides by n - 1
namespace mc::covariance_over_n {
double covariance(std::span<const double> x, std::span<const double> y) {
  const auto n = static_cast<double>(x.size());
  return right_covariance(x, y) * ((n - 1) / n);
}
}  // namespace mc::covariance_over_n

// mistake: returns E{XY} without subtracting anything
// hint: the means were not subtracted
namespace mc::covariance_without_means {
double covariance(std::span<const double> x, std::span<const double> y) {
  if (x.size() != y.size()) throw std::invalid_argument("x and y: sizes differ");
  if (x.size() < 2) return nan;
  double products = 0;
  for (std::size_t i = 0; i < x.size(); ++i) products += x[i] * y[i];
  return products / static_cast<double>(x.size() - 1);
}
}  // namespace mc::covariance_without_means

// mistake: the covariance of one pair is 0
// hint: a sample covariance needs two pairs
namespace mc::covariance_of_one_is_zero {
double covariance(std::span<const double> x, std::span<const double> y) {
  return x.size() == 1 && y.size() == 1 ? 0 : right_covariance(x, y);
}
}  // namespace mc::covariance_of_one_is_zero

// mistake: standardizes both lists, by variances that may be too small or too large for a double
// hint: no term may scale as x^2 or y^2
namespace mc::covariance_by_correlation {
double covariance(std::span<const double> x, std::span<const double> y) {
  double sigma_x = std::sqrt(variance_two_pass(x)), sigma_y = std::sqrt(variance_two_pass(y));
  if (x.size() < 2) return right_covariance(x, y);
  if (sigma_x == 0) sigma_x = 1;
  if (sigma_y == 0) sigma_y = 1;
  std::vector<double> u(x.begin(), x.end()), v(y.begin(), y.end());
  for (double& value : u) value /= sigma_x;
  for (double& value : v) value /= sigma_y;
  return right_covariance(u, v) * sigma_x * sigma_y;
}
}  // namespace mc::covariance_by_correlation

// mistake: standardizes both lists, also those of equal values
// hint: its sigma is 0: do not divide by it
namespace mc::covariance_of_standardized_lists {
double covariance(std::span<const double> x, std::span<const double> y) {
  const double sigma_x = std::sqrt(variance_two_pass(x)), sigma_y = std::sqrt(variance_two_pass(y));
  return right_covariance(x, y) / sigma_x / sigma_y * sigma_x * sigma_y;
}
}  // namespace mc::covariance_of_standardized_lists
