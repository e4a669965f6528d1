// alternative: every list is cut in two until it is one value, and the halves are put together

#include "variance.hpp"
#define mean(x) solution_mean(x)
#define variance_textbook solution_variance_textbook
#define variance_two_pass solution_variance_two_pass
#define covariance solution_covariance
#define moments solution_moments
#include "solutions/variance.cpp"

#include <algorithm>
#undef mean
#undef variance_textbook
#undef variance_two_pass
#undef covariance
#undef moments

namespace mc {
namespace {

/// Sum of term(i) for i in [first, last); log2(n) additions lie on the way of each.
template <class Term>
double pairwise(std::size_t first, std::size_t last, Term term) {
  if (first == last) return 0;
  if (last - first == 1) return term(first);
  const std::size_t middle = first + (last - first) / 2;
  return pairwise(first, middle, term) + pairwise(middle, last, term);
}

/// Moments of offsets from a shift, merged as lab 1.5 merges them.
Moments merged(std::span<const double> x, double shift) {
  if (x.size() == 1) return {1, x[0] - shift, 0};
  const std::size_t half = x.size() / 2;
  return merge(merged(x.first(half), shift), merged(x.subspan(half), shift));
}

}  // namespace

double mean(std::span<const double> x) {
  if (x.size() < 2) return x.empty() ? nan : x[0];
  const std::size_t half = x.size() / 2;
  const double low = mean(x.first(half)), high = mean(x.subspan(half));
  const double share = static_cast<double>(half) / static_cast<double>(x.size());
  return low * share + high * (1 - share);  // never beyond either half: nothing overflows
}

double variance_textbook(std::span<const double> x) {
  if (x.size() < 2) return nan;
  const auto n = static_cast<double>(x.size());
  const double sum = pairwise(0, x.size(), [&](std::size_t i) { return x[i]; });
  const double squares = pairwise(0, x.size(), [&](std::size_t i) { return x[i] * x[i]; });
  return squares / (n - 1) - sum / n * (sum / (n - 1));
}

double variance_two_pass(std::span<const double> x) {
  if (x.size() < 2) return nan;
  const auto n = static_cast<double>(x.size());
  const double center = mean(x);
  const double off = pairwise(0, x.size(), [&](std::size_t i) { return x[i] - center; });
  const double m2 =
      pairwise(0, x.size(), [&](std::size_t i) { return (x[i] - center) * (x[i] - center); });
  return std::max(m2 - off * off / n, 0.0) / (n - 1);
}

double covariance(std::span<const double> x, std::span<const double> y) {
  if (x.size() != y.size()) throw std::invalid_argument("x and y differ in size");
  if (x.size() < 2) return nan;
  const double mean_x = mean(x), mean_y = mean(y);
  return pairwise(0, x.size(), [&](std::size_t i) { return (x[i] - mean_x) * (y[i] - mean_y); }) /
         static_cast<double>(x.size() - 1);
}

Moments moments(std::span<const double> x) {
  if (x.empty()) return {};
  const double shift = mean(x);
  Moments all = merged(x, shift);
  all.mean += shift;
  return all;
}

}  // namespace mc
