// The data of lab 4's plots: patterns, their periodograms as pictures and as curves, errors of
// integration beside those of random and jittered points, and time against N. Cases of about equal
// cost; what is missing leaves a gap.

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "checks/blue_noise/patterns.hpp"
#include "checks/support/catch.hpp"
#include "checks/support/data.hpp"
#include "measurements/support/plot_data.hpp"

namespace mc::checks {
namespace {

using experiments::Points;
using Maybe = std::optional<double>;

/// Ways to place points: the last three are the submission's.
constexpr std::array<const char*, 5> ways{"random", "jittered", "fixed", "candidates", "discs"};

Points jittered(Rng& rng, std::size_t side) {
  Points points;
  for (std::size_t i = 0; i < side * side; ++i) {
    points.x.push_back((static_cast<double>(i % side) + uniform(rng)) / static_cast<double>(side));
    points.y.push_back((static_cast<double>(i / side) + uniform(rng)) / static_cast<double>(side));
  }
  return points;
}

Points copy_of(View x, View y) {
  return {{x.begin(), x.end()}, {y.begin(), y.end()}};
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
  if (way == "discs") {
    const double radius = radius_for(static_cast<double>(n));
    const auto got = TRY_MEASURE(poisson_disk, radius, sets, n);
    if (!got) return all;
    for (const Set& set : patterns_if_any(*got, radius, sets)) {
      all.push_back(copy_of(set.x, set.y));
    }
    return all;
  }
  // c so small that there are ten candidates in the middle of the list: hardly more than a fixed
  // number of them.
  const double c = way == "fixed" ? 20 / static_cast<double>(n) : 1;
  const auto got = TRY_MEASURE(best_candidate, n, c, sets, n);
  const Points* const points = got ? got->if_exactly(n * sets, unit) : nullptr;
  for (std::size_t set = 0; set < sets && points != nullptr; ++set) {
    all.push_back(
        copy_of(View(points->x).subspan(set * n, n), View(points->y).subspan(set * n, n)));
  }
  return all;
}

constexpr int kmax = 48, spectrum_side = 2 * kmax + 1;

/// The mean periodogram of sets, by the submission; empty where it has none. Sets of one size go
/// together.
std::vector<double> mean_periodogram(const std::vector<Points>& sets) {
  std::vector<double> mean;
  const auto values = static_cast<std::size_t>(spectrum_side * spectrum_side);
  std::vector<Points> sorted = sets;
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const Points& a, const Points& b) { return a.x.size() < b.x.size(); });
  for (std::size_t first = 0, end; first < sorted.size(); first = end) {
    Points together;
    for (end = first; end < sorted.size() && sorted[end].x.size() == sorted[first].x.size();
         ++end) {
      together.x.insert(together.x.end(), sorted[end].x.begin(), sorted[end].x.end());
      together.y.insert(together.y.end(), sorted[end].y.begin(), sorted[end].y.end());
    }
    const auto got = TRY_MEASURE(periodogram, together.x, together.y, end - first, kmax);
    const auto* const power = got ? got->if_exactly((end - first) * values, finite) : nullptr;
    if (power == nullptr) return {};
    mean.resize(values);
    for (std::size_t i = 0; i < power->size(); ++i) {
      mean[i % values] += (*power)[i] / static_cast<double>(sets.size());
    }
  }
  return mean;
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

TEST_CASE("plot periodograms as pictures and over rings", "[.plot]") {
  constexpr std::size_t sets = 40;
  std::array<std::vector<double>, ways.size()> radial;
  for (std::size_t w = 0; w < ways.size(); ++w) {
    const std::vector<double> mean = mean_periodogram(patterns(ways[w], 16, sets));
    auto file = plot_file(fmt::format("spectrum-{}.tsv", ways[w]));
    for (std::size_t row = 0; row < spectrum_side; ++row) {
      std::array<Maybe, spectrum_side> values;
      for (std::size_t i = 0; i < values.size() && !mean.empty(); ++i) {
        values[i] = mean[row * spectrum_side + i];
      }
      plot_row(file, values);
    }
    if (mean.empty()) continue;
    const auto means = TRY_MEASURE(radial_power, mean, kmax);
    const auto* const rings = means ? means->if_exactly(kmax + 1, any_number) : nullptr;
    if (rings != nullptr) radial[w] = *rings;
  }
  auto file = plot_file("radial.tsv");
  for (std::size_t ring = 1; ring <= kmax; ++ring) {
    std::array<Maybe, ways.size() + 1> row{static_cast<double>(ring) / 16};
    for (std::size_t w = 0; w < ways.size(); ++w) {
      if (!radial[w].empty() && std::isfinite(radial[w][ring])) row[w + 1] = radial[w][ring];
    }
    plot_row(file, row);
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
    const auto n = static_cast<double>(side * side);
    for (auto& of : rows) of.push_back({n, 1 / std::sqrt(n)});
    std::size_t column = 2;
    for (const char* way : {"random", "jittered", "candidates", "discs"}) {
      const auto all = patterns(way, side, side == 32 && way[0] == 'c' ? 40 : 100);
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

/// CPU seconds a round: of one round where that is long enough to be seen, else the difference of
/// 2R rounds and R. A few per cent of noise are nothing on four decades.
Maybe seconds_of(unsigned task, std::uint64_t n) {
  const auto run = [&](std::uint64_t rounds) -> Maybe {
    const auto got = TRY_MEASURE(repeat, task, n, rounds, 1);
    if (!got) return {};
    return got->cpu_seconds;
  };
  constexpr double enough = 0.01;
  for (std::uint64_t rounds = 1;; rounds *= 4) {
    const Maybe once = run(rounds);
    if (!once) return {};
    if (*once < enough) continue;
    if (rounds == 1) return once;
    const Maybe twice = run(2 * rounds);
    if (!twice || *twice <= *once) return {};
    return (*twice - *once) / static_cast<double>(rounds);
  }
}

TEST_CASE("plot time against N", "[.plot]") {
  auto file = plot_file("speed.tsv");
  for (const std::uint64_t n : {64u, 256u, 1024u, 4096u, 16384u, 65536u}) {
    std::array<Maybe, 3> row{static_cast<double>(n)};
    for (const unsigned task : {2u, 3u}) {
      if (task == 2 && n > 4096) continue;  // it takes n^2 candidates
      if (const Maybe round = seconds_of(task, n)) {
        row[task - 1] = *round * 1e6 / static_cast<double>(n);
      }
    }
    plot_row(file, row);
  }
}

}  // namespace
}  // namespace mc::checks
