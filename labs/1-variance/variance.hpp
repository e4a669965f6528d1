#pragma once
// Lab 1 · variance: what you implement in starter/variance.cpp. The handout is README.md in this
// folder.
//
// Var{X} = E{(X - E{X})^2}: each function below computes it in one way, or is one of its facts.
// Throughout:
//
// * Undefined results are a quiet NaN. "Variance" is the sample variance, with divisor n - 1.
// * An infinity or a NaN among the values is never hidden: the result is infinite or NaN.
// * Misuse throws std::invalid_argument with a message that names the argument. A function without
//   a `throws:` line never throws. A function without a `cost:` line takes time linear in the
//   number of values.
// * eps is 2^-52, and kappa is sqrt(1 + mean^2 / variance) of the values.

#include <cstddef>
#include <cstdint>
#include <span>

namespace mc {

/// 1.1  The mean of `x`.
/// requires: any number of values; NaN if there are none. Finite wherever the true mean is a
///   double, so also for {1e308, 1e308} and {-1e308, -1e308}, whose sums overflow, and for any
///   number of values that all are the largest double.
/// source: the definition.
double mean(std::span<const double> x);

/// 1.2  The sample variance by the handy fact Var{X} = E{X^2} - E{X}^2, times n / (n - 1).
/// In double and uncorrected: a check requires that it loses two digits for each digit of the mean.
/// requires: any number of values; NaN for fewer than two.
/// source: Chan, Golub, LeVeque 1983, "Algorithms for computing the sample variance", the textbook
///   algorithm.
double variance_textbook(std::span<const double> x);

/// 1.3  The sample variance by the corrected two-pass algorithm: first the mean, then the squared
/// deviations from it, then the correction for the rounding of the mean. Never negative, and at
/// most (eps c)^2 for up to 100,000 equal values c. Loses at most 10 n eps of the variance.
/// requires: any number of values; NaN for fewer than two. Infinite or NaN where n - 1 times the
///   variance does not fit into a double.
/// source: Chan, Golub, LeVeque 1983, eq. 1.7.
double variance_two_pass(std::span<const double> x);

/// The first two moments of a stream of values.
struct Moments {
  std::uint64_t count = 0;  ///< values seen so far
  double mean = 0;          ///< their mean; 0 when there are none
  double m2 = 0;            ///< sum of squared deviations from their mean
};

/// 1.4  Adds one value to `moments`, by Welford's update. Loses at most 10 n kappa eps of m2.
/// requires: any x; m2 is NaN or infinite after a NaN or an infinity, and after values whose
///   distance does not fit into a double. count + 1 fits into 64 bits.
/// cost: constant time and memory.
/// source: Welford 1962, "Note on a method for calculating corrected sums of squares and products";
///   Knuth, "The art of computer programming", volume 2, section 4.2.2, eq. 15 and 16.
void add(Moments& moments, double x);

/// 1.4  The sample variance of all values added so far: m2 / (count - 1).
/// requires: any 64-bit count; NaN below two.
/// cost: constant.
/// source: as add.
double variance(const Moments& moments);

/// 1.5  The moments of two streams together, from their moments alone.
/// requires: either may be empty, and one may have 10^15 times as many values as the other. The
///   product of the counts may need more than 64 bits: multiply them as doubles. Their sum fits.
///   The mean is finite wherever the true mean is a double, and m2 keeps its digits wherever it is
///   one, also where the distance of the means overflows, or its square is too small for a double.
/// cost: constant.
/// source: Chan, Golub, LeVeque 1983, eq. 2.1.
Moments merge(const Moments& a, const Moments& b);

/// 1.6  The sample covariance of the pairs (x[i], y[i]), over n - 1. Its error is at most
/// 10 n eps (kappa_x + kappa_y) sigma_x sigma_y, at any scales of x and y.
/// requires: x and y of equal size; NaN for fewer than two pairs. All deviations, their products
///   and the sums of both fit into a double.
/// throws: std::invalid_argument if the sizes of x and y differ.
/// source: Schubert, Gertz 2018, "Numerically stable parallel computation of (co-)variance".
double covariance(std::span<const double> x, std::span<const double> y);

/// 1.7  How far a joint distribution is from independence: the largest |p(x,y) - p(x) p(y)|. Where
/// X and Y are independent, only rounding is left: 4 eps, and eps more for each cell if the sums of
/// the weights are rounded.
/// requires: `joint` is a table of weights, row by row, `columns` wide: a row for each x, a column
///   for each y. Their total is positive and fits into a double; the function normalizes them.
/// throws: std::invalid_argument if columns is 0, if the size is not a multiple of `columns`, if a
///   weight is negative, infinite or NaN, and if the total is not positive.
/// source: the definition of independence, p(x,y) = p(x) p(y).
double dependence(std::span<const double> joint, std::size_t columns);

/// 1.8  Stretch, the speed task: the moments of `x`, as fast as you can. m2 has at most one and a
/// half digits fewer than 1.3 has for the same values (or than 15, if 1.3 has more). It is never
/// negative, and at most n (eps c)^2 for up to 4096 equal values c.
/// requires: any number of values; Moments{} for none. Of finite values beyond 1e150, whose squares
///   may overflow, only the count is promised.
/// source: Chan, Golub, LeVeque 1983, on shifted data.
Moments moments(std::span<const double> x);

}  // namespace mc
