// The data of lab 6's plots and demo: error against samples and against time, what a coordinate
// costs, and the handout's picture. Errors of 100 estimates and more: their root mean square is
// known to 7 %, a line's width on axes of five decades.

#include <cmath>

#include "checks/support/catch.hpp"
#include "measurements/sampler/methods.hpp"
#include "measurements/sampler/pictures.hpp"
#include "measurements/support/plot_data.hpp"

namespace mc::measurements {
namespace {

/// Two columns for each kind.
Names two_columns_each(const std::string& first, const std::string& second) {
  Names all;
  for (const Method& one : methods) all.insert(all.end(), {one.key + first, one.key + second});
  return all;
}

/// Of each kind the error, and the CPU time of an estimate in microseconds.
void plot_scene(const std::string& scene) {
  plot_table("error-" + scene + ".tsv", {"N", powers(16, 4, 4096)}, two_columns_each("", "_us"),
             [&](double size, std::size_t c) {
               const auto n = static_cast<Count>(size);
               const std::string& kind = methods.at(c / 2).kind;
               const bool is_blue = kind == "blue_noise";
               // Without a next2() blue noise is stratified; with 4096 points it takes a second.
               if (is_blue && (scene == "motion_edge" || n > 1024)) return missing;
               const Count cost = is_blue ? n * n / 8 : n;
               if (c % 2 == 0) {
                 const auto count = std::clamp<std::size_t>((1 << 19) / cost, 20, 400);
                 return scene_errors(kind, scene, n, count, 0).rmse();
               }
               return 1e6 * seconds_of(scene_rounds(kind, scene, n), 0.004, 1,
                                       std::max<Count>(1, (1 << 17) / cost));
             });
}

TEST_CASE("plot the error under a lamp", "[.plot]") {
  plot_scene("rect_light");
}
TEST_CASE("plot the error at an edge", "[.plot]") {
  plot_scene("pixel_edge");
}
TEST_CASE("plot the error at a moving edge", "[.plot]") {
  plot_scene("motion_edge");
}
TEST_CASE("plot the error in five dimensions", "[.plot]") {
  plot_scene("pixel_time_lens");
}

/// Rows: k and, for the k-th next2() of sobol, the error under a lamp and at an edge, and the same
/// for dimensions 2k and 2k + 1 of one sequence; and of independent points. 32 sets of 1,024
/// points: errors within 13 %.
TEST_CASE("plot what each next2 is worth", "[.plot]") {
  constexpr std::size_t n = 1024, count = 32, uses = 20;
  const Integrand scenes[] = {plane_integrand(scenes::RectangleLight{}),
                              plane_integrand(scenes::PixelEdge{})};
  auto file = plot_file("next2.tsv", {"k", "scrambled_sobol_1", "scrambled_sobol_2", "sobol_1",
                                      "sobol_2", "independent_1", "independent_2"});
  const Sets all = sets_in_parts(methods["scrambled_sobol"], n, 2 * uses, count, 1);
  for (unsigned k = 0; k < uses; ++k) {
    // One sequence has 32 dimensions: after the sixteenth pair there are none.
    const Sets pair = k < 16 ? sobol_dimensions({2 * k, 2 * k + 1}).points(n, 2, count, 1) : Sets{};
    Values row{static_cast<double>(k + 1)};
    for (const Integrand& scene : scenes) row.push_back(errors_of(all, scene, n, 2 * k).rmse());
    for (const Integrand& scene : scenes) row.push_back(errors_of(pair, scene, n).rmse());
    for (const char* name : {"rect_light", "pixel_edge"}) {
      row.push_back(std::sqrt(known_scene(name, {}, n).variance));
    }
    plot_row(file, row);
  }
}

/// Rows: of a scene, the fractions of its variance by order, 1 to 5, and what is within its uses.
/// They depend on the scene alone, not on the sampler.
TEST_CASE("plot the variance by order", "[.plot]") {
  auto file = plot_file("anova.tsv");
  Rng rng(7);
  const auto write = [&](const auto&... scene) {
    // From 2^17 points: fractions within 1 %, less than a bar's edge.
    for (Anova one : {anova_of(scene, 1 << 17, rng)...}) {
      one.by_order.resize(5);
      one.by_order.push_back(one.within_uses);
      plot_row(file, one.by_order);
    }
  };
  write(scenes::RectangleLight{}, scenes::SphereLight{}, scenes::DiskPenumbra{},
        scenes::PixelEdge{}, scenes::MotionEdge{}, scenes::PixelTimeLens{});
}

/// Nanoseconds for one of the `dims` coordinates of one of n samples; half a million of them at
/// first.
double nanoseconds(const std::string& kind, unsigned by, Count dims, Count n) {
  const Count numbers = kind == "blue_noise" ? (1 << 21) / n : 1 << 19;
  const Rounds run = [&](Count rounds) {
    return TRY_MEASURE(repeat, kind, by, dims, n, rounds, 1);
  };
  return 1e9 * seconds_of(run, 0.004, 1, 1 + numbers / (n * dims)) / static_cast<double>(n * dims);
}

/// Filling the columns alone, and in all: {generation, total}. A disturbance only adds time, so
/// each is the least of several measurements, one after the other, until the total is above its
/// part.
Values cost_of(const std::string& kind, Count n) {
  Values cost{infinity, infinity};
  for (int round = 0; round < 8 && (round < 2 || cost[1] < cost[0]); ++round) {
    cost[0] = std::min(cost[0], nanoseconds(kind, 0, 4, n));
    cost[1] = std::min(cost[1], nanoseconds(kind, 2, 4, n));
  }
  INFO(kind << " with " << n << " samples: the total is below its part");
  CHECK(cost[1] >= cost[0]);
  std::ranges::replace(cost, infinity, missing);
  return cost;
}

/// Four dimensions by next2(): generation alone, and all of it. Blue noise up to 256 samples.
TEST_CASE("plot what a coordinate costs", "[.plot][time]") {
  for (const Count n : {16u, 256u, 4096u}) {
    auto file = plot_file("speed-" + std::to_string(n) + ".tsv", {"generation", "all"});
    for (const Method& one : methods) {
      const bool is_long = one.kind == "blue_noise" && n > 256;
      plot_row(file, is_long ? Values(2, missing) : cost_of(one.kind, n));
    }
  }
}

/// With 256 samples: of each kind by next() and by next2().
TEST_CASE("plot what a coordinate costs against dimensions", "[.plot][time]") {
  plot_table("speed-dims.tsv", {"dims", {2, 4, 8}}, two_columns_each("_1", "_2"),
             [](double dims, std::size_t c) {
               const std::string& kind = methods.at(c / 2).kind;
               if (kind == "blue_noise") return missing;
               return nanoseconds(kind, c % 2 + 1, static_cast<Count>(dims), 256);
             });
}

/// The handout's picture, for render.gp, and a script with what else that needs.
TEST_CASE("plot a picture", "[.plot]") {
  const Count spp = 16;
  const auto exact = exact_image("penumbra", image_width, image_height);
  plot_image("exact.tsv", exact, image_width);
  auto script = plot_file("samplers.gp");
  script << fmt::format("white = {:g}\narray drawn[5]\n",
                        *std::max_element(exact.begin(), exact.end()));
  double range = 0;
  for (std::size_t k = 0; k < sampler_kinds.size(); ++k) {
    const std::string& kind = sampler_kinds[k];
    const auto image = lists_of(
        TRY_MEASURE(render, kind, "penumbra", image_width, image_height, spp, 1), exact.size());
    std::string title;
    if (image) {
      const auto errors = write_with_error(kind + "-samplers", image->pixels, exact);
      range = std::max(range, errors.large_error);
      title = fmt::format("{}\\nRMSE {:.3g}", kind, errors.rmse);
    }
    script << fmt::format("drawn[{}] = \"{}\"\n", k + 1, title);
  }
  script << fmt::format("range = {:.3g}\n", range);
}

/// The same picture by each kind, with more and more samples.
TEST_CASE("demo", "[.demo]") {
  begin_demo();
  constexpr unsigned width = 96, height = 72;
  const Values exact = exact_image("penumbra", width, height);
  // White is a third above the brightest pixel; what noise makes brighter than that is cut off.
  const double white = 4. / 3 * *std::max_element(exact.begin(), exact.end());
  const auto text_of = [&](Values pixels) {
    for (double& pixel : pixels) pixel /= white;
    return encoded(pixels, 2);
  };
  for (std::size_t k = 0; k < methods.size(); ++k) {
    const Method& one = methods.at(k);
    // The optional kind: who refuses it has no less of a demo.
    const Call made = MEASURE_OUTCOME(columns, one.kind, 1, {1}, {});
    if (made.outcome.answered && made.outcome.status == wire::Status::invalid_argument) continue;
    Values sizes;
    std::vector<std::string> images;
    for (const double spp : powers(1, 4, 64)) {
      const auto image = lists_of(TRY_MEASURE_WITH(large, render, one.kind, "penumbra", width,
                                                   height, static_cast<Count>(spp), 1),
                                  exact.size());
      if (!image) break;
      sizes.push_back(spp);
      images.push_back(text_of(image->pixels));
    }
    if (images.empty()) continue;
    write_demo(6, std::to_string(k),
               {{"name", one.name},
                {"width", double{width}},
                {"sizes", sizes},
                {"images", images},
                {"exact", text_of(exact)}});
  }
}

}  // namespace
}  // namespace mc::measurements
