// Lab 6 in the bench: scenes, through the interface of a sampler; what each next2() is worth, and
// what a number costs where samples are few.

#include <array>
#include <cmath>
#include <numeric>

#include "checks/support/catch.hpp"
#include "measurements/sampler/methods.hpp"
#include "measurements/support/bench_data.hpp"

namespace mc::measurements {
namespace {

/// Calls run(kind, name, scene, n) for each kind on each scene at sizes 16, 16 factor, …, for as
/// long as it returns true; blue noise up to 256.
template <class Run>
void on_scenes(std::uint64_t factor, Run run) {
  for (const SceneRow& scene : scene_rows) {
    if (!scene.in_bench) continue;
    for (std::size_t k = 0; k < methods.size(); ++k) {
      const std::uint64_t most = kinds[k] == "blue_noise" ? 256 : methods[k].most;
      for (std::uint64_t n = 16; n <= most; n *= factor) {
        if (!run(kinds[k], methods[k].name, scene, n)) break;
      }
    }
  }
}

TEST_CASE("bench error", "[.bench-error]") {
  for (const SceneRow& scene : scene_rows) {
    const Known known = known_scene(scene.name, {});
    if (!scene.in_bench) continue;
    bench_row(
        {"variance", scene.name, "", scene.dims, 0, known.variance / (known.exact * known.exact)});
  }
  on_scenes(4, [](const auto& kind, const auto& name, const SceneRow& scene, std::uint64_t n) {
    bench_error(name, scene.name, scene.dims, n, scene_errors(kind, scene.name, n, 200, 1),
                known_scene(scene.name, {}).exact);
    return true;
  });
}

TEST_CASE("bench time", "[.bench-time]") {
  on_scenes(16, [](const auto& kind, const auto& name, const SceneRow& scene, std::uint64_t n) {
    return bench_time(name, scene.name, scene.dims, n, [&](std::uint64_t rounds) {
      return cpu_seconds_of(TRY_MEASURE(repeat_scene, kind, scene.name, n, rounds, 1));
    });
  });
}

TEST_CASE("bench growth", "[.bench-growth]") {
  for (std::size_t k = 0; k < methods.size(); ++k) {
    if (methods[k].most < 4096) continue;
    const std::string &kind = kinds[k], name = "sampler: " + methods[k].name;
    Method by_next = methods[k];
    by_next.rounds = [=](std::uint64_t n, std::uint64_t dims, std::uint64_t rounds) {
      return cpu_seconds_of(TRY_MEASURE(repeat, kind, 1, dims, n, rounds, 1));
    };
    bench_growth_of_dims(name, by_next);
    bench_growth(name, 2, 10'000'000, [=](std::uint64_t n, std::uint64_t rounds) {
      return used_by(TRY_MEASURE_WITH(large, repeat, kind, 2, 2, n, rounds, 1));
    });
  }
}

constexpr std::size_t table_n = 1024, table_uses = 17;

/// What is made of point sets with a pair of dimensions for each use.
void write_worth(const std::string& row, const Sets& sets) {
  const scenes::RectangleLight rectangle;
  const Integrand lamp = plane_integrand(rectangle), edge = plane_integrand(scenes::PixelEdge{});
  constexpr std::size_t of_sums = 12, of_products = 6;
  for (const std::size_t k : {1u, 8u, 13u, 17u}) {
    ErrorSums under_lamp, at_edge;
    for (const PointSet& set : sets) {
      if (2 * k > set.dims()) continue;
      under_lamp.add(error_of(lamp, set, table_n, 2 * k - 2));
      at_edge.add(error_of(edge, set, table_n, 2 * k - 2));
    }
    const std::string column = fmt::format("{}{}", k, k == 1 ? "st" : "th");
    bench_table("RMSE of the k-th next2() under a lamp, N = 1024", row, column, table_n,
                under_lamp);
    bench_table("RMSE of the k-th next2() at an edge, N = 1024", row, column, table_n, at_edge);
  }
  ErrorSums sums, products;
  for (const PointSet& set : sets) {
    double sum = 0, product_sum = 0;
    for (std::size_t use = 0; use < of_sums; ++use) {
      sum += error_of(lamp, set, table_n, 2 * use) / lamp.mean / of_sums;
    }
    for (std::size_t i = 0; i < table_n; ++i) {
      double product = 1;
      for (std::size_t use = 0; use < of_products; ++use) {
        product *=
            lamp.g(std::array{set.column(2 * use)[i], set.column(2 * use + 1)[i]}) / lamp.mean;
      }
      product_sum += product;
    }
    sums.add(sum);
    products.add(product_sum / table_n - 1);
  }
  const std::string title = "RMSE of many lamps, a next2() each, relative to the value, N = 1024";
  bench_table(title, row, "mean of twelve", table_n, sums);
  bench_table(title, row, "product of six", table_n, products);
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
  for (std::size_t k = 0; k < methods.size(); ++k) {
    // A best candidate of 1,024 points costs as much as a thousand scrambled ones.
    const std::size_t count = kinds[k] == "blue_noise" ? 48 : 240;
    write_worth(kinds[k], sets_in_parts(methods[k], table_n, 2 * table_uses, count, 1));
  }
  write_worth("sobol, one sequence", sets_of_one_sequence(240));
}

/// Sixteen dimensions: two blocks, or the first sixteen of one sequence.
TEST_CASE("bench table of sixteen dimensions", "[.bench-table]") {
  constexpr std::size_t n = 4096, dims = 16;
  std::vector<unsigned> first(dims);
  std::iota(first.begin(), first.end(), 0u);
  const Integrand edge = plane_integrand(scenes::PixelEdge{});
  for (const auto& [row, method] :
       {std::pair{"two blocks of eight", methods[4]}, {"one sequence", sobol_dimensions(first)}}) {
    ErrorSums smooth, product, pairs;
    for (const PointSet& set : sets_in_parts(method, n, dims, 240, 1)) {
      double sum_smooth = 0, sum_product = 0, sum_pairs = 0;
      for (std::size_t i = 0; i < n; ++i) {
        double sum = 0, factors = 1;
        for (std::size_t d = 0; d < dims; ++d) {
          const double x = set.column(d)[i];
          sum += x / 4;
          factors *= 0.5 + x;
        }
        sum_smooth += std::exp(sum);
        sum_product += factors;
      }
      for (std::size_t d = 0; d < dims; d += 2) sum_pairs += error_of(edge, set, n, d) / 8;
      smooth.add(sum_smooth / n / std::pow(4 * (std::exp(0.25) - 1), dims) - 1);
      product.add(sum_product / n - 1);
      pairs.add(sum_pairs);
    }
    const std::string title = "RMSE in 16 dimensions, N = 4096";
    bench_table(title, row, "exp((x_1 + … + x_16) / 4), relative", n, smooth);
    bench_table(title, row, "product of 1/2 + x_j", n, product);
    bench_table(title, row, "mean of eight edges, a next2() each", n, pairs);
  }
}

/// Of exp(x + y + ...) over the first n points, in dimensions from `first` on.
ErrorSums exp_errors(const Sets& sets, std::size_t dims, std::size_t n, std::size_t first) {
  const Integrand& smooth = integrand(fmt::format("smooth {}D", dims));
  ErrorSums errors;
  for (const PointSet& set : sets) errors.add(error_of(smooth, set, n, first));
  return errors;
}

/// Costs and gains of the choice of a block (6.3).
TEST_CASE("bench table of blocks", "[.bench-table]") {
  const std::vector<unsigned> in_order{0, 1, 2, 3, 4, 5, 6, 7}, chosen{0, 1, 4, 6, 16, 20, 15, 21};
  for (const auto& dimensions : {in_order, chosen}) {
    for (const std::size_t n : {16u, 64u, 256u, 1024u}) {
      const Sets sets = sets_in_parts(sobol_dimensions(dimensions), n, 8, 1000, 1);
      if (sets.empty()) return;
      const auto write = [&](const std::string& what, std::size_t dims, const ErrorSums& errors) {
        const double variance = integrand(fmt::format("smooth {}D", dims)).variance;
        const double scale = static_cast<double>(n) / variance, rmse = errors.rmse();
        bench_table({"mean squared error of exp(x + y + ...) by that of independent samples",
                     (dimensions == chosen ? "the block, " : "dimensions 0 to 7, ") + what,
                     fmt::format("N = {}", n), n, rmse * rmse * scale,
                     2 * rmse * errors.standard_error() * scale});
      };
      std::vector<ErrorSums> pairs;
      for (std::size_t k = 0; k < 4; ++k) pairs.push_back(exp_errors(sets, 2, n, 2 * k));
      write("worst pair", 2,
            *std::max_element(pairs.begin(), pairs.end(),
                              [](const auto& a, const auto& b) { return a.squares < b.squares; }));
      write("first four", 4, exp_errors(sets, 4, n, 0));
      write("all eight", 8, exp_errors(sets, 8, n, 0));
    }
  }
}

/// How early an integration may be stopped (6.3): the first and the second block.
TEST_CASE("bench table of early stops", "[.bench-table]") {
  for (const std::size_t k : {1u, 3u, 4u}) {
    const Sets sets = sets_in_parts(methods[k], table_n, 12, 288, 1);
    for (const auto& [use, name] : {std::pair{0u, "1st"}, {1u, "2nd"}, {4u, "5th"}, {5u, "6th"}}) {
      bench_table("first 256 of 1024 samples: RMSE of exp(x + y) by the k-th next2()", kinds[k],
                  name, 256, exp_errors(sets, 2, 256, 2 * use));
    }
  }
}

/// Cells of a square grid of N cells that a next2() leaves empty (6.3), on average.
TEST_CASE("bench table of empty cells of next2", "[.bench-table]") {
  for (const std::size_t k : {3u, 4u}) {
    for (const std::size_t side : {4u, 8u, 16u, 32u}) {
      const std::size_t n = side * side;
      const Sets sets = sets_in_parts(methods[k], n, 8, 50, 1);
      for (std::size_t use = 0; use < 4 && !sets.empty(); ++use) {
        double empty = 0;
        for (const PointSet& set : sets) {
          std::vector<bool> taken(n);
          for (std::size_t i = 0; i < n; ++i) {
            const auto cell = [&](std::size_t d) {
              return static_cast<std::size_t>(set.column(d)[i] * static_cast<double>(side));
            };
            taken[cell(2 * use) * side + cell(2 * use + 1)] = true;
          }
          empty += static_cast<double>(std::count(taken.begin(), taken.end(), false));
        }
        bench_table({"empty cells of a grid of N, by call of next2()",
                     fmt::format("{}, {}", kinds[k], use + 1), fmt::format("N = {}", n), n,
                     empty / static_cast<double>(sets.size())});
      }
    }
  }
}

/// Four dimensions by next2(), what generate() does included.
TEST_CASE("bench table of times", "[.bench-table-time]") {
  for (std::size_t k = 0; k < methods.size(); ++k) {
    for (const std::uint64_t n : {1u, 4u, 16u, 64u, 256u, 1024u}) {
      const Number round =
          seconds_of([&](std::uint64_t rounds) { return methods[k].rounds(n, 4, rounds); });
      if (!round) break;
      bench_table({"ns per number, four dimensions by next2(), generate() included", kinds[k],
                   fmt::format("N = {}", n), n, *round * 1e9 / static_cast<double>(4 * n)});
    }
  }
}

}  // namespace
}  // namespace mc::measurements
