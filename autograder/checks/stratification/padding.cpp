// 3.4: random permutations, and patterns padded with them.

#include "checks/stratification/common.hpp"
#include "checks/stratification/orders.hpp"

namespace mc::checks {
namespace {

const std::string fair = "each of the remaining values must be equally likely to come next";
const Likely always_same =
    "the permutation is always the same: draw it from the given generator"_likely;

Randomness random_orders(const std::string& words, const std::string& rule,
                         const Likely& repeated) {
  return {.words = words, .alpha = alpha, .rule = rule, .repeated = repeated};
}

/// 0 … n-1, shuffled `times` times.
Permutations shuffled(std::size_t n, std::size_t times, std::uint64_t seed);

CHECK_CASE("3.4 every permutation is equally likely", "[3.4][main][points:3]") {
  const Permutations few = shuffled(5, 12000, fresh_seed(rng));
  expect_random_permutations(
      few,
      random_orders("the 120 permutations of five values are equally likely", fair, always_same),
      rng);
  for (const std::size_t n : {37u, 6u}) {
    expect_random_permutations(
        shuffled(n, 1500, fresh_seed(rng)),
        random_orders(fmt::format("permutations of {} values are equally likely", n),
                      n < 21 ? fair
                             : fair + ", by a new random number: 64 bits for all choices are too "
                                      "few from 21 values on",
                      always_same),
        rng);
  }
}

CHECK_CASE("3.4 permutations of many values are equally likely", "[3.4][points:3]") {
  // A million takes a shuffle by vector::erase(), which is quadratic, half a minute.
  for (const std::size_t n : {std::size_t{1'000'003}, std::size_t{100'000}, 129 + rng() % 3000}) {
    const std::size_t times = n > 100000 ? 1 : n > 10000 ? 3 : 2000000 / n;
    const Permutations orders = shuffled(n, times, fresh_seed(rng));
    const Randomness claim =
        random_orders(fmt::format("a permutation of {} values may be any of {}!", n, n),
                      "each value must be equally likely in each place", always_same);
    if (times == 1) {
      expect_fine_choices(orders, claim, rng);
      continue;
    }
    expect_random_permutations(orders, claim, rng, times > 3);
    if (times > 3) continue;
    Permutations meeting{orders.call + ", the second in the order of the first", n, Order(n)};
    for (std::size_t k = 0; k < n; ++k) meeting.values[orders[0][k]] = orders[1][k];
    expect_random_permutations(meeting, claim, rng);
  }
}

CHECK_CASE("3.4 shuffle keeps every value", "[3.4][points:1]") {
  for (const std::size_t n : {1000u, 100000u, 1025u, 65u, 10u, 2u, 1u, 0u}) {
    Values x = uniform_values(rng, n, -1, 1);
    if (n > 2) x[1] = x[2];  // two equal values are allowed
    const auto got = MEASURE(shuffle, x, 1, fresh_seed(rng));
    const Values& order = got.exactly(n);
    expect_that(n < 60 || order != x, got.call + " = " + shown(order), "another order",
                "only one of n! permutations is the identity", "nothing was moved");
    Values before = x, after = order;
    std::ranges::sort(before);
    std::ranges::sort(after);
    expect_that(before == after, got.call + " = " + shown(order),
                "the same values in another order", "",
                "a shuffle swaps values; it does not copy one over another");
  }
}

Stratified padded(std::size_t n, std::size_t dims) {
  std::vector<Pattern> patterns;
  for (std::size_t d = 0; d + 1 < dims; d += 2) patterns.push_back(plane_of(squarest(n), d));
  if (dims % 2 == 1) patterns.push_back(line_of(n, dims - 1));
  return {"3.4",
          [=](std::size_t sets, std::uint64_t seed) {
            return sets_from_columns(MEASURE(stratified, n, dims, sets, seed), n, dims, sets, n);
          },
          patterns,
          "dimensions (0,1), (2,3), … are jittered grids; an odd last dimension is a pattern of "
          "3.1"};
}

CHECK_CASE("3.4 every pair of dimensions is a jittered grid",
           "[3.4][points:4][needs:3.1][needs:3.2][needs:3.3]") {
  for (const std::size_t n : {64u, 12u, 101u, 1025u, 65u, 7u, 3u, 2u, 1u}) {
    for (const std::size_t dims : {4u, 2u, 7u, 3u, 9u, 17u, 33u, 1u}) {
      padded(n, dims).expect_cells(1, rng);
    }
  }
  for (const std::size_t n : {65539u, 66049u}) {  // one row, and a square
    padded(n, 3).expect_cells(1, rng);
  }
  padded(64, 5).expect_new_points(rng);
  const Likely same =
      "one pattern is used for several pairs of dimensions: make a new one for each"_likely;
  for (const auto& [n, dims] : {std::pair<std::size_t, std::size_t>{4, 5}, {6, 9}, {6, 1}}) {
    expect_random_calls(padded(n, dims).jitters(same), 2000, rng);
  }
}

CHECK_CASE("3.4 patterns are shuffled independently", "[3.4][points:4][needs:3.2][needs:3.3]") {
  const Randomness claim = random_orders(
      "the permutations of two patterns of 3.4 are independent",
      "each point of a pattern must be equally likely to be combined with any point of another: "
      "shuffle all points of each pattern, x and y together, each pattern separately",
      "the patterns are always combined in the same way: shuffle each one separately, by new "
      "random "
      "numbers"_likely);
  for (const auto& [n, dims, sets] :
       {Sizes{30, 27, 350}, {4, 5, 5000}, {64, 8, 1000}, {10000, 5, 1}}) {
    expect_random_permutations(meetings_of(padded(n, dims), sets, rng), claim, rng);
  }
}

CHECK_CASE("3.4 the first n of N are a fair sample", "[3.4][points:2][needs:3.2][needs:3.3]") {
  const Likely shuffled_too =
      "shuffle the first pattern too, for an estimate that stops early"_likely;
  for (const auto& [n, dims, sets] :
       {Sizes{4, 5, 2000}, {4, 2, 5000}, {4, 1, 2000}, {30, 3, 500}, {30, 9, 500}, {10000, 2, 1}}) {
    const Stratified points = padded(n, dims);
    const Permutations orders = orders_of(points, sets, rng);
    bool stays = true;  // the first pattern has the same order in every set
    for (std::size_t k = 0; k < orders.size(); k += points.patterns.size()) {
      stays = stays && std::equal(orders[k].begin(), orders[k].end(), orders[0].begin());
    }
    const Likely first = stays && sets > 1 ? shuffled_too : Likely{};
    const std::string rule = stays && sets > 1 ? first.text : "shuffle each pattern separately";
    expect_random_permutations(
        orders, random_orders("the cells of a pattern of 3.4 come in random order", rule, first),
        rng);
  }
  // With strata drawn without replacement, (N-n)/(N-1) of the variance between them remains.
  const auto axis = strata_of(gaussian, 8);
  const auto cells = product_of(axis, axis);
  const Sets plane = padded(64, 2).some(1000, rng);
  for (const std::size_t used : {20u, 32u}) {
    expect_level(plane,
                 {"exp(-x^2-y^2)", product_over_axes(gaussian), mean_of(cells),
                  variance_of_first(cells, used), 3, independent_variance(cells, used),
                  "they are strata drawn without replacement"},
                 used);
  }
}

// What the cases above use ------------------------------------------------------------------------

Permutations shuffled(std::size_t n, std::size_t times, std::uint64_t seed) {
  Values x(n);
  std::iota(x.begin(), x.end(), 0.0);
  const auto got = MEASURE(shuffle, x, times, seed);
  Permutations orders{got.call, n};
  const View values = got.exactly(n * times, up_to(static_cast<double>(n - 1)));
  for (std::size_t time = 0; time < times; ++time) {
    std::vector<bool> taken(n);
    for (const double value : values.subspan(time * n, n)) {
      const auto number = static_cast<std::size_t>(value);
      if (static_cast<double>(number) != value || taken[number]) {
        fail(Failure{fmt::format("{}: {} occurs twice, or is not an input value", got.call, value),
                     "the same values in another order", "",
                     "a shuffle swaps values; it does not copy one over another"_likely});
      }
      taken[number] = true;
      orders.values.push_back(number);
    }
  }
  return orders;
}

}  // namespace
}  // namespace mc::checks
