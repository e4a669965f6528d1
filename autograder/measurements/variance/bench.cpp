// Lab 1 in the bench: digits kept and nanoseconds a value, for each way to a variance.

#include <algorithm>
#include <array>
#include <cmath>

#include "1-variance/experiments.hpp"
#include "checks/support/catch.hpp"
#include "checks/support/data.hpp"
#include "checks/support/exact.hpp"
#include "checks/support/expect.hpp"
#include "checks/variance/data_sets.hpp"
#include "measurements/support/bench_data.hpp"

namespace mc::checks {
namespace {

struct Way {
  unsigned task;
  const char* name;
};
constexpr std::array<Way, 5> ways{{{2, "1.2 textbook"},
                                   {3, "1.3 two passes"},
                                   {4, "1.4 Welford"},
                                   {5, "1.5 merged parts"},
                                   {8, "1.8 moments"}}};

struct Data {
  const char* name;
  Values x;
};

/// From tame to hard; NumAcc4 is NIST's (Statistical Reference Datasets), its variance 0.01.
std::vector<Data> cases() {
  Rng rng(1);
  std::vector<Data> all{{"U(0, 1)", uniform_values(rng, 4096, 0, 1)},
                        {"1e6 + U(0, 1)", uniform_values(rng, 4096, 1e6, 1e6 + 1)},
                        {"1e9 + U(0, 1)", uniform_values(rng, 4096, 1e9, 1e9 + 1)},
                        {"NumAcc4", Values(1001)},
                        {"one far value", uniform_values(rng, 4096, 0, 1)}};
  for (std::size_t i = 0; i < 1001; ++i) {
    all[3].x[i] = i == 0 ? 10000000.2 : i % 2 == 1 ? 10000000.1 : 10000000.3;
  }
  all[4].x[0] = 1e12;
  return all;
}

TEST_CASE("bench digits", "[.bench-error]") {
  for (const Data& data : cases()) {
    const double exact = exact_moments(data.x).variance;
    for (const Way& way : ways) {
      const auto got = TRY_MEASURE(variances, way.task, data.x, data.x.size());
      const auto* variance = got ? got->if_exactly(1, any_number) : nullptr;
      if (!variance) continue;
      const double kept = std::clamp(digits(variance->front(), exact), 0.0, 16.0);
      bench_row({"digits", way.name, data.name, 1, data.x.size(), kept});
    }
  }
}

void bench_way(const Way& way, const char* where, std::uint64_t n) {
  const auto round = seconds_once([&](std::uint64_t rounds) {
    return cpu_seconds_of(TRY_MEASURE_WITH(large, repeat_made, way.task, n, rounds, 1));
  });
  if (round) bench_row({"time", way.name, where, 1, n, *round * 1e9 / static_cast<double>(n)});
}

TEST_CASE("bench time", "[.bench-time]") {
  for (const Way& way : ways) bench_way(way, "in cache", 4096);                        // 32 KB
  for (const Way& way : ways) bench_way(way, "out of cache", std::uint64_t{1} << 23);  // 64 MB
}

TEST_CASE("bench growth", "[.bench-growth]") {
  for (const Way& way : ways) {
    bench_growth(way.name, 1, 100'000'000, [&](std::uint64_t n, std::uint64_t rounds) {
      return used_by(TRY_MEASURE_WITH(large, repeat_made, way.task, n, rounds, 1));
    });
  }
}

}  // namespace
}  // namespace mc::checks
