#include "checks/support/strata.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <vector>

#include <fmt/format.h>

#include "checks/support/distributions.hpp"

namespace mc::checks {
namespace {

using Order = std::vector<std::size_t>;

/// How likely each order of n values is where every value changes places with any of them: of n^n
/// equally likely ways. Of the order, or of its inverse.
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

std::string shuffle_hint(std::span<const std::size_t> orders, std::size_t n,
                         const std::string& otherwise) {
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
      return fmt::format("value {} of 0 … {} never moves: all {} take part", k, n - 1, n);
    }
  }
  if (std::all_of(stays.begin(), stays.end(), [](std::size_t times) { return times == 0; })) {
    return "no value ever stays in its place: let it change places with itself too (j from i, not "
           "from i + 1)";
  }
  if (rotations == orders.size() / n) {
    return fmt::format(
        "these are rotations: a random number was added to each value, which gives {} "
        "of the {}! permutations",
        n, n);
  }
  // Where 50 of each are expected, any is missing with probability n! exp(-50) at most.
  const double all = std::tgamma(static_cast<double>(n) + 1);
  if (static_cast<double>(found.size()) < all && count > 50 * all) {
    return fmt::format("only {} of the {} permutations ever come", found.size(), all);
  }
  for (const unsigned way : {0u, 1u, 2u, 3u}) {
    const auto chances = chances_of_swaps_with_any(n, way % 2 == 1, way / 2 == 1);
    double chi_squared = 0;
    for (const auto& [order, chance] : chances) {
      const double expected = chance * count, off = found[order] - expected;
      chi_squared += off * off / expected;
    }
    if (chi_squared_tails(chi_squared, static_cast<double>(chances.size() - 1)).upper > 1e-8) {
      return "each value changes places with any of the n, which favors some permutations: with "
             "itself or one of those not placed yet (j from i to n-1)";
    }
  }
  return otherwise;
}

}  // namespace mc::checks
