// 3.5 and 3.6: a grid over all dimensions at once, and every axis stratified by itself.

#include <array>
#include <string>
#include <vector>

#include "checks/stratification/levels.hpp"
#include "checks/stratification/orders.hpp"
#include "checks/support/catch.hpp"
#include "checks/support/refusals.hpp"
#include "checks/support/strata.hpp"

namespace mc::checks {
namespace {

// 3.5 ---------------------------------------------------------------------------------------------

std::size_t power(std::size_t base, std::size_t exponent) {
  std::size_t product = 1;
  for (std::size_t i = 0; i < exponent; ++i) product *= base;
  return product;
}

Sets boxes(Rng& rng, std::size_t per_axis, std::size_t dims, std::size_t sets) {
  const std::size_t n = power(per_axis, dims);
  return columns_of(MEASURE(stratified_nd, n, dims, per_axis, sets, fresh_seed(rng)), n, dims, sets,
                    per_axis);
}

/// The stratum of each point along each axis, as one number; ends the check where a cell has not
/// one point.
Order expect_one_in_each_box(const Sets& sets, std::size_t set, std::size_t per_axis) {
  Order cells(sets.n), points(sets.n);
  for (std::size_t d = sets.dims; d-- > 0;) {
    const View column = sets.column(set, d);
    for (std::size_t k = 0; k < sets.n; ++k) {
      cells[k] = cells[k] * per_axis + *stratum_of(column[k], per_axis);
    }
  }
  for (const std::size_t cell : cells) ++points[cell];
  for (std::size_t cell = 0; cell < sets.n; ++cell) {
    if (points[cell] == 1) continue;
    std::string place;
    for (std::size_t d = 0, rest = cell; d < sets.dims; ++d, rest /= per_axis) {
      place += fmt::format("{}{}", d > 0 ? ", " : "", rest % per_axis);
    }
    bool axes = true;
    for (std::size_t d = 0; d < sets.dims; ++d) {
      axes = axes && has_each(sets.column(set, d), per_axis, sets.n / per_axis);
    }
    expect_that(
        false, fmt::format("{}: {} points in cell ({})", sets.call, points[cell], place),
        "one point", "every cell of the grid over all dimensions has one, in any order",
        axes && sets.n > 16
            ? "each axis has its points, but not each cell: one for each k, whose strata are "
              "the digits of k in base per_axis"
            : "one point for each cell k, whose strata are the digits of k in base "
              "per_axis");
  }
  pass();
  return cells;
}

CHECK_CASE("3.5 one point in each cell of all dimensions", "[3.5][main][points:4]") {
  Rng rng = check_rng();
  for (const auto& [per_axis, dims] : {std::pair<std::size_t, std::size_t>{3, 3},
                                       {5, 5},
                                       {2, 10},
                                       {4, 2},
                                       {2, 4},
                                       {7, 1},
                                       {1, 3}}) {
    const Sets got = boxes(rng, per_axis, dims, 2);
    for (std::size_t set = 0; set < 2; ++set) expect_one_in_each_box(got, set, per_axis);
    if (dims == 3 && per_axis == 3) {
      expect_drawn_afresh(got, boxes(rng, 3, 3, 1), std::array{per_axis, per_axis, per_axis});
    }
  }
}

CHECK_CASE("3.5 each point is uniform in its cell", "[3.5][points:2]") {
  Rng rng = check_rng();
  constexpr std::size_t per_axis = 2, dims = 3, n = 8, sets = 2700;
  const Sets got = boxes(rng, per_axis, dims, sets);
  std::array<Values, dims> u;  // by cell
  for (Values& axis : u) axis.resize(n * sets);
  for (std::size_t set = 0; set < sets; ++set) {
    const Order cells = expect_one_in_each_box(got, set, per_axis);
    for (std::size_t d = 0; d < dims; ++d) {
      const View column = got.column(set, d);
      for (std::size_t k = 0; k < n; ++k) u[d][set * n + cells[k]] = jitter_of(column[k], per_axis);
    }
  }
  for (const std::size_t axis : {1u, 2u, 0u}) {  // a cell and the next one along each axis
    const std::size_t apart = power(per_axis, axis);
    Values here, there;
    for (std::size_t k = 0; k < u[0].size(); ++k) {
      if (k / apart % 2 == 0) here.push_back(u[0][k]), there.push_back(u[0][k + apart]);
    }
    expect_independent(got.call, here, there,
                       fmt::format("cells of 3.5 side by side along axis {} are independent", axis),
                       one_for_all);
  }
  for (const auto& [one, other] : pairs_of_three) {
    expect_independent(
        got.call, u[one], u[other],
        fmt::format("jitter along axes {} and {} is uniform and independent", one, other),
        "the same random number moves the point along two axes: draw one for each");
  }
  Values all;
  for (const Values& axis : u) all.insert(all.end(), axis.begin(), axis.end());
  expect_fine(got.call, all, per_axis);
}

CHECK_CASE("3.5 the curse of dimension", "[3.5][points:3]") {
  Rng rng = check_rng();
  const auto expected = [](std::size_t per_axis) {
    const auto axis = strata_of(centred_exponential, per_axis);
    const auto plane = product_of(axis, axis);
    return expected_of(product_of(plane, plane));
  };
  const std::string otherwise =
      "the variance within the cells is all that may be left: is each point uniform in its cell, "
      "every coordinate drawn by itself?";
  const Tested g = product_over_axes("exp(x0 + x1 + x2 + x3 - 2)", centred_exponential);
  expect_level(boxes(rng, 3, 4, 1000), g, expected(3),
               "estimates over 3^4 cells have their exact variance", otherwise);
  expect_slope(boxes(rng, 2, 4, 500), boxes(rng, 5, 4, 500), g, {expected(2), expected(5)},
               "in four dimensions errors fall as N^-1/2-1/4", otherwise);
}

std::vector<InvalidCall> wrong_powers() {
  const auto made = [](std::uint64_t n, std::uint64_t dims, std::uint64_t per_axis) {
    return MEASURE_OUTCOME(stratified_nd, n, dims, per_axis, 1, 1);
  };
  const std::string divide =
      "the product of 64-bit numbers wraps around: divide, before anything is computed";
  const std::string name = "per_axis";
  return {{made(9, 3, 2), name, "2^3 is not 9"},
          {made(4, 3, 2), name, "2^3 is not 4"},
          {made(0, 2, 0), name, "an axis has strata"},
          {made(4, 2, (std::uint64_t{1} << 63) + 2), name,
           "per_axis^2 = 2^126 + 2^65 + 4, which is 4 in 64 bits only", divide},
          {made(16, 40, 65536), name, "65536^40 is 0 in 64 bits", divide}};
}

CHECK_CASE("3.5 sizes that are no power are refused", "[3.5][edge][points:0.5]") {
  expect_refused(wrong_powers());
}

CHECK_CASE("3.5 the refusals name the argument", "[3.5][edge][points:0.5]") {
  expect_argument_named(wrong_powers());
}

// 3.6 ---------------------------------------------------------------------------------------------

Sets hypercubes(Rng& rng, std::size_t n, std::size_t dims, std::size_t sets) {
  return columns_of(MEASURE(latin_hypercube, n, dims, sets, fresh_seed(rng)), n, dims, sets, n);
}

/// The strata of the points of a column.
Order strata_of_axis(const Sets& sets, std::size_t set, std::size_t d) {
  const View column = sets.column(set, d);
  expect_one_in_each(fmt::format("{}, dimension {}", sets.call, d), "x", column, sets.n,
                     "each column is a pattern of 3.1");
  Order order;
  for (const double x : column) order.push_back(*stratum_of(x, sets.n));
  return order;
}

const std::string own_shuffle =
    "two axes always meet in the same way: shuffle each of them by itself";

CHECK_CASE("3.6 every axis is stratified", "[3.6][main][points:4][needs:3.1]") {
  Rng rng = check_rng();
  for (const std::size_t n : {64u, 1000u, 101u, 7u, 2u, 1u}) {
    for (const std::size_t dims : {7u, 2u, 1u}) {
      const Sets got = hypercubes(rng, n, dims, 2);
      for (std::size_t d = 0; d < dims; ++d) strata_of_axis(got, 0, d);
      if (n == 64 && dims == 7) {
        expect_drawn_afresh(got, hypercubes(rng, n, dims, 1), std::vector<std::size_t>(dims, n));
      }
    }
  }
}

CHECK_CASE("3.6 the permutations of the axes are independent",
           "[3.6][points:3][needs:3.1][needs:3.4]") {
  Rng rng = check_rng();
  constexpr std::size_t n = 4, dims = 3, sets = 5000;
  const Sets got = hypercubes(rng, n, dims, sets);
  std::array<Order, dims> orders;
  std::array<Values, dims> u;
  for (std::size_t set = 0; set < sets; ++set) {
    for (std::size_t d = 0; d < dims; ++d) {
      const Order one = strata_of_axis(got, set, d);
      orders[d].insert(orders[d].end(), one.begin(), one.end());
    }
  }
  for (std::size_t d = 0; d < dims; ++d) u[d] = jitters_of(got, d, n);
  for (const auto& [one, other] : pairs_of_three) {
    expect_all_orders(got.call, relative_orders(orders[one], orders[other], n), n,
                      fmt::format("the permutations of axes {} and {} are independent", one, other),
                      own_shuffle, "shuffle every column by itself, with the shuffle of 3.4");
    expect_independent(got.call, u[one], u[other],
                       fmt::format("the jitters of axes {} and {} are independent", one, other),
                       "one column is used for two axes: draw each afresh");
  }
  // Of 64 points no two axes ever have the same order: one chance in 64!.
  const Sets wide = hypercubes(rng, 64, 12, 1);
  std::vector<Order> axes;
  for (std::size_t d = 0; d < wide.dims; ++d) axes.push_back(strata_of_axis(wide, 0, d));
  for (std::size_t one = 0; one < axes.size(); ++one) {
    for (std::size_t other = one + 1; other < axes.size(); ++other) {
      expect_that(
          axes[one] != axes[other],
          fmt::format("{}: axes {} and {} have the same permutation", wide.call, one, other),
          "different permutations",
          "two random permutations of 64 are equal with probability 1 / 64!", own_shuffle);
    }
  }
}

CHECK_CASE("3.6 sums gain everything and products little",
           "[3.6][points:3][needs:3.1][needs:3.4]") {
  Rng rng = check_rng();
  const std::string otherwise =
      "is each column uniform in its strata, shuffled by itself, and drawn independently?";
  const auto sum = [](std::size_t n) {
    auto expected = expected_of(strata_of(exponential, n));  // seven of these, independent
    expected.mean *= 7, expected.variance *= 7, expected.independent *= 7;
    return expected;
  };
  const auto product = [](double (*h)(double), std::size_t n) {
    const auto axis = strata_of(h, n);
    return Expected{mean_of(axis) * mean_of(axis), shuffled_product_variance(axis, axis), 3,
                    independent_variance(product_of(axis, axis), n)};
  };
  const Tested g = sum_over_axes("exp(x0) + … + exp(x6)", exponential);
  expect_level(hypercubes(rng, 64, 7, 1000), g, sum(64),
               "estimates of a sum over seven axes have their exact variance", otherwise);
  expect_slope(hypercubes(rng, 16, 7, 500), hypercubes(rng, 256, 7, 500), g, {sum(16), sum(256)},
               "errors for a sum over seven axes fall as N^-1.5", otherwise);
  expect_level(hypercubes(rng, 64, 2, 1000), product_over_axes("exp(-x^2-y^2)", gaussian),
               product(gaussian, 64),
               "exp(-x^2-y^2) is nearly a sum: 28 times less variance than independent points",
               otherwise);
  expect_level(hypercubes(rng, 64, 2, 1000), product_over_axes("(x-1/2)(y-1/2)", centred),
               product(centred, 64), "(x-1/2)(y-1/2) is no sum at all: nothing is gained",
               otherwise);
}

}  // namespace
}  // namespace mc::checks
