// The data of lab 6's plots: error against samples and against time, what a coordinate costs, and
// the handout's picture. Errors of 100 estimates and more: their root mean square is known to 7 %,
// a line's width on axes of five decades.

#include <algorithm>
#include <cmath>

#include "6-sampler/experiments.hpp"
#include "checks/sampler/samplers.hpp"
#include "checks/support/anova.hpp"
#include "checks/support/catch.hpp"
#include "checks/support/known_scenes.hpp"
#include "measurements/sampler/images.hpp"
#include "measurements/sampler/point_by_point.hpp"
#include "measurements/support/plot_data.hpp"

namespace mc::checks {
namespace {

using Number = std::optional<double>;
using Row = std::vector<Number>;

bool is_blue(const std::string& kind) {
  return kind == "blue_noise";
}

/// CPU seconds of a round: the time of `rounds` less that of one, which is the program's start.
template <class Run>
Number seconds_of_a_round(std::uint64_t rounds, Run run) {
  const auto one = run(1), many = run(rounds);
  if (!one || !many || many->cpu_seconds <= one->cpu_seconds) return {};
  return (many->cpu_seconds - one->cpu_seconds) / static_cast<double>(rounds - 1);
}

/// The root of the mean square error of an estimate.
Number rmse_of(const std::string& kind, const std::string& scene, std::uint64_t n) {
  const std::size_t count = is_blue(kind) ? std::clamp<std::size_t>((1 << 22) / (n * n), 20, 400)
                                          : std::max<std::size_t>(100, (1 << 16) / n);
  const auto got = TRY_MEASURE(estimates, kind, scene, {}, 1, 0, n, neighbours(0, count));
  const Values* const estimates = got ? got->if_exactly(count) : nullptr;
  if (!estimates) return {};
  const double exact = known_scene(scene, {}).exact;
  double squares = 0;
  for (const double value : *estimates) squares += (value - exact) * (value - exact);
  return std::sqrt(squares / static_cast<double>(count));
}

/// CPU microseconds of an estimate.
Number microseconds_of(const std::string& kind, const std::string& scene, std::uint64_t n) {
  const std::uint64_t rounds = std::max<std::uint64_t>(
      2, is_blue(kind) ? (1 << 18) / (n * n) : (std::uint64_t{1} << 18) / n);
  const Number seconds = seconds_of_a_round(rounds, [&](std::uint64_t count) {
    return TRY_MEASURE(repeat_scene, kind, scene, n, count, 1);
  });
  return seconds ? Number(1e6 * *seconds) : Number{};
}

/// Columns: samples, and of each kind error and microseconds.
void plot_scene(const std::string& scene) {
  auto file = plot_file("error-" + scene + ".tsv");
  for (std::uint64_t n = 16; n <= 4096; n *= 4) {
    Row row{static_cast<double>(n)};
    for (const std::string& kind : sampler_kinds) {
      // Without a next2() blue noise is stratified; with 4096 points it takes a second.
      const bool is_left_out = is_blue(kind) && (scene == "motion_edge" || n > 1024);
      row.push_back(is_left_out ? Number{} : rmse_of(kind, scene, n));
      row.push_back(is_left_out ? Number{} : microseconds_of(kind, scene, n));
    }
    plot_row(file, row);
  }
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

/// The root of the mean square error of a scene over sets of points, as many as `points` has
/// columns for: those of set s are points(s).
template <class S, class Points>
double rmse_over(const S& scene, std::size_t sets, Points points) {
  double squares = 0;
  for (std::size_t set = 0; set < sets; ++set) {
    const auto [x, y] = points(set);
    const double error = mean_over(scene, x, y) - exact(scene);
    squares += error * error;
  }
  return std::sqrt(squares / static_cast<double>(sets));
}

/// Rows: k and, for the k-th next2() of sobol, the error under a lamp and at an edge, and the same
/// for dimensions 2k and 2k + 1 of one sequence; and of independent points. 32 sets of 1,024
/// points: errors within 13 %.
TEST_CASE("plot what each next2 is worth", "[.plot]") {
  constexpr std::size_t n = 1024, sets = 32, uses = 20;
  const Seeds seeds = neighbours(1, sets);
  const scenes::RectangleLight lamp;
  const scenes::PixelEdge edge;
  const auto independent = [](const char* scene) {
    return std::sqrt(known_scene(scene, {}, static_cast<double>(n)).variance);
  };
  auto file = plot_file("next2.tsv");
  const auto handed = TRY_MEASURE(columns, "sobol", n, seeds, repeated(uses, {2}));
  const Values* const all = handed ? handed->if_exactly(sets * 2 * uses * n, unit) : nullptr;
  for (std::size_t k = 0; k < uses; ++k) {
    Row row{static_cast<double>(k),   {}, {}, {}, {}, independent("rect_light"),
            independent("pixel_edge")};
    const auto fill = [&](std::size_t column, const Values& values, std::size_t first,
                          std::size_t dims) {
      const SetsOfPoints points(values, n, dims);
      const auto pair = [&](std::size_t set) {
        return std::pair(points.column(set, first), points.column(set, first + 1));
      };
      row[column] = rmse_over(lamp, sets, pair);
      row[column + 1] = rmse_over(edge, sets, pair);
    };
    if (all) fill(1, *all, 2 * k, 2 * uses);
    const auto pair_of_one_sequence = [&] {
      return TRY_MEASURE(sobol_columns,
                         {static_cast<unsigned>(2 * k), static_cast<unsigned>(2 * k) + 1}, n,
                         seeds);
    };
    // It has 32 dimensions: behind the sixteenth pair there is none left.
    const auto got = k < 16 ? pair_of_one_sequence() : decltype(pair_of_one_sequence()){};
    const Values* const pair = got ? got->if_exactly(sets * 2 * n, unit) : nullptr;
    if (pair) fill(3, *pair, 0, 2);
    plot_row(file, row);
    if (k != 7) continue;
    auto points = plot_file("pair.tsv");  // dimensions 14 and 15
    for (std::size_t i = 0; i < n; ++i) {
      plot_row(points, pair ? Row{(*pair)[i], (*pair)[n + i]} : Row{{}, {}});
    }
  }
}

/// Rows: of a scene, the fractions of its variance by order, 1 to 5, and what is within its uses.
/// They are the scene's own, whoever's sampler it asks.
TEST_CASE("plot the variance by order", "[.plot]") {
  auto file = plot_file("anova.tsv");
  Rng rng(7);
  const auto write = [&](const auto& scene) {
    // From 2^17 points: fractions within 1 %, less than a bar's edge.
    Anova anova = anova_of(scene, 1 << 17, rng);
    anova.by_order.resize(5, 0.0);
    Row row(anova.by_order.begin(), anova.by_order.end());
    row.push_back(anova.within_uses);
    plot_row(file, row);
  };
  write(scenes::RectangleLight{});
  write(scenes::SphereLight{});
  write(scenes::DiskPenumbra{});
  write(scenes::PixelEdge{});
  write(scenes::MotionEdge{});
  write(scenes::PixelTimeLens{});
}

/// Nanoseconds for one of the `dims` coordinates of one of n samples: a million of them, about.
Number nanoseconds(const std::string& kind, unsigned by, std::uint64_t dims, std::uint64_t n) {
  const std::uint64_t numbers = is_blue(kind) ? (1 << 22) / n : 1 << 20;
  const Number round = seconds_of_a_round(2 + numbers / (n * dims), [&](std::uint64_t rounds) {
    return TRY_MEASURE(repeat, kind, by, dims, n, rounds, 1);
  });
  return round ? Number(1e9 * *round / static_cast<double>(n * dims)) : Number{};
}

/// A row for each kind: four dimensions by next2(), generation alone and all of it.
TEST_CASE("plot what a coordinate costs", "[.plot]") {
  for (const std::uint64_t n : {16u, 256u, 4096u}) {
    auto file = plot_file("cost-" + std::to_string(n) + ".tsv");
    for (const std::string& kind : sampler_kinds) {
      const bool is_left_out = is_blue(kind) && n > 256;
      plot_row(file, is_left_out ? Row{Number{}, Number{}}
                                 : Row{nanoseconds(kind, 0, 4, n), nanoseconds(kind, 2, 4, n)});
    }
  }
}

/// With 256 samples: columns dimensions, and of each kind by next() and by next2().
TEST_CASE("plot what a coordinate costs against dimensions", "[.plot]") {
  auto file = plot_file("dimensions.tsv");
  for (const std::uint64_t dims : {2u, 4u, 8u}) {
    Row row{static_cast<double>(dims)};
    for (const std::string& kind : sampler_kinds) {
      for (const unsigned by : {1u, 2u}) {
        row.push_back(is_blue(kind) ? Number{} : nanoseconds(kind, by, dims, 256));
      }
    }
    plot_row(file, row);
  }
}

/// The handout's picture, for render.gp; what it needs to know of it besides stands in a script.
TEST_CASE("plot a picture", "[.plot]") {
  const std::uint64_t spp = 16;
  const auto exact = exact_image("penumbra", image_width, image_height);
  write_image("exact.tsv", exact);
  auto script = plot_file("samplers.gp");
  script << "white = " << *std::max_element(exact.begin(), exact.end()) << "\narray drawn[5]\n";
  double range = 0;
  for (std::size_t k = 0; k < sampler_kinds.size(); ++k) {
    const std::string& kind = sampler_kinds[k];
    const auto got = TRY_MEASURE(render, kind, "penumbra", image_width, image_height, spp, 1);
    const Image* const image = got ? got->if_exactly(exact.size()) : nullptr;
    script << "drawn[" << k + 1 << "] = \"";
    if (image) {
      const Errors errors = write_with_error(kind + "-samplers", *image, exact);
      range = std::max(range, errors.large);
      script.precision(3);
      script << kind << "\\nRMSE " << errors.rmse;
    }
    script << "\"\n";
  }
  script << "range = " << range << '\n';
}

}  // namespace
}  // namespace mc::checks
