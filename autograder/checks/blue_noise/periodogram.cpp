// 4.4

#include <complex>
#include <functional>
#include <numbers>

#include <fmt/format.h>

#include "checks/blue_noise/random_sets.hpp"
#include "checks/support/catch.hpp"
#include "checks/support/compare.hpp"
#include "checks/support/refusals.hpp"

namespace mc::checks {
namespace {

using Power = std::function<double(int, int)>;  ///< at (kx, ky)

/// Its values for k in [-kmax, kmax]^2, ky outer.
Values values_of(int kmax, const Power& power) {
  Values all;
  for (int ky = -kmax; ky <= kmax; ++ky) {
    for (int kx = -kmax; kx <= kmax; ++kx) all.push_back(power(kx, ky));
  }
  return all;
}

/// What well-known mistakes give for these points, of the exact power.
std::vector<Curve> wrong_powers(const Points& points, int kmax, const Power& exact) {
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
  const std::pair<Power, const char*> suspects[] = {
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
  std::vector<Curve> curves;
  for (const auto& [power, hint] : suspects) curves.push_back({values_of(kmax, power), hint});
  return curves;
}

/// The definition in extended precision (where the machine has it): right to some of the least bits
/// of a double even where waves cancel.
Power exact_power(const Points& points, int kmax) {
  using Real = long double;
  const auto side = static_cast<std::size_t>(2 * kmax + 1);
  std::vector<std::complex<Real>> sums(side * side), along_x(side);
  const auto wave = [&](std::size_t k, double at) {
    const Real turns = (static_cast<Real>(k) - kmax) * at;
    return std::polar(Real{1}, 2 * std::numbers::pi_v<Real> * (turns - std::round(turns)));
  };
  for (std::size_t p = 0; p < points.x.size(); ++p) {
    for (std::size_t i = 0; i < side; ++i) along_x[i] = wave(i, points.x[p]);
    for (std::size_t j = 0; j < side; ++j) {
      const auto along_y = wave(j, points.y[p]);
      for (std::size_t i = 0; i < side; ++i) sums[j * side + i] += along_x[i] * along_y;
    }
  }
  return [=, n = points.x.size()](int kx, int ky) {
    const auto at =
        static_cast<std::size_t>(ky + kmax) * side + static_cast<std::size_t>(kx + kmax);
    return static_cast<double>(std::norm(sums[at]) / static_cast<Real>(n));
  };
}

/// How wrong a periodogram may be. A wave's angle, 2 pi (kx x + ky y) <= 4 pi kmax, is rounded a
/// few times, and so a wave is wrong by less than 32 (kmax + 1) eps; n additions lose n eps of n
/// waves. So the sum of n waves is wrong by n delta, and its square over n by the two terms here.
double power_tolerance(double exact, double n, int kmax) {
  const double delta = (32.0 * (kmax + 1) + n) * eps;
  return 2 * std::sqrt(n * exact) * delta + n * delta * delta;
}

/// Compares the periodogram of some points with its exact values.
void compare_power(const Points& points, int kmax) {
  const Power exact = exact_power(points, kmax);
  const auto measured = MEASURE(periodogram, points.x, points.y, 1, kmax);
  const auto side = static_cast<std::size_t>(2 * kmax + 1);
  Comparison powers{.exact = values_of(kmax, exact),
                    .tolerance = {},
                    .because = "waves are right to 32 (kmax + 1) eps, sums to N eps",
                    .otherwise =
                        "sum exp(-2 pi i (kx x + ky y)) over the points, in double; its squared "
                        "absolute value over N",
                    .name = [&](std::size_t i) {
                      return fmt::format("{}: power at k = ({}, {})", measured.call,
                                         static_cast<int>(i % side) - kmax,
                                         static_cast<int>(i / side) - kmax);
                    }};
  for (const double power : powers.exact) {
    powers.tolerance.push_back(power_tolerance(power, static_cast<double>(points.x.size()), kmax));
  }
  const View got = measured.exactly(side * side, any_number);
  if (difference({measured.call, got}, powers)) {  // only then: they are expensive
    powers.suspects = wrong_powers(points, kmax, exact);
  }
  expect_each({measured.call, got}, powers);
}

CHECK_CASE("4.4 random points by the definition", "[4.4][main][points:8]") {
  Rng rng = check_rng();
  const std::pair<std::size_t, int> cases[] = {{17, 3},  {2, 1},    {100, 12},  {1000, 4},
                                               {3, 60},  {1025, 2}, {65537, 1}, {65, 7},
                                               {15, 16}, {1, 33},   {1, 1}};
  for (const auto& [n, kmax] : cases) compare_power(uniform_points(rng, n), kmax);
}

/// Columns x rows points, at any place: N where both waves fit, else 0.
Points grid_of(int columns, int rows, Rng& rng) {
  const double left = uniform(rng, 0, 0.1), low = uniform(rng, 0, 0.1);
  Points grid;
  for (int i = 0; i < columns * rows; ++i) {
    grid.x.push_back(left + static_cast<double>(i % columns) / columns);
    grid.y.push_back(low + static_cast<double>(i / columns) / rows);
  }
  return grid;
}

CHECK_CASE("4.4 points whose waves cancel or agree", "[4.4][points:7]") {
  Rng rng = check_rng();
  // Pairs at a distance of exactly 1/2, where all odd waves cancel; of next to nothing; and at the
  // ends of the square, with waves short enough for every digit of a coordinate to tell, or so
  // short that an angle is some hundred turns. Points in one place: N at any k.
  const double x = uniform(rng, 0, 0.5), y = uniform(rng, 0, 0.5);
  const std::pair<Points, int> cases[] = {{{{x, x + 0.5}, {y, y}}, 7},
                                          {{{x, x + 0.5}, {y + 0.5, y}}, 7},
                                          {{{x, std::nextafter(x, 1)}, {y, y}}, 5},
                                          {{{0, below_one}, {below_one, 0}}, 20},
                                          {{{x, below_one}, {y, below_one}}, 60},
                                          {{{1 - x, y}, {1 - y, x}}, 300},
                                          {grid_of(5, 3, rng), 9},
                                          {grid_of(1, 4, rng), 9},
                                          {grid_of(8, 8, rng), 9},
                                          {{Values(50, x), Values(50, y)}, 5},
                                          {{{0}, {0}}, 4}};
  for (const auto& [points, kmax] : cases) compare_power(points, kmax);
}

std::vector<InvalidCall> wrong_sizes() {
  const std::string pairs = "each point has two coordinates, and there is at least one point";
  std::vector<InvalidCall> calls{
      {MEASURE_OUTCOME(periodogram_into, 3, 4, 1, 9), "x|y|size", pairs},
      {MEASURE_OUTCOME(periodogram_into, 4, 3, 1, 9), "x|y|size", pairs},
      {MEASURE_OUTCOME(periodogram_into, 3, 0, 1, 9), "x|y|size", pairs},
      {MEASURE_OUTCOME(periodogram_into, 0, 3, 1, 9), "x|y|size", pairs},
      {MEASURE_OUTCOME(periodogram_into, 0, 0, 1, 9), "x|y|size|point", pairs}};
  for (const auto& [kmax, size] :
       {std::pair{0, 1u}, {-1, 1u}, {-3, 1u}, {-2, 9u}, {std::numeric_limits<int>::min(), 1u}}) {
    calls.push_back(
        {MEASURE_OUTCOME(periodogram_into, 3, 3, kmax, size), "kmax", "kmax is 1 at least"});
  }
  for (const std::uint64_t size : {0u, 9u, 24u, 26u, 49u}) {
    calls.push_back({MEASURE_OUTCOME(periodogram_into, 3, 3, 2, size), "power",
                     "there are (2 kmax + 1)^2 = 25 values of k"});
  }
  calls.push_back({MEASURE_OUTCOME(periodogram_into, 3, 3, 1 << 15, 131073), "power",
                   "there are 65537^2 = 2^32 + 131073 values of k: their number overflows 32 bits",
                   "(2 kmax + 1)^2 overflows an int: compute it in std::size_t"});
  return calls;
}

REFUSAL_CASES("4.4", "misuse of periodogram is refused", "2", "a refusal names the argument", "1",
              wrong_sizes())

}  // namespace
}  // namespace mc::checks
