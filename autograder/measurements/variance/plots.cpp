// The data of lab 1's plots: digits kept and time taken, for each way to a variance.

#include <cmath>

#include "checks/support/catch.hpp"
#include "measurements/support/plot_data.hpp"
#include "measurements/variance/ways.hpp"

namespace mc::measurements {
namespace {

TEST_CASE("plot names", "[.plot]") {
  plot_names(ways);
}

TEST_CASE("plot digits kept against the offset", "[.plot]") {
  constexpr std::size_t sets = 5, n = 1000;
  Rng rng(1);  // the same data for every submission, so that their lines can be compared
  Values all;
  std::vector<Row> rows;
  for (double exponent = 0; exponent <= 15; exponent += 0.5) {
    const double offset = std::pow(10, exponent);
    rows.push_back({offset});
    for (std::size_t set = 0; set < sets; ++set) {
      // offset + values uniform in [0,1), rounded as doubles are
      const auto x = uniform_values(rng, n, offset, offset + 1);
      all.insert(all.end(), x.begin(), x.end());
    }
  }
  Names columns{"offset"};
  for (const Method& way : ways) {
    columns.push_back(way.key);
    const auto kept = digits_kept(way, all, n);  // a column is there or is not
    for (std::size_t i = 0; i < rows.size(); ++i) {
      rows[i].emplace_back();
      for (std::size_t set = i * sets; set < (i + 1) * sets && !kept.empty(); ++set) {
        rows[i].back() = rows[i].back().value_or(0) + kept[set] / sets;
      }
    }
  }
  auto file = plot_file("digits.tsv", columns);
  for (const Row& row : rows) plot_row(file, row);
}

/// 4,096 values near 1e9, 32 KB: they stay in the first-level cache. A case and a file for each
/// way: what is measured is drawn, whatever becomes of the others.
void plot_speed_of(std::size_t i) {
  Rng rng(2);
  const auto x = uniform_values(rng, 4096, 1e9, 1e9 + 1);
  auto file = plot_file("speed-" + ways[i].key + ".tsv", {"ns", "error"});
  const auto kept = digits_kept(ways[i], x, x.size());
  if (kept.empty()) return plot_row(file, Row(2));
  plot_row(file, Row{nanoseconds_of(ways[i], x), std::pow(10, -kept[0])});
}

TEST_CASE("plot time against digits of the textbook formula", "[.plot]") {
  plot_speed_of(0);
}
TEST_CASE("plot time against digits of two passes", "[.plot]") {
  plot_speed_of(1);
}
TEST_CASE("plot time against digits of Welford's update", "[.plot]") {
  plot_speed_of(2);
}
TEST_CASE("plot time against digits of merged parts", "[.plot]") {
  plot_speed_of(3);
}
TEST_CASE("plot time against digits of the fast moments", "[.plot]") {
  plot_speed_of(4);
}

}  // namespace
}  // namespace mc::measurements
