// The data of lab 4's plots: patterns, their periodograms as pictures and as curves, errors of
// integration beside those of random and jittered points, and time against N.

#include <array>
#include <cmath>
#include <functional>
#include <string>

#include <fmt/format.h>

#include "4-blue-noise/experiments.hpp"
#include "checks/support/catch.hpp"
#include "checks/support/data.hpp"
#include "checks/support/plot_data.hpp"

namespace mc::checks {
namespace {

using experiments::Patterns;
using experiments::Points;
using Maybe = std::optional<double>;

/// Ways to place points: the last three are the submission's.
constexpr std::array<const char*, 5> ways{"random", "jittered", "fixed", "candidates", "discs"};

double radius_for(std::size_t n) {  // so that about n points fill the square
  return 0.82 / std::sqrt(static_cast<double>(n));
}

Points jittered(Rng& rng, std::size_t side) {
  Points points;
  for (std::size_t i = 0; i < side * side; ++i) {
    points.x.push_back((static_cast<double>(i % side) + uniform(rng)) / static_cast<double>(side));
    points.y.push_back((static_cast<double>(i / side) + uniform(rng)) / static_cast<double>(side));
  }
  return points;
}

/// `sets` sets of about side^2 points; none where the submission has none.
std::vector<Points> patterns(std::string_view way, std::size_t side, std::size_t sets) {
  const std::size_t n = side * side;
  Rng rng(n);
  std::vector<Points> all;
  if (way == "random" || way == "jittered") {
    for (std::size_t set = 0; set < sets; ++set) {
      all.push_back(way == "jittered"
                        ? jittered(rng, side)
                        : Points{uniform_values(rng, n, 0, 1), uniform_values(rng, n, 0, 1)});
    }
    return all;
  }
  // c so small that there are ten candidates in the middle of the list: hardly more than a fixed
  // number of them.
  const auto got = way == "discs" ? TRY_MEASURE(poisson_disk, radius_for(n), sets, n)
                   : way == "fixed"
                       ? TRY_MEASURE(best_candidate, n, 20 / static_cast<double>(n), sets, n)
                       : TRY_MEASURE(best_candidate, n, 1, sets, n);
  if (!got) return all;
  std::size_t first = 0;
  for (const std::size_t size : got->value.sizes) {
    if (got->value.y.size() < first + size) break;
    const auto part = [&](const std::vector<double>& column) {
      const auto begin = column.begin() + static_cast<std::ptrdiff_t>(first);
      return std::vector<double>(begin, begin + static_cast<std::ptrdiff_t>(size));
    };
    all.push_back({part(got->value.x), part(got->value.y)});
    first += size;
  }
  return all;
}

TEST_CASE("plot patterns", "[.plot]") {
  for (const std::string way : ways) {
    auto file = plot_file("pattern-" + way + ".tsv");
    plot_row(file, std::array<Maybe, 2>{});  // so that there is a row to draw in any case
    for (const Points& points : patterns(way, 16, 1)) {
      for (std::size_t i = 0; i < points.x.size(); ++i) {
        plot_row(file, std::array{Maybe(points.x[i]), Maybe(points.y[i])});
      }
    }
  }
}

TEST_CASE("plot periodograms, as pictures and over rings", "[.plot]") {
  constexpr int kmax = 48, side = 2 * kmax + 1;
  constexpr std::size_t sets = 40;
  auto rings = plot_file("radial.tsv");
  std::array<std::vector<double>, ways.size()> radial;
  for (std::size_t w = 0; w < ways.size(); ++w) {
    std::vector<double> mean;
    for (const Points& points : patterns(ways[w], 16, sets)) {
      const auto power = TRY_MEASURE(periodogram, points.x, points.y, 1, kmax);
      if (!power) break;
      mean.resize(power->value.size());
      for (std::size_t k = 0; k < mean.size(); ++k) mean[k] += power->value[k] / sets;
    }
    auto file = plot_file(fmt::format("spectrum-{}.tsv", ways[w]));
    for (std::size_t row = 0; row < side; ++row) {
      std::array<Maybe, side> values;
      for (std::size_t i = 0; i < side && !mean.empty(); ++i) values[i] = mean[row * side + i];
      plot_row(file, values);
    }
    if (mean.empty()) continue;
    const auto means = TRY_MEASURE(radial_power, mean, kmax);
    if (means && means->value.size() == kmax + 1) radial[w] = means->value;
  }
  for (std::size_t ring = 1; ring <= kmax; ++ring) {
    std::array<Maybe, ways.size() + 1> row{static_cast<double>(ring) / 16};
    for (std::size_t w = 0; w < ways.size(); ++w) {
      if (!radial[w].empty()) row[w + 1] = radial[w][ring];
    }
    plot_row(rings, row);
  }
}

/// Two integrands of the unit square, with their integrals: a smooth one, and a slanted edge.
double bump(double x, double y) {
  return std::exp(-x * x - y * y);
}
constexpr double bump_integral = 0.557746285351034;  // (sqrt(pi)/2 erf(1))^2
double edge(double x, double y) {
  return y < 0.2 + 0.5 * x ? 1 : 0;
}
constexpr double edge_integral = 0.45;

TEST_CASE("plot error against N", "[.plot]") {
  const std::tuple<const char*, double (*)(double, double), double> integrands[] = {
      {"bump", bump, bump_integral}, {"edge", edge, edge_integral}};
  std::array<std::vector<std::array<Maybe, 6>>, 2> rows;
  for (const std::size_t side : {2u, 4u, 8u, 16u, 32u}) {
    constexpr std::size_t sets = 100;
    const auto n = static_cast<double>(side * side);
    for (auto& of : rows) of.push_back({n, 1 / std::sqrt(n)});
    std::size_t column = 2;
    for (const char* way : {"random", "jittered", "candidates", "discs"}) {
      const auto all = patterns(way, side, side == 32 && way[0] == 'c' ? 40 : sets);
      for (std::size_t f = 0; f < 2 && !all.empty(); ++f) {
        const auto& [name, g, integral] = integrands[f];
        double squares = 0;
        for (const Points& points : all) {
          double sum = 0;
          for (std::size_t i = 0; i < points.x.size(); ++i) sum += g(points.x[i], points.y[i]);
          const double error = sum / static_cast<double>(points.x.size()) - integral;
          squares += error * error / static_cast<double>(all.size());
        }
        rows[f].back()[column] = std::sqrt(squares);
      }
      ++column;
    }
  }
  for (std::size_t f = 0; f < 2; ++f) {
    auto file = plot_file(fmt::format("error-{}.tsv", std::get<0>(integrands[f])));
    for (const auto& row : rows[f]) plot_row(file, row);
  }
}

TEST_CASE("plot time against N", "[.plot]") {
  auto file = plot_file("speed.tsv");
  for (const std::uint64_t n : {64u, 256u, 1024u, 4096u, 16384u, 65536u}) {
    std::array<Maybe, 3> row{static_cast<double>(n)};
    for (const unsigned task : {2u, 3u}) {
      if (task == 2 && n > 4096) continue;  // it takes n^2 candidates
      const auto round = seconds_a_round([&](std::uint64_t rounds) -> Maybe {
        const auto got = TRY_MEASURE(repeat, task, n, rounds);
        if (!got) return {};
        return got->cpu_seconds;
      });
      if (round) row[task - 1] = *round * 1e6 / static_cast<double>(n);
    }
    plot_row(file, row);
  }
}

}  // namespace
}  // namespace mc::checks
