// 3.5, 3.6: a grid over all dimensions at once, and every axis stratified separately.

#include "checks/stratification/common.hpp"
#include "checks/stratification/orders.hpp"

namespace mc::checks {
namespace {

Stratified box(std::size_t per_axis, std::size_t dims) {
  std::size_t n = 1;
  Pattern all_axes{Order(dims), Order(dims, per_axis)};
  for (std::size_t d = 0; d < dims; ++d) n *= per_axis, all_axes.dims[d] = d;
  return {"3.5",
          [=](std::size_t sets, std::uint64_t seed) {
            return sets_from_columns(MEASURE(stratified_nd, n, dims, per_axis, sets, seed), n, dims,
                                     sets, per_axis);
          },
          {all_axes},
          "one point per cell k; its strata are the digits of k in base per_axis"};
}

void expect_full(std::initializer_list<std::pair<std::size_t, std::size_t>> sizes, Rng& rng) {
  for (const auto& [per_axis, dims] : sizes) box(per_axis, dims).expect_cells(1, rng);
}

CHECK_CASE("3.5 one point in each cell of all dimensions", "[3.5][main][points:3]") {
  expect_full({{3, 3}, {5, 4}, {2, 10}, {4 + rng() % 10, 2}}, rng);
  box(3, 3).expect_new_points(rng);
}

CHECK_CASE("3.5 any number of strata and dimensions", "[3.5][edge][points:1]") {
  expect_full(
      {{33, 3}, {2, 13}, {257, 2}, {2, 4}, {4097, 1}, {7, 1}, {2, 1}, {1, 33}, {1, 3}, {1, 1}},
      rng);
}

CHECK_CASE("3.5 each point is uniform in its cell and independent", "[3.5][points:1.5]") {
  for (const auto& [per_axis, dims, sets] :
       {Sizes{2, 3, 2000}, {3, 2, 2000}, {2, 9, 150}, {5, 1, 2000}, {1, 30, 1000}, {2, 12, 2}}) {
    expect_random_calls(box(per_axis, dims).jitters(), sets, rng);
  }
}

CHECK_CASE("3.5 the curse of dimension", "[3.5][points:2]") {
  for (const std::size_t per_axis :
       {3u, 2u, 5u}) {  // in four dimensions the error falls as N^-(1/2+1/4)
    const auto axis = strata_of(centered_exponential, per_axis);
    const auto plane = product_of(axis, axis);
    expect_level(box(per_axis, 4).some(700, rng),
                 level_of("exp(x0 + x1 + x2 + x3 - 2)", product_over_axes(centered_exponential),
                          product_of(plane, plane)));
  }
}

Stratified hypercube(std::size_t n, std::size_t dims) {
  return {"3.6",
          [=](std::size_t sets, std::uint64_t seed) {
            return sets_from_columns(MEASURE(latin_hypercube, n, dims, sets, seed), n, dims, sets,
                                     n);
          },
          lines_of(n, dims), "each column is a pattern of 3.1"};
}

CHECK_CASE("3.6 every axis is stratified", "[3.6][main][points:3][needs:3.1]") {
  for (const std::size_t n : {std::size_t{64}, std::size_t{1000}, 20 + rng() % 100}) {
    for (const std::size_t dims : {7u, 2u}) hypercube(n, dims).expect_cells(1, rng);
  }
  hypercube(64, 7).expect_new_points(rng);
}

CHECK_CASE("3.6 any number of points and dimensions", "[3.6][edge][points:1][needs:3.1]") {
  for (const std::size_t n : {101u, 1025u, 7u, 3u, 2u, 1u}) {
    for (const std::size_t dims : {9u, 17u, 33u, 2u, 1u}) hypercube(n, dims).expect_cells(1, rng);
  }
  hypercube(350'003, 2).expect_cells(1, rng);
}

CHECK_CASE("3.6 the axes are independent", "[3.6][points:3][needs:3.1][needs:3.4]") {
  Randomness meetings{.words = "the permutations of two axes of 3.6 are independent",
                      .alpha = alpha,
                      .rule = "shuffle every column separately, with the shuffle of 3.4",
                      .repeated =
                          "two axes are always combined in the same way: shuffle each one "
                          "separately, by new random "
                          "numbers"_likely};
  const Likely same = "one column is used for two axes: make a new one for each"_likely;
  for (const auto& [n, dims, sets] :
       {Sizes{30, 23, 300}, {4, 3, 5000}, {64, 4, 1000}, {10000, 3, 1}}) {
    const Stratified cube = hypercube(n, dims);
    if (n == 4) expect_random_calls(cube.jitters(same), sets, rng);
    expect_random_permutations(meetings_of(cube, sets, rng), meetings, rng);
  }
}

CHECK_CASE("3.6 sums gain everything and products little",
           "[3.6][points:3][needs:3.1][needs:3.4]") {
  for (const std::size_t n : {64u, 16u, 256u}) {
    Level sum =
        level_of("exp(x0) + … + exp(x6)", sum_over_axes(exponential), strata_of(exponential, n));
    sum.mean *= 7, sum.variance *= 7, sum.independent *= 7;  // seven independent terms
    expect_level(hypercube(n, 7).some(1000, rng), sum);
  }
  const auto product = [](auto h, std::size_t a, std::size_t b, std::string words,
                          std::string because) {
    const auto axis = strata_of(h, 64);
    const double variance = shuffled_product_variance(axis, axis), mean = mean_of(axis);
    const double independent = independent_variance(product_of(axis, axis), 64);
    const auto f = [=](View x) { return h(x[a]) * h(x[b]); };
    return Level{std::move(words), f, mean * mean, variance, 3, independent, std::move(because)};
  };
  const Sets cubes = hypercube(64, 5).some(1000, rng);
  expect_level(cubes, product(gaussian, 0, 1, "exp(-x0^2-x1^2)",
                              "nearly a sum: 28 times less variance than independent points"));
  for (std::size_t a = 0; a < 5; ++a) {
    for (std::size_t b = a + 1; b < 5; ++b) {
      expect_level(cubes, product(centered, a, b, fmt::format("(x{}-1/2)(x{}-1/2)", a, b),
                                  "no order of two axes is preferred, so that nothing is gained"));
    }
  }
}

}  // namespace
}  // namespace mc::checks
