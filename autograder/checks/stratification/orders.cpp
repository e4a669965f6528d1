#include <map>

#include "checks/stratification/orders.hpp"

namespace mc::checks {
namespace {

/// Ends the check if one of R permutations repeats, which has the probability R^2 / 2n! < 1e-9.
void fail_at_repeat(const Permutations& orders, const Randomness& claim) {
  std::map<std::uint64_t, std::size_t> seen;  // by a 64-bit hash
  for (std::size_t k = 0; k < orders.size(); ++k) {
    std::uint64_t hash = 0;
    for (const std::size_t value : orders[k]) hash = mix_bits(hash ^ value);
    const auto [first, is_new] = seen.emplace(hash, k);
    if (is_new) continue;
    const bool is_in_order = std::ranges::is_sorted(orders[k]);
    fail(Failure{fmt::format("{}: permutations {} and {} of {} are equal, with {} values each",
                             orders.call, first->second, k, orders.size(), orders.n),
                 "different permutations",
                 fmt::format("two random permutations of {} are equal with probability 1 / {}!",
                             orders.n, orders.n),
                 is_in_order ? claim.repeated
                             : "few permutations occur at all: rotations, a short seed, or one "
                               "order for several"_likely});
  }
}

/// Ends the check if a value keeps its place in all R permutations: tested if n^(1-R) < 1e-9.
void fail_at_fixed_value(const Permutations& orders) {
  if (static_cast<double>(orders.size() - 1) * std::log(orders.n) < 9 * std::log(10.0)) return;
  for (std::size_t value = 0, stays = 0; value < orders.n; ++value, stays = 0) {
    while (stays < orders.size() && orders[stays][value] == value) ++stays;
    if (stays < orders.size()) continue;
    fail(Failure{fmt::format("{}: value {} of {} keeps its place in all {} permutations",
                             orders.call, value, orders.n, stays),
                 "any value in any place", "",
                 "shuffle all values, including the last one"_likely});
  }
}

/// The hint if many values keep their order or stay together. If short random keys were sorted,
/// more than half of all neighbors ascend. In a random order, values that were neighbors are n / 3
/// places apart on average.
Likely order_hint(std::span<const std::size_t> order) {
  const std::size_t n = order.size();
  if (n < 10000) return {};
  std::size_t ascents = 0;
  Order place(n);
  for (std::size_t k = 0; k < n; ++k) {
    ascents += k > 0 && order[k - 1] < order[k] ? 1u : 0u;
    place[order[k]] = k;
  }
  double apart = 0;
  for (std::size_t i = 1; i < n; ++i) {
    apart +=
        static_cast<double>(std::max(place[i], place[i - 1]) - std::min(place[i], place[i - 1]));
  }
  const auto size = static_cast<double>(n);
  const double share = static_cast<double>(ascents) / size;
  if (n - ascents < 1000) return {};  // most values are in order
  if (share > 0.6)
    return "equal keys stay in order: even 16-bit random numbers are too short"_likely;
  return apart / size > size / 10
             ? Likely{}
             : "neighbors stay near each other: do not shuffle in blocks"_likely;
}

}  // namespace

void expect_fine_choices(const Permutations& orders, Randomness claim, Rng& rng) {
  const std::size_t n = orders.n;
  Order order(orders[0].begin(), orders[0].end()), inverse(n);
  claim.expected = "permutations that are all equally likely";
  for (const unsigned way : {0u, 1u, 2u, 3u}) {
    Uniforms numbers{orders.call, 1};
    std::size_t products = 0, rests = 0;  // values that 16-bit numbers can give
    for (std::size_t k = 0; k < 5000; ++k) {
      const std::size_t left = n - k, v = way < 2 ? order[left - 1] : n - 1 - order[k];
      if (v >= left) continue;
      numbers.values.push_back(fill_cell(v, left, rng));
      products += ((v << 16) + left - 1) / left * left < (v + 1) << 16 ? 1u : 0u;
      rests += v >> 16 == 0 ? 1u : 0u;
    }
    claim.explain = [&]() -> Likely {
      if (10 * std::max(products, rests) < 9 * numbers.values.size()) return order_hint(orders[0]);
      return "16-bit random numbers are too short to choose among so many values"_likely;
    };
    expect_independent_uniforms(numbers, claim, true);
    for (std::size_t k = 0; k < n; ++k) inverse[order[k]] = k;
    std::swap(order, inverse);
  }
}

void expect_random_permutations(const Permutations& orders, const Randomness& claim, Rng& rng,
                                bool only_repeats) {
  if (orders.n >= 20) {
    fail_at_repeat(orders, claim);
    fail_at_fixed_value(orders);
  }
  if (only_repeats) return pass();
  Randomness of_numbers = claim;
  of_numbers.expected = "permutations that are all equally likely";
  const auto later = std::span(orders.values).subspan(orders.n);
  const bool are_equal =
      !later.empty() && std::equal(later.begin(), later.end(), orders.values.begin());
  of_numbers.explain = [&] {
    const Likely hint = are_equal ? claim.repeated : order_hint(orders[0]);
    const bool is_known = hint != Likely{} || orders.n > 5 || orders.size() < 10000;
    return is_known ? hint : shuffle_hint(orders.values, orders.n);
  };
  Uniforms signs{orders.call + ", the signs of the products of three permutations", 1};
  for (const bool backwards : {false, true}) {
    std::size_t odd = 0;  // a bit per permutation: the parity of the number of inversions
    Uniforms numbers{orders.call, orders.n - 1};
    for (std::size_t k = 0; k < orders.size(); ++k) {
      Order order(orders[k].begin(), orders[k].end());
      if (backwards) std::ranges::reverse(order);
      const auto ranks = uniforms_of_permutation(order, rng);
      append(numbers.values, ranks);
      odd *= 2;
      for (std::size_t i = 0; i < ranks.size(); ++i) {
        odd ^= static_cast<std::size_t>(ranks[i] * static_cast<double>(orders.n - i)) % 2;
      }
      if (k < 2 || backwards) continue;
      signs.values.push_back(fill_cell(std::popcount(odd % 8) % 2u, 2, rng));
    }
    numbers.name = [&, backwards](std::size_t position) {
      const std::size_t at = backwards ? orders.n - 1 - position : position;
      return fmt::format("the rank of value {} among values {} to {}", at, backwards ? 0 : at,
                         backwards ? at : orders.n - 1);
    };
    expect_independent_uniforms(numbers, of_numbers);
  }
  const Randomness of_signs{.words = claim.words,
                            .alpha = claim.alpha,
                            .rule = "no permutation is a product of two others",
                            .expected = "permutations that are independent, also of two others",
                            .is_certain = true};
  if (signs.values.size() >= 200) expect_independent_uniforms(signs, of_signs, true);
}

Permutations orders_of(const Stratified& made, std::size_t sets, Rng& rng) {
  const Sets got = made.some(sets, rng);
  Permutations orders{got.call, got.n};
  for (std::size_t set = 0; set < sets; ++set) {
    for (const Pattern& pattern : made.patterns) {
      orders.add(expect_one_in_each_cell(got, set, pattern, made.rule));
    }
  }
  return orders;
}

Permutations meetings_of(const Stratified& made, std::size_t sets, Rng& rng) {
  const Permutations all = orders_of(made, sets, rng);
  Permutations meetings{all.call, all.n};
  Order turn(made.patterns.size()), order(all.n);
  std::iota(turn.begin(), turn.end(), 0);
  for (std::size_t first = 0; first < all.size(); first += turn.size()) {
    std::ranges::shuffle(turn, rng);
    for (std::size_t p = 0; p + 1 < turn.size(); p += 2) {
      const auto from = all[first + turn[p]], to = all[first + turn[p + 1]];
      const bool turns = rng() % 2 == 0;  // one may be the reverse of the other
      for (std::size_t k = 0; k < all.n; ++k) order[from[k]] = to[turns ? all.n - 1 - k : k];
      meetings.add(order);
    }
  }
  return meetings;
}

}  // namespace mc::checks
