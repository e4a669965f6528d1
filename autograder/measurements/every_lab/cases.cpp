// What every lab measures of the methods in its table: names for plots; for the bench, errors and
// times of those that the bench has.

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "checks/support/catch.hpp"
#include "measurements/support/bench_data.hpp"
#include "measurements/support/plot_data.hpp"
#include "methods.hpp"

namespace mc::measurements {
namespace {

/// Each method's name for gnuplot: KEY_is = "3.3 jittered".
TEST_CASE("plot names", "[.plot]") {
  auto file = plot_file("names.gp");
  for (const Method& one : methods) {
    file << fmt::format("{}_is = \"{}\"\n", one.key, one.name_with_task());
  }
}

/// Deterministic points have one error and no RMSE: they are shifted by random vectors, in the same
/// way for all methods.
Method shifted(const Method& points) {
  Method moved = points;
  moved.traits.is_random = true;
  moved.name += ", shifted";
  moved.points = [points](Count n, Count dims, Count count, Count seed) -> Sets {
    const Sets one = points.points(n, dims, 1, 1);
    if (one.empty()) return {};
    Sets sets(count, one[0]);
    Rng rng(seed);
    for (PointSet& set : sets) {
      for (Count d = 0; d < dims; ++d) {
        const double shift = uniform(rng);
        for (double& x : set.column(d)) x = x + shift < 1 ? x + shift : x + shift - 1;
      }
    }
    return sets;
  };
  return moved;
}

/// Replicates of an error: as many as fit into two million coordinates, which is what one
/// measurement can carry, 32 at least and 400 at most. The error's own standard error is then a
/// part 1/sqrt(2 · 32) = 12 % of it at most, if it is as good as normal.
Count replicates_for(Count coordinates) {
  return std::clamp<Count>((Count{1} << 20) / coordinates, 32, 400);
}

/// Of each method that the bench has, in each of its dimensions: errors of 16, 64, … points, and
/// what a point costs.
void bench_method(const Method& method, Count dims) {
  std::vector<Integrand> some;
  std::ranges::copy_if(integrands(), std::back_inserter(some),
                       [&](const Integrand& one) { return one.in_bench && one.dims == dims; });
  double point =
      method.traits.same_for_all_n ? nanoseconds_of(method.rounds_of(4096, dims), 4096) : missing;
  for (Count n = 16; n <= method.traits.most; n *= 4) {
    const double side = std::pow(static_cast<double>(n), 1 / static_cast<double>(dims));
    if (method.traits.power_of_root && std::abs(side - std::round(side)) > 1e-9) continue;
    if (!method.traits.same_for_all_n) point = nanoseconds_of(method.rounds_of(n, dims), n);
    if (std::isnan(point)) return;
    const auto errors = errors_of(method, some, n, replicates_for(n * dims), 1);
    for (std::size_t i = 0; i < some.size(); ++i) {
      const double mean_n = std::round(errors[i].points / std::max(1.0, errors[i].count()));
      bench_row({.method = method.name,
                 .task = method.task,
                 .integrand = some[i].name,
                 .dimensions = dims,
                 .n = static_cast<Count>(mean_n),
                 .rmse = errors[i].rmse() / some[i].mean,
                 .ns = point + nanoseconds_of(some[i])});
    }
  }
}

TEST_CASE("bench of methods", "[.bench]") {
  for (const Method& one : methods) {
    for (const Count dims : one.traits.dims) {
      bench_method(one.traits.is_random ? one : shifted(one), dims);
    }
  }
}

}  // namespace
}  // namespace mc::measurements
