// The data of lab 5's plots: the points themselves, their discrepancy, and pairs of axes that are
// bad for each other.

#include <cmath>

#include "checks/support/catch.hpp"
#include "measurements/halton/plot_points.hpp"

namespace mc::checks {
namespace {

TEST_CASE("plot the points", "[.plot]") {
  Rng rng(1);
  const Points sobol = sobol_plot_points(256, {0, 1});
  write_points("points-1.tsv", random_points(rng, 256, 2));
  write_points("points-2.tsv", stratified_points(rng, 256, 2));
  write_points("points-3.tsv", halton_points(216, 2));
  write_points("points-4.tsv", hammersley_points(256, 2));
  write_points("points-5.tsv", sobol);
  write_points("points-6.tsv", scrambled_sets_of(sobol, 1, 1)[0]);
}

Number discrepancy(const Points& points) {
  if (!points) return {};
  const auto got = TRY_MEASURE(star_discrepancy_2d, (*points)[0], (*points)[1]);
  if (!got || !(got->value >= 0 && got->value <= 1)) return {};
  return got->value;
}

/// N at powers of two, and between them where the binary digits are 10101…: there Sobol' points are
/// as uneven as they get.
TEST_CASE("plot discrepancy against N", "[.plot]") {
  Rng rng(2);
  std::vector<std::size_t> sizes;
  for (std::size_t n = 16; n <= 4096; n *= 2) sizes.insert(sizes.end(), {n * 2 / 3 + 1, n});
  const auto write = [&](int way, auto make) {
    auto file = plot_file("discrepancy-" + std::to_string(way) + ".tsv");
    for (const std::size_t n : sizes) {
      const bool power = (n & (n - 1)) == 0;
      if (way == 2 && !power) continue;  // there is no such grid
      plot_row(file, std::array{Number(static_cast<double>(n)), discrepancy(make(n))});
    }
  };
  write(1, [&](std::size_t n) { return random_points(rng, n, 2); });
  write(2, [&](std::size_t n) { return stratified_points(rng, n, 2); });
  write(3, [&](std::size_t n) { return halton_points(n, 2); });
  write(4, [&](std::size_t n) { return hammersley_points(n, 2); });
  write(5, [&](std::size_t n) { return sobol_plot_points(n, {0, 1}); });
  write(6, [&](std::size_t n) { return scrambled_sets_of(sobol_plot_points(n, {0, 1}), 1, 1)[0]; });
}

TEST_CASE("plot the bad pairs", "[.plot]") {
  constexpr std::size_t n = 64;
  const Column x = column_of(TRY_MEASURE(radical_inverses, 29, 0, n), n);
  const Column y = column_of(TRY_MEASURE(radical_inverses, 31, 0, n), n);
  write_points("pair-1.tsv", joined({x, y}));
  Points shifted;
  if (x && y) {
    std::vector<double> both = *x;
    both.insert(both.end(), y->begin(), y->end());
    shifted = columns_of(column_of(TRY_MEASURE(random_shift, both, 2, 1, 1), 2 * n), n);
  }
  write_points("pair-2.tsv", shifted);
  write_points("pair-3.tsv",
               joined({column_of(TRY_MEASURE(radical_inverses_scrambled, 29, 0, n, {1}), n),
                       column_of(TRY_MEASURE(radical_inverses_scrambled, 31, 0, n, {2}), n)}));
  const Points sobol = sobol_plot_points(1024, {14, 15});
  write_points("pair-4.tsv", sobol);
  write_points("pair-5.tsv", scrambled_sets_of(sobol, 1, 1)[0]);
}

}  // namespace
}  // namespace mc::checks
