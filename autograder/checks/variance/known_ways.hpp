#pragma once
// The ways to a variance that a submission may have gone, right ones and wrong ones, in double:
// what
// they give is what a hint compares with.

#include <span>

namespace mc::checks {

double textbook_from_means(std::span<const double> x);  ///< (E{X^2} - E{X}^2) n/(n-1)
double textbook_from_sums(std::span<const double> x);   ///< (sum of x^2 - (sum of x)^2/n) / (n-1)
double two_pass_here(std::span<const double> x);        ///< corrected, not stopped at 0
double uncorrected_here(std::span<const double> x);     ///< two passes, as if the mean were exact

/// One pass of sums about a shift.
struct About {
  double mean, m2;
};
About about(std::span<const double> x, double shift);

/// What Welford's update makes of x, and what each of its well-known misreadings does.
struct Welford {
  double m2 = 0;
  double from_old_means = 0;  ///< (x - old mean)^2 in place of (x - old mean)(x - new mean)
  double from_new_means = 0;  ///< (x - new mean)^2
  double about_first = 0;     ///< the mean never moves from the first value
};
Welford welford_here(std::span<const double> x);

/// The sum of x by std::accumulate(…, 0): every partial sum is cut off to a whole number.
double sum_in_whole_numbers(std::span<const double> x);

}  // namespace mc::checks
