// 2.9: points on the light and directions, combined by the balance heuristic.

#include "checks/independent/lights.hpp"

namespace mc::checks {
namespace {

const Likely half = "do not average the two terms: their weights add up to 1 already"_likely;
const std::string uniform_points =
    "a uniform point of the light and an independent direction, from four random numbers";

Measured<Estimates> by_pairs(const RectLight& light, std::uint64_t n, std::uint64_t seed,
                             std::uint64_t replicates) {
  return MEASURE(irradiance_combined, light, n, seed, replicates);
}

void judge_each_term(Rng& rng);
void judge_single_pairs(const PlacedLight& placed, Rng& rng);

CHECK_CASE("2.9 irradiance from pairs by the balance heuristic",
           "[2.9][stretch][main][needs:2.1]") {
  judge_each_term(rng);
  const std::uint64_t replicates = 400;
  const PlacedLight far{{-0.5, 0.5, -0.5, 0.5, uniform(rng, 3, 5), 3}, "far away"};
  const PlacedLight near{{-4, 4, -4, 4, uniform(rng, 0.4, 0.6), 2}, "large and near"};
  // Of the far light, 2 % of the directions: 20 of each estimate.
  for (const auto& [placed, n] :
       {std::pair{above(rng), 64u}, {aside(rng), 64u}, {far, 1024u}, {near, 64u}}) {
    const auto got = by_pairs(placed.light, n, rng(), replicates);
    const Values values = values_of(got.call, got.exactly(replicates, any_number));
    const Known known = mean_of(of_pair(placed.light), n);
    const Replicates sample{got.call, values, static_cast<double>(n)};
    expect_mean(sample, known.exact, known.variance,
                {"pairs for a light " + placed.where + " have the mean E", alpha},
                {{{known.exact / 2, half}}, "the term of a direction that misses the light is 0"});
    expect_variance(sample, known.exact, known.variance, known.kurtosis,
                    {"pairs for a light " + placed.where + " have their exact variance", alpha},
                    {{}, "each term is f / (p_area + p_hemisphere), at " + uniform_points});
  }
  judge_single_pairs(above(rng), rng);
  judge_single_pairs(aside(rng), rng);
}

CHECK_CASE("2.9 pairs know their error", "[2.9][stretch][needs:2.1]") {
  const RectLight light = above(rng).light;
  const std::uint64_t three = 3, sets = 20'000;
  const auto got = by_pairs(light, three, rng(), sets);
  const Population x = of_pair(light);
  Values squares;
  for (const Estimate& one : got.exactly(sets, any_number)) {
    expect_equal(got.call + ": n", one.n, three, "n counts pairs", "count every pair once");
    squares.push_back(one.standard_error * one.standard_error * three / x.variance);
  }
  expect_mean({got.call + ", n standard_error^2 / variance", squares, three}, 1, x.kurtosis / 3,
              {"squared standard errors of pairs have the mean variance / n", alpha},
              {{{0.5, "this is s / sqrt(2 n): there are n pairs, and a pair is one value"_likely}},
               "return s / sqrt(n) of the n values of pairs"});
}

CHECK_CASE("2.9 one pair and none", "[2.9][stretch][edge][needs:2.1]") {
  const auto one = by_pairs({}, 1, rng(), 1);
  expect_nan(one.call + ".standard_error", one.exactly(1, any_number)[0].standard_error,
             "one value has no spread");
  expect_refused_by_name({{MEASURE_OUTCOME(irradiance_combined, {}, 0, 1, 1), "n", no_mean}});
}

/// A light so small that no direction meets it, and one that fills the sky: only one term of a pair
/// counts, and the estimate does not depend on the random numbers.
void judge_each_term(Rng& rng) {
  Results small, sky;
  for (const std::uint64_t n : {64u, 1u, 2u, 1000u}) {
    const RectLight light = light_in({0.3, 0.9}, {-0.9, -0.3}, {1e-11, 2e-11}, {1.2, 1.9}, rng);
    const double square = light.x0 * light.x0 + light.y0 * light.y0, a = area(light);
    const double exact = balanced_at(light, square);
    const double distance = std::sqrt(square + light.height * light.height);
    const double cosine = light.height / distance, f = light.radiance * cosine;
    const auto got = by_pairs(light, n, rng(), 1);
    small.add(
        got.call + ".value", got.exactly(1, any_number)[0].value, exact, 1e-9 * exact,
        [=]() -> std::vector<Suspect> {
          return {
              {exact / 2, half},
              {f / (1 / a + cosine / pi),
               "1 / area is a density per area: per solid angle it is distance^2 / (area "
               "cos(light))"_likely},
              {f / (distance * distance / a),
               "a cosine is missing: f has that at the receiver, p_area that at the light"_likely},
              {0,
               "the point on this light has nearly the weight 1, p_area / (p_area + "
               "p_hemisphere), and adds nothing"_likely}};
        });
    const RectLight all{-1e15, 1e15, -1e15, 1e15, uniform(rng, 0.5, 2), uniform(rng, 2, 9)};
    const auto of_sky = by_pairs(all, n, rng(), 1);
    const double most = pi * all.radiance;
    sky.add(of_sky.call + ".value", of_sky.exactly(1, any_number)[0].value, most, 1e-9 * most,
            [=]() -> std::vector<Suspect> {
              return {{most / 2, half},
                      {0,
                       "the direction has nearly the weight 1, p_hemisphere / (p_area + "
                       "p_hemisphere), and adds nothing"_likely}};
            });
  }
  const std::string rule = "f / (p_area + p_hemisphere), with both densities per solid angle";
  small.expect("no direction meets this light, and p_hemisphere is small there: f / p_area",
               rule + "; the term of a direction that misses the light is 0");
  sky.expect("every direction meets this light, and p_area is small there: f / p_hemisphere", rule);
}

/// Below twice the least value of a point, a pair's direction missed the light, and its value shows
/// the distance of its point.
void judge_single_pairs(const PlacedLight& placed, Rng& rng) {
  const RectLight& light = placed.light;
  const std::uint64_t pairs = 20'000;
  const double least = balanced_at(light, farthest(light)),
               most = balanced_at(light, nearest(light));
  const auto got = by_pairs(light, 1, rng(), pairs);
  const double cut = share_within(light, square_distance_of_balanced(light, 2 * least));
  Uniforms shares{got.call + ", fractions of the light closer than each point", 1, {}, 20};
  for (const double value : values_of(got.call, got.exactly(pairs, any_number))) {
    expect_that(value >= least * (1 - 1e-9) && value <= 2 * most * (1 + 1e-9),
                fmt::format("{} gave {}", got.call, value),
                fmt::format("from {:.8g}, a corner of the light and no direction that meets it, "
                            "to {:.8g}, twice the nearest point",
                            least, 2 * most),
                "a pair adds f / (p_area + p_hemisphere) at one point, and at one direction if it "
                "meets the light",
                "both terms divide by the sum of both densities, not by one of them");
    if (value >= 2 * least) continue;
    const double share = share_within(light, square_distance_of_balanced(light, value));
    shares.values.push_back(std::clamp((share - cut) / (1 - cut), 0.0, 1 - 0x1p-53));
  }
  const double missed = 1 - irradiance(light) / (pi * light.radiance);
  expect_proportion(got.call,
                    "the direction missed the light and the point was far from its middle",
                    shares.values.size(), pairs, (1 - cut) * missed,
                    {"values of one term, light " + placed.where, alpha}, {{}, uniform_points});
  expect_independent_uniforms(shares,
                              {.words = "points of pairs are uniform, light " + placed.where,
                               .rule = uniform_points,
                               .expected = "independent uniform points on the light"});
}

}  // namespace
}  // namespace mc::checks
