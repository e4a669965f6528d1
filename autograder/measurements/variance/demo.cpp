// Lab 1 in the demo: each way to a variance as the offset of the data grows.

#include <fmt/format.h>

#include "checks/support/catch.hpp"
#include "measurements/support/demo.hpp"
#include "measurements/variance/ways.hpp"

namespace mc::measurements {
namespace {

TEST_CASE("demo", "[.demo]") {
  begin_demo();
  std::vector<double> offsets;
  for (double power = 1; power < 1e16; power *= 10) {
    offsets.insert(offsets.end(), {power, 3 * power});
  }
  Rng rng(1);
  for (const auto& [key, name, base] :
       {std::tuple{1, "1,000 values in [0, 1)", uniform_values(rng, 1000, 0, 1)},
        {2, "4, 7, 13, 16", Values{4, 7, 13, 16}}}) {
    Values all, exact;
    for (const double offset : offsets) {
      for (const double x : base) all.push_back(offset + x);
      const std::span data(all);
      exact.push_back(exact_moments(data.last(base.size())).variance);
    }
    for (const Method& way : ways) {
      const auto found = lists_of(TRY_MEASURE(variances, task_of(way), all, base.size()),
                                  offsets.size(), any_number);
      if (!found) continue;
      write_demo(1, fmt::format("{}-{}", key, way.task),
                 {{"name", way.name},
                  {"data", std::string(name)},
                  {"offsets", offsets},
                  {"values", *found},
                  {"exact", exact}});
    }
  }
}

}  // namespace
}  // namespace mc::measurements
