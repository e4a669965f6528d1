#include "known_ways.hpp"

#include <cmath>

namespace mc::checks {

double textbook_from_means(std::span<const double> x) {
  const auto n = static_cast<double>(x.size());
  double sum = 0, squares = 0;
  for (const double value : x) {
    sum += value;
    squares += value * value;
  }
  return (squares / n - sum / n * (sum / n)) * n / (n - 1);
}

double textbook_from_sums(std::span<const double> x) {
  const auto n = static_cast<double>(x.size());
  double sum = 0, squares = 0;
  for (const double value : x) {
    sum += value;
    squares += value * value;
  }
  return (squares - sum * sum / n) / (n - 1);
}

About about(std::span<const double> x, double shift) {
  double sum = 0, squares = 0;
  for (const double value : x) {
    sum += value - shift;
    squares += (value - shift) * (value - shift);
  }
  const auto n = static_cast<double>(x.size());
  return {shift + sum / n, squares - sum * sum / n};
}

double uncorrected_here(std::span<const double> x) {
  const auto n = static_cast<double>(x.size());
  double sum = 0, squares = 0;
  for (const double value : x) sum += value;
  const double mean = sum / n;
  for (const double value : x) squares += (value - mean) * (value - mean);
  return squares / (n - 1);
}

double two_pass_here(std::span<const double> x) {
  const auto n = static_cast<double>(x.size());
  double sum = 0;
  for (const double value : x) sum += value;
  return about(x, sum / n).m2 / (n - 1);
}

Welford welford_here(std::span<const double> x) {
  Welford sums;
  double mean = 0, count = 0;
  for (const double value : x) {
    const double before = value - mean;
    mean += before / ++count;
    const double after = value - mean;
    sums.m2 += before * after;
    sums.from_old_means += before * before;
    sums.from_new_means += after * after;
    sums.about_first += (value - x[0]) * (value - x[0]);
  }
  return sums;
}

double sum_in_whole_numbers(std::span<const double> x) {
  double sum = 0;
  for (const double value : x) sum = std::trunc(sum + value);
  return sum;
}

}  // namespace mc::checks
