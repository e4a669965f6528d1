// Generates the page from one run.

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "bench/bench.hpp"
#include "judge/base/replace.hpp"
#include "measurements/support/markdown.hpp"

namespace mc::grader {
namespace {

using protocol::Comparison;
using protocol::Row;
using Names = std::vector<std::string>;

/// Errors this close are equal: four standard errors (bench/ratios/samplers.cpp).
constexpr double noise = 1.05;

/// "0.83 µs", "12 ms"
std::string duration(double seconds) {
  const std::pair<double, const char*> units[] = {
      {1e-9, "ns"}, {1e-6, "µs"}, {1e-3, "ms"}, {1, "s"}};
  const auto* unit = units;
  while (unit + 1 != std::end(units) && seconds >= 999.5 * unit->first) ++unit;
  return two_digits(seconds / unit->first) + ' ' + unit->second;
}

std::string number(double value) {
  if (std::isnan(value)) return "";
  return value < 9999.5 ? two_digits(value) : fmt::format("{:.0e}", value);
}

std::string reached(const Curve* curve, double target) {
  if (curve == nullptr) return "";
  const auto when = time_to(*curve, target);
  if (!when) return "not reached";
  if (when->how == TimeToTarget::by_law) return '(' + duration(when->seconds) + ')';
  return (when->how == TimeToTarget::or_less ? "≤ " : "") + duration(when->seconds);
}

/// The point with n samples; or with the most below, if there is none.
const Curve::Point* at(const Curve* curve, double n) {
  const Curve::Point* best = nullptr;
  for (std::size_t i = 0; curve != nullptr && i < curve->points.size(); ++i) {
    if (curve->points[i].n <= 1.1 * n) best = &curve->points[i];  // Poisson disks come close
  }
  return best;
}
double error_at(const std::vector<Curve>& curves, const std::string& method,
                const std::string& integrand, double n) {
  const Curve::Point* const point = at(find_curve(curves, method, integrand), n);
  return point == nullptr || point->n != n ? protocol::unknown : point->rmse;
}

/// The values of a field of all curves, in their order.
Names all_of(const std::vector<Curve>& curves, std::string Curve::*field) {
  Names names;
  for (const Curve& curve : curves) enlist(names, curve.*field);
  return names;
}

const Names ours{"independent", "stratified", "blue_noise", "halton", "sobol", "lattice"};
bool is_ours(const std::string& sampler) {
  return std::ranges::find(ours, sampler) != ours.end();
}

/// The errors of all samplers on a function in the time that `sobol` takes for n samples, if each
/// sample takes `more` nanoseconds more.
struct Race {
  double seconds = protocol::unknown;
  std::vector<std::pair<std::string, double>> errors{};  ///< NaN: not even one sample fits
  /// The least error of the samplers that are `among`, and the samplers that have it.
  template <class Among>
  std::pair<double, Names> best(Among among) const {
    double least = INFINITY;
    for (const auto& [name, error] : errors) {
      if (among(name)) least = std::fmin(least, error);
    }
    Names names;
    for (const auto& [name, error] : errors) {
      if (among(name) && error <= noise * least) names.push_back(name);
    }
    return {least, names};
  }
};
Race race(std::vector<Curve> curves, const std::string& function, double n, double more) {
  for (Curve& curve : curves) {
    for (auto& point : curve.points) point.ns += more;
  }
  const Curve::Point* const sobol = at(find_curve(curves, "sobol", function), n);
  Race all;
  if (sobol == nullptr) return all;
  all.seconds = sobol->seconds();
  for (const Curve& curve : curves) {
    if (curve.integrand != function) continue;
    all.errors.emplace_back(
        curve.method, curve.method == "sobol" ? sobol->rmse : error_within(curve, all.seconds));
  }
  return all;
}
constexpr double race_sizes[] = {4, 16, 64};

/// What the samples of a renderer may cost at least.
constexpr double tracing = 100;

std::string which_sampler(const Bench& bench) {
  const auto curves = curves_of(bench.samplers);
  Markdown table("scene");
  for (const std::string& function : all_of(curves, &Curve::integrand)) {
    std::string times;
    for (const double n : race_sizes) {
      const Race one = race(curves, function, n, tracing);
      const auto [least, first] = one.best([](auto&) { return true; });
      const auto [error, own] = one.best(is_ours);
      std::string& cell = table.cell(function, fmt::format("N = {}", n));
      cell = fmt::format("{} {}", fmt::join(own, ", "), two_digits(error));
      if (error > noise * least) {
        cell += fmt::format(" ({} {})", fmt::join(first, ", "), two_digits(least));
      }
      times += (times.empty() ? "" : ", ") + number(one.seconds * 1e6);
    }
    table.cell(function, "µs") = times;
  }
  return table.text();
}

std::string equal_time(const Bench& bench) {
  const auto curves = curves_of(bench.samplers);
  Markdown table("scene, N of `sobol`");
  for (const std::string& function : all_of(curves, &Curve::integrand)) {
    for (const double n : race_sizes) {
      const Race one = race(curves, function, n, 0);
      const auto [least, first] = one.best([](auto&) { return true; });
      for (const auto& [name, error] : one.errors) {
        const bool wins = std::ranges::find(first, name) != first.end();
        table.cell(fmt::format("{}, {}", function, n), name) =
            wins ? "**" + number(error) + "**" : number(error);
      }
    }
  }
  return table.text();
}

/// Rows are functions and numbers of samples; the last column is the error of the best of the
/// others, divided by that of the first.
std::string equal_samples(const std::vector<Curve>& curves, const Names& functions,
                          const std::vector<double>& sizes, const Names& samplers,
                          const std::string& last) {
  Markdown table("scene, N");
  for (const std::string& function : functions) {
    for (const double n : sizes) {
      const std::string row = fmt::format("{}, {}", function, n);
      double others = INFINITY;
      for (const std::string& sampler : samplers) {
        const double error = error_at(curves, sampler, function, n);
        table.cell(row, sampler) = number(error);
        if (sampler != samplers[0]) others = std::fmin(others, error);
      }
      table.cell(row, last) = number(others / error_at(curves, samplers[0], function, n));
    }
  }
  return table.text();
}

std::string one_minute(const std::vector<Curve>& curves) {
  std::vector<std::pair<double, const Curve*>> order;
  for (const Curve& curve : curves) {
    if (curve.integrand != "smooth 2D" || at(&curve, 4096) == nullptr) continue;
    const auto when = time_to(curve, 1e-3);
    order.emplace_back(when ? when->seconds : 1e9 * curve.points.back().rmse, &curve);
  }
  std::ranges::stable_sort(order, {}, [](const auto& one) { return one.first; });
  Markdown table("sampler");
  for (const auto& [key, plane] : order) {
    const Curve::Point& point = *at(plane, 4096);
    // Jittered points of four dimensions are padded ones.
    const std::string padded =
        "jittered, padded" +
        plane->method.substr(plane->method.starts_with("jittered") ? 8 : plane->method.size());
    const std::string many = plane->method.starts_with("jittered") ? padded : plane->method;
    const auto cell = [&, row = plane->method](const char* column) -> std::string& {
      return table.cell(row, column);
    };
    cell("ns per sample") = number(point.ns);
    cell("smooth 2D to $10^{-3}$") = reached(plane, 1e-3);
    cell("edge 2D to $10^{-3}$") = reached(find_curve(curves, plane->method, "edge 2D"), 1e-3);
    cell("smooth 4D to $10^{-3}$") = reached(find_curve(curves, many, "smooth 4D"), 1e-3);
    cell("efficiency") = number(efficiency(curves, *plane, point));
  }
  return table.text();
}

/// The errors at 4,096 samples, or the most below.
std::string errors(const std::vector<Curve>& curves) {
  Markdown table("sampler");
  for (const Curve& curve : curves) {
    const Curve::Point* const point = at(&curve, 4096);
    if (point == nullptr) continue;
    table.cell(curve.method, curve.integrand) =
        number(point->rmse) + (point->n < 4000 ? fmt::format(" (N = {})", point->n) : "");
  }
  return table.text();
}

std::string ratios(const Bench& bench) {
  Markdown table("what");
  for (const Comparison& one : bench.ratios) {
    const auto cell = [&, row = one.task + ", against " + one.against](
                          const char* column) -> std::string& { return table.cell(row, column); };
    cell("ns") = fmt::format("{:.2f}", one.ns);
    cell("of the other") = fmt::format("{:.2f}", one.other);
    cell("ratio") = number(one.ratio);
    cell("range") = number(one.low) + " to " + number(one.high);
    for (const Comparison& other : bench.baseline) {
      if (other.task != one.task || other.against != one.against) continue;
      cell("without AVX2") = number(other.ratio);
    }
  }
  return table.text();
}

/// Ways to a variance: correct decimal digits, and nanoseconds per value.
std::string variances(const Bench& bench) {
  Markdown table("way");
  for (const Row& row : bench.rows) {
    if (row.lab != "variance") continue;
    table.cell(row.method, std::isnan(row.rmse) ? "ns, " + row.integrand : row.integrand) =
        std::isnan(row.rmse) ? number(row.ns)
                             : fmt::format("{:.1f}", std::fabs(std::log10(row.rmse)));
  }
  return table.text();
}

/// The rows of samplers on scenes, in lab 6; and those of points on integrands.
std::vector<Curve> curves_of(const Bench& bench, bool on_scenes) {
  auto rows = bench.rows;
  std::erase_if(rows, [&](const Row& row) { return (row.lab == "sampler") != on_scenes; });
  return grader::curves_of(rows);
}

}  // namespace

std::string bench_summary(const Bench& bench) {
  std::string all;
  const auto points = curves_of(bench, false), scenes = curves_of(bench, true);
  const auto add = [&](bool is_there, const char* title, const std::string& table) {
    if (is_there) all += fmt::format("{}\n\n{}\n", title, table);
  };
  add(!bench.samplers.empty(), "Which sampler", which_sampler(bench));
  add(!points.empty(), "Time to an error, integrand included", one_minute(points));
  add(!points.empty(), "RMSE of 4096 samples, relative", errors(points));
  add(!scenes.empty(), "RMSE of 4096 samples of a scene, relative", errors(scenes));
  add(variances(bench).find("1.") != std::string::npos, "Correct digits of a variance",
      variances(bench));
  add(!bench.ratios.empty(), "Speed tasks against other code", ratios(bench));
  return all;
}

std::string bench_page(const Bench& bench, const std::string& outline,
                       const std::filesystem::path& pictures) {
  const auto points = curves_of(bench, false);
  const auto samplers = curves_of(bench.samplers);
  const std::pair<const char*, std::string> parts[] = {
      {"run", bench.machine},
      {"which sampler", which_sampler(bench)},
      {"equal time", equal_time(bench)},
      {"other sizes",
       equal_samples(samplers, {"random half-planes", "random disks"}, {10, 16, 64, 100},
                     {"stratified", "sobol", "halton"}, "best other / `stratified`")},
      {"dimensions",
       equal_samples(samplers, {"smooth 4D", "smooth 8D", "edge 4D", "edge 8D"}, {64, 256, 1024},
                     {"sobol", "stratified", "OpenQMC's pmj"}, "best padded / `sobol`")},
      {"one minute", one_minute(points)},
      {"errors", errors(points)},
      {"ratios", ratios(bench)},
      {"variance", variances(bench)},
      {"pictures", pictures.string()}};
  std::string page = outline;
  for (auto [name, text] : parts) {
    while (text.ends_with('\n')) text.pop_back();
    page = with_replacements(page, {{fmt::format("{{{{{}}}}}", name), text}});
  }
  return page;
}

}  // namespace mc::grader
