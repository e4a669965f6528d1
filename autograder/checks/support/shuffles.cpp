#include <map>

#include "checks/support/checks.hpp"

namespace mc::checks {
namespace {

using Order = std::vector<std::size_t>;

/// The probability of each order of n values (or of its inverse) if every value is swapped with any
/// of the n: n^n equally likely sequences of swaps.
std::map<Order, double> chances_of_swaps_with_any(std::size_t n, bool backwards, bool is_inverse) {
  const double ways = std::pow(n, n);
  std::map<Order, double> chances;
  Order order(n), inverse(n);
  for (std::size_t way = 0; static_cast<double>(way) < ways; ++way) {
    std::iota(order.begin(), order.end(), 0);
    for (std::size_t k = 0, left = way; k < n; ++k, left /= n) {
      std::swap(order[backwards ? n - 1 - k : k], order[left % n]);
    }
    for (std::size_t k = 0; k < n; ++k) inverse[order[k]] = k;
    chances[is_inverse ? inverse : order] += 1 / ways;
  }
  return chances;
}

}  // namespace

Likely shuffle_hint(std::span<const std::size_t> orders, std::size_t n) {
  const auto count = static_cast<double>(orders.size() / n);
  std::map<Order, double> found;
  Order stays(n);
  std::size_t rotations = 0;
  for (std::size_t first = 0; first < orders.size(); first += n) {
    const auto order = orders.subspan(first, n);
    ++found[Order(order.begin(), order.end())];
    bool rotates = true;
    for (std::size_t k = 0; k < n; ++k) {
      stays[k] += order[k] == k ? 1u : 0u;
      rotates = rotates && order[k] == (order[0] + k) % n;
    }
    rotations += rotates ? 1u : 0u;
  }
  for (std::size_t k = 0; k < n; ++k) {
    if (stays[k] == orders.size() / n) {
      return likely("value {} of 0 … {} never moves: shuffle all {} values", k, n - 1, n);
    }
  }
  if (std::ranges::all_of(stays, [](std::size_t times) { return times == 0; })) {
    return "no value ever keeps its place: a value may be swapped with itself (j from i on)"_likely;
  }
  if (rotations == orders.size() / n) {
    return likely(
        "these are rotations: adding a random number gives only {} of the {}! permutations", n, n);
  }
  // If 50 of each are expected, one is missing with probability at most n! exp(-50).
  const double all = std::tgamma(static_cast<double>(n) + 1);
  if (static_cast<double>(found.size()) < all && count > 50 * all) {
    return likely("only {} of the {} permutations occur", found.size(), all);
  }
  for (const unsigned way : {0u, 1u, 2u, 3u}) {
    const auto chances = chances_of_swaps_with_any(n, way % 2 == 1, way / 2 == 1);
    double chi_squared = 0;
    for (const auto& [order, chance] : chances) {
      const double expected = chance * count, off = found[order] - expected;
      chi_squared += off * off / expected;
    }
    if (chi_squared_tails(chi_squared, static_cast<double>(chances.size() - 1)).upper > 1e-8) {
      return "each value is swapped with any of the n values: swap it with itself or a later one "
             "(j from i to n-1)"_likely;
    }
  }
  // The least share of permutations in which two values keep their order.
  double least = 1;
  for (std::size_t j = 1; j < n; ++j) {
    for (std::size_t i = 0; i < j; ++i) {
      double kept = 0;
      for (const auto& [order, times] : found) {
        const auto first = std::ranges::find_if(order, [=](auto v) { return v == i || v == j; });
        kept += *first == i ? times : 0;
      }
      least = std::min(least, kept / count);
    }
  }
  if (least > 0.5 + 5 / std::sqrt(count)) {
    return likely(
        "any two values keep their order in {:.0f} % of the permutations or more, not in 50 %: "
        "values with equal keys must not stay in order",
        100 * least);
  }
  return {};
}

}  // namespace mc::checks
