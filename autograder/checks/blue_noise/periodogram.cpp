// 4.4

#include <functional>

#include <fmt/format.h>

#include "checks/blue_noise/power.hpp"
#include "checks/support/catch.hpp"
#include "checks/support/expect.hpp"
#include "checks/support/statistics.hpp"

namespace mc::checks {
namespace {

using Power = std::function<double(int, int)>;  ///< at (kx, ky)

bool agree(View got, std::size_t n, int kmax, const Power& power) {
  std::size_t i = 0;
  for (int ky = -kmax; ky <= kmax; ++ky) {
    for (int kx = -kmax; kx <= kmax; ++kx, ++i) {
      const double here = power(kx, ky);
      const auto size = static_cast<double>(n);
      // Nine digits: suspects are computed in another order, and have their own scale.
      const double room = power_tolerance(std::abs(here), size, kmax) + 1e-9 * std::abs(here);
      if (!(std::abs(got[i] - here) <= room)) return false;
    }
  }
  return true;
}

/// The mistake that explains the whole periodogram, if one does.
std::string power_hint(View got, const Points& points, int kmax, const Power& exact) {
  const auto n = static_cast<double>(points.x.size());
  const auto sums = [&](double wave, bool cosines, bool sines) {  // of waves `wave` times as long
    return [=, &points](int kx, int ky) {
      double real = 0, imaginary = 0;
      for (std::size_t p = 0; p < points.x.size(); ++p) {
        const double angle = 2 * std::numbers::pi / wave * (kx * points.x[p] + ky * points.y[p]);
        real += std::cos(angle);
        imaginary += std::sin(angle);
      }
      return ((cosines ? real * real : 0) + (sines ? imaginary * imaginary : 0)) / n;
    };
  };
  const std::pair<Power, std::string> suspects[] = {
      {[&](int kx, int ky) { return exact(kx, ky) * n; },
       "this is |sum|^2: divide by the number of points"},
      {[&](int kx, int ky) { return exact(kx, ky) / n; }, "this is divided by N twice"},
      {[&](int kx, int ky) { return std::sqrt(exact(kx, ky) * n); },
       "this is |sum|: its square over N is asked for"},
      {[&](int kx, int ky) { return std::sqrt(exact(kx, ky) / n); },
       "this is |sum| / N: the sum is squared, then divided by N"},
      {[&](int kx, int ky) { return std::sqrt(exact(kx, ky)); },
       "this is an amplitude: power is its square"},
      {[&](int kx, int ky) { return exact(ky, kx); },
       "kx and ky are exchanged: ky is the outer index"},
      {[&](int kx, int ky) { return kx == 0 && ky == 0 ? 0 : exact(kx, ky); },
       "k = 0 is power like any other here: N"},
      {sums(1, true, false), "this is the sum of cosines alone: the sum of sines is missing"},
      {sums(1, false, true), "this is the sum of sines alone: the sum of cosines is missing"},
      {sums(2 * std::numbers::pi, true, true), "2 pi is missing in the angle"},
      {sums(2, true, true), "the angle is 2 pi k x, not pi k x"}};
  const std::string* found = nullptr;
  bool is_only_one = true;  // points in one place, say, leave more than one way to the same power
  for (const auto& [power, hint] : suspects) {
    if (!agree(got, points.x.size(), kmax, power)) continue;
    is_only_one = found == nullptr;
    found = &hint;
  }
  if (found != nullptr && is_only_one) return *found;
  return "sum exp(-2 pi i (kx x + ky y)) over the points, in double; its squared absolute value "
         "over N";
}

void expect_power(const std::string& call, View got, const Points& points, int kmax,
                  const Power& exact, const std::string& because) {
  const auto size = static_cast<double>(points.x.size());
  std::size_t i = 0;
  for (int ky = -kmax; ky <= kmax; ++ky) {
    for (int kx = -kmax; kx <= kmax; ++kx, ++i) {
      const double power = exact(kx, ky), tolerance = power_tolerance(power, size, kmax);
      if (std::abs(got[i] - power) <= tolerance) continue;  // its story is not told 14,641 times
      expect_within(fmt::format("{}: power at k = ({}, {})", call, kx, ky), got[i], power,
                    tolerance, because, {{}, power_hint(got, points, kmax, exact)});
    }
  }
  pass();
}

std::size_t values_of(int kmax) {
  return static_cast<std::size_t>((2 * kmax + 1) * (2 * kmax + 1));
}

/// Judges one periodogram.
void expect_periodogram(const std::string& name, const Points& points, int kmax, const Power& exact,
                        const std::string& because) {
  const auto measured = MEASURE(periodogram, points.x, points.y, 1, kmax);
  expect_power(measured.call + name, measured.exactly(values_of(kmax), finite), points, kmax, exact,
               because);
}

const char* const by_definition = "waves are right to 32 (kmax + 1) eps, sums to N eps";

}  // namespace

CHECK_CASE("4.4 random points by the definition", "[4.4][main][points:7]") {
  Rng rng = check_rng();
  const std::pair<std::size_t, int> cases[] = {{17, 3}, {2, 1}, {100, 12}, {1000, 4}, {3, 60}};
  for (const auto& [n, kmax] : cases) {
    const Points points = uniform_points(rng, n);
    const Spectrum exact = exact_spectrum(points.x, points.y, kmax);
    expect_periodogram(
        "", points, kmax, [&](int kx, int ky) { return exact.at(kx, ky); }, by_definition);
  }
}

CHECK_CASE("4.4 spectra that are known exactly", "[4.4][points:5]") {
  Rng rng = check_rng();
  const Points two = uniform_points(rng, 2);
  // Pairs anywhere; at a distance of exactly 1/2, where all odd waves cancel; of next to nothing;
  // and at the ends of the square, with waves short enough for every digit of a coordinate to tell,
  // or so short that an angle is some hundred turns.
  const double x = uniform(rng, 0, 0.5), y = uniform(rng, 0, 0.5);
  const std::pair<Points, int> pairs[] = {{two, 6},
                                          {{{x, x + 0.5}, {y, y}}, 7},
                                          {{{x, x + 0.5}, {y + 0.5, y}}, 7},
                                          {{{x, std::nextafter(x, 1)}, {y, y}}, 5},
                                          {{{0, below_one}, {below_one, 0}}, 20},
                                          {{{x, below_one}, {y, below_one}}, 60},
                                          {{{1 - x, y}, {1 - y, x}}, 300}};
  for (const auto& [pair, kmax] : pairs) {
    const long double dx = static_cast<long double>(pair.x[1]) - pair.x[0];
    const long double dy = static_cast<long double>(pair.y[1]) - pair.y[0];
    expect_periodogram(
        "", pair, kmax, [=](int kx, int ky) { return power_of_two(dx, dy, kx, ky); },
        "two points have |1 + exp(2 pi i k.d)|^2 / 2 = 2 cos(pi k.d)^2");
  }
  // A grid with an uneven number of columns and rows, at any place: N where both waves fit.
  for (const auto& [columns, rows] : {std::pair{5, 3}, std::pair{1, 4}, std::pair{8, 8}}) {
    const double left = uniform(rng, 0, 0.1), low = uniform(rng, 0, 0.1);
    Points grid;
    for (int j = 0; j < rows; ++j) {
      for (int i = 0; i < columns; ++i) {
        grid.x.push_back(left + static_cast<double>(i) / columns);
        grid.y.push_back(low + static_cast<double>(j) / rows);
      }
    }
    expect_periodogram(
        fmt::format(", a grid of {} x {}", columns, rows), grid, 9,
        [&, columns = columns, rows = rows](int kx, int ky) {
          return kx % columns == 0 && ky % rows == 0 ? static_cast<double>(grid.x.size()) : 0;
        },
        "a grid is in phase where its columns divide kx and its rows ky, and cancels elsewhere");
  }
  for (const std::size_t n : {50u, 3u, 2u}) {
    const Points one = uniform_points(rng, 1);
    const Points same{Values(n, one.x[0]), Values(n, one.y[0])};
    expect_periodogram(
        "", same, 5, [&](int, int) { return static_cast<double>(n); },
        "N points in one place are in phase at any k: N^2 / N");
  }
  for (const int kmax : {7, 20, 2, 1}) {
    expect_periodogram(
        "", uniform_points(rng, 1), kmax, [](int, int) { return 1; },
        "one wave has the absolute value 1");
  }
}

CHECK_CASE("4.4 jittered points have the power they must", "[4.4][points:3]") {
  Rng rng = check_rng();
  constexpr int side = 8, kmax = 8;
  constexpr std::size_t n = side * side, sets = 200;  // half the power shows at one of four k
  Points jittered;
  for (std::size_t i = 0; i < n * sets; ++i) {
    jittered.x.push_back((static_cast<double>(i % side) + uniform(rng)) / side);
    jittered.y.push_back((static_cast<double>(i / side % side) + uniform(rng)) / side);
  }
  const auto measured = MEASURE(periodogram, jittered.x, jittered.y, sets, kmax);
  const Values& got = measured.exactly(sets * values_of(kmax), non_negative);
  // Sums of 64 independent terms are nearly Gaussian, so the power is nearly exponential: amplitudes
  // sqrt(P) have mean square E{P} and kurtosis E{P^2} / E{P}^2 = 2, less something below
  // 1/64 / E{P}^2, which makes the test a little stricter on itself.
  for (const auto& [kx, ky] :
       {std::pair{3, 2}, std::pair{1, 5}, std::pair{-6, 4}, std::pair{0, 8}}) {
    Values amplitudes;
    for (std::size_t set = 0; set < sets; ++set) {
      const auto at = (2 * kmax + 1) * (2 * kmax + 1) * set +
                      static_cast<std::size_t>((ky + kmax) * (2 * kmax + 1) + kx + kmax);
      amplitudes.push_back(std::sqrt(got[at]));
    }
    expect_variance({fmt::format("{}: amplitudes at k = ({}, {}) of {} jittered sets",
                                 measured.call, kx, ky, sets),
                     amplitudes, n},
                    0, jittered_power(kx, ky, side), 2,
                    {"jittered points have 1 - sinc(kx/n)^2 sinc(ky/n)^2 on average", alpha},
                    {{}, "is this the power at this very k, |sum|^2 / N?"});
  }
}

CHECK_CASE("4.4 misuse of periodogram is refused", "[4.4][edge][points:2]") {
  Rng rng = check_rng();
  const std::uint64_t n = 2 + rng() % 9;
  const std::string because = "each point has two coordinates, and there is at least one point";
  expect_refused(MEASURE_OUTCOME(periodogram_into, n, n + 1, 1, 9), because);
  expect_refused(MEASURE_OUTCOME(periodogram_into, n, n - 1, 1, 9), because);
  expect_refused(MEASURE_OUTCOME(periodogram_into, 0, 0, 1, 9), because);
  for (const int kmax : {0, -1, -3}) {
    expect_refused(MEASURE_OUTCOME(periodogram_into, n, n, kmax, 1), "kmax is 1 at least");
  }
  for (const std::uint64_t size : {0u, 9u, 24u, 26u}) {
    expect_refused(MEASURE_OUTCOME(periodogram_into, n, n, 2, size),
                   "there are (2 kmax + 1)^2 = 25 values of k");
  }
  expect_refused(MEASURE_OUTCOME(periodogram_into, n, n, 1 << 15, 131073),
                 "there are 65537^2 = 2^32 + 131073 values of k: their number overflows 32 bits");
}

CHECK_CASE("4.4 a refusal names the argument", "[4.4][edge][points:1]") {
  expect_invalid_argument(MEASURE_OUTCOME(periodogram_into, 3, 4, 1, 9), "x|y",
                          "the sizes of x and y differ");
  expect_invalid_argument(MEASURE_OUTCOME(periodogram_into, 3, 3, 0, 1), "kmax",
                          "kmax is 1 at least");
  expect_invalid_argument(MEASURE_OUTCOME(periodogram_into, 3, 3, 2, 24), "power",
                          "there are (2 kmax + 1)^2 = 25 values of k");
}

}  // namespace mc::checks
