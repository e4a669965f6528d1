// 6.1, 6.2: independent numbers; stratified sample dimensions, each in a separate random order.

#include <tuple>

#include "checks/sampler/samplers.hpp"

namespace mc::checks {
namespace {

const std::string one_per_stratum = "a column has one number in each stratum";
const Randomness fresh{
    .words = "all numbers of all samples are uniform and independent",
    .rule = "use new uniforms of lab 2 for every coordinate of every sample",
    .repeated = "numbers are used again for another sample dimension or another sample"_likely,
    .same = "numbers are used again for another sample dimension"_likely};

CHECK_CASE("6.1 numbers are uniform and independent", "[6.1][main][points:5][needs:2]") {
  const std::size_t many = 33 + rng() % 40;  // sample dimensions of either sort
  for (const auto& [n, uses] : {std::pair{4096u, repeated(17, {1, 2})},
                                {1000u, repeated(many, {1})},
                                {500u, repeated(many, {2})},
                                {131073u, Uses{1, 2}}}) {
    const SampleSets got = columns_of("independent", n, {fresh_seed(rng)}, uses);
    Uniforms samples{got.call, got.dims};
    samples.name = [](std::size_t c) { return fmt::format("coordinate {}", c); };
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t c = 0; c < got.dims; ++c) samples.values.push_back(got.column(0, c)[i]);
    }
    expect_independent_uniforms(samples, fresh);
  }
}

CHECK_CASE("6.1 numbers of different seeds are independent", "[6.1][points:5][needs:2]") {
  for (const std::size_t n : {1u, 100u}) {
    expect_random_seeds(sample_of("independent", n, n - 1, {1, 2, 1, 2, 2, 1}, fresh),
                        {domain::seeds(rng, 2000)});
  }
}

// Of 40,009 numbers rounded to float 16 leave their stratum on average; of 10,007 only one.
std::vector<std::uint64_t> sizes(Rng& rng) {
  auto all = domain::sizes(5000, rng);
  all.insert(all.end() - 1, 40009);
  return all;
}

CHECK_CASE("6.2 next has one number in each of N strata", "[6.2][points:4][needs:3]") {
  for (const std::size_t n : sizes(rng)) {
    const SampleSets got = columns_of("stratified", n, {fresh_seed(rng)}, {1, 1, 1});
    expect_one_in_each_cell(got, lines_of(n, got.dims),
                            "a next() must be a shuffled stratified_1d");
  }
}

CHECK_CASE("6.2 next2 has one point in each cell and stratum", "[6.2][main][points:6][needs:3]") {
  for (const std::size_t n : sizes(rng)) {
    const SampleSets got = columns_of("stratified", n, {fresh_seed(rng)}, {2, 2});
    for (const std::size_t c : {0u, 2u}) expect_multi_jittered(got, c);
  }
}

/// The stratum of each sample, in the coordinates with a free order: next(), and x of next2().
using Orders = std::vector<std::vector<std::size_t>>;
Orders orders_of(const SampleSets& got, std::size_t set, const Uses& uses);
Likely hint_for_orders(const std::vector<Orders>& sets);

// Swaps with any other of three values give a distribution that is 1/27 off: 20,000 sets show 1/40.
using Shape = std::tuple<std::size_t, Uses, std::size_t>;
const std::vector<Shape> shapes{{12, repeated(6, {1, 2}), 300}, {3, repeated(17, {2, 1}), 300},
                                {10007, {1, 2, 1}, 1},          {3, {1}, 20000},
                                {2, repeated(3, {1, 2}), 300},  {131072, {1, 2}, 1}};

CHECK_CASE("6.2 each sample dimension has its own permutation", "[6.2][points:6][needs:3]") {
  for (const auto& [n, uses, sets] : shapes) {
    const SampleSets got = columns_of("stratified", n, domain::seeds(rng, sets), uses);
    Uniforms choices{got.call, uses.size() * (n - 1)};
    choices.name = [n = n](std::size_t position) {
      return fmt::format("choice {} of the permutation of sample dimension {} (the first is 0)",
                         position % (n - 1), position / (n - 1));
    };
    expect_one_in_each_cell(got, lines_of(n, got.dims), one_per_stratum);
    std::vector<Orders> orders;
    for (std::size_t set = 0; set < sets; ++set) {
      orders.push_back(orders_of(got, set, uses));
      for (const auto& order : orders.back()) {
        append(choices.values, uniforms_of_permutation(order, rng));
      }
    }
    expect_independent_uniforms(
        choices, {.words = "the orders of sample dimensions are independent random permutations",
                  .rule = "the pattern must be shuffled for each dimension and seed (not rotated)",
                  .explain = [&] { return hint_for_orders(orders); }});
  }
}

CHECK_CASE("6.2 numbers are uniform in their strata and cells", "[6.2][points:4][needs:3]") {
  for (const auto& [n, uses, sets] : shapes) {
    const SampleSets got = columns_of("stratified", n, domain::seeds(rng, sets), uses);
    expect_independent_uniforms(
        jitters_of(got, lines_of(n, got.dims), one_per_stratum),
        {.words = "numbers are independent and uniform in their strata",
         .rule = "use a separate random number for each place in a stratum"});
  }
  for (const std::size_t n : {4u, 9u, 12u}) {
    const Grid grid = squarest(n);
    const SampleSets got = columns_of("stratified", n, domain::seeds(rng, 2000), {2});
    const std::vector<Pattern> plane{plane_of(grid)};
    const Uniforms places = jitters_of(got, plane, "");
    for (std::size_t cell = 0; cell < n; ++cell) {  // cells may share permutations
      expect_independent_uniforms(
          some_of(places, {cell, n + cell}),
          {.words = "each point of next2() is uniform in its cell",
           .alpha = alpha / 10,
           .rule = "use independent random permutations to assign the strata of x to the "
                   "cells of a column, and those of y to the cells of a row (3.7)"});
    }
  }
}

Orders orders_of(const SampleSets& got, std::size_t set, const Uses& uses) {
  Orders orders;
  std::size_t c = 0;
  for (const unsigned use : uses) {
    auto& order = orders.emplace_back();
    for (const double x : got.column(set, c)) order.push_back(stratum_of(x, got.n).value_or(0));
    c += use;
  }
  return orders;
}

/// The hint from the orders of all sets.
Likely hint_for_orders(const std::vector<Orders>& sets) {
  const auto in_all = [&](auto is_wrong) { return std::ranges::all_of(sets, is_wrong); };
  for (std::size_t a = 0; a < sets[0].size(); ++a) {
    if (in_all([=](const Orders& all) { return std::ranges::is_sorted(all[a]); })) {
      return "the strata are in order: the pattern must be shuffled"_likely;
    }
    for (std::size_t b = 0; b < a; ++b) {
      if (in_all([=](const Orders& all) { return all[a] == all[b]; })) {
        return "one permutation is used for several dimensions: shuffle each one separately"_likely;
      }
    }
  }
  if (sets.size() < 10000) return {};
  std::vector<std::size_t> orders;
  for (const Orders& all : sets) append(orders, all[0]);
  return shuffle_hint(orders, sets[0][0].size());
}

}  // namespace
}  // namespace mc::checks
