#include "measurements/support/bench_data.hpp"

#include <algorithm>
#include <cmath>

namespace mc::measurements {

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
  const std::string name = method.name + (method.traits.is_random ? "" : ", shifted");
  for (Count dims = 1; dims <= 32; dims *= 2) {
    const double round = seconds_of(method.rounds_of(4096, dims));
    if (std::isnan(round)) return;
    bench_row({"growth", name, "dims", dims, 4096, round});
  }
}

}  // namespace mc::measurements
