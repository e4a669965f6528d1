#include "measurements/support/bench_data.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace mc::measurements {
namespace {

/// Deterministic points have an error, but no RMSE: for that they are shifted by random vectors,
/// here, so that it is done alike for all.
Method shifted(const Method& points) {
  Method moved = points;
  moved.is_random = true;
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

/// Calls measure(method, dims, sizes) for each method that the bench has, in each of its
/// dimensions; the sizes are 16, 64, ….
template <class Measure>
void for_each_method(const std::vector<Method>& methods, Measure measure) {
  for (const Method& one : methods) {
    const Method method = one.is_random ? one : shifted(one);
    for (const Count dims : method.dims) {
      std::vector<Count> sizes;
      for (Count n = 16; n <= method.most; n *= 4) {
        const double side = std::pow(static_cast<double>(n), 1 / static_cast<double>(dims));
        if (method.power_of_root && std::abs(side - std::round(side)) > 1e-9) continue;
        sizes.push_back(n);
      }
      measure(method, dims, sizes);
    }
  }
}

/// Replicates of an error: as many as fit into two million coordinates, which is what one
/// measurement can carry, 32 at least and 400 at most. The error's own standard error is then a
/// part 1/sqrt(2 · 32) = 12 % of it at most, if it is as good as normal.
Count replicates_for(Count coordinates) {
  return std::clamp<Count>((Count{1} << 20) / coordinates, 32, 400);
}

}  // namespace

void bench_error(const std::string& what, const std::string& on, Count dims, Count n,
                 const ErrorSums& errors, double exact) {
  bench_row({"error", what, on, dims, n, errors.rmse() / exact, errors.standard_error() / exact});
}

bool bench_time(const std::string& what, const std::string& on, Count dims, Count n,
                const Rounds& rounds) {
  const double round = seconds_of(rounds);
  bench_row({"time", what, on, dims, n, round * 1e9 / static_cast<double>(n)});
  return !std::isnan(round);
}

void bench_errors(const std::vector<Method>& methods) {
  for_each_method(methods, [](const Method& method, Count dims, const std::vector<Count>& sizes) {
    std::vector<Integrand> some;
    std::copy_if(integrands().begin(), integrands().end(), std::back_inserter(some),
                 [&](const Integrand& one) { return one.in_bench && one.dims == dims; });
    for (const Count n : sizes) {
      const auto errors = errors_of(method, some, n, replicates_for(n * dims), 1);
      for (std::size_t i = 0; i < some.size(); ++i) {
        const auto mean_n =
            static_cast<Count>(std::llround(errors[i].points / std::max(1.0, errors[i].count)));
        bench_error(method.name, some[i].name, dims, mean_n, errors[i], some[i].mean);
      }
    }
  });
}

void bench_times(const std::vector<Method>& methods) {
  for (const Integrand& one : integrands()) {
    if (!one.in_bench) continue;
    bench_row({"integrand", one.name, "", one.dims, 0, nanoseconds_of(one)});
    bench_row({"variance", one.name, "", one.dims, 0, one.variance / (one.mean * one.mean)});
  }
  for_each_method(methods, [](const Method& method, Count dims, std::vector<Count> sizes) {
    if (method.same_for_all_n) sizes = {4096};
    for (std::size_t i = 0; i < sizes.size(); ++i) {
      if (i % 2 == 1 && i + 1 < sizes.size()) continue;  // every other one, and the last
      if (!bench_time(method.name, "", dims, sizes[i], method.rounds_of(sizes[i], dims))) break;
    }
  });
}

void bench_growth(const Method& method, Count dims, Count most, Count least, Count factor) {
  for (Count n = least; n <= most; n *= factor) {
    std::size_t memory = 0;
    const double round = seconds_of([&](Count rounds) {
      const Cost cost = method.rounds(n, dims, rounds, large);
      memory = std::max(memory, cost.memory);
      return cost;
    });
    if (std::isnan(round)) return;
    bench_row({"growth", method.name, "n", dims, n, round});
    bench_row({"memory", method.name, "n", dims, n, static_cast<double>(memory)});
  }
}

void bench_growth_of_dims(const Method& method) {
  const std::string name = method.is_random ? method.name : shifted(method).name;
  for (Count dims = 1; dims <= 32; dims *= 2) {
    const double round = seconds_of(method.rounds_of(4096, dims));
    if (std::isnan(round)) return;
    bench_row({"growth", name, "dims", dims, 4096, round});
  }
}

}  // namespace mc::measurements
