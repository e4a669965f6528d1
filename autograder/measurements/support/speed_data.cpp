#include "measurements/support/speed_data.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <stdexcept>
#include <vector>

#include "measurements/support/error_sums.hpp"
#include "protocol/environment.hpp"
#include "runner/text.hpp"

namespace mc::measurements {
namespace {

/// Nanoseconds per number of a running sum: what every machine does about as fast as its clock
/// says. Divided by it, a time means the same on every machine, so the reference's time can be
/// estimated where there is no reference. The shortest of several, for noise only adds.
double nanoseconds_of_addition() {
  static const std::vector<double> x(4096, 1 + 1e-9);  // 32 KB: in the first-level cache
  constexpr int rounds = 64, attempts = 7;
  double least = infinity;
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
  if (std::isnan(row.value)) return;
  static std::ofstream file = [] {
    const char* path = std::getenv(protocol::rows_variable);
    if (path == nullptr) throw std::runtime_error("MC_BENCH_DATA is not set");
    return std::ofstream(path, std::ios::app);
  }();
  file << protocol::line_of(row) << std::endl;
}

Count rounds_for(const Rounds& run, double wanted, Count first) {
  constexpr double enough = 0.004;
  for (Count rounds = first;; rounds *= 4) {
    const double took = run(rounds).seconds;
    if (std::isnan(took)) return 0;
    if (took < enough) continue;
    return static_cast<Count>(
        std::ceil(static_cast<double>(rounds) * std::max(1.0, wanted / took)));
  }
}

double seconds_by_difference(const Rounds& run, Count& rounds) {
  for (int attempt = 0; attempt < 8; ++attempt, rounds *= 4) {
    const double one = run(rounds).seconds, more = run(2 * rounds).seconds - one;
    if (std::isnan(more)) return missing;
    if (more > 0.25 * one) return more / static_cast<double>(rounds);
  }
  return missing;
}

double seconds_of(const Rounds& run, double wanted, int differences, Count first) {
  Count rounds = rounds_for(run, wanted, first);
  if (rounds == 0) return missing;
  Values seconds;
  for (int i = 0; i < differences; ++i) {
    seconds.push_back(seconds_by_difference(run, rounds));
    if (std::isnan(seconds.back())) return missing;
  }
  return median(seconds);
}

void bench_speed(const SpeedTask& task) {
  const char* const wanted = std::getenv(protocol::speed_tasks_variable);
  const auto words = text::words_of(wanted == nullptr ? "" : wanted);
  if (std::find(words.begin(), words.end(), task.task) == words.end()) return;
  const std::string what = task.task + ' ' + task.name;
  const double round = seconds_of(task.rounds, 0.025, 3);
  if (!std::isnan(round)) {
    bench_row({"speed unit", what, "", 0, 1, nanoseconds_of_addition()});
    bench_row({"speed", what, "", 0, task.values, round * 1e9 / static_cast<double>(task.values)});
  }
  if (!task.points) return;
  const double integral = std::expm1(1.0) * std::expm1(1.0);
  ErrorSums errors;
  for (const PointSet& set : task.points(task.n, 2, 64, 1)) {
    double sum = 0;
    for (std::size_t i = 0; i < task.n; ++i) sum += std::exp(set.column(0)[i] + set.column(1)[i]);
    errors.add(sum / static_cast<double>(task.n) / integral - 1);
  }
  bench_row({"speed error", what, "exp(x + y)", 2, task.n, errors.rmse(), errors.standard_error()});
}

}  // namespace mc::measurements
