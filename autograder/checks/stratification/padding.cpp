// 3.4: random orders, and patterns put side by side in them.

#include "checks/stratification/grids.hpp"
#include "checks/stratification/levels.hpp"
#include "checks/stratification/orders.hpp"
#include "checks/support/catch.hpp"
#include "checks/support/data.hpp"
#include "checks/support/distributions.hpp"
#include "checks/support/strata.hpp"

namespace mc::checks {
namespace {

const std::string fair = "each of the n values left is as likely to come next as any other";

Values counting(std::size_t n) {
  Values x(n);
  std::iota(x.begin(), x.end(), 0.0);
  return x;
}

/// 0 … n-1, shuffled: each of them is there once.
Order order_of(const std::string& call, View values) {
  Order order;
  std::vector<bool> taken(values.size());
  for (const double value : values) {
    const auto number = static_cast<std::size_t>(value);
    if (static_cast<double>(number) != value || taken[number]) {
      expect_that(false, fmt::format("{}: {} is there twice, or was not given", call, value),
                  "the same values in another order", "",
                  "a shuffle swaps values; it does not copy one over another");
    }
    taken[number] = true;
    order.push_back(number);
  }
  return order;
}

/// 0 … n-1, shuffled `times` times.
Order orders_of(Rng& rng, std::size_t n, std::size_t times, std::string& call) {
  const auto got = MEASURE(shuffle, counting(n), times, fresh_seed(rng));
  const Values& values = got.exactly(n * times, up_to(static_cast<double>(n - 1)));
  call = got.call;
  Order all;
  for (std::size_t time = 0; time < times; ++time) {
    const Order one = order_of(got.call, View(values).subspan(time * n, n));
    all.insert(all.end(), one.begin(), one.end());
  }
  return all;
}

/// How likely each of the 120 orders of five values is where every value changes places with any of
/// the five: of 5^5 equally likely ways.
Values orders_of_swaps_with_any(bool backwards) {
  Values chances(120);
  for (std::size_t way = 0; way < 3125; ++way) {
    std::array<std::size_t, 5> order{0, 1, 2, 3, 4};
    for (std::size_t k = 0, rest = way; k < 5; ++k, rest /= 5) {
      std::swap(order[backwards ? 4 - k : k], order[rest % 5]);
    }
    chances[rank_of(order)] += 1.0 / 3125;
  }
  return chances;
}

/// What is wrong with a shuffle whose orders of five values are not equally likely, if it is one of
/// those that everybody writes once.
std::string shuffle_hint(const Order& orders) {
  constexpr std::size_t n = 5;
  std::vector<std::uint64_t> counts(120);
  bool only_cycles = true;
  std::array<bool, n> stays{true, true, true, true, true};
  for (std::size_t first = 0; first < orders.size(); first += n) {
    const auto order = std::span(orders).subspan(first, n);
    ++counts[rank_of(order)];
    std::size_t length = 1;
    for (std::size_t at = order[0]; at != 0; at = order[at]) ++length;
    only_cycles = only_cycles && length == n;
    for (std::size_t k = 0; k < n; ++k) stays[k] = stays[k] && order[k] == k;
  }
  for (std::size_t k = 0; k < n; ++k) {
    if (stays[k]) return fmt::format("value {} of 0 … 4 never moves: all five take part", k);
  }
  if (only_cycles) {
    return "no value ever stays in its place: let it change places with itself too (j from i, not "
           "from i + 1)";
  }
  for (const bool backwards : {false, true}) {
    const Values chances = orders_of_swaps_with_any(backwards);
    double chi_squared = 0;
    for (std::size_t i = 0; i < chances.size(); ++i) {
      const double due = chances[i] * static_cast<double>(orders.size() / n);
      const double off = static_cast<double>(counts[i]) - due;
      chi_squared += off * off / due;
    }
    if (chi_squared_tails(chi_squared, 119).upper > alpha) {
      return "each value changes places with any of the n, which favours some permutations: with "
             "itself or one of those not placed yet (j from i to n-1)";
    }
  }
  return fair;
}

CHECK_CASE("3.4 every permutation is equally likely", "[3.4][main][points:3]") {
  Rng rng = check_rng();
  std::string call;
  const Order few = orders_of(rng, 5, 12000, call);
  expect_all_orders(
      call, few, 5, "the 120 permutations of five values are equally likely",
      "the permutation is always the same: draw it from the generator that is passed in",
      shuffle_hint(few));

  // Where the first and the last of 100 values go, in five parts: of 100 * 99 pairs of places.
  constexpr std::size_t n = 100;
  const Order many = orders_of(rng, n, 4000, call);
  std::vector<std::uint64_t> counts(25);
  for (std::size_t first = 0; first < many.size(); first += n) {
    const auto order = std::span(many).subspan(first, n);
    const auto place = [&](std::size_t value) {
      const auto found = std::find(order.begin(), order.end(), value) - order.begin();
      return std::min<std::size_t>(static_cast<std::size_t>(found) / 20, 4);
    };
    ++counts[5 * place(0) + place(n - 1)];
  }
  Values probabilities(25, 20.0 * 20 / 9900);
  for (std::size_t i = 0; i < 5; ++i) probabilities[6 * i] = 20.0 * 19 / 9900;
  expect_counts(call + ", places of the first and the last value, in 5 x 5 parts", counts,
                probabilities, {"the first and the last of 100 values go to any two places", alpha},
                {{}, fair});
}

/// Trends of orders of many things, all of which are equally likely.
void expect_no_trend(const std::string& call, std::span<const Trend> trends,
                     const std::string& words, const std::string& hint) {
  Values z;
  for (const Trend& trend : trends) z.push_back(trend.correlation), z.push_back(trend.ascents);
  expect_variance({call, z}, 0, 1, 3, {words, alpha}, {{}, hint});
}

CHECK_CASE("3.4 permutations of many values have no trend", "[3.4][points:2]") {
  Rng rng = check_rng();
  // Numbers of 16 bits in a shuffle of 100,000 make a correlation of -45 standard errors, keys of
  // 16 bits that are sorted, with ties left as they come, 90 in ascents.
  constexpr std::size_t n = 100000;
  std::string call;
  const Order one = orders_of(rng, n, 1, call), other = orders_of(rng, n, 1, call);
  const Trend trends[] = {trend_of(one), trend_of(other), trend_of(relative_orders(one, other, n))};
  expect_no_trend(call + ", rank correlation of place and value, and ascents", trends,
                  "a permutation of 100,000 values has no trend, nor have two beside each other",
                  one == other
                      ? "the same permutation for two seeds: draw it from the generator that is "
                        "passed in"
                      : "each value may go anywhere: choosing among n values takes more bits than "
                        "n has, of which 16 are too few here");
}

CHECK_CASE("3.4 shuffle keeps every value", "[3.4][points:1]") {
  Rng rng = check_rng();
  for (const std::size_t n : {1000u, 100000u, 10u, 2u, 1u, 0u}) {
    Values x = uniform_values(rng, n, -1, 1);
    if (n > 2) x[1] = x[2];  // twice the same is no harm
    const auto got = MEASURE(shuffle, x, 1, fresh_seed(rng));
    const Values& order = got.exactly(n);
    if (n == 1000) {
      expect_that(order != x, got.call + " = " + shown(order), "another order",
                  "one permutation of n! is the identity", "nothing was moved");
      const auto again = MEASURE(shuffle, x, 1, fresh_seed(rng));
      expect_that(order != again.exactly(n),
                  got.call + " and with another seed: the same permutation",
                  "other permutations for other seeds",
                  "two random permutations are equal with probability 1 / n!",
                  "draw the permutation from the generator that is passed in");
    }
    Values before = x, after = order;
    std::sort(before.begin(), before.end());
    std::sort(after.begin(), after.end());
    expect_that(before == after, got.call + " = " + shown(order),
                "the same values in another order", "",
                "a shuffle swaps values; it does not copy one over another");
  }
}

Sets padded(Rng& rng, std::size_t n, std::size_t dims, std::size_t sets) {
  return columns_of(MEASURE(stratified, n, dims, sets, fresh_seed(rng)), n, dims, sets, n);
}

/// The stratum of each point, for each pattern of a set: dimensions (0,1), (2,3), … and an odd last
/// one; ends the check where one of them is no pattern.
std::vector<Order> patterns_of(const Sets& sets, std::size_t set) {
  std::vector<Order> orders;
  std::size_t d = 0;
  for (; d + 1 < sets.dims; d += 2) {
    orders.push_back(
        expect_one_in_each_cell(fmt::format("{}, dimensions {} and {}", sets.call, d, d + 1),
                                sets.column(set, d), sets.column(set, d + 1), squarest(sets.n)));
  }
  if (d == sets.dims) return orders;
  expect_one_in_each(fmt::format("{}, dimension {}", sets.call, d), "x", sets.column(set, d),
                     sets.n, "an odd last dimension is a pattern of 3.1");
  Order& last = orders.emplace_back();
  for (const double x : sets.column(set, d)) last.push_back(*stratum_of(x, sets.n));
  return orders;
}

CHECK_CASE("3.4 every pair of dimensions is a jittered grid",
           "[3.4][points:3][needs:3.2][needs:3.3]") {
  Rng rng = check_rng();
  for (const std::size_t n : {64u, 12u, 101u, 7u, 1u}) {
    for (const std::size_t dims : {4u, 2u, 7u, 3u, 1u}) patterns_of(padded(rng, n, dims, 1), 0);
  }
  const Grid grid = squarest(64);
  const std::array strata{grid.nx, grid.ny, grid.nx, grid.ny, std::size_t{64}};
  expect_drawn_afresh(padded(rng, 64, 5, 2), padded(rng, 64, 5, 1), strata);
}

/// The orders of the three patterns of 5 dimensions, (0,1), (2,3) and (4), in sets of 4 points.
std::array<Order, 3> pattern_orders(const Sets& sets) {
  std::array<Order, 3> orders;
  for (std::size_t set = 0; set < sets.size(); ++set) {
    const std::vector<Order> patterns = patterns_of(sets, set);
    for (std::size_t p = 0; p < 3; ++p) {
      orders[p].insert(orders[p].end(), patterns[p].begin(), patterns[p].end());
    }
  }
  return orders;
}

const char* const pattern_names[] = {"dimensions (0,1)", "dimensions (2,3)",
                                     "the odd last dimension"};

CHECK_CASE("3.4 patterns are shuffled independently", "[3.4][points:4][needs:3.3]") {
  Rng rng = check_rng();
  const std::string together =
      "shuffle the points of each pattern, x and y together, once for each pattern";
  const std::string always =
      "the patterns always meet in the same way: shuffle each of them by itself";
  const Sets got = padded(rng, 4, 5, 5000);
  const auto orders = pattern_orders(got);
  for (const auto& [one, other] : pairs_of_three) {
    expect_all_orders(got.call, relative_orders(orders[one], orders[other], 4), 4,
                      fmt::format("the permutations of {} and {} are independent",
                                  pattern_names[one], pattern_names[other]),
                      always, together);
  }
  Values u, v;
  for (std::size_t set = 0; set < got.size(); ++set) {
    for (std::size_t k = 0; k < 4; ++k) {
      u.push_back(jitter_of(got.column(set, 0)[k], 2));
      v.push_back(jitter_of(got.column(set, 2)[k], 2));
    }
  }
  expect_independent(got.call, u, v, "the jitters of dimensions 0 and 2 are independent",
                     "one pattern is used for several pairs of dimensions: draw each afresh");
  // Of 64 points no two patterns ever meet in the same way: one chance in 64!.
  const Sets wide = padded(rng, 64, 13, 1);
  const std::vector<Order> patterns = patterns_of(wide, 0);
  for (std::size_t one = 0; one < patterns.size(); ++one) {
    for (std::size_t other = one + 1; other < patterns.size(); ++other) {
      expect_that(patterns[one] != patterns[other],
                  fmt::format("{}: the patterns of dimensions {} and {} visit their strata in the "
                              "same order",
                              wide.call, 2 * one, 2 * other),
                  "different permutations",
                  "two random permutations of 64 are equal with probability 1 / 64!", always);
    }
  }
}

CHECK_CASE("3.4 long patterns have no trend", "[3.4][points:1][needs:3.2][needs:3.3]") {
  Rng rng = check_rng();
  const Sets got = padded(rng, 10000, 5, 1), other_seed = padded(rng, 10000, 5, 1);
  const std::vector<Order> patterns = patterns_of(got, 0), others = patterns_of(other_seed, 0);
  std::vector<Trend> trends;
  for (const Order& order : patterns) trends.push_back(trend_of(order));
  for (const auto& [one, other] : pairs_of_three) {
    trends.push_back(trend_of(relative_orders(patterns[one], patterns[other], got.n)));
  }
  for (std::size_t p = 0; p < 3; ++p) {
    trends.push_back(trend_of(relative_orders(patterns[p], others[p], got.n)));
  }
  expect_no_trend(
      got.call + ", rank correlations of place and stratum, and ascents", trends,
      "the permutations of long patterns have no trend, nor have two beside each other",
      "every point of a pattern may come anywhere: shuffle all N of them, each pattern by itself");
}

CHECK_CASE("3.4 the first n of N are a fair sample", "[3.4][points:2][needs:3.3]") {
  Rng rng = check_rng();
  const std::string shuffled =
      "shuffle the first pattern too: who stops early must not see only the first rows of the grid";
  const Sets got = padded(rng, 4, 5, 5000);
  const auto orders = pattern_orders(got);
  for (std::size_t pattern = 0; pattern < 3; ++pattern) {
    expect_all_orders(got.call, orders[pattern], 4,
                      fmt::format("the permutations of the cells of {} are equally likely",
                                  pattern_names[pattern]),
                      shuffled, "shuffle all the points of each pattern");
  }
  // Strata drawn without replacement: (N-n)/(N-1) of the variance between them is left.
  const auto axis = strata_of(gaussian, 8);
  const auto cells = product_of(axis, axis);
  const Sets plane = padded(rng, 64, 2, 1000);
  for (const std::size_t used : {20u, 32u}) {
    expect_level_of_first(
        plane, used, product_over_axes("exp(-x^2-y^2)", gaussian),
        {mean_of(cells), variance_of_first(cells, used), 3, independent_variance(cells, used)},
        fmt::format("the first {} of 64 points are {} strata drawn without "
                    "replacement",
                    used, used),
        shuffled);
  }
}

}  // namespace
}  // namespace mc::checks
