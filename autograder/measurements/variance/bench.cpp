// Lab 1 in the bench: digits kept and nanoseconds a value, for each way to a variance.

#include "checks/support/catch.hpp"
#include "measurements/support/bench_data.hpp"
#include "measurements/variance/methods.hpp"

namespace mc::measurements {
namespace {

/// From tame to hard; NumAcc4 is NIST's (Statistical Reference Datasets), its variance 0.01.
TEST_CASE("bench digits", "[.bench-error]") {
  Rng rng(1);
  std::vector<std::pair<const char*, Values>> hard_cases{
      {"U(0, 1)", uniform_values(rng, 4096, 0, 1)},
      {"1e6 + U(0, 1)", uniform_values(rng, 4096, 1e6, 1e6 + 1)},
      {"1e9 + U(0, 1)", uniform_values(rng, 4096, 1e9, 1e9 + 1)},
      {"NumAcc4", {10000000.2}},
      {"one far value", uniform_values(rng, 4096, 0, 1)}};
  for (int i = 0; i < 500; ++i) append(hard_cases[3].second, Values{10000000.1, 10000000.3});
  hard_cases[4].second[0] = 1e12;
  for (const auto& [name, x] : hard_cases) {
    for (const Method& way : methods) {
      for (const double kept : digits_kept(way, x, x.size())) {
        bench_row({"digits", way.name_with_task(), name, 1, x.size(), kept});
      }
    }
  }
}

TEST_CASE("bench time", "[.bench-time]") {
  for (const auto& [where, n] : {std::pair{"in cache", Count{4096}},   // 32 KB
                                 {"out of cache", Count{1} << 23}}) {  // 64 MB
    for (const Method& way : methods) {
      bench_time(way.name_with_task(), where, 1, n, way.rounds_of(n, 1, large));
    }
  }
}

TEST_CASE("bench growth", "[.bench-growth]") {
  for (Method way : methods) {
    way.name = way.name_with_task();
    bench_growth(way, 1, 100'000'000);
  }
}

}  // namespace
}  // namespace mc::measurements
