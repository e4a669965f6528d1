// Not from Boost.Math: compiling its incomplete gamma and beta functions takes 350 MB and several
// seconds in every fresh clone. Here they are a continued fraction and a series;
// distributions_test.cpp compares them with published values.

#include "checks/support/checks.hpp"

namespace mc::checks {
namespace {

constexpr double tiny = 1e-300;        // replaces a zero denominator in Lentz's method
constexpr int most_terms = 1'000'000;  // a series needs a few times the root of its parameters

/// b0 + a1 / (b1 + a2 / (b2 + …)), where `term(i)` returns {a_i, b_i}: by Lentz's method.
template <class Term>
double continued_fraction(double b0, Term term) {
  double fraction = b0, c = b0, d = 0;
  for (double i = 1; i < most_terms; ++i) {
    const auto [a, b] = term(i);
    d = a * d + b;
    c = b + a / c;
    if (std::abs(d) < tiny) d = tiny;
    if (std::abs(c) < tiny) c = tiny;
    d = 1 / d;
    fraction *= d * c;
    if (std::abs(d * c - 1) <= eps) break;
  }
  return fraction;
}

/// The regularized incomplete gamma functions P(a, x) and Q(a, x) = 1 - P. Series and continued
/// fraction: Abramowitz and Stegun 6.5.29 and 6.5.31.
Tails incomplete_gamma(double a, double x) {
  if (!(x > 0)) return {0, 1};
  if (std::isinf(x)) return {1, 0};
  const double front = std::exp(a * std::log(x) - x - std::lgamma(a));
  if (x < a + 1) {
    double term = 1 / a, sum = term;
    for (double n = a + 1; term > sum * eps && n < a + most_terms; ++n) sum += term *= x / n;
    const double lower = front * sum;
    return {lower, 1 - lower};
  }
  const double b0 = x + 1 - a;
  const double upper = front / continued_fraction(b0, [=](double i) {
                         return std::pair{-i * (i - a), b0 + 2 * i};
                       });
  return {1 - upper, upper};
}

/// The continued fraction of the incomplete beta function (Abramowitz and Stegun 26.5.8), for x <
/// (a+1)/(a+b+2).
double beta_fraction(double a, double b, double x) {
  return 1 / continued_fraction(1, [=](double i) {
           const double m = std::floor(i / 2), a2 = a + 2 * m;
           const double step = std::fmod(i, 2) == 0 ? m * (b - m) * x / ((a2 - 1) * a2)
                                                    : -(a + m) * (a + b + m) * x / (a2 * (a2 + 1));
           return std::pair{step, 1.0};
         });
}

/// The regularized incomplete beta functions I_x(a, b) and 1 - I_x(a, b), given x and y = 1 - x.
Tails incomplete_beta(double a, double b, double x, double y) {
  if (!(x > 0)) return {0, 1};
  if (!(y > 0)) return {1, 0};
  const double front = std::exp(std::lgamma(a + b) - std::lgamma(a) - std::lgamma(b) +
                                a * std::log(x) + b * std::log(y));
  if (x < (a + 1) / (a + b + 2)) {
    const double lower = front * beta_fraction(a, b, x) / a;
    return {lower, 1 - lower};
  }
  const double upper = front * beta_fraction(b, a, y) / b;
  return {1 - upper, upper};
}

}  // namespace

double Tails::two_sided() const {
  const double p = 2 * std::min(lower, upper);
  return p > 0 ? std::min(1.0, p) : 0;
}

Tails normal_tails(double z) {
  const double root_half = std::numbers::sqrt2 / 2;
  return {std::erfc(-z * root_half) / 2, std::erfc(z * root_half) / 2};
}

Tails chi_squared_tails(double x, double degrees) {
  if (std::isnan(x)) return {0, 0};
  return incomplete_gamma(degrees / 2, x / 2);
}

Tails f_tails(double x, double degrees_above, double degrees_below) {
  if (std::isnan(x)) return {0, 0};
  if (std::isinf(x)) return {1, 0};
  const double above = degrees_above * x, all = above + degrees_below;
  return incomplete_beta(degrees_above / 2, degrees_below / 2, above / all, degrees_below / all);
}

Tails binomial_tails(std::uint64_t k, std::uint64_t n, double p) {
  if (k > n || std::isnan(p)) return {0, 0};
  const auto successes = static_cast<double>(k), failures = static_cast<double>(n - k);
  return {k == n ? 1 : incomplete_beta(failures, successes + 1, 1 - p, p).lower,
          k == 0 ? 1 : incomplete_beta(successes, failures + 1, p, 1 - p).lower};
}

// For p < 0.05, twice the one-sided tail, which is a finite sum of positive terms (Birnbaum and
// Tingey 1951); this counts less than 1e-4 of it twice (Simard and L'Ecuyer 2011, "Computing the
// two-sided Kolmogorov-Smirnov distribution", section 2.4). Elsewhere Kolmogorov's limit at Vrbik's
// argument (2018, "Small-sample corrections to Kolmogorov-Smirnov test statistic").
Tails kolmogorov_tails(double d, std::uint64_t n) {
  if (std::isnan(d)) return {0, 0};
  const auto size = static_cast<double>(n);
  const double scaled = d * std::sqrt(size);
  const double t = scaled + 1 / (6 * std::sqrt(size)) + (scaled - 1) / (4 * size);
  Tails tails{0, 1};
  if (t < 1) {  // the theta function in the form that converges for small t
    if (t > 0.04) {
      for (int i = 1; i < 40; i += 2) {
        tails.lower += std::exp(-i * i * std::numbers::pi * std::numbers::pi / (8 * t * t));
      }
      tails.lower *= std::sqrt(2 * std::numbers::pi) / t;
    }
    tails.upper = 1 - tails.lower;
    return tails;
  }
  tails.upper = 0;
  for (int i = 1; i < 20; ++i) tails.upper += (i % 2 == 1 ? 2 : -2) * std::exp(-2 * i * i * t * t);
  if (tails.upper < 0.05) {
    const double log_factorial = std::lgamma(size + 1);
    double one_sided = 0;
    for (double j = 0; j <= std::floor(size * (1 - d)); ++j) {
      const double rest = 1 - d - j / size;
      if (!(rest > 0)) break;
      one_sided += std::exp(log_factorial - std::lgamma(j + 1) - std::lgamma(size - j + 1) +
                            (j - 1) * std::log(d + j / size) + (size - j) * std::log(rest));
    }
    tails.upper = 2 * d * one_sided;
  }
  tails.lower = 1 - tails.upper;
  return tails;
}

// One bucket per value, so that each holds few: three times as fast as std::sort.
void sort_uniforms(std::vector<double>& values) {
  const std::size_t n = values.size();
  const auto size = static_cast<double>(n);
  const auto bucket = [&](double u) {
    return static_cast<std::size_t>(std::clamp(u * size, 0.0, size - 1));
  };
  std::vector<std::uint32_t> end(n + 1);
  for (const double u : values) ++end[bucket(u) + 1];
  for (std::size_t b = 0; b < n; ++b) end[b + 1] += end[b];
  std::vector<double> sorted(n);
  for (const double u : values) sorted[end[bucket(u)]++] = u;
  for (std::size_t b = 0, first = 0; b < n; first = end[b++]) {
    if (end[b] - first > 16) std::sort(&sorted[first], &sorted[first] + (end[b] - first));
  }
  for (std::size_t i = 1; i < n; ++i) {  // insertion sort for the others
    for (std::size_t k = i; k > 0 && sorted[k - 1] > sorted[k]; --k)
      std::swap(sorted[k - 1], sorted[k]);
  }
  values = std::move(sorted);
}

double distance_from_uniform(std::vector<double>& values) {
  sort_uniforms(values);
  const auto n = static_cast<double>(values.size());
  double distance = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double below = static_cast<double>(i) / n;
    distance = std::max({distance, values[i] - below, below + 1 / n - values[i]});
  }
  return distance;
}

Interval central_interval(const std::function<Tails(double)>& tails, double alpha, double low,
                          double high) {
  const auto boundary = [&](auto is_above) {
    double below = low, above = high;
    for (int i = 0; i < 200 && above - below > 1e-12 * std::abs(above); ++i) {
      const double middle = (below + above) / 2;
      (is_above(tails(middle)) ? above : below) = middle;
    }
    return above;
  };
  return {boundary([&](const Tails& at) { return at.lower >= alpha / 2; }),
          boundary([&](const Tails& at) { return at.upper < alpha / 2; })};
}

}  // namespace mc::checks
