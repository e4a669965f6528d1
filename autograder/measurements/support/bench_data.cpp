#include "measurements/support/bench_data.hpp"

#include <algorithm>
#include <cmath>

namespace mc::measurements {
namespace {

/// Sizes 16, 64, … of which errors are measured.
std::vector<std::uint64_t> bench_sizes(const Method& method, std::uint64_t dims) {
  std::vector<std::uint64_t> sizes;
  for (std::uint64_t n = 16; n <= method.most; n *= 4) {
    const double side = std::pow(static_cast<double>(n), 1 / static_cast<double>(dims));
    if (method.power_of_root && std::abs(side - std::round(side)) > 1e-9) continue;
    sizes.push_back(n);
  }
  return sizes;
}

/// Replicates of an error: as many as fit into two million coordinates, which is what one
/// measurement can carry, 32 at least and 400 at most. The error's own standard error is then a
/// part 1/sqrt(2 · 32) = 12 % of it at most, if it is as good as normal.
std::uint64_t replicates_for(std::uint64_t coordinates) {
  return std::clamp<std::uint64_t>((std::uint64_t{1} << 20) / coordinates, 32, 400);
}

}  // namespace

void bench_error(const std::string& what, const std::string& on, std::uint64_t dims,
                 std::uint64_t n, const ErrorSums& errors, double exact) {
  if (errors.count == 0) return;
  bench_row({"error", what, on, dims, n, errors.rmse() / exact, errors.standard_error() / exact});
}

bool bench_time(const std::string& what, const std::string& on, std::uint64_t dims, std::uint64_t n,
                const Rounds& rounds) {
  const Number round = seconds_of(rounds);
  if (round) bench_row({"time", what, on, dims, n, *round * 1e9 / static_cast<double>(n)});
  return round.has_value();
}

void bench_errors(const std::vector<Method>& methods) {
  for (const Method& method : methods) {
    for (const std::uint64_t dims : method.dims) {
      std::vector<Integrand> some;
      for (const Integrand& one : integrands()) {
        if (one.in_bench && one.dims == dims) some.push_back(one);
      }
      for (const std::uint64_t n : bench_sizes(method, dims)) {
        const auto errors = errors_of(method, some, n, replicates_for(n * dims), 1);
        for (std::size_t i = 0; i < some.size(); ++i) {
          const auto mean_n = static_cast<std::uint64_t>(
              std::llround(errors[i].points / std::max(1.0, errors[i].count)));
          bench_error(method.name, some[i].name, dims, mean_n, errors[i], some[i].mean);
        }
      }
    }
  }
}

void bench_times(const std::vector<Method>& methods) {
  for (const Integrand& one : integrands()) {
    if (!one.in_bench) continue;
    bench_row({"integrand", one.name, "", one.dims, 0, nanoseconds_of(one)});
    bench_row({"variance", one.name, "", one.dims, 0, one.variance / (one.mean * one.mean)});
  }
  for (const Method& method : methods) {
    for (const std::uint64_t dims : method.dims) {
      auto sizes = bench_sizes(method, dims);
      if (method.same_for_all_n) sizes = {4096};
      for (std::size_t i = 0; i < sizes.size(); ++i) {
        if (i % 2 == 1 && i + 1 < sizes.size()) continue;  // every other one, and the last
        if (!bench_time(method.name, "", dims, sizes[i], [&](std::uint64_t rounds) {
              return method.rounds(sizes[i], dims, rounds);
            })) {
          break;
        }
      }
    }
  }
}

void bench_growth(const std::string& what, std::uint64_t dims, std::uint64_t most,
                  const std::function<std::optional<Used>(std::uint64_t, std::uint64_t)>& rounds,
                  std::uint64_t least, std::uint64_t factor) {
  for (std::uint64_t n = least; n <= most; n *= factor) {
    std::size_t memory = 0;
    const Number round = seconds_of([&](std::uint64_t times) -> Number {
      const auto used = rounds(n, times);
      if (!used) return {};
      memory = std::max(memory, used->memory);
      return used->seconds;
    });
    if (!round) return;
    bench_row({"growth", what, "n", dims, n, *round});
    bench_row({"memory", what, "n", dims, n, static_cast<double>(memory)});
  }
}

void bench_growth_of_dims(const std::string& what, const Method& method) {
  for (std::uint64_t dims = 1; dims <= 32; dims *= 2) {
    const Number round =
        seconds_of([&](std::uint64_t rounds) { return method.rounds(4096, dims, rounds); });
    if (!round) return;
    bench_row({"growth", what, "dims", dims, 4096, *round});
  }
}

void bench_table(const Cell& cell) {
  bench_row({"table " + cell.title, cell.row, cell.column, 0, cell.n, cell.value, cell.error});
}

void bench_table(const std::string& title, const std::string& row, const std::string& column,
                 std::uint64_t n, const ErrorSums& errors) {
  if (errors.count == 0) return;
  bench_table({title, row, column, n, errors.rmse(), errors.standard_error()});
}

}  // namespace mc::measurements
