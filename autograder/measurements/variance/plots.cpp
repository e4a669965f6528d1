// The data of lab 1's plots and demo: digits kept and time taken, for each way to a variance, as
// the offset of the data grows.

#include <cmath>

#include "checks/support/catch.hpp"
#include "measurements/support/plot_data.hpp"
#include "measurements/variance/methods.hpp"

namespace mc::measurements {
namespace {

TEST_CASE("plot digits kept against the offset", "[.plot]") {
  constexpr std::size_t sets = 5, n = 1000;
  Rng rng(1);  // the same data for every submission, so that their lines can be compared
  const Values offsets = powers(1, std::sqrt(10), 1.1e15);
  Values all;
  for (const double offset : offsets) {
    append(all, uniform_values(rng, sets * n, offset, offset + 1));
  }
  std::vector<Values> kept;
  for (const Method& way : methods) kept.push_back(digits_kept(way, all, n));
  plot_table("digits.tsv", {"offset", offsets}, methods.keys(), [&](double x, std::size_t c) {
    if (kept[c].empty()) return missing;
    const auto at = std::find(offsets.begin(), offsets.end(), x) - offsets.begin();
    return sum_of(std::span(kept[c]).subspan(static_cast<std::size_t>(at) * sets, sets)) / sets;
  });
}

/// 4,096 values near 1e9, 32 KB: they stay in the first-level cache.
TEST_CASE("plot time against digits", "[.plot][time]") {
  Rng rng(2);
  const auto x = uniform_values(rng, 4096, 1e9, 1e9 + 1);
  for (const Method& way : methods) {
    const Values kept = digits_kept(way, x, x.size());
    plot_speed(way.key, x.size(), way.rounds_of(x.size(), 1),
               kept.empty() ? missing : std::pow(10, -kept[0]));
  }
}

TEST_CASE("demo", "[.demo]") {
  begin_demo();
  Values offsets;
  for (const double power : powers(1, 10, 1e15)) append(offsets, Values{power, 3 * power});
  Rng rng(1);
  for (const auto& [key, name, base] :
       {std::tuple{1, "1,000 values in [0, 1)", uniform_values(rng, 1000, 0, 1)},
        {2, "4, 7, 13, 16", Values{4, 7, 13, 16}}}) {
    Values all, exact;
    for (const double offset : offsets) {
      for (const double x : base) all.push_back(offset + x);
      exact.push_back(exact_variance(all, all.size() - base.size(), base.size()));
    }
    for (const Method& way : methods) {
      const Values found = variances_by(way, all, base.size());
      if (found.empty()) continue;
      write_demo(1, fmt::format("{}-{}", key, way.task),
                 {{"name", way.name},
                  {"data", std::string(name)},
                  {"offsets", offsets},
                  {"values", found},
                  {"exact", exact}});
    }
  }
}

}  // namespace
}  // namespace mc::measurements
