#include "measurements/support/speed_data.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <vector>

#include <fmt/format.h>

#include "measurements/support/error_sums.hpp"
#include "protocol/environment.hpp"

namespace mc::measurements {
namespace {

bool is_asked_for(const std::string& task) {
  const char* tasks = std::getenv(protocol::speed_tasks_variable);
  return tasks != nullptr && fmt::format(" {} ", tasks).find(' ' + task + ' ') != std::string::npos;
}

/// Nanoseconds per number of a running sum: what every machine does about as fast as its clock
/// says. Divided by it, a time means the same on every machine, so the reference's time can be
/// estimated where there is no reference. The shortest of several, for noise only adds.
double nanoseconds_of_addition() {
  static const std::vector<double> x(4096, 1 + 1e-9);  // 32 KB: in the first-level cache
  constexpr int rounds = 64, attempts = 7;
  double least = std::numeric_limits<double>::infinity();
  volatile double sink = 0;
  for (int attempt = 0; attempt < attempts; ++attempt) {
    const std::clock_t start = std::clock();
    for (int round = 0; round < rounds; ++round) {
      double sum = sink;
      for (const double value : x) sum += value;
      sink = sum;
    }
    least = std::min(least, static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
  }
  return least * 1e9 / (rounds * static_cast<double>(x.size()));
}

}  // namespace

void bench_row(const protocol::Row& row) {
  static std::ofstream file = [] {
    const char* path = std::getenv(protocol::rows_variable);
    if (path == nullptr) throw std::runtime_error("MC_BENCH_DATA is not set");
    return std::ofstream(path, std::ios::app);
  }();
  file << protocol::line_of(row) << std::endl;
}

std::optional<std::uint64_t> rounds_of(const Rounds& run, double wanted, std::uint64_t first) {
  constexpr double enough = 0.004;
  for (std::uint64_t rounds = first;; rounds *= 4) {
    const auto took = run(rounds);
    if (!took) return {};
    if (*took < enough) continue;
    return static_cast<std::uint64_t>(
        std::ceil(static_cast<double>(rounds) * std::max(1.0, wanted / *took)));
  }
}

Number seconds_by_difference(const Rounds& run, std::uint64_t& rounds) {
  for (int attempt = 0; attempt < 8; ++attempt, rounds *= 4) {
    const auto one = run(rounds), two = run(2 * rounds);
    if (!one || !two) return {};
    if (*two - *one > 0.25 * *one) return (*two - *one) / static_cast<double>(rounds);
  }
  return {};
}

Number seconds_of(const Rounds& run, double wanted, int differences, std::uint64_t first) {
  auto rounds = rounds_of(run, wanted, first);
  std::vector<double> seconds;
  for (int i = 0; rounds && i < differences; ++i) {
    const Number one = seconds_by_difference(run, *rounds);
    if (!one) return {};
    seconds.push_back(*one);
  }
  if (seconds.empty()) return {};
  std::sort(seconds.begin(), seconds.end());
  return seconds[seconds.size() / 2];
}

void bench_speed(const std::string& task, const std::string& name, std::uint64_t values,
                 const Rounds& rounds) {
  if (!is_asked_for(task)) return;
  const Number round = seconds_of(rounds, 0.025, 3);
  if (!round) return;
  const std::string what = task + ' ' + name;
  bench_row({"speed unit", what, "", 0, 1, nanoseconds_of_addition()});
  bench_row({"speed", what, "", 0, values, *round * 1e9 / static_cast<double>(values)});
}

void bench_speed_error(const std::string& task, const std::string& name, std::uint64_t n,
                       const Method& method) {
  if (!is_asked_for(task)) return;
  constexpr double integral = (std::numbers::e - 1) * (std::numbers::e - 1);
  ErrorSums errors;
  for (const PointSet& set : method.points(n, 2, 64, 1)) {
    double sum = 0;
    for (std::size_t i = 0; i < n; ++i) sum += std::exp(set.column(0)[i] + set.column(1)[i]);
    errors.add(sum / static_cast<double>(n) / integral - 1);
  }
  if (errors.count == 0) return;
  bench_row({"speed error", task + ' ' + name, "exp(x + y)", 2, n, errors.rmse(),
             errors.standard_error()});
}

void bench_speed(const std::string& task, const std::string& name, std::uint64_t n,
                 const Method& method) {
  bench_speed(task, name, n, [&](std::uint64_t rounds) { return method.rounds(n, 2, rounds); });
  bench_speed_error(task, name, n, method);
}

}  // namespace mc::measurements
