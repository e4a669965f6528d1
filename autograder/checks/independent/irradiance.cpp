// Task 2.7: one light, two ways.

#include "checks/independent/functions.hpp"
#include "checks/support/rect_light_exact.hpp"

namespace mc::checks {
namespace {

constexpr double pi = std::numbers::pi;

using Estimates = std::vector<Estimate>;

// The lights, and what is known of them in closed form --------------------------------------------

struct Placed {
  RectLight light;
  std::string where;
};

/// Over the receiver: the one of the handout.
Placed above(Rng& rng) {
  RectLight light;
  light.radiance = uniform(rng, 0.5, 5);
  return {light, "above the receiver"};
}

/// Somewhere else, with a corner near the receiver's normal; not so near that a few points carry
/// everything.
Placed aside(Rng& rng) {
  RectLight light = light_in({0.1, 0.5}, {0.1, 0.5}, {0.5, 2}, {0.7, 2}, rng);
  light.y0 = -std::exchange(light.y1, -light.y0);
  return {light, "to one side"};
}

/// Low and far away: seen, and seeing, at two to three degrees.
Placed grazing(Rng& rng) {
  return {light_in({4, 5}, {-1, 0}, {1, 2}, {0.2, 0.25}, rng), "at a grazing angle"};
}

/// Everything beyond the plane x = k h on one side. It has a share of (1 - sin(atan(k))) / 2 of the
/// whole sky: 1 to 2.6 % for k from 3 to 5, 24 to 36 of 1.6 million directions for 105 to 130.
Placed half_sky_aside(double least, double most, Rng& rng) {
  RectLight light{0, 1e15, -1e15, 1e15, uniform(rng, 0.5, 2), uniform(rng, 0.5, 5)};
  light.x0 = light.height * uniform(rng, least, most);
  return {light, "at a grazing angle"};
}

/// A quarter of the sky.
Placed quarter_sky(unsigned quadrant, Rng& rng) {
  RectLight light{0, 1e15, 0, 1e15, uniform(rng, 0.5, 2), uniform(rng, 0.5, 5)};
  if (quadrant % 2 == 1) light.x0 = -std::exchange(light.x1, 0);
  if (quadrant / 2 == 1) light.y0 = -std::exchange(light.y1, 0);
  return {light, "in quadrant " + std::to_string(quadrant)};
}

/// What a point of the light gives that is this far, squared, from the point of the light's plane
/// above the receiver: area · radiance · height^2 / (square + height^2)^2.
double at_square_distance(const RectLight& light, double square) {
  const double distance2 = square + light.height * light.height;
  return area(light) * light.radiance * light.height * light.height / (distance2 * distance2);
}

/// How far, squared, a point is that gives `value`; NaN where nothing gives that.
double square_distance_of(const RectLight& light, double value) {
  const double h2 = light.height * light.height;
  return std::sqrt(area(light) * light.radiance * h2 / value) - h2;
}

double nearest(const RectLight& light) {
  const double x = std::max({light.x0, -light.x1, 0.0}), y = std::max({light.y0, -light.y1, 0.0});
  return x * x + y * y;
}
double farthest(const RectLight& light) {
  const double x = std::max(-light.x0, light.x1), y = std::max(-light.y0, light.y1);
  return x * x + y * y;
}

/// The area of the disk of radius r around the origin inside [0, x] x [0, y]; odd in x and in y.
double disk_in_corner(double x, double y, double r) {
  const double sign = (x < 0) == (y < 0) ? 1 : -1;
  const double a = std::min(std::abs(x), r), b = std::abs(y);
  const auto under_arc = [=](double at) {  // the integral of sqrt(r^2 - x^2) from 0
    return (at * std::sqrt(std::max(0.0, r * r - at * at)) +
            r * r * std::asin(std::min(1.0, at / r))) /
           2;
  };
  const double flat = b < r ? std::min(a, std::sqrt(r * r - b * b)) : 0;  // up to here y bounds it
  return sign * (b * flat + under_arc(a) - under_arc(flat));
}

/// The share of the light within this distance, squared, of the point above the receiver.
double share_within(const RectLight& light, double square) {
  if (!(square > 0)) return 0;
  const double r = std::sqrt(square);
  const double inside =
      disk_in_corner(light.x1, light.y1, r) - disk_in_corner(light.x0, light.y1, r) -
      disk_in_corner(light.x1, light.y0, r) + disk_in_corner(light.x0, light.y0, r);
  return inside / area(light);
}

/// The solid angle that the light fills, in closed form.
double solid_angle(const RectLight& light) {
  const double h = light.height;
  const auto corner = [=](double x, double y) {
    return std::atan(x * y / (h * std::sqrt(x * x + y * y + h * h)));
  };
  return corner(light.x1, light.y1) - corner(light.x0, light.y1) - corner(light.x1, light.y0) +
         corner(light.x0, light.y0);
}

/// What one uniform point of the light gives.
Population of_area(const RectLight& light) {
  const auto moment = [&](double k) {
    return mean_over(light, [&](double x, double y) {
      return std::pow(at_square_distance(light, x * x + y * y), k);
    });
  };
  Population x = population(moment(1), moment(2), moment(3), moment(4));
  x.mean = irradiance(light);
  return x;
}

// The area of the light ---------------------------------------------------------------------------

Measured<Estimates> by_area(const RectLight& light, std::uint64_t n, std::uint64_t seed,
                            std::uint64_t replicates) {
  return MEASURE(irradiance_area, light, n, seed, replicates);
}

/// Lights so small that all of their points give the same, to ten digits: whatever is drawn, the
/// estimate has one right value, and each wrong formula another one.
void judge_formula(Rng& rng) {
  Results values;
  for (const std::uint64_t n : {64u, 1u, 2u, 1000u}) {
    const RectLight light = light_in({0.3, 0.9}, {-0.9, -0.3}, {1e-11, 2e-11}, {1.2, 1.9}, rng);
    const double h = light.height, a = area(light), l = light.radiance;
    const double aside2 = light.x0 * light.x0 + light.y0 * light.y0, d2 = aside2 + h * h;
    const double d = std::sqrt(d2), exact = a * l * h * h / (d2 * d2);
    const auto got = by_area(light, n, rng(), 1);
    values.add(
        got.call + ".value", got.exactly(1, any_number)[0].value, exact, 1e-9 * exact,
        [=]() -> std::vector<Suspect> {
          return {
              {exact * static_cast<double>(n), "this is the sum over the samples: divide by n"},
              {a * l * h / (d2 * d), "a cosine is missing: the light, too, is seen at an angle"},
              {a * l * h * h / (d2 * d), "the distance is not squared: 1 / distance^2"},
              {a * l / d2, "both cosines are missing: cos = height / distance"},
              {a * l * h * h / d2, "the distance is missing: 1 / distance^2"},
              {l * h * h / (d2 * d2), "the density of points is 1 / area: the area is missing"},
              {l * h * h / (d2 * d2) / a, "divide by the density 1 / area: times the area"},
              {a * h * h / (d2 * d2), "the radiance is missing"},
              {a * l / (d2 * d2), "cos = height / distance: the height is missing"},
              {a * l * h * h / (d2 * d2 * d2),
               "cos · cos = height^2 / distance^2: the distance is there too often"},
              {exact / pi, "nothing is divided by pi here"},
              {exact * pi, "no pi here: radiance, not its integral over directions"},
              {a * l * h * h / (aside2 * aside2),
               "the distance goes up to the light, too: + height^2"}};
        });
  }
  values.expect("all points of so small a light give area · radiance · cos · cos / distance^2",
                "area · radiance · cos(receiver) · cos(light) / distance^2");
}

/// An estimate from one sample is the value at one point: how far from the point of the light's
/// plane above the receiver that is, squared.
Values square_distances(const Measured<Estimates>& ones, const RectLight& light,
                        std::size_t count) {
  Values all;
  for (const double value : values_of(ones.call, ones.exactly(count, any_number))) {
    all.push_back(square_distance_of(light, value));
    const bool is_on_it =
        all.back() >= nearest(light) - 1e-9 && all.back() <= farthest(light) + 1e-9;
    if (is_on_it) continue;
    expect_that(false, fmt::format("{}: a value {}", ones.call, value),
                fmt::format("what a point of the light gives: {:.8g} to {:.8g}",
                            at_square_distance(light, farthest(light)),
                            at_square_distance(light, nearest(light))),
                "an estimate from one sample is the value at one point of the light",
                "x between x0 and x1, y between y0 and y1");
  }
  return all;
}

/// Where one point lies on a light that is a line along x, or along y: the number it was made from,
/// to 40 bits.
Numbers places_on_a_line(bool along_x) {
  return {along_x ? "the x of points on a light" : "the y of points on a light", 1,
          [=](std::uint64_t n, std::uint64_t seed, std::uint64_t calls) {
            RectLight line{0.5, 1.5, 0, 1e-17, 1, 1};
            if (!along_x) line = {0, 1e-17, 0.5, 1.5, 1, 1};
            const auto got = by_area(line, 1, seed, n * calls);
            Uniforms places{got.call, 1};
            places.bits = 40;
            for (const double square : square_distances(got, line, n * calls)) {
              places.values.push_back(std::clamp(std::sqrt(square) - 0.5, 0.0, 1 - 0x1p-53));
            }
            return places;
          }};
}

CHECK_CASE("2.7 irradiance from points on the light", "[2.7][points:4][needs:2.1][main]") {
  Rng rng = check_rng();
  judge_formula(rng);
  for (const bool along_x : {true, false}) {
    judge_calls_in_turn(places_on_a_line(along_x), 1, 5000, rng);
    judge_one_call(places_on_a_line(along_x), 5000, 40, rng);
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
                {{}, "at uniform points of the light, x and y from a number each"});
    expect_variance(
        sample, known.exact, known.variance, known.kurtosis,
        {"the area estimate of a light " + placed.where + " has its exact variance", alpha},
        {{}, "n independent points, uniform on the light, x and y from a number each"});
  }
  // One sample is one value, and shows how far from the receiver its point is.
  const RectLight light = aside(rng).light;
  const auto ones = by_area(light, 1, rng(), 20000);
  Uniforms shares{ones.call + ", parts of the light within the distances of its points", 1, {}, 20};
  for (const double square : square_distances(ones, light, 20000)) {
    shares.values.push_back(std::clamp(share_within(light, square), 0.0, 1 - 0x1p-53));
  }
  expect_independent_uniforms(
      shares, {.words = "points are uniform on the light",
               .alpha = alpha,
               .otherwise = "x between x0 and x1, y between y0 and y1, from a number each",
               .expected = "points anywhere on the light, independent"});
}

// The hemisphere ----------------------------------------------------------------------------------

Measured<Estimates> by_hemisphere(const RectLight& light, std::uint64_t n, std::uint64_t seed,
                                  std::uint64_t replicates) {
  return MEASURE(irradiance_hemisphere, light, n, seed, replicates);
}

/// How many of n directions met the light, for each estimate.
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
        "a direction with density cos / pi gives pi · radiance, or nothing",
        "what does a direction count? The cosine and the density cos / pi leave pi");
    all.push_back(std::round(met));
  }
  return all;
}

/// Lights that fill the sky: every direction meets them.
void judge_sky(Rng& rng) {
  Results values;
  for (const std::uint64_t n : {64u, 1u, 2u, 1000u}) {
    const RectLight sky{-1e15, 1e15, -1e15, 1e15, uniform(rng, 0.5, 2), uniform(rng, 2, 9)};
    const auto got = by_hemisphere(sky, n, rng(), 1);
    const double radiance = sky.radiance, exact = pi * radiance;
    values.add(
        got.call + ".value", got.exactly(1, any_number)[0].value, exact, 1e-12 * exact,
        [=]() -> std::vector<Suspect> {
          return {
              {exact * static_cast<double>(n), "this is the sum over the directions: divide by n"},
              {radiance, "the density is cos / pi: the radiance over it, times cos, leaves pi"},
              {2 * exact, "2 pi is for directions that are uniform on the hemisphere; not these"},
              {radiance / pi, "times pi, not divided by it"},
              {pi, "the radiance is missing"},
              {0, "no direction meets it: is z up, and the direction followed to z = height?"}};
        });
  }
  values.expect("the light fills the sky: each direction meets it, and gives pi · radiance",
                "pi · radiance where a direction meets the light");
}

CHECK_CASE("2.7 irradiance from directions of the hemisphere", "[2.7][points:4][needs:2.1]") {
  Rng rng = check_rng();
  judge_sky(rng);
  // Each quarter of the sky is as likely as any other: of angles that were drawn in degrees, 57.3
  // turns, one quarter has 1.2 % more, which is 9 deviations of 1.6 million directions.
  std::vector<Placed> lights{above(rng), half_sky_aside(3, 5, rng), half_sky_aside(105, 130, rng)};
  for (const unsigned quadrant : {0u, 1u, 2u, 3u}) lights.push_back(quarter_sky(quadrant, rng));
  for (const Placed& placed : lights) {
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
        {{{&placed == &lights[0] ? solid_angle(light) / (2 * pi) : nan,
           "these directions are uniform on the hemisphere: steep ones must be more"}},
         (&placed == &lights[0] ? ""
                                : "a direction meets the light if it reaches z = height between "
                                  "x0 and x1 and between y0 and y1; ") +
             std::string("a direction is a uniform point of the unit disk (radius sqrt(u), angle "
                         "2 pi v, from two numbers), lifted to the hemisphere")});
    if (&placed != &lights[0]) continue;
    // The directions of one estimate are independent, too: how many meet is binomial.
    const auto trials = static_cast<double>(n), variance = p * (1 - p) * trials;
    expect_variance({got.call + ", directions that met the light", met, trials}, p * trials,
                    variance, 3 + (1 - 6 * p * (1 - p)) / variance,
                    {"directions are independent, light " + placed.where, alpha},
                    {{}, "n independent directions"});
    // 400 counts of about 20 values each are never equal by chance.
    const auto other = by_hemisphere(light, n, rng(), replicates);
    expect_that(directions_met(other, light, n, replicates) != met,
                other.call + " gave the estimates of another seed", "other estimates",
                "the generator that it is given is its only source of randomness",
                "take the numbers from rng, and from nowhere else");
  }
}

CHECK_CASE("2.7 both estimates know their error", "[2.7][points:2][needs:2.1]") {
  Rng rng = check_rng();
  for (const Placed& placed : {above(rng), aside(rng)}) {
    const RectLight& light = placed.light;
    // E{s^2} = sigma^2, and Var{s^2} = (kurtosis - (n-3)/(n-1)) sigma^4 / n for independent values.
    // With three samples, what is wrong about n shows most, and each mistake by its own factor.
    const std::uint64_t three = 3, replicates = 20000;
    const auto got = by_area(light, three, rng(), replicates);
    const Population x = of_area(light);
    Values squares;
    for (const Estimate& one : got.exactly(replicates, any_number)) {
      squares.push_back(one.standard_error * one.standard_error * three / x.variance);
    }
    expect_mean(
        {got.call + ", n standard_error^2 / variance", squares, three}, 1, x.kurtosis / 3,
        {"the light is " + placed.where + "; squared standard errors have the mean variance / n",
         alpha},
        {{{3, "s instead of s / sqrt(n)"},
          {1.5, "s / sqrt(n - 1): one n - 1 is enough, in s^2"},
          {2. / 3, "s^2 divides by n: divide by n - 1"}},
         "s / sqrt(n) of the values of the samples, where these are right"});
    const std::uint64_t n = 64;
    const auto by_directions = by_hemisphere(light, n, rng(), 100);
    const Values met = directions_met(by_directions, light, n, 100);
    const double each = pi * light.radiance, size = n;
    Results errors;
    for (std::size_t i = 0; i < met.size(); ++i) {
      const double s2 = each * each * met[i] * (size - met[i]) / (size * (size - 1));
      errors.add(fmt::format("{}[{}].standard_error", by_directions.call, i),
                 by_directions.exactly(100, any_number)[i].standard_error, std::sqrt(s2 / size),
                 1e-7 * each, [=]() -> std::vector<Suspect> {
                   return {{std::sqrt(s2), "s instead of s / sqrt(n)"},
                           {s2 / size, "this is its square"},
                           {std::sqrt(s2 / size * (size - 1) / size),
                            "s^2 divides by n: divide by n - 1"}};
                 });
    }
    errors.expect("as many directions met the light as the value says",
                  "s / sqrt(n) of the values of the samples");
  }
}

CHECK_CASE("2.7 one sample and none", "[2.7][points:1][edge][needs:2.1]") {
  Rng rng = check_rng();
  for (const auto& measure : {by_area, by_hemisphere}) {
    const auto one = measure({}, 1, rng(), 1);
    expect_nan(one.call + ".standard_error", one.exactly(1, any_number)[0].standard_error,
               "one value has no spread");
    const auto some = measure({}, 77, rng(), 1);
    const std::uint64_t counted = some.exactly(1, any_number)[0].n;
    expect_that(counted == 77, fmt::format("{}: n = {}", some.call, counted), "77",
                "the n of an Estimate counts samples", "every sample counts once");
  }
  const std::string of_nothing = "the mean of nothing is not an estimate";
  expect_refused({{MEASURE_OUTCOME(irradiance_area, {}, 0, 1, 1), "n", of_nothing},
                  {MEASURE_OUTCOME(irradiance_hemisphere, {}, 0, 1, 1), "n", of_nothing}});
}

}  // namespace
}  // namespace mc::checks
