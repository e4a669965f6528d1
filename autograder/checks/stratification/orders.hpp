#pragma once
// Orders: all of few things equally likely, those of many things without a trend.

#include <cmath>
#include <numeric>

#include "checks/stratification/jitter.hpp"

namespace mc::checks {

using Order = std::vector<std::size_t>;  ///< a permutation of 0 … n-1

inline constexpr std::pair<std::size_t, std::size_t> pairs_of_three[] = {{0, 1}, {0, 2}, {1, 2}};

/// The number, below n!, of a permutation of 0 … n-1 (Lehmer's code).
inline std::size_t rank_of(std::span<const std::size_t> order) {
  std::size_t rank = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const auto smaller = std::count_if(order.begin() + static_cast<std::ptrdiff_t>(i), order.end(),
                                       [&](std::size_t other) { return other < order[i]; });
    rank = rank * (order.size() - i) + static_cast<std::size_t>(smaller);
  }
  return rank;
}

/// Orders of `size` things (each a permutation, one after the other) are all equally likely.
inline void expect_all_orders(const std::string& call, const Order& orders, std::size_t size,
                              const std::string& words, const std::string& always,
                              const std::string& otherwise) {
  std::size_t count = 1;
  for (std::size_t i = 2; i <= size; ++i) count *= i;
  std::vector<std::uint64_t> counts(count);
  for (std::size_t first = 0; first + size <= orders.size(); first += size) {
    ++counts[rank_of(std::span(orders).subspan(first, size))];
  }
  const double each = 1 / static_cast<double>(count);
  const bool only_one = *std::max_element(counts.begin(), counts.end()) * size == orders.size();
  expect_counts(fmt::format("{}, permutations of {}, of which there are {}", call, size, count),
                counts, std::span(&each, 1), {words, alpha}, {{}, only_one ? always : otherwise});
}

/// For each set, the order of `to` where `from` is taken in order.
inline Order relative_orders(const Order& from, const Order& to, std::size_t size) {
  Order orders(from.size());
  for (std::size_t k = 0; k < from.size(); ++k) orders[k / size * size + from[k]] = to[k];
  return orders;
}

/// How an order of n things goes on from place to place, as two numbers that are standard normal if
/// all n! orders are equally likely, and next to uncorrelated (2 sqrt(12) / n).
struct Trend {
  double correlation;  ///< Spearman's rank correlation of place and value, times sqrt(n - 1)
  double ascents;      ///< places with a larger value behind them: (n-1)/2 on average, and of
                       ///< variance (n+1)/12 (Knuth, "The art of computer programming", 5.1.3)
};
inline Trend trend_of(const Order& order) {
  const auto n = static_cast<double>(order.size()), middle = (n - 1) / 2;
  double products = 0, ascents = 0;
  for (std::size_t k = 0; k < order.size(); ++k) {
    products += (static_cast<double>(k) - middle) * (static_cast<double>(order[k]) - middle);
    if (k + 1 < order.size() && order[k] < order[k + 1]) ++ascents;
  }
  return {products / (n * (n * n - 1) / 12) * std::sqrt(n - 1),
          (ascents - middle) / std::sqrt((n + 1) / 12)};
}

}  // namespace mc::checks
