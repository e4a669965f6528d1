// The evaluation of bench rows, and the page.

#include <cmath>
#include <regex>
#include <set>
#include <sstream>

#include "bench/bench.hpp"
#include "measurements/support/error_sums.hpp"
#include "measurements/support/integrands.hpp"
#include "measurements/support/markdown.hpp"
#include "tests/submissions.hpp"

namespace mc::grader {
namespace {

using protocol::Row;

/// Rows with errors c n^-slope at `ns` per sample.
std::vector<Row> falling(const std::string& method, const std::string& integrand, double c,
                         double slope, double ns) {
  std::vector<Row> rows;
  for (const std::uint64_t n : {1u, 4u, 16u, 64u, 256u, 1024u, 4096u}) {
    const double rmse = c * std::pow(static_cast<double>(n), -slope);
    rows.push_back({"lab", method, "", integrand, 2, n, rmse, ns});
  }
  return rows;
}

TEST_CASE("rows become curves by method and integrand; what lacks a number is left out") {
  auto rows = falling("a", "g", 1, 1, 2);
  std::ranges::reverse(rows);
  rows.push_back({.method = "a", .integrand = "g", .n = 9, .rmse = 1});
  const auto more = falling("b", "g", 1, 1, 2);
  rows.insert(rows.end(), more.begin(), more.end());
  const auto curves = curves_of(rows);
  REQUIRE(curves.size() == 2);
  REQUIRE(curves[0].points.size() == 7);
  CHECK(curves[0].points[1].n == 4);
  CHECK(find_curve(curves, "b", "g") == &curves[1]);
  CHECK(find_curve(curves, "b", "h") == nullptr);
}

TEST_CASE("the time to an error is interpolated, or follows the law of independent points") {
  const Curve curve = curves_of(falling("points", "g", 1, 1, 2))[0];
  const Curve independent = curves_of(falling("independent, std", "g", 1, 0.5, 2))[0];
  const struct {
    const Curve& curve;
    double error;
    decltype(TimeToTarget::between) how;
    double seconds;
  } cases[] = {{curve, 1e-3, TimeToTarget::between, 2e-6},               // n = 1000, 2 ns each
               {curve, 2, TimeToTarget::or_less, 2e-9},                  // the first size or less
               {independent, 1e-6, TimeToTarget::by_law, 1e12 * 2e-9}};  // 1 / 1e-12 points
  for (const auto& one : cases) {
    CAPTURE(one.error);
    const auto when = time_to(one.curve, one.error);
    REQUIRE(when);
    CHECK(when->how == one.how);
    CHECK(when->seconds == Approx(one.seconds));
  }
  CHECK_FALSE(time_to(curve, 1e-6));                   // below all sizes
  CHECK(error_within(curve, 200e-9) == Approx(0.01));  // 100 samples
  CHECK(std::isnan(error_within(curve, 1e-9)));        // not one sample
}

TEST_CASE("efficiency is relative to independent points") {
  auto rows = falling("independent", "g", 1, 0.5, 10);
  const auto better = falling("better", "g", 0.1, 0.5, 20);  // a hundredth of the squared error
  rows.insert(rows.end(), better.begin(), better.end());
  const auto curves = curves_of(rows);
  CHECK(efficiency(curves, curves[0], curves[0].points[2]) == Approx(1));
  CHECK(efficiency(curves, curves[1], curves[1].points[2]) == Approx(50));
}

/// One of ours that is good, a library that is better for few samples, and one that is within
/// noise.
TEST_CASE("the page names the sampler that wins at equal time") {
  Bench bench;
  for (const auto& rows : {falling("sobol", "edge", 1, 1, 10), falling("halton", "edge", 1, 1, 40),
                           falling("OpenQMC's pmj", "edge", 0.4, 0.5, 10)}) {
    bench.samplers.insert(bench.samplers.end(), rows.begin(), rows.end());
  }
  bench.machine = "this machine";
  bench.ratios = {{"moments", "a loop", 1, 5, 5, 4, 6}};
  const std::string page = bench_page(
      bench, "{{run}}\n{{which sampler}}\n{{equal time}}\n{{ratios}}\n{{pictures}}/a.svg", "place");
  tests::check_contains(page, {"this machine", "place/a.svg",
                               "| edge | sobol 0.25 (OpenQMC's pmj 0.20) | sobol 6.2e-2 |",
                               "| edge, 64 | **1.6e-2** |",
                               "| moments, against a loop | 1.00 | 5.00 | 5.0 | 4.0 to 6.0 |"});
}

TEST_CASE("the page needs every table of its outline, and is short") {
  const Layout layout = read_layout();
  const std::string page =
      bench_page({}, read_text(layout.root / "autograder" / "bench" / "page.md"), "place");
  CHECK_FALSE(tests::contains(page, "{{"));
  const std::string written = read_text(layout.root / "docs" / "speed-against-error.md");
  CHECK(std::ranges::count(written, '\n') <= 350);
}

TEST_CASE("a table has its rows and columns in their order of arrival") {
  Markdown table("way");
  table.cell("second", "b") = two_digits(0.00012345);
  table.cell("first", "a") = two_digits(0.0999);  // rounded up into the next power of ten
  table.cell("second", "a") = two_digits(12.3);
  CHECK(table.text() ==
        "| way | b | a |\n|---|--:|--:|\n"
        "| second | 1.2e-4 | 12 |\n"
        "| first | | 1.0e-1 |\n");
}

TEST_CASE("the bench takes a file of the repository's submissions, and no other") {
  tests::check_refused(tests::lab({"bench", "variance", "solutions/variance.cpp", "--tables"}),
                       "solutions/variance.cpp is not in autograder/submissions");
  tests::check_refused(tests::lab({"bench", "variance", "missing.cpp"}),
                       "there is no file missing.cpp");
}

TEST_CASE("the bench prints tables of what it is given, each with its name", "[.slow]") {
  const std::string definitions = "alternatives/stratification/plain_definitions.cpp";
  REQUIRE_RUN(run, tests::lab({"bench", "autograder/submissions/" + definitions, "--tables"}));
  tests::check_contains(run.output, {"\nkurtosis of the error of exp(x + y) (",
                                     " % at most)\n\n| | N = 16 | N = 64 | N = 256 | N = 1024 |\n",
                                     " % at most), plain_definitions\n\n"});
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
