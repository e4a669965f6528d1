// Lab 1 in the bench: errors and nanoseconds per value, for each way to a variance.

#include "checks/support/catch.hpp"
#include "measurements/support/bench_data.hpp"
#include "measurements/variance/methods.hpp"

namespace mc::measurements {
namespace {

/// From tame to hard; NumAcc4 is NIST's (Statistical Reference Datasets), its variance 0.01. And
/// the time in cache (32 KB) and out of it (64 MB).
TEST_CASE("bench of variances", "[.bench]") {
  Rng rng(1);
  std::vector<std::pair<const char*, Values>> hard_cases{
      {"U(0, 1)", uniform_values(rng, 4096, 0, 1)},
      {"1e6 + U(0, 1)", uniform_values(rng, 4096, 1e6, 1e6 + 1)},
      {"1e9 + U(0, 1)", uniform_values(rng, 4096, 1e9, 1e9 + 1)},
      {"NumAcc4", {10000000.2}},
      {"one far value", uniform_values(rng, 4096, 0, 1)}};
  for (int i = 0; i < 500; ++i) append(hard_cases[3].second, Values{10000000.1, 10000000.3});
  hard_cases[4].second[0] = 1e12;
  for (const Method& way : methods) {
    if (variances_by(way, {1, 2}, 2).empty()) continue;
    Row row{.method = way.name_with_task(), .task = way.task};
    for (const auto& [where, n] :
         {std::pair{"in cache", Count{4096}}, {"out of cache", Count{1} << 23}}) {
      row.integrand = where, row.n = n, row.ns = nanoseconds_of(way.rounds_of(n, 1, large), n);
      bench_row(row);
    }
    row.ns = missing;
    for (const auto& [name, x] : hard_cases) {
      for (const double kept : digits_kept(way, x, x.size())) {
        row.integrand = name, row.n = x.size(), row.rmse = std::pow(10, -kept);
        bench_row(row);
      }
    }
  }
}

}  // namespace
}  // namespace mc::measurements
