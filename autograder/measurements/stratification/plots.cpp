// The data of lab 3's plots and demo: patterns, a picture, errors against N with the variance that
// is left within the strata, what stopping early costs, and time against error.

#include <cmath>

#include "checks/support/catch.hpp"
#include "checks/support/exact_stratified.hpp"
#include "measurements/stratification/methods.hpp"
#include "measurements/support/demo.hpp"
#include "measurements/support/plot_data.hpp"

namespace mc::measurements {
namespace {

TEST_CASE("plot names", "[.plot]") {
  plot_names(methods);
}

/// An integrand of the plots, and what is exact of one point in each of n strata.
struct Case {
  std::string name;
  Integrand integrand;
  Names methods;             ///< the first has the strata
  std::vector<Count> sizes;  ///< N
  std::function<WithinStrata(Count)> over;
  double rate;  ///< the error falls as N^-rate
};

WithinStrata square(double (*h)(double), std::size_t side) {
  const auto axis = strata_of(h, side);
  return product_of(axis, axis);
}

/// The edge of lab 3's experiments (exact_stratified.hpp).
Integrand slanted_edge() {
  return {.name = "edge", .dims = 2, .mean = mean_of(edge_strata(0.1, 1)), .g = [](View x) {
            return std::cos(1.0) * (x[0] - 0.5) + std::sin(1.0) * (x[1] - 0.5) < 0.1 ? 1.0 : 0.0;
          }};
}

const std::vector<Case>& cases() {
  static const std::vector<Count> squares{1, 4, 16, 64, 256, 1024, 4096};
  static const Names plane{"jittered", "latin_hypercube", "multi_jittered"};
  static const std::vector<Case> all_cases{
      {"line",
       integrand("smooth 1D"),
       {"stratified"},
       {1, 2, 4, 8, 16, 32, 64, 128, 256, 512, 1024},
       [](Count n) { return strata_of([](double x) { return std::exp(x); }, n); },
       1.5},
      {"plane", integrand("bump"), plane, squares,
       [](Count n) { return square([](double x) { return std::exp(-x * x); }, root(n, 2)); }, 1},
      {"edge", slanted_edge(), plane, squares, [](Count n) { return edge_strata(0.1, root(n, 2)); },
       0.75},
      {"four",
       integrand("smooth 4D"),
       {"jittered_nd", "padded", "latin_hypercube"},
       {1, 16, 81, 256, 625, 1296, 2401, 4096},
       [](Count n) {
         const auto pair = square([](double x) { return std::exp(x); }, root(n, 4));
         return product_of(pair, pair);
       },
       0.75}};
  return all_cases;
}

/// The RMSE's own standard error is 3.5 to 7 % of it, and a mark is as wide.
Count replicates(Count n) {
  return std::clamp<Count>((1u << 17) / n, 100, 400);
}

/// Errors against N with the two lines of theory; and the fraction of the variance that the first
/// method leaves within the strata.
void plot_case(const Case& one) {
  const double whole = one.over(1).variance[0], largest = static_cast<double>(one.sizes.back());
  const double last = std::sqrt(stratified_variance(one.over(one.sizes.back())));
  Names keys = one.methods;
  keys.push_back("independent");
  plot_errors({.names = {one.name},
               .integrands = {one.integrand},
               .methods = methods_of(methods, keys),
               .sizes = one.sizes,
               .replicates = replicates,
               .more = {"by_chance", "by_strata"},
               .theory = [&](Count n) {
                 const auto size = static_cast<double>(n);
                 return Values{std::sqrt(whole / size), last * std::pow(size / largest, -one.rate)};
               }});
  auto file = plot_file("within-" + one.name + ".tsv", {"N", "exact", "measured"});
  for (const Count n : one.sizes) {
    const auto size = static_cast<double>(n);
    const double rmse =
        errors_of(method(methods, one.methods[0]), one.integrand, n, replicates(n), n).rmse();
    plot_row(file,
             {size, stratified_variance(one.over(n)) * size / whole, rmse * rmse * size / whole});
  }
}

TEST_CASE("plot the error against N on the line", "[.plot]") {
  plot_case(cases()[0]);
}
TEST_CASE("plot the error against N in the plane", "[.plot]") {
  plot_case(cases()[1]);
}
TEST_CASE("plot the error against N across an edge", "[.plot]") {
  plot_case(cases()[2]);
}
TEST_CASE("plot the error against N in four dimensions", "[.plot]") {
  plot_case(cases()[3]);
}

TEST_CASE("plot what stopping early costs", "[.plot]") {
  plot_table("early.tsv", {"N", {1,   2,   4,   8,   16,  32,  64,   128,  256,  384,
                                 512, 640, 768, 896, 960, 992, 1008, 1016, 1020, 1024}},
             methods_of(methods, {"independent", "jittered", "padded"}),
             [&](Count n, const Method& method) {
               return errors_of(method, integrand("bump"), 1024, 128, n, n).rmse();
             });
}

TEST_CASE("plot patterns of 64 points", "[.plot]") {
  plot_points("patterns",
              methods_of(methods, {"independent", "jittered", "latin_hypercube", "multi_jittered"}),
              64, 1);
}

TEST_CASE("plot a soft shadow with 16 samples a pixel", "[.plot]") {
  constexpr std::size_t width = 128, size = width * width;
  const auto shadow = [&](unsigned task, Count spp, Count seed) {
    const auto got = TRY_MEASURE(shadow, task, width, spp, seed);
    return lists_of(got, size, closed_unit).value_or(Values(size, missing));
  };
  const Values exact = shadow(7, 1024, 2);  // nearly: the error falls at least as N^-3/4
  const Names keys{"independent", "jittered", "multi_jittered"};
  auto file = plot_file("shadow-rmse.tsv", keys);
  Values rmse;
  for (const unsigned task : {0u, 3u, 7u}) {
    const Values pixels = shadow(task, 16, 1);
    plot_image("shadow-" + keys[rmse.size()] + ".tsv", pixels, width);
    ErrorSums errors;
    for (std::size_t i = 0; i < size; ++i) errors.add(pixels[i] - exact[i]);
    rmse.push_back(errors.rmse());
  }
  plot_row(file, rmse);
}

TEST_CASE("plot time against error", "[.plot]") {
  plot_speed(methods_of(methods, {"textbook", "independent", "jittered", "padded", "jittered_nd",
                                  "latin_hypercube", "multi_jittered"}),
             integrand("bump"), 1024, 128);  // 16 KB: in the first-level cache
}

TEST_CASE("demo", "[.demo]") {
  demo_points(3, methods_of(methods, {"jittered", "latin_hypercube", "multi_jittered"}));
}

}  // namespace
}  // namespace mc::measurements
