// 3.1, 3.2, 3.3, 3.10: strata of the line and the plane. Tested exactly: the stratum of each point,
// with edges i / n divided in double; its position in the stratum is tested as a random number.
// Nothing depends on the order in which a submission draws.

#include "checks/stratification/common.hpp"

namespace mc::checks {
namespace {

const std::string one_in_each = "one point in each stratum: (i + u) / N for i = 0 … N-1";

Stratified line(std::size_t n) {
  return {"3.1",
          [=](std::size_t sets, std::uint64_t seed) {
            return sets_from_columns(MEASURE(stratified_1d, n, sets, seed), n, 1, sets, n);
          },
          {line_of(n)},
          one_in_each};
}

/// Point i of n lies in stratum i, for all i.
void require_order(const Sets& sets);

CHECK_CASE("3.1 one point in each stratum and in order", "[3.1][main][points:4]") {
  for (const std::size_t n : {std::size_t{12}, std::size_t{100}, 20 + rng() % 1000}) {
    require_order(line(n).some(2, rng));
  }
  line(64).expect_new_points(rng);
}

CHECK_CASE("3.1 any number of strata", "[3.1][edge][points:2]") {
  for (const std::size_t n : domain::sizes(999983, rng)) {
    require_order(line(n).some(n < 5000 ? 2 : 1, rng));
  }
  expect_random_calls(line(32000).jitters(), 2, rng);  // other code may write many points
}

CHECK_CASE("3.1 each point is uniform in its stratum and independent", "[3.1][points:4]") {
  for (const std::size_t n : {16u, 37u, 100u, 1025u, 1u}) {
    expect_random_calls(line(n).jitters(), std::max<std::size_t>(200, 20000 / n), rng, n <= 40);
  }
}

CHECK_CASE("3.1 the error falls as N^-1.5", "[3.1][points:3]") {
  for (const std::size_t n : {64u, 16u, 256u}) {
    expect_level(line(n).some(1000, rng),
                 level_of("exp(x)", sum_over_axes(exponential), strata_of(exponential, n)));
  }
  // Every stratum contains a whole period: mean 0, variance 1/2, kurtosis 3/2, like the whole line.
  constexpr double n = 64;
  expect_level(line(64).some(1000, rng),
               {"cos(2 pi N x)", [](View x) { return std::cos(2 * std::numbers::pi * n * x[0]); },
                0, 0.5 / n, 3 - 1.5 / n, 0,
                "all variance of a wave with N periods is within the strata: nothing is gained"});
}

CHECK_CASE("3.1 no point leaves its stratum whatever the bits", "[3.1][edge][points:2]") {
  for (const std::size_t n :
       {std::size_t{1000}, std::size_t{49}, 2 + rng() % 5000, std::size_t{1009},
        std::size_t{999983}, std::size_t{5}, std::size_t{3}, std::size_t{2}, std::size_t{1}}) {
    for (const std::uint64_t word : domain::constant_words(rng)) {
      require_order(sets_from_columns(MEASURE(stratified_1d_constant, n, word), n, 1, 1, n));
    }
  }
}

const std::string largest_divisor = "ny is the largest divisor of n up to sqrt(n)";
void compare_grids(const std::vector<std::uint64_t>& n, const std::string& rule = largest_divisor);

CHECK_CASE("3.2 the grid is as square as n allows", "[3.2][main][points:2]") {
  std::vector<std::uint64_t> n(389);
  std::iota(n.begin(), n.end(), 12);
  compare_grids(n);
  compare_grids({30030, 1u << 20, 1000000, 999999, 1009 * 1013, 1000 + rng() % 1000000});
}

CHECK_CASE("3.2 primes and the smallest numbers", "[3.2][edge][points:0.5]") {
  compare_grids(
      {7, 101, 1009, 65537, 999983, 2 * 499979, 1000000007, 11, 10, 9, 8, 6, 5, 4, 3, 2, 1});
  compare_grids(domain::sizes(999983, rng));
}

CHECK_CASE("3.2 any 64-bit number of cells", "[3.2][edge][points:1]") {
  // Squares, products of neighbors, and neighbors of squares: a search down from the root ends at
  // once, or after two steps. 2^64 - 1 = (2^32 - 1) (2^32 + 1).
  const std::uint64_t k = 66000 + rng() % 400000, most = ~std::uint64_t{0}, root = most >> 32;
  for (const std::vector<std::uint64_t>& n :
       {std::vector<std::uint64_t>{k * k, k * (k + 1), k * k - 1},
        {std::uint64_t{1} << 40, 1000000000000},
        {most, root * root, root * (root - 1), root * root - 1}}) {
    const Call call = MEASURE_OUTCOME(strata, n);
    expect_that(!call.outcome.over_limit(), call.text + " did not end",
                "at most sqrt(n) - ny + 1 divisions", "",
                n[0] < most
                    ? "k * k overflows 32 bits and never exceeds n: make k a std::size_t"
                    : "k * k overflows 64 bits and never exceeds n, or the search begins at "
                      "1: begin at sqrt(n) and go down");
    compare_grids(
        n, largest_divisor + ", a root that a float or a double rounds: correct it in integers");
  }
  std::uint64_t odd = (1u << 24) + 1 + 2 * (rng() % 1000000);  // a float rounds its root down
  while (std::sqrt(static_cast<float>(odd * odd)) >= static_cast<double>(odd)) odd += 2;
  compare_grids({odd * odd}, "a float has 24 bits: compute the root in double");
}

const std::string one_in_each_of_plane =
    "each cell (i, j) gets one point, ((i + u) / nx, (j + v) / ny)";

Stratified jittered(Grid grid) {
  return {"3.3",
          [=](std::size_t sets, std::uint64_t seed) {
            return sets_from_xy(MEASURE(stratified_2d, grid, sets, seed), grid, sets);
          },
          {plane_of(grid)},
          one_in_each_of_plane};
}

CHECK_CASE("3.3 one point in each cell", "[3.3][main][points:4]") {
  for (const Grid grid :
       {Grid{16, 4}, Grid{8, 8}, Grid{3, 5}, Grid{10 + rng() % 40, 10 + rng() % 40}}) {
    jittered(grid).expect_cells(2, rng);
  }
  jittered({16, 4}).expect_new_points(rng);
}

CHECK_CASE("3.3 any grid", "[3.3][edge][points:2]") {
  for (const Grid grid :
       {Grid{100, 10}, Grid{33, 31}, Grid{129, 127}, Grid{1023, 3}, Grid{3, 1025}, Grid{257, 255},
        Grid{1, 4097}, Grid{65537, 1}, Grid{701, 499}, Grid{511, 9}, Grid{7, 1}, Grid{1, 11},
        Grid{3, 1}, Grid{1, 3}, Grid{2, 1}, Grid{1, 2}, Grid{1, 1}}) {
    jittered(grid).expect_cells(2, rng);
  }
  // The size that is timed, and a large one, for which a program may have other code.
  for (const auto& [grid, sets] : {std::pair<Grid, std::size_t>{{32, 32}, 100}, {{200, 160}, 1}}) {
    expect_random_calls(jittered(grid).jitters(), sets, rng);
  }
}

CHECK_CASE("3.3 each point is uniform in its cell and independent", "[3.3][points:5]") {
  for (const Grid grid : {Grid{4, 4}, Grid{5, 3}, Grid{1, 7}, Grid{31, 33}, Grid{1, 1}}) {
    const std::size_t sets = std::max<std::size_t>(200, 20000 / grid.nx / grid.ny);
    expect_random_calls(jittered(grid).jitters(), sets, rng, grid.nx == 4);
  }
}

CHECK_CASE("3.3 the error falls as 1/N and across an edge as N^-3/4", "[3.3][points:4]") {
  const double edge = uniform(rng, 0.05, 0.15);
  const auto below_edge = [=](View x) {
    return std::cos(1.0) * (x[0] - 0.5) + std::sin(1.0) * (x[1] - 0.5) < edge ? 1.0 : 0.0;
  };
  // Jitter shared by a row of cells gives 1.2 times the variance: 9000 sets detect that.
  for (const auto& [side, sets] : {std::pair<std::size_t, std::size_t>{8, 9000}, {16, 1000}}) {
    const Sets got = jittered({side, side}).some(sets, rng);
    const auto axis = strata_of(gaussian, side);
    expect_level(got,
                 level_of("exp(-x^2-y^2)", product_over_axes(gaussian), product_of(axis, axis)));
    const auto cells = edge_strata(edge, side);
    expect_level(got, level_of(fmt::format("1 where cos(1)(x-1/2) + sin(1)(y-1/2) < {:.6g}", edge),
                               below_edge, cells, edge_kurtosis(cells)));
  }
}

CHECK_CASE("3.3 edges and waves have their exact variances", "[3.3][points:1]") {
  constexpr std::size_t side = 8, n = side * side;
  const Sets got = jittered({side, side}).some(4000, rng);
  // The diagonal halves `side` cells, of variance 1/4 and kurtosis 1 each.
  expect_level(got, {"1 where y < x", [](View x) { return x[1] < x[0] ? 1.0 : 0.0; }, 0.5,
                     side * 0.25 / (n * n), 3 - 2.0 / side, 0.25 / n,
                     "the diagonal cuts 8 of 64 cells in half"});
  // Every cell contains whole periods: mean 0, variance 1/4, kurtosis (3/8)^2 / (1/4)^2.
  expect_level(got, {"cos(2 pi nx x) cos(2 pi ny y)",
                     [](View x) {
                       const double turns = 2 * std::numbers::pi * side;
                       return std::cos(turns * x[0]) * std::cos(turns * x[1]);
                     },
                     0, 0.25 / n, 3 - 0.75 / n, 0,
                     "all variance of a wave as fine as the cells is within them"});
}

CHECK_CASE("3.3 no point leaves its cell whatever the bits", "[3.3][edge][points:1]") {
  for (const Grid grid : {Grid{49, 98}, Grid{1 + rng() % 100, 1 + rng() % 100}, Grid{2, 3},
                          Grid{1009, 1}, Grid{1, 1009}, Grid{1, 1}}) {
    for (const std::uint64_t word : domain::constant_words(rng)) {
      const auto got = MEASURE(stratified_2d_upper_bits, grid, word);
      expect_one_in_each_cell(sets_from_xy(got, grid, 1), 0, plane_of(grid), one_in_each_of_plane);
    }
  }
}

CHECK_CASE("3.10 blocks of any length have their strata",
           "[3.10][main][stretch][needs:3.1][needs:3.3]") {
  const std::string rest = "the last block may be shorter than the others";
  const std::size_t some = 3000 + rng() % 5000;
  for (const std::size_t n : {std::size_t{4099}, some, std::size_t{500009}}) {
    Stratified blocks = line(n);
    blocks.rule = rest;
    expect_random_calls(blocks.jitters(), 1, rng);
  }
  for (const Grid grid : {Grid{1 + rng() % 30, some}, Grid{4099, 1}, Grid{1000, 500}}) {
    Stratified blocks = jittered(grid);
    blocks.rule = rest;
    blocks.expect_cells(1, rng);
  }
}

// What the cases above use ------------------------------------------------------------------------

void require_order(const Sets& sets) {
  for (std::size_t set = 0; set < sets.size(); ++set) {
    const auto strata = expect_one_in_each_cell(sets, set, line_of(sets.n), one_in_each);
    for (std::size_t i = 0; i < sets.n; ++i) {
      if (strata[i] == i) continue;
      fail(Failure{fmt::format("{}: x[{}] = {}", sets.call, i, sets.column(set, 0)[i]),
                   fmt::format("a value in [{}/{}, {}/{})", i, sets.n, i + 1, sets.n),
                   "point i lies in stratum i",
                   "every stratum has its point, but the points are not in order"_likely});
    }
  }
}

/// The squarest grids, and the results of well-known mistakes: nx, ny, nx, ny, …
Comparison most_square(const std::vector<std::uint64_t>& n, const std::string& rule) {
  Comparison grids{
      .exact = {},
      .because = "nx * ny = n with nx >= ny, as close to each other as the factors of n allow",
      .suspects = {{{}, "nx must be the larger one"_likely},
                   {{}, "nx * ny must be n: with fewer cells, points are left over"_likely}},
      .rule = rule};
  for (const std::uint64_t cells : n) {
    const Grid best = squarest(cells);
    const auto root = static_cast<std::uint64_t>(std::sqrt(static_cast<double>(cells)));
    const auto add = [](Values& values, std::uint64_t nx, std::uint64_t ny) {
      values.insert(values.end(), {static_cast<double>(nx), static_cast<double>(ny)});
    };
    add(grids.exact, best.nx, best.ny);
    add(grids.suspects[0].values, best.ny, best.nx);
    add(grids.suspects[1].values, cells / root, root);
  }
  if (n.back() >> 32 != 0) grids.suspects.clear();  // a rounded root has these results, too
  grids.name = [n](std::size_t i) {
    return fmt::format("strata({}).{}", n[i / 2], i % 2 == 0 ? "nx" : "ny");
  };
  return grids;
}

void compare_grids(const std::vector<std::uint64_t>& n, const std::string& rule) {
  const auto got = MEASURE(strata, n);
  Values values;
  for (const Grid grid : got.exactly(n.size(), any_number)) {
    values.insert(values.end(), {static_cast<double>(grid.nx), static_cast<double>(grid.ny)});
  }
  expect_each({got.call, values}, most_square(n, rule));
}

}  // namespace
}  // namespace mc::checks
