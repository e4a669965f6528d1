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

#include "common/rng.hpp"
#include "protocol/environment.hpp"

namespace mc::checks {
namespace {

bool is_asked_for(const std::string& task) {
  const char* tasks = std::getenv(protocol::speed_tasks_variable);
  return tasks != nullptr && fmt::format(" {} ", tasks).find(' ' + task + ' ') != std::string::npos;
}

/// Nanoseconds a number of a running sum: what every machine does about as fast as its clock says.
/// Beside it a time means the same on another machine, so what the reference takes is known where
/// there is none. The shortest of several, for noise only adds.
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

void time_speed(const std::string& what, std::uint64_t values, const Rounds& rounds) {
  auto count = rounds_of(rounds, 0.025);
  if (!count) return;
  // The median of three differences, the two runs of each close together: a shared machine changes
  // its pace from one second to the next.
  std::array<double, 3> seconds{};
  for (double& one : seconds) {
    const auto round = seconds_by_difference(rounds, *count);
    if (!round) return;
    one = *round;
  }
  std::sort(seconds.begin(), seconds.end());
  bench_row({"speed unit", what, "", 0, 1, nanoseconds_of_addition()});
  bench_row({"speed", what, "", 0, values, seconds[1] * 1e9 / static_cast<double>(values)});
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

std::optional<std::uint64_t> rounds_of(const Rounds& run, double wanted) {
  constexpr double enough = 0.004;
  for (std::uint64_t rounds = 1;; rounds *= 4) {
    const auto took = run(rounds);
    if (!took) return {};
    if (*took < enough) continue;
    return static_cast<std::uint64_t>(
        std::ceil(static_cast<double>(rounds) * std::max(1.0, wanted / *took)));
  }
}

std::optional<double> seconds_by_difference(const Rounds& run, std::uint64_t& rounds) {
  for (int attempt = 0; attempt < 8; ++attempt, rounds *= 4) {
    const auto one = run(rounds), two = run(2 * rounds);
    if (!one || !two) return {};
    if (*two - *one > 0.25 * *one) return (*two - *one) / static_cast<double>(rounds);
  }
  return {};
}

void bench_speed(const std::string& task, const std::string& name, std::uint64_t values,
                 const Rounds& rounds) {
  if (!is_asked_for(task)) return;
  time_speed(task + ' ' + name, values, rounds);
}

void bench_speed_error(
    const std::string& task, const std::string& name, std::uint64_t n,
    const std::function<std::optional<std::vector<double>>(std::uint64_t sets)>& points) {
  if (!is_asked_for(task)) return;
  constexpr std::uint64_t sets = 64;
  const auto got = points(sets);
  if (!got || got->size() != sets * n * 2) return;
  constexpr double integral = (std::numbers::e - 1) * (std::numbers::e - 1);
  double squares = 0, fourths = 0;
  for (std::uint64_t set = 0; set < sets; ++set) {
    const double* const x = got->data() + set * n * 2;
    double sum = 0;
    for (std::uint64_t i = 0; i < n; ++i) sum += std::exp(x[i] + x[n + i]);
    const double error = sum / static_cast<double>(n) / integral - 1;
    squares += error * error / sets;
    fourths += error * error * error * error / sets;
  }
  const double rmse = std::sqrt(squares);
  // Of the RMSE: that of the mean square, by the delta method.
  const double standard_error =
      std::sqrt(std::max(0.0, fourths - squares * squares) / sets) / (2 * rmse);
  bench_row({"speed error", task + ' ' + name, "exp(x + y)", 2, n, rmse, standard_error});
}

}  // namespace mc::checks
