// Lab 2 in the demo: independent points; and a hundred estimates with their standard errors at
// every N.

#include <cmath>

#include <fmt/format.h>

#include "checks/support/catch.hpp"
#include "common/normal_quantile.hpp"
#include "measurements/independent/methods.hpp"
#include "measurements/support/demo.hpp"

namespace mc::measurements {
namespace {

TEST_CASE("demo", "[.demo]") {
  begin_demo();
  write_demo_points(2, uniform_points);
}

double rounded(double value) {
  return std::strtod(fmt::format("{:.6g}", value).c_str(), nullptr);
}

TEST_CASE("demo of intervals", "[.demo]") {
  begin_demo();
  constexpr std::size_t replicates = 100;
  const std::vector<double> levels{0.5, 0.683, 0.8, 0.9, 0.95, 0.99, 0.999};
  std::vector<double> z;
  for (const double level : levels) z.push_back(normal_quantile((1 + level) / 2));
  for (const std::size_t i : {0u, 2u, 3u, 4u}) {
    const auto& [name, g, mean] = line_integrands[i];
    std::vector<double> sizes, values, errors;
    for (Count n = 4; n <= 16384; n *= 4) {
      const auto all = lists_of(TRY_MEASURE(estimates, g, n, 1, replicates), replicates);
      if (!all) return;
      sizes.push_back(static_cast<double>(n));
      for (const auto& one : *all) {
        values.push_back(rounded(one.value));
        errors.push_back(rounded(one.standard_error));
      }
    }
    write_demo(2, fmt::format("intervals-{}", i),
               {{"name", std::string(name)},
                {"mean", mean},
                {"levels", levels},
                {"z", z},
                {"sizes", sizes},
                {"values", values},
                {"errors", errors}});
  }
}

}  // namespace
}  // namespace mc::measurements
