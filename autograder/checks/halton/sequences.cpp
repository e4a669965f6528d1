// 5.3 and 5.4: primes, Halton and Hammersley points.

#include <array>

#include "5-halton/experiments.hpp"
#include "checks/halton/expect_axes.hpp"
#include "checks/support/catch.hpp"
#include "checks/support/measure.hpp"

namespace mc::checks {
namespace {

const char* prime_hint(unsigned got, unsigned due) {
  if (got == 1) return "1 is no prime";
  for (unsigned divisor = 2; divisor * divisor <= got; ++divisor) {
    if (got % divisor == 0) return "a prime has no divisor but 1 and itself";
  }
  return got > due ? "a prime was left out" : "each prime comes once, in order";
}

CHECK_CASE("5.3 the first primes", "[5.3][points:2]") {
  Rng rng = check_rng();
  const auto exact = sieved_primes(20000);
  for (const std::uint64_t count : {std::uint64_t{10}, 100 + rng() % 1900, std::uint64_t{1}}) {
    const auto measured = MEASURE(primes, count);
    const auto& got = measured.exactly(count);
    for (std::size_t i = 0; i < count; ++i) {
      expect_that(got[i] == exact[i], fmt::format("{}[{}] = {}", measured.call, i, got[i]),
                  fmt::format("{}", exact[i]), "the primes in order: 2, 3, 5, 7, 11, …",
                  prime_hint(got[i], exact[i]));
    }
  }
}

CHECK_CASE("5.3 Halton points have one prime an axis", "[5.3][points:3][needs:5.2][main]") {
  Rng rng = check_rng();
  const auto primes = sieved_primes(400);
  for (const std::uint64_t dims : {2u, 3u, 12u, 60u, 1u}) {
    for (const std::uint64_t first : {std::uint64_t{0}, 1 + rng() % 1000, rng() >> 8}) {
      const std::uint64_t n = 30 + rng() % (dims < 20 ? 300 : 20);
      const auto measured = MEASURE(halton, n, dims, first);
      expect_axes(measured.call, measured.exactly(n * dims, any_number),
                  std::span(primes).first(dims), n, first);
    }
  }
}

/// In which of `cells` equal parts x lies, where x is within 1e-12 of a whole multiple of 1/grid,
/// cells a divisor of grid: by rounding to that multiple, since x itself may be rounded below it.
std::size_t cell_of(double x, std::size_t grid, std::size_t cells) {
  const auto multiple = static_cast<std::size_t>(std::llround(x * static_cast<double>(grid)));
  return std::min(multiple, grid - 1) / (grid / cells);
}

CHECK_CASE("5.3 each elementary interval holds one Halton point",
           "[5.3][points:1][needs:5.2][edge]") {
  Rng rng = check_rng();
  // Of 2^4 3^3 consecutive points, one lies in each of the 16 x 27 boxes. To a whole multiple of
  // 2^-30 the first coordinate is exact; the second is rounded to multiples of 3^-19.
  constexpr std::size_t nx = 16, ny = 27, n = nx * ny;
  const std::uint64_t first = n * (rng() % 1000);
  const auto measured = MEASURE(halton, n, 2, first);
  const auto& got = measured.exactly(2 * n, unit);
  const std::size_t grid_x = std::size_t{1} << 30, grid_y = 1162261467;  // 3^19
  std::vector<int> points(n);
  for (std::size_t i = 0; i < n; ++i) {
    ++points[cell_of(got[i], grid_x, nx) * ny + cell_of(got[n + i], grid_y, ny)];
  }
  for (std::size_t cell = 0; cell < n; ++cell) {
    expect_that(points[cell] == 1,
                fmt::format("{}: {} points in elementary interval ({}, {}) of 16 x 27",
                            measured.call, points[cell], cell / ny, cell % ny),
                "one point",
                "432 consecutive indices go through all last four binary digits and all last three "
                "ternary ones, in every combination",
                "bases 2 and 3, from `first` on");
  }
}

CHECK_CASE("5.3 integrals by Halton points", "[5.3][points:1][needs:5.2]") {
  const Estimates known[] = {
      {16, 13. / 64, 0.60910969847097418, 5. / 8, 2.648121968809563},
      {256, 244367. / 995328, 0.56165686217700495, 129. / 256, 2.9264176047586425},
      {4096, 1144897861. / 4586471424, 0.55805132661770473, 513. / 1024, 2.9503483693180392}};
  for (const Estimates& each : known) {
    const auto measured = MEASURE(halton, each.n, 2, 0);
    const std::span<const double> got = measured.exactly(2 * each.n, unit);
    expect_estimates(measured.call, got.first(each.n), got.subspan(each.n), each,
                     "bases 2 and 3, from index 0 on");
  }
}

CHECK_CASE("5.3 points past the last index are refused", "[5.3][points:1][edge]") {
  expect_refused(MEASURE_OUTCOME(halton, 3, 2, last_index - 1),
                 "the last index is 2^64 - 1, and the third one would be 2^64");
}

CHECK_CASE("5.4 Hammersley points", "[5.4][points:5][needs:5.2][main]") {
  Rng rng = check_rng();
  const auto primes = sieved_primes(400);
  for (const std::uint64_t dims : {2u, 3u, 9u, 60u, 1u}) {
    for (const std::uint64_t n : {std::uint64_t{256}, 2 + rng() % 1000, std::uint64_t{1}}) {
      const auto measured = MEASURE(hammersley, n, dims);
      const std::span<const double> got = measured.exactly(n * dims, any_number);
      const auto size = static_cast<double>(n);
      for (std::size_t i = 0; i < n; ++i) {
        const auto index = static_cast<double>(i);
        expect_within(fmt::format("{}: coordinate 0 of point {}", measured.call, i), got[i],
                      index / size, 2 * half_ulp, "coordinate 0 is i / N",
                      {{{(index + 1) / size, "points count from 0: i / N, not (i + 1) / N"},
                        {(index + 0.5) / size, "this is the centred variant: i / N"},
                        {inverse(2, i), "this is Halton's first axis: Hammersley's is i / N"},
                        {0, "i / N of two whole numbers is 0: make doubles of them first"},
                        {index / (size - 1), "N points, N strata: i / N, not i / (N - 1)"}},
                       "i / N in double division",
                       never_written});
      }
      expect_axes(measured.call, got.subspan(n), std::span(primes).first(dims - 1), n, 0, 1);
    }
  }
}

CHECK_CASE("5.4 integrals by Hammersley points", "[5.4][points:1][needs:5.2]") {
  const Estimates known[] = {
      {16, 257. / 1024, 0.59996611391993993, 1. / 2, 2.8591728486142411},
      {256, 66049. / 262144, 0.56120375868220918, 65. / 128, 2.9524073863838791},
      {4096, 16793601. / 67108864, 0.5580113546545965, 1035. / 2048, 2.9528479361167372}};
  for (const Estimates& each : known) {
    const auto measured = MEASURE(hammersley, each.n, 2);
    const std::span<const double> got = measured.exactly(2 * each.n, unit);
    expect_estimates(measured.call, got.first(each.n), got.subspan(each.n), each,
                     "i / N and base 2");
  }
}

}  // namespace
}  // namespace mc::checks
