// The scenes of lab 6 and their closed forms, each against the other, and both against reference
// values.
#include <cmath>
#include <cstdlib>

#include "checks/support/catch.hpp"
#include "measurements/sampler/pictures.hpp"
#include "sampler.hpp"

using namespace mc;
using namespace mc::checks;

namespace {

/// Random numbers, with a log of the calls.
class RecordingSampler final : public Sampler {
 public:
  explicit RecordingSampler(std::uint64_t seed) : rng_(seed) {}
  void generate(std::size_t, std::uint64_t) override {}
  double next() override {
    asked += "next ";
    return uniform(rng_);
  }
  Point2 next2() override {
    asked += "next2 ";
    const double x = uniform(rng_);
    return {x, uniform(rng_)};
  }
  void advance() override { asked.clear(); }
  std::string asked;

 private:
  Rng rng_;
};

constexpr double samples = 200'000;

/// Sample moments.
template <class S>
Population brute_force(const S& scene, std::uint64_t seed) {
  RecordingSampler sampler(seed);
  double sum = 0, squares = 0;
  for (double i = 0; i < samples; ++i, sampler.advance()) {
    const double value = scene(sampler);
    sum += value;
    squares += value * value;
  }
  const double mean = sum / samples;
  return {mean, squares / samples - mean * mean};
}

/// 5.5 standard errors: exceeded once in 2.6e7 by a Gaussian.
constexpr double sigmas = 5.5;

template <class... S>
struct Scenes {
  template <class F>
  static void each(F f) {
    std::size_t i = 0;
    (f(std::string(known_scenes[i++].name), S{}), ...);
  }
};
using AllScenes =
    Scenes<scenes::PixelEdge, scenes::RectangleLight, scenes::HorizonLight, scenes::DiskLight,
           scenes::SphereLight, scenes::HalfplanePenumbra, scenes::DiskPenumbra,
           scenes::WallOcclusion, scenes::SphereOcclusion, scenes::SphereOcclusionUniform,
           scenes::DefocusEdge, scenes::MotionEdge, scenes::PixelTimeLens, scenes::Stripes>;

}  // namespace

TEST_CASE("a scene's estimate matches its closed form, with default and random parameters") {
  AllScenes::each([](const std::string& name, auto scene) {
    INFO(name);
    Rng rng(6);
    for (std::uint64_t i = 0; i < 8; ++i) {
      if (i > 0) draw(scene, rng);
      const Population known = population_of(scene);
      const Population got = brute_force(scene, i);
      CHECK(std::abs(got.mean - known.mean) < sigmas * std::sqrt(known.variance / samples));
      // The second term is the mean's own error, squared.
      CHECK(std::abs(got.variance / known.variance - 1) <
            sigmas * std::sqrt((known.kurtosis - 1) / samples) + sigmas * sigmas / samples);
      CHECK(moment(scene, 1) == Approx(exact(scene)).epsilon(1e-12));
      const Population by_name = scene_population(name, parameters_of(scene));
      CHECK(by_name.mean == known.mean);
      CHECK(by_name.variance == known.variance);
    }
  });
}

TEST_CASE("random parameters give a variance worth measuring") {
  Rng rng(9);
  for (const KnownScene& scene : known_scenes) {
    INFO(std::string(scene.name));
    for (int i = 0; i < 1000; ++i) {
      const Population known = scene_population(scene.name, scene.fresh(rng));
      CHECK(known.variance > std::pow(0.05 * known.mean, 2));
      CHECK(known.kurtosis < 30);
    }
  }
}

TEST_CASE("a scene makes exactly the calls it lists, for any random numbers") {
  AllScenes::each([](const std::string& name, auto scene) {
    INFO(name);
    RecordingSampler sampler(1);
    for (int i = 0; i < 1000; ++i, sampler.advance()) {
      scene(sampler);
      REQUIRE(sampler.asked == std::string(scene.uses) + ' ');
    }
  });
}

// By adaptive quadrature with 30 digits, independent of this code; for the default parameters.
TEST_CASE("closed forms of the scenes against independently computed values") {
  struct Reference {
    std::string_view name;
    double mean, variance;
  };
  constexpr Reference references[] = {
      {"pixel_edge", 0.6188395105778121216261599, 0.23587717072562608085},
      {"rect_light", 1.133290224099014525738617, 0.19407819334767491552},
      {"rect_light_horizon", 0.3501882877138967108788832, 0.10510118738267366254},
      {"disk_light", 1.130973355292325565846552, 0.086339299300729709198},
      {"sphere_light", 0.4148589287274015939746981, 0.003668803148030330236},
      {"penumbra_halfplane", 0.7562410723388381717214145, 0.46517624515898544872},
      {"penumbra_disk", 0.9103295447505301210131548, 0.28907866669478079941},
      {"ao_wall", 0.9, 0.09},
      {"ao_sphere", 0.5555555555555555555555556, 0.24691358024691358025},
      {"ao_sphere_uniform", 0.5555555555555555555555556, 0.24347357469130609788},
      {"defocus_edge", 0.8044988905221146790444983, 0.15728042567080121928},
      {"motion_edge", 0.7538461538461538461538462, 0.1855621301775147929},
      {"pixel_time_lens", 0.5096294160399723259281598, 0.24990727434672912369},
  };
  for (const Reference& reference : references) {
    INFO(std::string(reference.name));
    const Known known = known_scene(reference.name, {});
    CHECK(known.exact == Approx(reference.mean).epsilon(1e-14));
    CHECK(known.variance == Approx(reference.variance).epsilon(1e-12));
  }
}

TEST_CASE("Lambert's formula for a rectangle overhead is the sum over its corners") {
  Rng rng(7);
  for (int i = 0; i < 100; ++i) {
    const RectLight light = fresh_light(rng);
    const double h = light.height;
    const std::array<scenes::Vector, 4> corners{{{light.x0, light.y0, h},
                                                 {light.x1, light.y0, h},
                                                 {light.x1, light.y1, h},
                                                 {light.x0, light.y1, h}}};
    CHECK(light.radiance * std::abs(lambert(corners)) == Approx(irradiance(light)).epsilon(1e-13));
  }
}

TEST_CASE("a name with parameters selects the scene; unknown names and parameters are refused") {
  Rng rng(8);
  for (const KnownScene& scene : known_scenes) {
    const std::vector<double> parameters = scene.fresh(rng);
    CHECK(known_scene(scene.name, parameters).exact != known_scene(scene.name, {}).exact);
  }
  CHECK(known_scene("motion_edge", std::array{0.2, 0.4}).exact == Approx(0.4));  // .2 + .4/2
  CHECK_THROWS(known_scene("no_scene", {}));
  CHECK_THROWS(known_scene("motion_edge", std::array{1.0}));
  CHECK_THROWS(exact_image("no_picture", 2, 2));
}

template <class At>
void require_exact_pixels(At at) {
  constexpr double width = 24, height = 18, spp = 2000;
  double seen = 0;
  for (double row = 0; row < height; ++row) {
    for (double column = 0; column < width; ++column) {
      const auto scene = at(width, height, column, row);
      const double variance = moment(scene, 2) - exact(scene) * exact(scene);
      RecordingSampler sampler(static_cast<std::uint64_t>(column + width * row));
      double sum = 0;
      for (double i = 0; i < spp; ++i, sampler.advance()) sum += scene(sampler);
      // A rare 1 follows a Poisson rather than a normal distribution: 12 events where 0.5 are
      // expected happen once in 1e12.
      INFO(column << ", " << row);
      CHECK(std::abs(sum / spp - exact(scene)) <
            sigmas * std::sqrt(std::max(0.0, variance) / spp) + 12 / spp);
      if (exact(scene) > 0 && exact(scene) < 1) ++seen;
    }
  }
  CHECK(seen > height);  // the image is not empty
}

TEST_CASE("the exact image of a picture is the mean of its pixels") {
  require_exact_pixels(scenes::edge_picture);
  require_exact_pixels(scenes::penumbra_picture);
  require_exact_pixels(scenes::defocus_picture);
  require_exact_pixels(scenes::motion_picture);
  require_exact_pixels(scenes::stripes_picture);
  const std::vector<double> image = exact_image("motion", 8, 4);  // row by row from the top
  REQUIRE(image.size() == 32);
  CHECK(image[2 * 8 + 5] == exact(scenes::motion_picture(8, 4, 5, 2)));
}
