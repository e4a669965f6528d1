#include "bench/bench.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <tuple>
#include <utility>

#include "grader/submission/submission.hpp"

namespace mc::grader {
namespace fs = std::filesystem;
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// log-log interpolation of the points' values at `n`; outside of their range, the nearest value.
double between(const std::vector<std::pair<double, double>>& points, double n) {
  if (points.empty()) return nan;
  if (n <= points.front().first) return points.front().second;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const auto [a, f] = points[i - 1];
    const auto [b, g] = points[i];
    if (n > b) continue;
    return f * std::pow(g / f, std::log(n / a) / std::log(b / a));
  }
  return points.back().second;
}

/// Nanoseconds per sample of a curve, if measured: on its own integrand if evaluating that is not
/// separable from drawing the sample; else on any.
double sample_time(const std::vector<BenchRow>& times, const Curve& curve, double n) {
  for (const std::string& on : {curve.on, std::string()}) {
    std::vector<std::pair<double, double>> points;
    for (const BenchRow& row : times) {
      if (row.lab == curve.lab && row.submission == curve.submission && row.what == curve.what &&
          row.on == on && row.dims == curve.dims) {
        points.emplace_back(static_cast<double>(row.n), row.value);
      }
    }
    if (!points.empty()) return between(points, n);
  }
  return nan;
}

/// Independent points on the same integrand: the solution's, or else the first available ones.
const Curve* independent_of(const std::vector<Curve>& curves, const Curve& curve) {
  const Curve* best = nullptr;
  for (const Curve& other : curves) {
    if (other.what != "independent" || other.on != curve.on) continue;
    if (best == nullptr || other.submission == "solutions") best = &other;
  }
  return best;
}

}  // namespace

std::vector<BenchRow> Bench::of(const std::string& kind) const {
  std::vector<BenchRow> all;
  std::copy_if(rows.begin(), rows.end(), std::back_inserter(all),
               [&](const BenchRow& row) { return row.kind == kind; });
  return all;
}

std::vector<BenchRow> read_bench_rows(const fs::path& file, const std::string& lab,
                                      const std::string& submission) {
  std::vector<BenchRow> rows;
  std::ifstream from(file);
  for (std::string line; std::getline(from, line);) {
    if (auto row = protocol::row_in(line)) rows.push_back({std::move(*row), lab, submission});
  }
  return rows;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  return n % 2 == 1 ? values[n / 2] : (values[n / 2 - 1] + values[n / 2]) / 2;
}

std::vector<BenchRow> medians(const std::vector<BenchRow>& rows) {
  std::vector<BenchRow> all;
  std::map<std::tuple<std::string, std::string, std::string, std::string, std::string,
                      std::uint64_t, std::uint64_t>,
           std::pair<std::size_t, std::vector<double>>>
      groups;
  for (const BenchRow& row : rows) {
    const auto key =
        std::tuple(row.lab, row.submission, row.kind, row.what, row.on, row.dims, row.n);
    const auto [at, is_new] = groups.try_emplace(key, all.size(), std::vector<double>{});
    if (is_new) all.push_back(row);
    at->second.second.push_back(row.value);
  }
  for (auto& [key, group] : groups) {
    auto& [index, values] = group;
    all[index].value = median(values);
    if (values.size() < 3) continue;
    std::sort(values.begin(), values.end());
    all[index].error = (values[values.size() * 3 / 4] - values[values.size() / 4]) / 2;
  }
  return all;
}

double time_of(const Bench& bench, const std::string& submission, const std::string& what,
               const std::string& on, std::uint64_t n) {
  for (const BenchRow& row : bench.of("time")) {
    if (row.submission == submission && row.what == what && row.on == on && row.n == n) {
      return row.value;
    }
  }
  return nan;
}

std::vector<Curve> curves_of(const Bench& bench) {
  std::map<std::string, std::vector<double>> cost;  // per integrand: every lab measures it
  std::map<std::string, double> variance;
  for (const BenchRow& row : bench.of("integrand")) cost[row.what].push_back(row.value);
  for (const BenchRow& row : bench.of("variance")) variance[row.what] = row.value;

  std::vector<Curve> curves;
  for (const BenchRow& row : bench.of("error")) {
    auto found = std::find_if(curves.begin(), curves.end(), [&](const Curve& curve) {
      return curve.lab == row.lab && curve.submission == row.submission && curve.what == row.what &&
             curve.on == row.on;
    });
    if (found == curves.end()) {
      curves.push_back({row.lab,
                        row.submission,
                        row.what,
                        row.on,
                        row.dims,
                        variance.contains(row.on) ? variance[row.on] : nan,
                        {}});
      found = curves.end() - 1;
    }
    found->points.push_back({static_cast<double>(row.n), row.value, row.error, nan,
                             cost.contains(row.on) ? median(cost[row.on]) : 0, nan});
  }
  const auto times = bench.of("time");
  for (Curve& curve : curves) {
    for (Curve::Point& point : curve.points) point.sample = sample_time(times, curve, point.n);
  }
  for (Curve& curve : curves) {
    const Curve* const chance = independent_of(curves, curve);
    for (std::size_t i = 0; chance != nullptr && i < curve.points.size(); ++i) {
      Curve::Point& point = curve.points[i];
      double square = curve.variance / point.n;  // squared error of independent points, if known
      for (const Curve::Point& other : chance->points) {
        if (std::isnan(curve.variance) && other.n == point.n) square = other.rmse * other.rmse;
      }
      const double time = sample_time(times, *chance, point.n) + point.integrand;
      point.efficiency =
          square * time / (point.rmse * point.rmse * (point.sample + point.integrand));
    }
  }
  return curves;
}

std::optional<TimeToTarget> time_to(const Curve& curve, double target) {
  const auto& points = curve.points;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!(points[i].rmse <= target)) continue;
    if (!(points[i].seconds() > 0)) return {};  // its time was not measured
    if (i == 0) return TimeToTarget{points[0].seconds(), TimeToTarget::or_less};
    const auto& before = points[i - 1];
    const auto& after = points[i];
    const double part = std::log(before.rmse / target) / std::log(before.rmse / after.rmse);
    return TimeToTarget{before.seconds() * std::pow(after.seconds() / before.seconds(), part),
                        TimeToTarget::between};
  }
  if (curve.what != "independent" || points.empty() || !(points.back().seconds() > 0)) return {};
  const double n = curve.variance / (target * target);
  return TimeToTarget{n * points.back().seconds() / points.back().n, TimeToTarget::by_law};
}

std::optional<Exponent> exponent_of(const std::vector<std::pair<double, double>>& points) {
  const auto count = static_cast<double>(points.size());
  if (points.size() < 3) return {};
  double mean_x = 0, mean_y = 0, xx = 0, xy = 0, rest = 0;
  for (const auto& [x, y] : points) {
    mean_x += std::log(x) / count;
    mean_y += std::log(y) / count;
  }
  for (const auto& [x, y] : points) {
    xx += (std::log(x) - mean_x) * (std::log(x) - mean_x);
    xy += (std::log(x) - mean_x) * (std::log(y) - mean_y);
  }
  const double slope = xy / xx;
  for (const auto& [x, y] : points) {
    rest += std::pow(std::log(y) - mean_y - slope * (std::log(x) - mean_x), 2);
  }
  return Exponent{slope, std::sqrt(rest / (count - 2) / xx)};
}

std::vector<Peer> peers_of(const Layout& layout, const std::vector<Lab>& labs) {
  std::vector<Peer> all;
  for (const std::string& library : peer_libraries(layout)) {
    for (const Lab& lab : labs) {
      std::ifstream file(layout.submissions() / "peers" / library / lab.file());
      if (!file) continue;
      Peer peer{library, lab.name, {}, {}, layout.peers.contains(library)};
      std::vector<std::string> checks;
      // "// key: text"
      for (std::string line; std::getline(file, line) && line.starts_with("//");) {
        const auto colon = line.find(": ");
        if (colon == std::string::npos) continue;
        const std::string key = line.substr(0, colon), text = line.substr(colon + 2);
        if (key == "// peer") peer.what = text;
        if (key == "// fails") checks.push_back(text);
        if (key == "// because") peer.failures.push_back({std::exchange(checks, {}), text});
      }
      all.push_back(std::move(peer));
    }
  }
  return all;
}

}  // namespace mc::grader
