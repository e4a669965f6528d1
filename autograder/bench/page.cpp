// Generates the page from one run.

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "bench/bench.hpp"
#include "bench/markdown.hpp"
#include "grader/base/replace.hpp"

namespace mc::grader {
namespace {

/// "0.83 µs", "12 ms"
std::string duration(double seconds) {
  const std::pair<double, const char*> units[] = {
      {1e-9, "ns"}, {1e-6, "µs"}, {1e-3, "ms"}, {1, "s"}};
  const auto* unit = units;
  while (unit + 1 != std::end(units) && seconds >= 999.5 * unit->first) ++unit;
  const double value = seconds / unit->first;
  return fmt::format("{:.{}f} {}", value, value < 10 ? 2 : value < 100 ? 1 : 0, unit->second);
}

std::string reached(const Curve* curve, double target) {
  if (curve == nullptr) return "";
  const auto when = time_to(*curve, target);
  if (!when) return "not reached";
  if (when->how == TimeToTarget::by_law) return '(' + duration(when->seconds) + ')';
  return (when->how == TimeToTarget::or_less ? "≤ " : "") + duration(when->seconds);
}

/// Two significant digits.
std::string shown_number(double value) {
  if (std::isnan(value)) return "";
  if (value >= 9999.5) return fmt::format("{:.1e}", value);
  if (value >= 99.5) return fmt::format("{:.0f}", value);
  return fmt::format("{:.{}f}", value, value >= 9.95 ? 0 : value >= 0.995 ? 1 : 2);
}

std::string whose(const std::string& submission) {
  return submission == "solutions" ? "these labs" : submission;
}

const Curve* find(const std::vector<Curve>& curves, const std::string& submission,
                  const std::string& what, const std::string& on) {
  for (const Curve& curve : curves) {
    if (curve.submission == submission && curve.what == what && curve.on == on) return &curve;
  }
  return nullptr;
}

/// The point at 4,096 samples, or the last one before.
const Curve::Point* at_4096(const Curve* curve) {
  const Curve::Point* best = nullptr;
  for (std::size_t i = 0; curve != nullptr && i < curve->points.size(); ++i) {
    if (curve->points[i].n <= 4500) best = &curve->points[i];  // Poisson disks only come close
  }
  return best;
}

/// Its error, and its N if that is not 4,096.
std::string error_of(const Curve::Point& point, bool with_standard_error) {
  std::string text = fmt::format("{:.1e}", point.rmse);
  if (with_standard_error) text += fmt::format(" ± {:.0e}", point.error);
  if (point.n < 4000) text += fmt::format(" (N = {:.0f})", point.n);
  return text;
}

/// A sampler's row in the one-minute table, from any lab.
struct Line {
  const Curve *plane, *edge, *four;
};

std::vector<Line> lines_of(const std::vector<Curve>& curves) {
  std::vector<Line> lines;
  for (const Curve& curve : curves) {
    if (curve.on != "smooth 2D") continue;
    // Jittered points of four dimensions are padded ones.
    const std::string many = curve.what == "jittered" ? "jittered, padded" : curve.what;
    lines.push_back({&curve, find(curves, curve.submission, curve.what, "edge 2D"),
                     find(curves, curve.submission, many, "smooth 4D")});
  }
  const auto key = [](const Line& line) {
    const auto when = time_to(*line.plane, 1e-3);
    return when ? when->seconds : 1e9 * line.plane->points.back().rmse;
  };
  std::stable_sort(lines.begin(), lines.end(),
                   [&](const Line& a, const Line& b) { return key(a) < key(b); });
  return lines;
}

std::string one_minute(const Bench& bench) {
  const auto curves = curves_of(bench);
  Markdown table{{"sampler", "by", "ns per sample", "error", "smooth 2D to $10^{-3}$",
                  "edge 2D to $10^{-3}$", "smooth 4D to $10^{-3}$", "efficiency"},
                 2};
  for (const Line& line : lines_of(curves)) {
    const Curve::Point* const point = at_4096(line.plane);
    if (point == nullptr) continue;
    table.rows.push_back({line.plane->what, whose(line.plane->submission),
                          shown_number(point->sample), error_of(*point, false),
                          reached(line.plane, 1e-3), reached(line.edge, 1e-3),
                          reached(line.four, 1e-3), shown_number(point->efficiency)});
  }
  return table.text();
}

std::string ratios(const Bench& bench) {
  Markdown table{{"what", "against", "ns", "ns of the other", "ratio", "wanted",
                  "ratio without AVX2", "AVX2 buys"},
                 2};
  for (const Ratio& one : bench.ratios) {
    std::string without, buys;
    for (const Ratio& other : bench.baseline) {
      if (other.name != one.name || other.against != one.against) continue;
      without = shown_number(other.ratio);
      buys = fmt::format("× {:.1f}", other.ours / one.ours);
    }
    table.rows.push_back({one.name, one.against, fmt::format("{:.2f}", one.ours),
                          fmt::format("{:.2f}", one.other), shown_number(one.ratio),
                          one.wanted > 0 ? fmt::format("≥ {:g}", one.wanted) : "", without, buys});
  }
  return table.text();
}

std::string tables_of_times(const Bench& bench) {
  const auto curves = curves_of(bench);
  std::vector<std::string> integrands;
  for (const Curve& curve : curves) enlist(integrands, curve.on);
  std::string all;
  for (const std::string& on : integrands) {
    double cost = 0;
    Markdown table{{"sampler", "by", "ns per sample", "RMSE at 4096", "to $10^{-2}$", "$10^{-3}$",
                    "$10^{-4}$", "$10^{-5}$", "$10^{-6}$", "efficiency"},
                   2};
    for (const Curve& curve : curves) {
      const Curve::Point* const point = at_4096(&curve);
      if (curve.on != on || point == nullptr) continue;
      cost = point->integrand;
      table.rows.push_back({curve.what, whose(curve.submission), shown_number(point->sample),
                            error_of(*point, true)});
      for (int digits = 2; digits <= 6; ++digits) {
        table.rows.back().push_back(reached(&curve, std::pow(10, -digits)));
      }
      table.rows.back().push_back(shown_number(point->efficiency));
    }
    all +=
        fmt::format("### {}\n\n{}\n\n{}\n", on,
                    cost > 0 ? fmt::format("The integrand itself takes {} ns.", shown_number(cost))
                             : "The integrand is part of the sample.",
                    table.text());
  }
  return all;
}

std::string variances(const Bench& bench) {
  Markdown table{{"way", "by", "ns, in cache", "ns, out of it"}, 2};
  std::vector<std::string> names;
  for (const BenchRow& row : bench.of("digits")) {
    const std::size_t y = enlist(names, row.what + '\n' + row.submission);
    if (y == table.rows.size()) {
      const auto time = [&](const char* where, std::uint64_t n) {
        return shown_number(time_of(bench, row.submission, row.what, where, n));
      };
      table.rows.push_back({row.what, whose(row.submission), time("in cache", 4096),
                            time("out of cache", std::uint64_t{1} << 23)});
    }
    table.cell(y, row.on) = fmt::format("{:.1f}", row.value);
  }
  return table.text();
}

std::string libraries(const Bench& bench) {
  Markdown table{{"library", "lab", "what of it", "fails", "because"}, 5};
  for (const Peer& peer : bench.peers) {
    const std::vector<std::string> start{
        peer.library + (peer.installed ? "" : " (not installed here)"), peer.lab, peer.what};
    const auto add = [&](const std::string& fails, const std::string& because) {
      table.rows.push_back(start);
      table.rows.back().insert(table.rows.back().end(), {fails, because});
    };
    if (peer.failures.empty()) add("nothing", "");
    for (const Peer::Failure& failure : peer.failures) {
      add(fmt::format("{}", fmt::join(failure.checks, "; ")), failure.because);
    }
  }
  return table.text();
}

std::string growth(const Bench& bench) {
  struct Series {
    BenchRow first;
    std::vector<std::pair<double, double>> times{}, bytes{};  // over n, or over dims
  };
  std::vector<std::string> names;
  std::vector<Series> all;
  for (const BenchRow& row : bench.rows) {
    if (row.kind != "growth" && row.kind != "memory") continue;
    const bool over_n = row.on == "n";
    const std::size_t place = enlist(
        names, fmt::format("{}|{}|{}|{}", row.submission, row.what, row.on, over_n ? row.dims : 0));
    if (place == all.size()) all.push_back({row});
    (row.kind == "growth" ? all[place].times : all[place].bytes)
        .emplace_back(static_cast<double>(over_n ? row.n : row.dims), row.value);
  }
  Markdown table{
      {"what", "over", "from", "to", "time grows as", "memory as", "ns at the largest", "bytes"},
      2};
  const auto shown = [](const std::optional<Exponent>& exponent, const char* of) {
    return exponent ? fmt::format("{}^({:.2f} ± {:.2f})", of, exponent->slope, exponent->error)
                    : std::string();
  };
  for (auto& [row, times, bytes] : all) {
    const bool over_n = row.on == "n";
    std::sort(times.begin(), times.end());
    std::sort(bytes.begin(), bytes.end());
    // Without the program's own memory; the remainder is noise.
    for (std::size_t i = bytes.size(); i-- > 0;) bytes[i].second -= bytes[0].second;
    std::erase_if(bytes, [](const auto& point) { return point.second < 5e5; });
    const auto [largest, seconds] = times.back();
    const double items = largest * static_cast<double>(over_n ? row.dims : row.n);
    table.rows.push_back(
        {row.what, over_n ? fmt::format("N, {}D", row.dims) : "dimensions, N = 4096",
         fmt::format("{:g}", times.front().first), fmt::format("{:g}", largest),
         shown(exponent_of(times), over_n ? "N" : "d"), shown(exponent_of(bytes), "N"),
         fmt::format("{:.2f} a coordinate", seconds * 1e9 / items),
         bytes.empty() ? "" : fmt::format("{:.0f} MB", bytes.back().second / 1e6)});
  }
  return table.text();
}

}  // namespace

std::string bench_summary(const Bench& bench) {
  std::string all;
  if (!lines_of(curves_of(bench)).empty()) all += one_minute(bench);
  if (!bench.of("digits").empty()) all += (all.empty() ? "" : "\n") + variances(bench);
  if (!bench.ratios.empty()) all += "\n" + ratios(bench);
  if (const std::string tables = bench_tables(bench); !tables.empty()) all += "\n" + tables;
  return all;
}

std::string bench_page(const Bench& bench, const std::string& outline,
                       const std::filesystem::path& pictures) {
  const std::pair<const char*, std::string> parts[] = {
      {"run",
       fmt::format("{}, {} cores, {}; {}; `{}`; version {}; {:.0f} s.{}", bench.processor,
                   bench.cores, bench.system, bench.compiler, bench.flags, bench.version,
                   bench.seconds,
                   bench.whole ? "" : " It was cut short: what is missing was not measured.")},
      {"one minute", one_minute(bench)},
      {"ratios", ratios(bench)},
      {"tables", bench_tables(bench)},
      {"times", tables_of_times(bench)},
      {"variance", variances(bench)},
      {"libraries", libraries(bench)},
      {"growth", growth(bench)},
      {"rounds", std::to_string(bench.rounds)},
      {"pictures", pictures.string()}};
  std::string page = outline;
  for (auto [name, text] : parts) {
    while (text.ends_with('\n')) text.pop_back();
    page = with_replacements(page, {{fmt::format("{{{{{}}}}}", name), text}});
  }
  return page;
}

}  // namespace mc::grader
