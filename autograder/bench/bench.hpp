#pragma once
// Speed against error: measured rows (protocol/rows.hpp), and the page that is made of them.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "judge/checkout/layout.hpp"
#include "judge/pictures/gnuplot.hpp"
#include "protocol/rows.hpp"

namespace mc::grader {

struct Bench {
  std::string machine;                  ///< processor, compiler, version, …
  std::vector<protocol::Row> rows;      ///< of submissions and libraries, by their programs
  std::vector<protocol::Row> samplers;  ///< by bench_ratios: all samplers in one process
  std::vector<protocol::Comparison> ratios, baseline;  ///< with AVX2, and for any x86-64
};

/// One sampler on one integrand.
struct Curve {
  std::string method, integrand;
  struct Point {
    double n = 0, rmse = 0, ns = 0;  ///< of each sample
    double seconds() const { return n * ns * 1e-9; }
  };
  std::vector<Point> points;  ///< by n
};
/// Those of rows that have both an error and a time.
std::vector<Curve> curves_of(const std::vector<protocol::Row>& rows);
/// Null if there is none.
const Curve* find_curve(const std::vector<Curve>& curves, const std::string& method,
                        const std::string& integrand);

/// Seconds until the error is `target`.
struct TimeToTarget {
  double seconds = 0;
  enum {
    between,  ///< two sizes: interpolated linearly in the logarithms
    or_less,  ///< the first size is good enough
    by_law    ///< no size is, but the error of independent points falls as N^-1/2
  } how = between;
};
/// Nothing if no size is good enough.
std::optional<TimeToTarget> time_to(const Curve& curve, double target);

/// The error of as many samples as fit into a time, interpolated in the same way; NaN if none fits,
/// or more than were measured.
double error_within(const Curve& curve, double seconds);

/// 1 / (MSE · time) of a point of a curve, relative to that of as many independent points.
double efficiency(const std::vector<Curve>& curves, const Curve& curve, const Curve::Point& point);

/// The page: `outline` (autograder/bench/page.md) with its tables, and its pictures from `pictures`
/// (a path as the page links it).
std::string bench_page(const Bench& bench, const std::string& outline,
                       const std::filesystem::path& pictures);
/// The tables of what was measured, for a terminal.
std::string bench_summary(const Bench& bench);
/// Draws the pictures into `place`.
Plots draw_bench(const Layout& layout, const Bench& bench, const std::filesystem::path& place);

}  // namespace mc::grader
