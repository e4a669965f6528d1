// The evaluation of bench rows.

#include <cmath>
#include <limits>
#include <regex>
#include <set>
#include <sstream>
#include <utility>

#include "bench/bench.hpp"
#include "measurements/support/error_sums.hpp"
#include "measurements/support/integrands.hpp"
#include "tests/submissions.hpp"

namespace mc::grader {
namespace {

/// Errors c / n at 2 ns per sample, integrand included.
Curve falling(double c) {
  Curve curve{"lab", "anna", "points", "g", 2, 1.0, {}};
  for (double n = 16; n <= 65536; n *= 4) curve.points.push_back({n, c / n, 0, 1.5, 0.5, 0});
  return curve;
}

TEST_CASE("the time to an error is interpolated, or follows the law of independent points") {
  const Curve curve = falling(1);
  Curve independent = curve;
  independent.what = "independent";
  const struct {
    const Curve& curve;
    double error;
    decltype(TimeToTarget::between) how;
    double seconds;
  } cases[] = {{curve, 1e-3, TimeToTarget::between, 2e-6},               // n = 1000, 2 ns each
               {curve, 0.5, TimeToTarget::or_less, 16 * 2e-9},           // the first size or less
               {independent, 1e-6, TimeToTarget::by_law, 1e12 * 2e-9}};  // variance 1 over 1e-12
  for (const auto& one : cases) {
    CAPTURE(one.error);
    const auto when = time_to(one.curve, one.error);
    REQUIRE(when);
    CHECK(when->how == one.how);
    CHECK(when->seconds == Approx(one.seconds));
  }
  CHECK_FALSE(time_to(curve, 1e-6));  // below all sizes
}

TEST_CASE("an exponent is the slope of the logarithms") {
  const auto exponent = exponent_of({{10, 300}, {100, 3000 * std::sqrt(10)}, {1000, 300000}});
  REQUIRE(exponent);
  CHECK(exponent->slope == Approx(1.5));
  CHECK(exponent->error == Approx(0).margin(1e-9));
  CHECK_FALSE(exponent_of({{1, 1}, {2, 2}}));
}

/// Rows of a sampler at n = 64 and 256, with errors c / sqrt(n) and a time on that integrand.
void add_rows(Bench& bench, const std::string& what, double c, double nanoseconds) {
  for (const std::uint64_t n : {64u, 256u}) {
    const double rmse = c / std::sqrt(static_cast<double>(n));
    bench.rows.push_back({{"error", what, "a scene", 2, n, rmse, 0}, "sampler", "solutions"});
  }
  bench.rows.push_back({{"time", what, "a scene", 2, 64, nanoseconds, 0}, "sampler", "solutions"});
}

TEST_CASE("efficiency is relative to independent points, by their exact variance if it is known") {
  Bench bench;
  add_rows(bench, "independent", 1, 10);
  add_rows(bench, "better", 0.1, 20);  // a hundredth of the squared error in twice the time
  for (const Curve& curve : curves_of(bench)) {
    for (const auto& point : curve.points) {
      CHECK(point.efficiency == Approx(curve.what == "better" ? 50 : 1));
    }
  }
  Bench known;
  add_rows(known, "independent", 1, 10);
  known.rows.push_back({{"variance", "a scene", "", 2, 0, 4, 0}, "lab", "solutions"});
  const auto curves = curves_of(known);
  REQUIRE(curves.size() == 1);
  CHECK(curves[0].points[0].efficiency == Approx(4));  // by chance twice as good as expected
}

TEST_CASE("rounds of the same row become their median") {
  std::vector<BenchRow> rows(5, {{"time", "points", "", 2, 64, 0, 0}, "lab", "anna"});
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i].value = static_cast<double>(i * i);
  rows.push_back({{"time", "points", "", 2, 256, 7, 0}, "lab", "anna"});
  const auto all = medians(rows);
  REQUIRE(all.size() == 2);
  CHECK(all[0].value == 4);
  CHECK(all[1].value == 7);
}

TEST_CASE("a truncated row is left out") {
  const tests::Scratch place;
  const auto rows = read_bench_rows(
      place.write("rows.tsv", "time\tpoints\t\t2\t64\t1.5\tnan\ntime\tpoints\t\t2"), "lab", "anna");
  REQUIRE(rows.size() == 1);
  CHECK(rows[0].n == 64);
  CHECK(rows[0].value == 1.5);
}

TEST_CASE("a table has its rows and columns in their order of arrival") {
  Bench bench;
  const auto cell = [&](const char* row, const char* column, double value, double error) {
    bench.rows.push_back(
        {{"table of digits", row, column, 0, 0, value, error}, "lab", "solutions"});
  };
  const double none = std::numeric_limits<double>::quiet_NaN();
  cell("second", "b", 0.00012345, none);
  cell("first", "a", 0.0999, 0.00999);  // rounded up into the next power of ten
  cell("second", "a", 12.3, 0.123);
  cell("third", "a", 52, 20);  // so uncertain that the cell shows its error
  bench.rows.push_back({{"table of digits", "first", "a", 0, 0, 0.25, none}, "lab", "mine"});
  bench.rows.push_back({{"table of digits", "law, exact", "b", 0, 0, 3, none}, "lab", "mine"});
  bench.rows.push_back({{"error", "no", "table", 0, 0, 1, none}, "lab", "solutions"});
  CHECK(bench_tables(bench) ==
        "of digits (± 10 % at most)\n\n"
        "| | b | a |\n|---|--:|--:|\n"
        "| second | 1.2e-4 | 12 |\n"
        "| first | | 1.0e-1 |\n"
        "| third | | 52 ± 20 |\n"
        "| first, mine | | 0.25 |\n"
        "| law, exact | 3.0 | |\n");
  CHECK(bench_tables({}).empty());
}

TEST_CASE("sums of errors give RMSE and kurtosis, with standard errors") {
  measurements::ErrorSums errors;
  for (const double error : {3.0, -1.0, 1.0, -1.0}) errors.add(error);
  CHECK(errors.rmse() == Approx(std::sqrt(3)));      // of 12 / 4
  CHECK(errors.kurtosis() == Approx(84.0 / 4 / 9));  // the mean of fourths over that squared
  CHECK(errors.standard_error() == Approx(std::sqrt((21.0 - 9) / 4) / (2 * std::sqrt(3))));
  // The kurtosis is 7/3. The error 3 moves it by 9 - 14 + 7/3 = -8/3, each of the others by 8/9.
  CHECK(errors.kurtosis_error() == Approx(std::sqrt((64. / 9 + 3 * 64. / 81) / 4 / 4)));
}

/// By a midpoint rule in one and two dimensions: its error is h^2/24 times second derivatives (at
/// most 2 e^2 in the table) where g is smooth: 2e-7. Along an edge it is at most one cell
/// each, in some of at most 4 side cells, with either sign.
TEST_CASE("the integrands of bench and plots have the stated mean and variance") {
  for (const measurements::Integrand& one : measurements::integrands()) {
    if (one.dims > 2) continue;
    const int side = one.dims == 1 ? 100000 : 2000;
    double sum = 0, squares = 0;
    for (int i = 0; i < side; ++i) {
      for (int j = 0; j < (one.dims == 1 ? 1 : side); ++j) {
        const double x[] = {(i + 0.5) / side, (j + 0.5) / side};
        const double value = one.g({x, one.dims});
        sum += value;
        squares += value * value;
      }
    }
    const double n = std::pow(side, static_cast<double>(one.dims)), mean = sum / n;
    CAPTURE(one.name);
    CHECK(std::abs(mean - one.mean) < 5e-5);
    if (std::isnan(one.variance)) continue;
    CHECK(squares / n - mean * mean == Approx(one.variance).epsilon(1e-3));
  }
}

/// The table of labs/common/draw.gp: "jittered = 3; set style line 3 lc rgb "#0072B2" lw 2 pt 6 …".
TEST_CASE("no two methods share a color and a mark in plots") {
  const Layout layout = read_layout();
  std::istringstream script(read_text(layout.labs() / "common" / "draw.gp"));
  std::set<std::string> numbers, looks;
  const std::regex row(
      "([a-z_]+) = ([0-9]+); +set style line +([0-9]+) lc rgb (\"#[0-9A-F]+\").* pt ([0-9]+) .*");
  std::smatch found;
  for (std::string line; std::getline(script, line);) {
    if (!std::regex_match(line, found, row)) continue;
    CAPTURE(line);
    CHECK(found[2] == found[3]);
    CHECK(numbers.insert(found[2]).second);
    CHECK(looks.insert(found[4].str() + found[5].str()).second);
  }
  CHECK(numbers.size() > 15);
  // A plot takes styles by name.
  for (const Lab& lab : find_labs(layout)) {
    CAPTURE(lab.name);
    const std::string plots = read_text(layout.labs() / lab.folder / "plots.gp");
    CHECK_FALSE(std::regex_search(plots, std::regex(" ls [0-9]")));
  }
}

}  // namespace
}  // namespace mc::grader
