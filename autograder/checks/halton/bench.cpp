// Lab 5 in the bench: Halton and Sobol' points, shifted and scrambled.

#include <cmath>
#include <numeric>

#include "5-halton/experiments.hpp"
#include "checks/support/bench_data.hpp"
#include "checks/support/catch.hpp"
#include "checks/support/data.hpp"

namespace mc::checks {
namespace {

using Values = std::vector<double>;
using Columns = std::optional<PointSets>;

/// Points that are not random have an error, but no mean square of it: they are shifted by `sets`
/// random vectors, here, so that it is done alike for all.
Columns shifted(const std::optional<Values>& points, std::uint64_t n, std::uint64_t dims,
                std::uint64_t sets, std::uint64_t seed) {
  if (!points || points->size() != n * dims) return {};
  Rng rng(seed);
  PointSets all{n, dims, {}};
  all.values.reserve(n * dims * sets);
  for (std::uint64_t column = 0; column < sets * dims; ++column) {
    const double shift = uniform(rng);
    for (std::uint64_t i = 0; i < n; ++i) {
      const double moved = (*points)[column % dims * n + i] + shift;
      all.values.push_back(moved < 1 ? moved : moved - 1);
    }
  }
  return all;
}

/// `scrambled(d, seeds)` makes column d by each seed, one after the other: sets of those.
template <class Scramble>
Columns by_columns(std::uint64_t n, std::uint64_t dims, std::uint64_t sets, std::uint64_t seed,
                   Scramble scrambled) {
  PointSets all{n, dims, Values(n * dims * sets)};
  for (std::uint64_t d = 0; d < dims; ++d) {
    std::vector<std::uint64_t> seeds(sets);
    std::iota(seeds.begin(), seeds.end(), (seed * 64 + d) << 20);
    const std::optional<Values> columns = scrambled(static_cast<unsigned>(d), seeds);
    if (!columns || columns->size() != n * sets) return {};
    for (std::uint64_t set = 0; set < sets; ++set) {
      std::copy_n(columns->begin() + static_cast<std::ptrdiff_t>(set * n), n,
                  all.values.begin() + static_cast<std::ptrdiff_t>((set * dims + d) * n));
    }
  }
  return all;
}

std::optional<Values> sobol_column(unsigned d, std::uint64_t n) {
  auto got = TRY_MEASURE(sobol, d, 0, n);
  if (!got) return {};
  return std::move(got->value);
}

BenchSampler sampler(unsigned task, std::string name) {
  BenchSampler made{std::move(name), {1, 2, 4, 8}};
  made.rounds = [=](std::uint64_t n, std::uint64_t dims, std::uint64_t rounds) {
    return cpu_seconds_of(TRY_MEASURE(repeat_points, task, n, dims, rounds));
  };
  made.points = [=](std::uint64_t n, std::uint64_t dims, std::uint64_t sets,
                    std::uint64_t seed) -> Columns {
    if (task == 3) {
      const auto got = TRY_MEASURE(halton, n, dims, 0);
      if (!got) return {};
      return shifted(got->value, n, dims, sets, seed);
    }
    if (task == 5) {
      Values points;
      for (unsigned d = 0; d < dims; ++d) {
        const auto column = sobol_column(d, n);
        if (!column) return {};
        points.insert(points.end(), column->begin(), column->end());
      }
      return shifted(points, n, dims, sets, seed);
    }
    constexpr unsigned bases[] = {2, 3, 5, 7, 11, 13, 17, 19};
    return by_columns(n, dims, sets, seed, [&](unsigned d, const auto& seeds) {
      std::optional<Values> columns;
      if (task == 9) {
        auto got = TRY_MEASURE(radical_inverses_scrambled, bases[d], 0, n, seeds);
        if (got) columns = std::move(got->value);
      } else if (const auto column = sobol_column(d, n)) {
        auto got = TRY_MEASURE(owen_scramble, *column, seeds);
        if (got) columns = std::move(got->value);
      }
      return columns;
    });
  };
  return made;
}

std::vector<BenchSampler> samplers() {
  return {sampler(3, "Halton, shifted"), sampler(9, "Halton, scrambled"),
          sampler(5, "Sobol', shifted"), sampler(8, "Sobol', scrambled")};
}

TEST_CASE("bench error", "[.bench-error]") {
  bench_errors(samplers());
}
TEST_CASE("bench time", "[.bench-time]") {
  bench_times(samplers());
}
TEST_CASE("bench growth", "[.bench-growth]") {
  for (const BenchSampler& one : samplers()) bench_growth_of_dims(one);
  // Columns of one axis, which nobody cuts into blocks.
  for (const auto& [name, task, of] : {std::tuple{"5.2 radical inverses, base 3", 2u, 3u},
                                       {"5.5 Sobol', dimension 1", 5u, 1u},
                                       {"5.8 the same, scrambled", 8u, 1u},
                                       {"5.9 scrambled radical inverses, base 3", 9u, 3u}}) {
    bench_growth(name, 1, 100'000'000,
                 [task = task, of = of](std::uint64_t n, std::uint64_t rounds) {
                   return used_by(TRY_MEASURE_WITH(large, repeat, task, of, n, rounds));
                 });
  }
}

TEST_CASE("speed of sequences", "[.speed]") {
  const auto column = [](unsigned task, unsigned of) {
    return [=](std::uint64_t rounds) {
      return cpu_seconds_of(TRY_MEASURE(repeat, task, of, 4096, rounds));
    };
  };
  bench_speed("5.2", "radical inverses in base 3", 4096, column(2, 3));
  bench_speed("5.5", "Sobol' coordinates", 4096, column(5, 1));
  bench_speed("5.8", "scrambled Sobol' coordinates", 4096, column(8, 1));
  bench_speed_error("5.8", "scrambled Sobol' coordinates", sampler(8, ""), 1024);
}

}  // namespace
}  // namespace mc::checks
