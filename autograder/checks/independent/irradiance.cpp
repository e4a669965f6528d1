// 2.7: the irradiance from a light by two estimators.

#include "checks/independent/functions.hpp"
#include "checks/independent/lights.hpp"

namespace mc::checks {
namespace {

// The area of the light ---------------------------------------------------------------------------

Measured<Estimates> by_area(const RectLight& light, std::uint64_t n, std::uint64_t seed,
                            std::uint64_t replicates) {
  return MEASURE(irradiance_area, light, n, seed, replicates);
}

void judge_formula(Rng& rng);
Values square_distances(const Measured<Estimates>& ones, const RectLight& light, std::size_t count);
/// The places of n points on a light that is a line.
Construction places_on_a_line(bool along_x, std::uint64_t n);

CHECK_CASE("2.7 irradiance from points on the light", "[2.7][points:6][needs:2.1][main]") {
  judge_formula(rng);
  for (const bool along_x : {true, false}) {
    expect_random_calls(places_on_a_line(along_x, 1), 5000, rng);
    expect_random_samples(places_on_a_line(along_x, 5000), 1, 40, rng);
  }
  const std::uint64_t replicates = 400;
  for (const auto& [placed, n] :
       {std::pair{above(rng), 64u}, {aside(rng), 64u}, {grazing(rng), 64u}, {above(rng), 1500u}}) {
    const RectLight& light = placed.light;
    const auto got = by_area(light, n, rng(), replicates);
    const Values values = values_of(got.call, got.exactly(replicates, any_number));
    const Known known = mean_of(of_area(light), n);
    const Replicates sample{got.call, values, static_cast<double>(n)};
    expect_mean(sample, known.exact, known.variance,
                {"the area estimate of a light " + placed.where + " has the mean E", alpha},
                {{}, "use uniform points, with new and different random numbers for x and y"});
    expect_variance(
        sample, known.exact, known.variance, known.kurtosis,
        {"the area estimate of a light " + placed.where + " has its exact variance", alpha},
        {{}, "use n independent uniform points, with different random numbers for x and y"});
  }
  // An estimate from one sample shows the distance of its point.
  const RectLight light = aside(rng).light;
  const auto ones = by_area(light, 1, rng(), 20000);
  Uniforms shares{ones.call + ", fractions of the light closer than each point", 1, {}, 20};
  for (const double square : square_distances(ones, light, 20000)) {
    shares.values.push_back(std::clamp(share_within(light, square), 0.0, 1 - 0x1p-53));
  }
  expect_independent_uniforms(
      shares, {.words = "points are uniform on the light",
               .rule = "x between x0 and x1, y between y0 and y1, with separate random numbers",
               .expected = "independent uniform points on the light"});
}

// The hemisphere ----------------------------------------------------------------------------------

Measured<Estimates> by_hemisphere(const RectLight& light, std::uint64_t n, std::uint64_t seed,
                                  std::uint64_t replicates) {
  return MEASURE(irradiance_hemisphere, light, n, seed, replicates);
}

Values directions_met(const Measured<Estimates>& measured, const RectLight& light, std::uint64_t n,
                      std::uint64_t replicates);
void judge_sky(Rng& rng);

CHECK_CASE("2.7 irradiance from directions of the hemisphere", "[2.7][points:6][needs:2.1]") {
  judge_sky(rng);
  // All quarters of the sky are equally likely. If angles were drawn as degrees and used as
  // radians, 57.3 turns, one quarter would have 1.2 % more: 9 standard deviations.
  std::vector<PlacedLight> lights{above(rng), half_sky_aside(3, 5, rng),
                                  half_sky_aside(105, 130, rng)};
  for (const unsigned quadrant : {0u, 1u, 2u, 3u}) lights.push_back(quarter_sky(quadrant, rng));
  for (const PlacedLight& placed : lights) {
    const RectLight& light = placed.light;
    const bool has_many = &placed - &lights[0] >= 2;
    const std::uint64_t n = has_many ? 1600 : 64, replicates = has_many ? 1000 : 400;
    const auto got = by_hemisphere(light, n, rng(), replicates);
    const Values met = directions_met(got, light, n, replicates);
    const double all = std::accumulate(met.begin(), met.end(), 0.0);
    const double p = irradiance(light) / (pi * light.radiance);
    expect_proportion(
        got.call, "a direction met the light", static_cast<std::uint64_t>(all), n * replicates, p,
        {"directions with density cos / pi meet a light " + placed.where +
             " with probability E / (pi L)",
         alpha},
        {{{solid_angle(light) / (2 * pi),
           "these directions are uniform on the hemisphere: steep ones must "
           "be more likely"_likely}},
         "a direction is a uniform point of the unit disk (radius sqrt(u), angle 2 pi v, from two "
         "numbers), lifted to the hemisphere; it meets the light if it is in x0 … x1 and y0 … y1 "
         "at z = height"});
    if (&placed != &lights[0]) continue;
    // The number of independent directions that meet the light is binomial.
    const auto trials = static_cast<double>(n), variance = p * (1 - p) * trials;
    expect_variance({got.call + ", directions that met the light", met, trials}, p * trials,
                    variance, 3 + (1 - 6 * p * (1 - p)) / variance,
                    {"directions are independent, light " + placed.where, alpha},
                    {{}, "use n independent directions"});
    // 400 counts of about 20 values each are never equal by chance.
    const auto other = by_hemisphere(light, n, rng(), replicates);
    expect_that(directions_met(other, light, n, replicates) != met,
                other.call + "  gave the same estimates as with another seed",
                "different estimates", "rng is the only source of randomness", from_rng.text);
  }
}

CHECK_CASE("2.7 the size of the scene does not matter", "[2.7][points:1][needs:2.1]") {
  // All lengths times a power of two: each direction and each value stays the same.
  const RectLight light = above(rng).light;
  for (const auto& measure : {by_area, by_hemisphere}) {
    const std::uint64_t seed = rng(), replicates = 40;
    const auto usual = measure(light, 64, seed, replicates);
    const Values expected = values_of(usual.call, usual.exactly(replicates, any_number));
    for (const double scale : {0x1p-8, 0x1p8}) {
      RectLight scaled = light;
      for (double* const length :
           {&scaled.x0, &scaled.x1, &scaled.y0, &scaled.y1, &scaled.height}) {
        *length *= scale;
      }
      const auto got = measure(scaled, 64, seed, replicates);
      expect_each({got.call, values_of(got.call, got.exactly(replicates, any_number))},
                  {.exact = expected,
                   .tolerance = each(expected, [](double e) { return 1e-9 * std::abs(e); }),
                   .because = fmt::format("irradiance does not depend on the unit of length: this "
                                          "is {} with all lengths times {}",
                                          usual.call, scale),
                   .rule = "use no constant length: no minimal distance, no clamped value"});
    }
  }
}

CHECK_CASE("2.7 both estimates know their error", "[2.7][points:3][needs:2.1]") {
  for (const PlacedLight& placed : {above(rng), aside(rng)}) {
    const RectLight& light = placed.light;
    // E{s^2} = sigma^2, and Var{s^2} = (kurtosis - (n-3)/(n-1)) sigma^4 / n for independent values.
    // With three samples, mistakes about n have the largest effect, each with its own factor.
    const std::uint64_t three = 3, sets = 20000;
    const auto got = by_area(light, three, rng(), sets);
    const Population x = of_area(light);
    Values squares;
    for (const Estimate& one : got.exactly(sets, any_number)) {
      squares.push_back(one.standard_error * one.standard_error * three / x.variance);
    }
    expect_mean(
        {got.call + ", n standard_error^2 / variance", squares, three}, 1, x.kurtosis / 3,
        {"the light is " + placed.where + "; squared standard errors have the mean variance / n",
         alpha},
        {{{3, "this is s, not s / sqrt(n)"_likely}},
         "return s / sqrt(n) of the samples' values, whose points are independent"});
    constexpr std::uint64_t many = 65'539;  // n (n - 1) exceeds 32 bits
    const auto one = by_area(light, many, rng(), 1);
    const double error = one.exactly(1, any_number)[0].standard_error;
    const double expected = std::sqrt(x.variance / double{many});
    expect_that(std::abs(error / expected - 1) < 0.5,
                fmt::format("{}.standard_error = {}", one.call, error),
                fmt::format("about {}", expected), "", "return s / sqrt(n): count in 64 bits");
    Results errors;
    for (const std::uint64_t n : {std::uint64_t{64}, many}) {
      const std::uint64_t replicates = n == 64 ? 100 : 1;
      const auto by_directions = by_hemisphere(light, n, rng(), replicates);
      const Values met = directions_met(by_directions, light, n, replicates);
      const double each = pi * light.radiance, size = static_cast<double>(n);
      for (std::size_t i = 0; i < met.size(); ++i) {
        const double s2 = each * each * met[i] * (size - met[i]) / (size * (size - 1));
        errors.add(fmt::format("{}[{}].standard_error", by_directions.call, i),
                   by_directions.exactly(replicates, any_number)[i].standard_error,
                   std::sqrt(s2 / size), 1e-7 * each);
      }
    }
    errors.expect("the estimate shows how many directions met the light",
                  "return s / sqrt(n) of the samples' values");
  }
}

CHECK_CASE("2.7 one sample and none", "[2.7][points:1][edge][needs:2.1]") {
  for (const auto& measure : {by_area, by_hemisphere}) {
    const auto one = measure({}, 1, rng(), 1);
    const double error = one.exactly(1, any_number)[0].standard_error;
    expect_nan(one.call + ".standard_error", error, "one value has no spread");
    const auto some = measure({}, 77, rng(), 1);
    expect_equal(some.call + ": n", some.exactly(1, any_number)[0].n, 77,
                 "the n of an Estimate counts samples", "count every sample once");
  }
  expect_refused({{MEASURE_OUTCOME(irradiance_area, {}, 0, 1, 1), "n", no_mean},
                  {MEASURE_OUTCOME(irradiance_hemisphere, {}, 0, 1, 1), "n", no_mean}});
}

// What the cases above measure --------------------------------------------------------------------

/// For lights so small that all points have the same value, to ten digits, the estimate does not
/// depend on the random numbers, and each wrong formula has its own value.
void judge_formula(Rng& rng) {
  Results values;
  for (const std::uint64_t n : {64u, 1u, 2u, 1000u}) {
    const RectLight light = light_in({0.3, 0.9}, {-0.9, -0.3}, {1e-11, 2e-11}, {1.2, 1.9}, rng);
    const double h = light.height, a = area(light);
    const double d = std::hypot(light.x0, light.y0, h);
    const double exact = at_square_distance(light, d * d - h * h);
    const auto got = by_area(light, n, rng(), 1);
    values.add(
        got.call + ".value", got.exactly(1, any_number)[0].value, exact, 1e-9 * exact,
        [=]() -> std::vector<Suspect> {
          return {{exact * d / h, "a cosine is missing: the light is also seen at an angle"_likely},
                  {exact * d, "the distance is not squared: 1 / distance^2"_likely},
                  {exact / a, "the density of points is 1 / area: the area is missing"_likely}};
        });
  }
  values.expect("all points of such a small light give area · radiance · cos · cos / distance^2",
                "area · radiance · cos(receiver) · cos(light) / distance^2, all over the light");
}

/// An estimate from one sample is the value at one point: returns the squared distance of each such
/// point from the point of the light's plane above the receiver.
Values square_distances(const Measured<Estimates>& ones, const RectLight& light,
                        std::size_t count) {
  Values all;
  for (const double value : values_of(ones.call, ones.exactly(count, any_number))) {
    all.push_back(square_distance_of(light, value));
    if (all.back() >= nearest(light) - 1e-9 && all.back() <= farthest(light) + 1e-9) continue;
    expect_that(false, fmt::format("{} gave {}", ones.call, value),
                fmt::format("the value at a point of the light: from {:.8g} to {:.8g}",
                            at_square_distance(light, farthest(light)),
                            at_square_distance(light, nearest(light))),
                "an estimate from one sample is the value at one point of the light",
                "x between x0 and x1, y between y0 and y1");
  }
  return all;
}

/// The position of one point on a light that is a line along x or y, accurate to 40 bits.
Construction places_on_a_line(bool along_x, std::uint64_t n) {
  return {numbers_in_turn(along_x ? "the x of points on a light" : "the y of points on a light"),
          [=](std::uint64_t seed, std::uint64_t calls) {
            RectLight line{0.5, 1.5, 0, 1e-17, 1, 1};
            if (!along_x) line = {0, 1e-17, 0.5, 1.5, 1, 1};
            const auto got = by_area(line, 1, seed, n * calls);
            Uniforms places{got.call, n};
            places.bits = 40;
            for (const double square : square_distances(got, line, n * calls)) {
              places.values.push_back(std::clamp(std::sqrt(square) - 0.5, 0.0, 1 - 0x1p-53));
            }
            // A hundredth of the line stays empty once in 10^21 sets of 5,000 points.
            const auto [least, largest] = std::ranges::minmax(places.values);
            expect_that(
                least < 0.01 || largest > 0.99,
                fmt::format("{}: values of points from {:.3g} to {:.3g} of a light that is a line",
                            got.call, least, largest),
                "values of points from one end to the other", "points are uniform on the light",
                "in the value at a point, the distance and both cosines are those of this point");
            return places;
          }};
}

/// How many of the n directions of each estimate met the light.
Values directions_met(const Measured<Estimates>& measured, const RectLight& light, std::uint64_t n,
                      std::uint64_t replicates) {
  Values all;
  const double each = pi * light.radiance / static_cast<double>(n);
  for (const Estimate& one : measured.exactly(replicates, any_number)) {
    const double met = one.value / each;
    expect_that(
        std::abs(met - std::round(met)) < 1e-6 && met > -0.5 && met < static_cast<double>(n) + 0.5,
        fmt::format("{} gave {}", measured.call, one.value),
        fmt::format("a multiple of pi · radiance / n = {:.8g}, up to n of it", each),
        "a direction with density cos / pi contributes pi · radiance or 0",
        "cos divided by the density cos / pi is pi, for each direction that meets the light");
    all.push_back(std::round(met));
  }
  return all;
}

/// Every direction meets a light that fills the sky.
void judge_sky(Rng& rng) {
  Results values;
  for (const std::uint64_t n : {64u, 1u, 2u, 1000u}) {
    const RectLight sky{-1e15, 1e15, -1e15, 1e15, uniform(rng, 0.5, 2), uniform(rng, 2, 9)};
    const auto got = by_hemisphere(sky, n, rng(), 1);
    const double exact = pi * sky.radiance;
    values.add(got.call + ".value", got.exactly(1, any_number)[0].value, exact, 1e-12 * exact);
  }
  values.expect("the light fills the sky: each direction meets it, and gives pi · radiance",
                "radiance · cos, divided by the density cos / pi; z is up");
}

}  // namespace
}  // namespace mc::checks
