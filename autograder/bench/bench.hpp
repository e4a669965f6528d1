#pragma once
// Speed against error: measured rows (protocol/rows.hpp), and what is computed from them.

#include <cstdint>
#include <filesystem>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "grader/checkout/labs.hpp"
#include "grader/checkout/layout.hpp"
#include "grader/pictures/gnuplot.hpp"
#include "protocol/rows.hpp"

namespace mc::grader {

/// One number. Times are medians over rounds, with half the interquartile range as error.
struct BenchRow : protocol::Row {
  std::string lab, submission;
};

/// A ratio of autograder/bench/ratios.
struct Ratio {
  std::string name, against;
  double wanted = 0;                      ///< 0: none
  double ratio = 0, ours = 0, other = 0;  ///< nanoseconds
};

/// A library's adapter, and its reasons for the checks that it fails.
struct Peer {
  std::string library, lab, what;
  struct Failure {
    std::vector<std::string> checks;
    std::string because;
  };
  std::vector<Failure> failures;
  bool installed = false;
};

struct Bench {
  std::string processor, system, compiler, flags, version;
  unsigned cores = 0, rounds = 0;
  double seconds = 0;
  bool whole = true;  ///< false: interrupted, or not of all labs
  std::vector<BenchRow> rows;
  std::vector<Ratio> ratios, baseline;  ///< with AVX2, and for any x86-64
  std::vector<Peer> peers;

  /// The rows of a kind.
  std::vector<BenchRow> of(const std::string& kind) const;
};

/// One sampler of one submission on one integrand.
struct Curve {
  std::string lab, submission, what, on;
  std::uint64_t dims = 0;
  double variance = std::numeric_limits<double>::quiet_NaN();  ///< of the integrand's values
  struct Point {
    double n = 0, rmse = 0, error = 0;  ///< standard error of the RMSE
    double sample = 0, integrand = 0;   ///< nanoseconds each
    double efficiency = 0;              ///< 1 / (MSE time) relative to independent sampling; or NaN
    double seconds() const { return n * (sample + integrand) * 1e-9; }
  };
  std::vector<Point> points;
};
std::vector<Curve> curves_of(const Bench& bench);

/// Seconds until the error is `target`.
struct TimeToTarget {
  double seconds = 0;
  enum {
    between,  ///< two sizes: interpolated linearly in the logarithms
    or_less,  ///< the first size is good enough
    /// No size is, but independent points need a known number: variance / target^2.
    by_law
  } how = between;
};
/// Nothing if no size is good enough.
std::optional<TimeToTarget> time_to(const Curve& curve, double target);

/// The least-squares slope of log(value) over log(size), and its standard error.
struct Exponent {
  double slope = 0, error = 0;
};
std::optional<Exponent> exponent_of(const std::vector<std::pair<double, double>>& points);

/// The median time of an algorithm for n values, in nanoseconds each; or NaN.
double time_of(const Bench& bench, const std::string& submission, const std::string& what,
               const std::string& on, std::uint64_t n);

/// Reads the rows of one case.
std::vector<BenchRow> read_bench_rows(const std::filesystem::path& file, const std::string& lab,
                                      const std::string& submission);

/// Of an even number of values, the mean of the two in the middle.
double median(std::vector<double> values);

/// Medians of rows that were measured in several rounds.
std::vector<BenchRow> medians(const std::vector<BenchRow>& rows);

/// Libraries that implement the labs' interfaces, installed or not.
std::vector<Peer> peers_of(const Layout& layout, const std::vector<Lab>& labs);

std::string bench_csv(const Bench& bench);
std::string bench_json(const Bench& bench);
/// The page: `outline` (autograder/bench/page.md) with its tables, and its pictures from `pictures`
/// (a path as the page links it).
std::string bench_page(const Bench& bench, const std::string& outline,
                       const std::filesystem::path& pictures);
/// The tables that labs' cases filled (rows of kind "table TITLE"), each below its title.
std::string bench_tables(const Bench& bench);
/// The first tables of the page, and those above, for a terminal.
std::string bench_summary(const Bench& bench);
/// Draws the pictures into `place`.
Plots draw_bench(const Layout& layout, const Bench& bench, const std::filesystem::path& place);

/// Writes labs/N-name/speed.tsv of each lab: the solutions' times for its speed tasks.
void calibrate(const Context& context, const std::vector<Lab>& labs, unsigned rounds);

}  // namespace mc::grader
