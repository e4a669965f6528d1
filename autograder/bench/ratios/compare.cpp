#include "bench/ratios/compare.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <limits>

namespace mc::ratios {
namespace {

/// Nanoseconds per call, over as many calls as take 0.2 ms.
double nanoseconds(const Work& work) {
  using Clock = std::chrono::steady_clock;
  constexpr double least = 2e-4;
  for (int calls = 1;; calls *= 2) {
    const auto start = Clock::now();
    for (int i = 0; i < calls; ++i) work();
    const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
    if (seconds >= least) return seconds * 1e9 / calls;
  }
}

}  // namespace

volatile double sink = 0;

void compare(const std::string& name, double values, const Work& ours,
             const std::vector<Opponent>& opponents) {
  for (const Opponent& opponent : opponents) {
    std::array<std::array<double, 3>, 5> ratios{};  // ratio, ours, the other's
    for (auto& [ratio, best, other] : ratios) {
      best = other = std::numeric_limits<double>::infinity();
      for (int round = 0; round < 15; ++round) {
        best = std::min(best, nanoseconds(ours));
        other = std::min(other, nanoseconds(opponent.work));
      }
      ratio = other / best;
    }
    std::sort(ratios.begin(), ratios.end());
    const auto& [ratio, best, other] = ratios[2];
    std::printf("%s\t%s\t%.4g\t%.4g\t%.4g\t%.4g\n", name.c_str(), opponent.name.c_str(),
                opponent.wanted, ratio, best / values, other / values);
    std::fflush(stdout);
  }
}

}  // namespace mc::ratios
