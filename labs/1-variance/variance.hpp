#pragma once
// Lab 1 · variance: what you implement, in starter/variance.cpp. The handout is README.md here.
//
// Var{X} = E{(X - E{X})^2} is one line of mathematics. Each function below is one way of getting a
// computer to agree with it. Throughout: what is undefined is a quiet NaN, misuse throws
// std::invalid_argument naming the argument, and "variance" is the sample variance, over n - 1. An
// infinity or a NaN among the values is never hidden: what depends on it is infinite or NaN, too.

#include <cstddef>
#include <cstdint>
#include <span>

namespace mc {

/// 1.1  The mean of `x`. NaN if there are no values. Finite wherever the true mean is a double, so
/// also for {1e308, 1e308} and {-1e308, -1e308}, whose sums are not.
double mean(std::span<const double> x);

/// 1.2  Sample variance by the handy fact Var{X} = E{X^2} - E{X}^2, scaled by n/(n-1). In double,
/// and uncorrected: it is here to be seen failing. NaN for fewer than two values.
double variance_textbook(std::span<const double> x);

/// 1.3  Sample variance by the corrected two-pass algorithm: first the mean, then the squared
/// deviations from it, then the correction for the rounding of the mean (Chan, Golub, LeVeque 1983,
/// "Algorithms for computing the sample variance", eq. 1.7). Never negative; for constant data c it
/// is 0, give or take the square of one rounding error, (eps c)^2. NaN for fewer than two values.
double variance_two_pass(std::span<const double> x);

/// The first two moments of a stream, as Welford keeps them.
struct Moments {
  std::uint64_t count = 0;  ///< values seen so far
  double mean = 0;          ///< their mean; 0 when there are none
  double m2 = 0;            ///< sum of squared deviations from their mean
};

/// 1.4  Takes one more value into `moments`, in constant memory (Welford 1962; Knuth, TAOCP vol. 2,
/// 4.2.2, eq. 15-16). The count has 64 bits, all of which count.
void add(Moments& moments, double x);

/// 1.4  The sample variance of everything added so far. NaN below two values.
double variance(const Moments& moments);

/// 1.5  The moments of two streams put together, from their moments alone (Chan, Golub, LeVeque
/// 1983, eq. 2.1). Either may be empty, and one may be 10^15 times the other. Counts multiply to
/// more than 64 bits: multiply them as doubles.
Moments merge(const Moments& a, const Moments& b);

/// 1.6  Sample covariance of the pairs (x[i], y[i]), over n - 1. NaN for fewer than two pairs. Its
/// error is at most 10 n eps (kappa_x + kappa_y) sigma_x sigma_y with kappa = sqrt(1 + mean^2 /
/// variance) of each, whatever the scales of x and y are, alike or not.
/// Throws std::invalid_argument where the sizes of x and y differ.
double covariance(std::span<const double> x, std::span<const double> y);

/// 1.7  How far a joint distribution is from independence: max |p(x,y) - p(x) p(y)|. `joint` is a
/// table of weights, row by row, `columns` wide; any positive total that is a double (it is
/// normalised here). Zero, up to 4 eps, exactly when X and Y are independent. Throws
/// std::invalid_argument for no columns, a size that is no multiple of `columns`, a negative,
/// infinite or NaN weight, a total that is not positive.
double dependence(std::span<const double> joint, std::size_t columns);

/// 1.8  The speed task: the moments of `x`, all at once, as fast as you can and with no fewer
/// digits than 1.3 (1.5 digits of grace). Moments{} for no values.
Moments moments(std::span<const double> x);

}  // namespace mc
