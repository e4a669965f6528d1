#include "data_sets.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

namespace mc::checks {
namespace {

/// Moments of a list in which each value stands so many times.
ExactMoments exact_of_counts(std::span<const std::pair<double, double>> values_and_counts) {
  Exact count, sum, m2;
  for (const auto& [value, times] : values_and_counts) {
    count = count + Exact(times);
    sum = sum + Exact(value) * Exact(times);
  }
  const Exact mean = sum / count;
  for (const auto& [value, times] : values_and_counts) {
    m2 = m2 + (Exact(value) - mean) * (Exact(value) - mean) * Exact(times);
  }
  ExactMoments all;
  all.count = static_cast<double>(count);
  all.mean = mean;
  all.m2 = m2;
  all.variance = static_cast<double>(m2 / (count - Exact(1)));
  return all;
}

double either_sign(Rng& rng, double size) {
  return rng() % 2 == 0 ? size : -size;
}

}  // namespace

Values tame_values(Rng& rng, std::size_t n, double low, double high) {
  Values x = uniform_values(rng, n, low, high);
  const double quarter = (high - low) / 4;
  if (n > 1) {
    x[0] = uniform(rng, low, low + quarter);
    x[1] = uniform(rng, high - quarter, high);
  }
  return x;
}

Values shifted_pattern(Rng& rng, double offset, std::size_t n) {
  const double base = offset + static_cast<double>(rng() % 1000);
  const double pattern[] = {4, 7, 13, 16};
  Values x(n);
  for (std::size_t i = 0; i < n; ++i) x[i] = base + pattern[i % 4];
  std::shuffle(x.begin(), x.end(), rng);
  return x;
}

Values numacc(int number, Rng& rng) {
  const double scale = std::ldexp(1.0, static_cast<int>(rng() % 17) - 8);
  if (number == 1) return {10000001 * scale, 10000003 * scale, 10000002 * scale};
  const double first[] = {1.2, 1000000.2, 10000000.2};
  const double low[] = {1.1, 1000000.1, 10000000.1};
  const double high[] = {1.3, 1000000.3, 10000000.3};
  Values x{first[number - 2] * scale};
  for (int i = 0; i < 500; ++i) {
    x.push_back(low[number - 2] * scale);
    x.push_back(high[number - 2] * scale);
  }
  return x;
}

std::vector<HardList> one_outlier_lists(Rng& rng, int of_each) {
  constexpr std::size_t n = 100'001;  // odd: the middle is in one place
  const std::pair<const char*, std::size_t> places[] = {{"the outlier comes first", 0},
                                                        {"the outlier is in the middle", n / 2},
                                                        {"the outlier comes last", n - 1}};
  std::vector<HardList> lists;
  for (const auto& [name, place] : places) {
    for (int i = 0; i < of_each; ++i) {
      const double usual = uniform(rng, 1, 2);
      const double outlier = either_sign(rng, uniform(rng, 1e9, 2e9));
      Values x(n, usual);
      x[place] = outlier;
      const std::pair<double, double> counts[] = {{usual, n - 1}, {outlier, 1}};
      lists.push_back({name, std::move(x), exact_of_counts(counts)});
    }
  }
  return lists;
}

HardList several_outliers(Rng& rng) {
  constexpr std::size_t n = std::size_t{1} << 20;
  const double usual = uniform(rng, 1, 2);
  std::vector<std::pair<double, double>> counts{{usual, n - 3}};
  Values x(n, usual);
  for (const std::size_t place : {std::size_t{0}, n / 2, n - 1}) {
    x[place] = either_sign(rng, uniform(rng, 1e9, 9e9));
    counts.emplace_back(x[place], 1);
  }
  return {"three outliers: first, in the middle, and last", std::move(x), exact_of_counts(counts)};
}

std::vector<HardList> short_hard_lists(Rng& rng) {
  Values one_outlier(1000, 1.0);
  one_outlier[rng() % 1000] = uniform(rng, 1e9, 1e10);
  Values sorted = uniform_values(rng, 1000, 0, 1);
  std::sort(sorted.begin(), sorted.end());
  Values trend(1000);
  std::iota(trend.begin(), trend.end(), uniform(rng, 1e5, 1e6));
  Values alternating{1.0};
  for (int i = 0; i < 500; ++i) alternating.insert(alternating.end(), {1e8, -1e8});
  std::vector<HardList> lists{{"one outlier", std::move(one_outlier), {}},
                              {"sorted", std::move(sorted), {}},
                              {"a trend", std::move(trend), {}},
                              {"alternating", std::move(alternating), {}}};
  for (HardList& list : lists) list.exact = exact_moments(list.x);
  return lists;
}

std::vector<Values> without_finite_variance(Rng& rng) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  std::vector<Values> lists{{1e300, 2e300, 3e300}, {1.7e308, -1.7e308, 1.7e308, -1.7e308}};
  for (const double odd_one : {nan, inf, -inf}) {
    Values x = uniform_values(rng, 100, 1, 2);
    x[rng() % x.size()] = odd_one;
    lists.push_back(std::move(x));
  }
  return lists;
}

}  // namespace mc::checks
