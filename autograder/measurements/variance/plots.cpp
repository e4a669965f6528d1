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
  const std::vector<double> offsets = powers(1, std::sqrt(10), 1.1e15);
  Values all;
  for (std::size_t i = 0; i < sets * offsets.size(); ++i) {
    // offset + values uniform in [0,1), rounded as doubles are
    const double offset = offsets[i / sets];
    const auto x = uniform_values(rng, n, offset, offset + 1);
    all.insert(all.end(), x.begin(), x.end());
  }
  std::vector<std::vector<double>> kept;
  for (const Method& way : ways) kept.push_back(digits_kept(way, all, n));
  plot_table("digits.tsv", {"offset", offsets}, keys_of(ways),
             [&](double x, std::size_t c) -> Number {
               if (kept[c].empty()) return {};
               const auto from = std::find(offsets.begin(), offsets.end(), x) - offsets.begin();
               const auto first = kept[c].begin() + from * static_cast<std::ptrdiff_t>(sets);
               return std::accumulate(first, first + sets, 0.0) / sets;
             });
}

/// 4,096 values near 1e9, 32 KB: they stay in the first-level cache. A file for each way: what is
/// measured is drawn, whatever becomes of the others.
TEST_CASE("plot time against digits", "[.plot]") {
  Rng rng(2);
  const auto x = uniform_values(rng, 4096, 1e9, 1e9 + 1);
  for (const Method& way : ways) {
    auto file = plot_file("speed-" + way.key + ".tsv", {"ns", "error"});
    const auto kept = digits_kept(way, x, x.size());
    plot_row(file, kept.empty() ? Row(2) : Row{nanoseconds_of(way, x), std::pow(10, -kept[0])});
  }
}

}  // namespace
}  // namespace mc::measurements
