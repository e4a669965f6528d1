// Lab 6 in the bench: scenes, through the interface of a sampler; and what each next2() is worth.

#include <cmath>
#include <numeric>

#include "checks/support/catch.hpp"
#include "measurements/sampler/methods.hpp"
#include "measurements/support/bench_data.hpp"

namespace mc::measurements {
namespace {

TEST_CASE("bench of scenes", "[.bench]") {
  for (const auto& [scene, dims] : {std::pair{"pixel_edge", 2},
                                    {"rect_light", 2},
                                    {"penumbra_disk", 2},
                                    {"ao_sphere", 2},
                                    {"defocus_edge", 2},
                                    {"pixel_time_lens", 5}}) {
    for (const Method& method : methods) {
      const Count most = method.kind == "blue_noise" ? 256 : method.traits.most;
      for (Count n = 16; n <= most; n *= 4) {
        const double ns = nanoseconds_of(scene_rounds(method.kind, scene, n), n);
        if (std::isnan(ns)) break;
        bench_row({.method = method.kind,
                   .task = method.task,
                   .integrand = scene,
                   .dimensions = static_cast<Count>(dims),
                   .n = n,
                   .rmse = scene_errors(method.kind, scene, n, 200, 1).rmse() /
                           known_scene(scene, {}).exact,
                   .ns = ns});
      }
    }
  }
}

/// Divided by its mean.
Integrand relative(const Integrand& one) {
  return {one.name, one.dims, 1, [=](View x) { return one.g(x) / one.mean; }};
}
/// The mean, or the product, of the values of an integrand of the plane for each of so many pairs
/// of dimensions.
Integrand mean_of_uses(const Integrand& one, std::size_t uses) {
  return {"mean", 2 * uses, one.mean, [=](View x) {
            double sum = 0;
            for (std::size_t use = 0; use < uses; ++use) sum += one.g(x.subspan(2 * use, 2));
            return sum / static_cast<double>(uses);
          }};
}
Integrand product_of_uses(const Integrand& one, std::size_t uses) {
  return {"product", 2 * uses, std::pow(one.mean, static_cast<double>(uses)), [=](View x) {
            double product = 1;
            for (std::size_t use = 0; use < uses; ++use) product *= one.g(x.subspan(2 * use, 2));
            return product;
          }};
}

constexpr std::size_t table_n = 1024, table_uses = 17;

/// What is made of point sets with a pair of dimensions for each use.
void write_worth(const std::string& row, const Sets& sets) {
  const Integrand lamp = plane_integrand(scenes::RectangleLight{}),
                  edge = plane_integrand(scenes::PixelEdge{});
  const BenchTable under_lamp{"RMSE of the k-th next2() under a lamp, N = 1024", table_n};
  const BenchTable at_edge{"RMSE of the k-th next2() at an edge, N = 1024", table_n};
  const BenchTable many{"RMSE of many lamps, a next2() each, relative to the value, N = 1024",
                        table_n};
  for (const std::size_t k : {1u, 8u, 13u, 17u}) {
    if (sets.empty() || 2 * k > sets[0].dims()) continue;
    const std::string column = fmt::format("{}{}", k, k == 1 ? "st" : "th");
    under_lamp.add_rmse(row, column, errors_of(sets, lamp, table_n, 2 * k - 2));
    at_edge.add_rmse(row, column, errors_of(sets, edge, table_n, 2 * k - 2));
  }
  const Integrand one = relative(lamp);
  many.add_rmse(row, "mean of twelve", errors_of(sets, mean_of_uses(one, 12), table_n));
  many.add_rmse(row, "product of six", errors_of(sets, product_of_uses(one, 6), table_n));
}

/// Dimensions 0 and 1, 2 and 3, … of one Sobol' sequence; there are 16 pairs in all, and what is
/// shown ends before them. A pair at a time, each with its own seeds.
Sets sets_of_one_sequence(std::size_t count) {
  constexpr std::size_t pairs = 13;
  Sets all(count, PointSet(table_n, 2 * pairs));
  for (unsigned use = 0; use < pairs; ++use) {
    const Sets pair = sets_in_parts(sobol_dimensions({2 * use, 2 * use + 1}), table_n, 2, count,
                                    1 + 1'000'000 * use);
    if (pair.empty()) return {};
    for (std::size_t set = 0; set < count; ++set) {
      for (const std::size_t d : {0u, 1u}) {
        std::copy_n(pair[set].column(d).begin(), table_n, all[set].column(2 * use + d).begin());
      }
    }
  }
  return all;
}

TEST_CASE("bench table", "[.bench-table]") {
  for (const Method& one : methods) {
    // A best candidate of 1,024 points costs as much as a thousand scrambled ones.
    const std::size_t count = one.kind == "blue_noise" ? 48 : 240;
    write_worth(one.kind, sets_in_parts(one, table_n, 2 * table_uses, count, 1));
  }
  write_worth("sobol, one sequence", sets_of_one_sequence(240));
}

/// Sixteen dimensions: two blocks, or the first sixteen of one sequence.
TEST_CASE("bench table of sixteen dimensions", "[.bench-table]") {
  constexpr std::size_t n = 4096, dims = 16;
  const double mean = std::pow(4 * std::expm1(0.25), dims);
  const Integrand smooth{"smooth", dims, 1, [=](View x) { return std::exp(sum_of(x) / 4) / mean; }};
  const Integrand product{"product", dims, 1, [](View x) {
                            return std::accumulate(
                                x.begin(), x.end(), 1.0,
                                [](double all, double one) { return all * (0.5 + one); });
                          }};
  const Integrand edges = mean_of_uses(plane_integrand(scenes::PixelEdge{}), dims / 2);
  const BenchTable table{"RMSE in 16 dimensions, N = 4096", n};
  for (const auto& [row, method] : {std::pair{"two blocks of eight", methods["scrambled_sobol"]},
                                    {"one sequence", sobol_dimensions({0, 1, 2, 3, 4, 5, 6, 7, 8, 9,
                                                                       10, 11, 12, 13, 14, 15})}}) {
    const Sets sets = sets_in_parts(method, n, dims, 240, 1);
    table.add_rmse(row, "exp((x_1 + … + x_16) / 4), relative", errors_of(sets, smooth, n));
    table.add_rmse(row, "product of 1/2 + x_j", errors_of(sets, product, n));
    table.add_rmse(row, "mean of eight edges, a next2() each", errors_of(sets, edges, n));
  }
}

/// Costs and gains of the choice of a block (6.8).
TEST_CASE("bench table of blocks", "[.bench-table]") {
  BenchTable table{"mean squared error of exp(x + y + ...) by that of independent samples"};
  for (const auto& [name, dimensions] : {std::pair<std::string, std::vector<unsigned>>{
                                             "dimensions 0 to 7", {0, 1, 2, 3, 4, 5, 6, 7}},
                                         {"the block", {0, 1, 4, 6, 16, 20, 15, 21}}}) {
    for (const std::size_t n : {16u, 64u, 256u, 1024u}) {
      table.n = n;
      const Sets sets = sets_in_parts(sobol_dimensions(dimensions), n, 8, 1000, 1);
      const auto add = [&, row = name](const char* what, const Integrand& smooth,
                                       const ErrorSums& errors) {
        const double scale = static_cast<double>(n) / smooth.variance;
        table.add(fmt::format("{}, {}", row, what), table.column_of_n(), errors.moment(2) * scale,
                  errors.moment_error(2) * scale);
      };
      const Integrand &plane = integrand("smooth 2D"), &four = integrand("smooth 4D"),
                      &eight = integrand("smooth 8D");
      ErrorSums worst = errors_of(sets, plane, n);
      for (const std::size_t d : {2u, 4u, 6u}) {
        const ErrorSums pair = errors_of(sets, plane, n, d);
        if (pair.rmse() > worst.rmse()) worst = pair;
      }
      add("worst pair", plane, worst);
      add("first four", four, errors_of(sets, four, n));
      add("all eight", eight, errors_of(sets, eight, n));
    }
  }
}

/// How early an integration may be stopped (6.8): the first and the second block.
TEST_CASE("bench table of early stops", "[.bench-table]") {
  const BenchTable table{"first 256 of 1024 samples: RMSE of exp(x + y) by the k-th next2()", 256};
  for (const Method& one : methods.of({"multi_jittered", "scrambled_halton", "scrambled_sobol"})) {
    const Sets sets = sets_in_parts(one, table_n, 12, 288, 1);
    for (const auto& [use, name] : {std::pair{0u, "1st"}, {1u, "2nd"}, {4u, "5th"}, {5u, "6th"}}) {
      table.add_rmse(one.kind, name, errors_of(sets, integrand("smooth 2D"), 256, 2 * use));
    }
  }
}

/// Cells of a square grid of N cells that a next2() leaves empty (6.8), on average.
TEST_CASE("bench table of empty cells of next2", "[.bench-table]") {
  BenchTable table{"empty cells of a grid of N, by call of next2()"};
  for (const Method& one : methods.of({"scrambled_halton", "scrambled_sobol"})) {
    for (const std::size_t side : {4u, 8u, 16u, 32u}) {
      table.n = side * side;
      const Sets sets = sets_in_parts(one, table.n, 8, 50, 1);
      for (std::size_t use = 0; use < 4; ++use) {
        ErrorSums empty;
        for (const PointSet& set : sets) empty.add(empty_cells(set, side, 2 * use));
        table.add(fmt::format("{}, {}", one.kind, use + 1), table.column_of_n(), empty.moment(1));
      }
    }
  }
}

}  // namespace
}  // namespace mc::measurements
