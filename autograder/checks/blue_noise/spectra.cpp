// 4.4, 4.5: periodograms and their means over rings.

#include <complex>

#include "checks/blue_noise/random_sets.hpp"

namespace mc::checks {
namespace {

/// Compares the periodogram of some points with its exact values.
void compare_power(const Points& points, int kmax);
void compare_rings(const std::vector<int>& sizes, Rng& rng);
/// A shifted grid of columns x rows points: the power is N if both waves fit, else 0.
Points grid_of(int columns, int rows, Rng& rng);

CHECK_CASE("4.4 random points by the definition", "[4.4][main][points:6]") {
  for (const auto& [n, kmax] :
       {std::pair<std::size_t, int>{17, 3}, {100, 12}, {1000, 4}, {65, 7}}) {
    compare_power(uniform_points(rng, n), kmax);
  }
}

CHECK_CASE("4.4 any number of points and frequencies", "[4.4][edge][points:2]") {
  const std::pair<std::size_t, int> cases[] = {{3, 60}, {1025, 2}, {65537, 1}, {15, 16}, {2, 1},
                                               {3, 1},  {1, 33},   {1, 2},     {1, 1}};
  for (const auto& [n, kmax] : cases) compare_power(uniform_points(rng, n), kmax);
}

CHECK_CASE("4.4 points whose waves cancel or agree", "[4.4][points:7]") {
  // Pairs at a distance of exactly 1/2, whose odd waves cancel, or of one ulp; pairs at the ends of
  // the square, with waves so short that every digit of a coordinate matters, or that an angle is
  // hundreds of turns; equal points, whose power is N for every k.
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

CHECK_CASE("4.5 the mean over each ring", "[4.5][main][points:4]") {
  compare_rings({5, 24, 10, 20 + static_cast<int>(rng() % 20)}, rng);
}

CHECK_CASE("4.5 any number of rings", "[4.5][edge][points:1]") {
  compare_rings({63, 129, 300, 3, 2, 1}, rng);
}

Points grid_of(int columns, int rows, Rng& rng) {
  const double left = uniform(rng, 0, 0.1), low = uniform(rng, 0, 0.1);
  Points grid;
  for (int i = 0; i < columns * rows; ++i) {
    grid.x.push_back(left + static_cast<double>(i % columns) / columns);
    grid.y.push_back(low + static_cast<double>(i / columns) / rows);
  }
  return grid;
}

using Power = std::function<double(int, int)>;  ///< at (kx, ky)

/// The values for k in [-kmax, kmax]^2, ky outer.
Values values_of(int kmax, const Power& power) {
  Values all;
  for (int ky = -kmax; ky <= kmax; ++ky) {
    for (int kx = -kmax; kx <= kmax; ++kx) all.push_back(power(kx, ky));
  }
  return all;
}

std::vector<Curve> wrong_powers(const Points& points, int kmax, const Power& exact) {
  const auto n = static_cast<double>(points.x.size());
  const auto sums = [&](double half_turns, bool sines = true) {
    return [=, &points](int kx, int ky) {
      double real = 0, imaginary = 0;
      for (std::size_t p = 0; p < points.x.size(); ++p) {
        const double angle = half_turns * std::numbers::pi * (kx * points.x[p] + ky * points.y[p]);
        real += std::cos(angle);
        imaginary += sines ? std::sin(angle) : 0;
      }
      return (real * real + imaginary * imaginary) / n;
    };
  };
  const std::pair<Power, Likely> suspects[] = {
      {[&](int kx, int ky) { return exact(kx, std::abs(ky)); },
       "P(kx, ky) = P(-kx, -ky), but it is not P(kx, -ky)"_likely},
      {[&](int kx, int ky) { return exact(std::abs(kx), ky); },
       "P(kx, ky) = P(-kx, -ky), but it is not P(kx, -ky)"_likely},
      {[&](int kx, int ky) { return exact(kx, ky) * n; },
       "this is |sum|^2: divide by the number of points"_likely},
      {[&](int kx, int ky) { return exact(kx, ky) / n; }, "this is divided by N twice"_likely},
      {[&](int kx, int ky) { return std::sqrt(exact(kx, ky) * n); },
       "this is |sum|: the task asks for its square over N"_likely},
      {[&](int kx, int ky) { return std::sqrt(exact(kx, ky) / n); },
       "this is |sum| / N: square |sum| before dividing by N"_likely},
      {[&](int kx, int ky) { return exact(ky, kx); },
       "kx and ky are swapped: ky is the outer index"_likely},
      {[&](int kx, int ky) { return kx == 0 && ky == 0 ? 0 : exact(kx, ky); },
       "the power at k = 0 belongs to the result: N"_likely},
      {sums(2, false), "this is the sum of cosines only: the sum of sines is missing"_likely},
      {sums(1), "the angle is 2 pi k x, not pi k x"_likely}};
  std::vector<Curve> curves;
  for (const auto& [power, hint] : suspects) curves.push_back({values_of(kmax, power), hint});
  return curves;
}

/// The definition in extended precision (if available): accurate even if waves cancel.
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

/// The tolerance of a periodogram. A wave's angle, 2 pi (kx x + ky y) <= 4 pi kmax, is rounded a
/// few times, so a wave has an error below 32 (kmax + 1) eps; n additions lose n eps. So the sum of
/// n waves has an error of n delta, and its square over n that of the two terms here.
double power_tolerance(double exact, double n, int kmax) {
  const double delta = (32.0 * (kmax + 1) + n) * eps;
  return 2 * std::sqrt(n * exact) * delta + n * delta * delta;
}

void compare_power(const Points& points, int kmax) {
  const Power exact = exact_power(points, kmax);
  const auto measured = MEASURE(periodogram, points.x, points.y, 1, kmax);
  const auto side = static_cast<std::size_t>(2 * kmax + 1);
  Comparison powers{
      .exact = values_of(kmax, exact),
      .tolerance = {},
      .because = "waves are accurate to 32 (kmax + 1) eps, sums to N eps",
      .rule = "sum exp(-2 pi i (kx x + ky y)) in double, and divide its squared size by N",
      .name =
          [&](std::size_t i) {
            return fmt::format("{}: power at k = ({}, {})", measured.call,
                               static_cast<int>(i % side) - kmax,
                               static_cast<int>(i / side) - kmax);
          },
      .is_tame = true};
  for (const double power : powers.exact) {
    powers.tolerance.push_back(power_tolerance(power, static_cast<double>(points.x.size()), kmax));
  }
  const View got = measured.exactly(side * side, any_number);
  if (difference({measured.call, got}, powers)) {  // expensive
    powers.suspects = wrong_powers(points, kmax, exact);
  }
  expect_each({measured.call, got}, powers);
}

/// The ring of (kx, ky), whose length is k; no ring beyond the last.
using RingOf = std::function<double(int kx, int ky, double k)>;

Rings sums_over(const Values& power, int kmax, const RingOf& ring_of) {
  return rings_of(Spectrum{kmax, power}, static_cast<std::size_t>(kmax) + 1,
                  [&](int kx, int ky) { return ring_of(kx, ky, std::hypot(kx, ky)); });
}

/// The means; NaN for ring 0.
Values means_over(const Values& power, int kmax, const RingOf& ring_of) {
  auto [sum, count] = sums_over(power, kmax, ring_of);
  for (std::size_t r = 0; r < sum.size(); ++r) sum[r] = r == 0 ? nan : sum[r] / count[r];
  return sum;
}

std::vector<Curve> wrong_means(const Values& power, int kmax, const RingOf& nearest) {
  Values sum = sums_over(power, kmax, nearest).sum, by_length = sum;
  for (std::size_t r = 1; r < sum.size(); ++r) {
    by_length[r] /= 2 * std::numbers::pi * static_cast<double>(r);
  }
  sum[0] = by_length[0] = nan;
  Values with_center = means_over(power, kmax, nearest), with_zero = with_center;
  with_center[0] = power[power.size() / 2];
  with_zero[0] = 0;
  const auto means = [&](const RingOf& ring_of) { return means_over(power, kmax, ring_of); };
  return {{means([](int, int, double k) { return std::floor(k); }),
           "|k| is truncated: round it to the nearest ring"_likely},
          {sum, "this is the sum over the ring: the task asks for its mean"_likely},
          {by_length,
           "this is the sum over 2 pi r: divide by the number of (kx, ky) in the ring"_likely},
          {means([=](int, int ky, double k) { return ky >= 0 ? std::round(k) : infinity; }),
           "this is the mean over ky >= 0 only"_likely},
          {means([=](int, int, double k) { return std::min<double>(std::round(k), kmax); }),
           "the corners are in the last ring: they belong to no ring"_likely},
          {with_center,
           "ring 0 has the power at k = 0: it must be NaN, because it has no meaning"_likely},
          {with_zero, "ring 0 is 0: it must be NaN, because it has no meaning"_likely}};
}

void compare_rings(const std::vector<int>& sizes, Rng& rng) {
  for (const int kmax : sizes) {
    const auto side = static_cast<std::size_t>(2 * kmax + 1);
    const Values power = uniform_values(rng, side * side, 0, 3);
    // k + 1/2 is not the root of an integer, so nothing is halfway.
    const RingOf nearest = [](int, int, double k) { return std::round(k); };
    const Values count = sums_over(power, kmax, nearest).count;
    Comparison rings{
        .exact = means_over(power, kmax, nearest),
        .tolerance = {},
        .because = "n positive terms lose at most n eps; the power at k = 0 is N, so ring 0 is NaN",
        .rule = "the mean over all (kx, ky) whose length rounds to r"};
    for (std::size_t r = 0; r < count.size(); ++r) {
      rings.tolerance.push_back((count[r] + 2) * eps * rings.exact[r]);
    }
    const auto measured = MEASURE(radial_power, power, kmax);
    const MeasuredValues got{measured.call, measured.exactly(count.size(), any_number)};
    if (difference(got, rings)) rings.suspects = wrong_means(power, kmax, nearest);
    expect_each(got, rings);
  }
}

}  // namespace
}  // namespace mc::checks
