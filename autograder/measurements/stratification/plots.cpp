// The data of lab 3's plots and demo: patterns, a picture, errors against N with the variance that
// is left within the strata, what stopping early costs, and time against error.

#include <cmath>

#include "checks/support/catch.hpp"
#include "checks/support/exact_stratified.hpp"
#include "measurements/stratification/methods.hpp"
#include "measurements/support/plot_data.hpp"

namespace mc::measurements {
namespace {

/// The RMSE's own standard error is 3.5 to 7 % of it, and a mark is as wide.
Count replicates(Count n) {
  return std::clamp<Count>((1u << 17) / n, 100, 400);
}

/// Errors against N. For the same N, the two lines of theory: by chance, and by strata, where the
/// error falls as N^-rate; and the fraction of the variance that the first method leaves within the
/// strata. What is exact of one point in each of n strata comes from `over`.
void plot_case(const std::string& name, const Integrand& integrand, Names keys, const Values& sizes,
               double rate, const std::function<WithinStrata(Count n)>& over) {
  const Method& stratified = methods[keys[0]];
  keys.push_back("independent");
  plot_errors({name}, {integrand}, methods.of(keys), sizes, replicates);
  const double whole = over(1).variance[0], largest = sizes.back();
  const double last = std::sqrt(stratified_variance(over(static_cast<Count>(largest))));
  auto file =
      plot_file("within-" + name + ".tsv", {"N", "exact", "measured", "by_chance", "by_strata"});
  for (const double size : sizes) {
    const auto n = static_cast<Count>(size);
    const double square = errors_of(stratified, integrand, n, replicates(n), n).moment(2);
    plot_row(file, {size, stratified_variance(over(n)) * size / whole, square * size / whole,
                    std::sqrt(whole / size), last * std::pow(size / largest, -rate)});
  }
}

WithinStrata line_strata(Count n) {
  return strata_of([](double x) { return std::exp(x); }, n);
}
WithinStrata square(const WithinStrata& axis) {
  return product_of(axis, axis);
}
const Names plane{"jittered", "latin_hypercube", "multi_jittered"};

TEST_CASE("plot the error against N on the line", "[.plot]") {
  plot_case("line", integrand("smooth 1D"), {"stratified"}, powers(1, 2, 1024), 1.5, line_strata);
}
TEST_CASE("plot the error against N in the plane", "[.plot]") {
  plot_case("plane", integrand("bump"), plane, powers(1, 4, 4096), 1, [](Count n) {
    return square(strata_of([](double x) { return std::exp(-x * x); }, root(n, 2)));
  });
}
TEST_CASE("plot the error against N across an edge", "[.plot]") {
  const double where = 0.1;  // that of lab 3's experiments (exact_stratified.hpp)
  const Integrand edge{
      "edge", 2, mean_of(edge_strata(where, 1)), [=](View x) {
        return std::cos(1.0) * (x[0] - 0.5) + std::sin(1.0) * (x[1] - 0.5) < where ? 1.0 : 0.0;
      }};
  plot_case("edge", edge, plane, powers(1, 4, 4096), 0.75,
            [=](Count n) { return edge_strata(where, root(n, 2)); });
}
TEST_CASE("plot the error against N in four dimensions", "[.plot]") {
  plot_case("four", integrand("smooth 4D"), {"jittered_nd", "padded", "latin_hypercube"},
            {1, 16, 81, 256, 625, 1296, 2401, 4096}, 0.75,
            [](Count n) { return square(square(line_strata(root(n, 4)))); });
}

TEST_CASE("plot what stopping early costs", "[.plot]") {
  plot_table("early.tsv", {"N", {1,   2,   4,   8,   16,  32,  64,   128,  256,  384,
                                 512, 640, 768, 896, 960, 992, 1008, 1016, 1020, 1024}},
             methods.of({"independent", "jittered", "padded"}), [&](Count n, const Method& method) {
               return errors_of(method, integrand("bump"), 1024, 128, n, n).rmse();
             });
}

TEST_CASE("plot patterns of 64 points", "[.plot]") {
  plot_points("patterns",
              methods.of({"independent", "jittered", "latin_hypercube", "multi_jittered"}), 64, 1);
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

TEST_CASE("plot time against error", "[.plot][time]") {
  plot_speed(methods.of({"textbook", "independent", "jittered", "padded", "jittered_nd",
                         "latin_hypercube", "multi_jittered"}),
             integrand("bump"), 1024, 128);  // 16 KB: in the first-level cache
}

TEST_CASE("demo", "[.demo]") {
  demo_points(3, methods.of({"jittered", "latin_hypercube", "multi_jittered"}));
}

}  // namespace
}  // namespace mc::measurements
