// The data of lab 6's plots: error against samples and against time, what a coordinate costs, and
// the handout's picture.

#include <cmath>

#include "6-sampler/experiments.hpp"
#include "checks/sampler/images.hpp"
#include "checks/support/catch.hpp"
#include "checks/support/known_scenes.hpp"
#include "checks/support/plot_data.hpp"

namespace mc::checks {
namespace {

using Number = std::optional<double>;
using Row = std::vector<Number>;

constexpr const char* kinds[] = {"independent", "stratified", "blue_noise", "halton", "sobol"};
bool is_blue(const std::string& kind) {
  return kind == "blue_noise";
}

/// How many estimates of n samples are made: 2^19 samples, 400 estimates at least; fewer of blue
/// noise, whose time grows with n^2.
std::uint64_t replicates_of(const std::string& kind, std::uint64_t n) {
  if (is_blue(kind)) return std::min<std::uint64_t>(20'000, (std::uint64_t{1} << 25) / (n * n));
  return std::max<std::uint64_t>(400, (std::uint64_t{1} << 19) / n);
}

/// The root of the mean square error, and the CPU seconds of an estimate.
struct Cost {
  Number rmse, seconds;
};
Cost cost_of(const std::string& kind, const std::string& scene, std::uint64_t n) {
  const auto ask = [&](std::uint64_t count) {
    std::vector<std::uint64_t> seeds(count);
    for (std::uint64_t i = 0; i < count; ++i) seeds[i] = i;
    return TRY_MEASURE(estimates, kind, scene, {}, 1, 0, n, seeds);
  };
  const auto one = ask(1), many = ask(replicates_of(kind, n));
  if (!one || !many) return {};
  const double exact = known_scene(scene, {}).exact;
  double squares = 0;
  for (const double value : many->value) squares += (value - exact) * (value - exact);
  const auto count = static_cast<double>(many->value.size());
  const double seconds = (many->cpu_seconds - one->cpu_seconds) / (count - 1);
  return {std::sqrt(squares / count), seconds > 0 ? Number(seconds) : Number{}};
}

/// Columns: samples, and of each kind error and microseconds.
TEST_CASE("plot the error of scenes", "[.plot]") {
  for (const std::string scene : {"rect_light", "pixel_edge", "motion_edge", "pixel_time_lens"}) {
    auto file = plot_file("error-" + scene + ".tsv");
    for (std::uint64_t n = 16; n <= 4096; n *= 4) {
      Row row{static_cast<double>(n)};
      for (const std::string kind : kinds) {
        // Without a next2() blue noise is stratified; with 4096 points it takes a second.
        const bool left_out = is_blue(kind) && (scene == "motion_edge" || n > 1024);
        const Cost cost = left_out ? Cost{} : cost_of(kind, scene, n);
        row.push_back(cost.rmse);
        row.push_back(cost.seconds ? Number(1e6 * *cost.seconds) : Number{});
      }
      plot_row(file, row);
    }
  }
}

/// Nanoseconds for one of the `dims` coordinates of one of n samples.
Number nanoseconds(const std::string& kind, unsigned by, std::uint64_t dims, std::uint64_t n) {
  const auto round = seconds_a_round(
      [&](std::uint64_t rounds) -> Number {
        const auto got = TRY_MEASURE(repeat, kind, by, dims, n, rounds);
        if (!got) return {};
        return got->cpu_seconds;
      },
      0.02);
  if (!round) return {};
  return 1e9 * *round / static_cast<double>(n * dims);
}

/// A row for each kind: four dimensions by next2(), generation alone and all of it.
TEST_CASE("plot what a coordinate costs", "[.plot]") {
  for (const std::uint64_t n : {16, 256, 4096}) {
    auto file = plot_file("cost-" + std::to_string(n) + ".tsv");
    for (const std::string kind : kinds) {
      const bool left_out = is_blue(kind) && n > 256;
      plot_row(file, left_out ? Row{Number{}, Number{}}
                              : Row{nanoseconds(kind, 0, 4, n), nanoseconds(kind, 2, 4, n)});
    }
  }
}

/// With 256 samples: columns dimensions, and of each kind by next() and by next2().
TEST_CASE("plot what a coordinate costs against dimensions", "[.plot]") {
  auto file = plot_file("dimensions.tsv");
  for (const std::uint64_t dims : {2, 4, 8}) {
    Row row{static_cast<double>(dims)};
    for (const std::string kind : kinds) {
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
  for (std::size_t k = 0; k < std::size(kinds); ++k) {
    const auto got = TRY_MEASURE(render, kinds[k], "penumbra", image_width, image_height, spp, 1);
    script << "drawn[" << k + 1 << "] = \"";
    if (got) {
      const Errors errors =
          write_with_error(kinds[k] + std::string("-samplers"), got->value, exact);
      range = std::max(range, errors.large);
      script.precision(3);
      script << kinds[k] << "\\nRMSE " << errors.rmse;
    }
    script << "\"\n";
  }
  script << "range = " << range << '\n';
}

}  // namespace
}  // namespace mc::checks
