#include "measurements/support/speed_data.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <vector>

#include "measurements/support/error_sums.hpp"
#include "protocol/environment.hpp"
#include "runner/text.hpp"

namespace mc::measurements {

void bench_row(const Row& row) {
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
  const auto nanoseconds = [&](const Rounds& run, Count& rounds) {
    return rounds == 0
               ? missing
               : seconds_by_difference(run, rounds) * 1e9 / static_cast<double>(task.values);
  };
  Count own = rounds_for(task.rounds, 0.008),
        plain = task.plain ? rounds_for(task.plain, 0.008) : 0;
  for (int turn = 0; turn < 3 && own > 0; ++turn) {
    bench_row({.task = what, .n = task.values, .ns = nanoseconds(task.rounds, own)});
    bench_row(
        {.method = "plain", .task = what, .n = task.values, .ns = nanoseconds(task.plain, plain)});
  }
  if (!task.points || own == 0) return;
  const double integral = std::expm1(1.0) * std::expm1(1.0);
  ErrorSums errors;
  for (const PointSet& set : task.points(task.n, 2, 64, 1)) {
    double sum = 0;
    for (std::size_t i = 0; i < task.n; ++i) sum += std::exp(set.column(0)[i] + set.column(1)[i]);
    errors.add(sum / static_cast<double>(task.n) / integral - 1);
  }
  bench_row({.task = what,
             .integrand = "exp(x + y)",
             .dimensions = 2,
             .n = task.n,
             .rmse = errors.rmse()});
}

}  // namespace mc::measurements
