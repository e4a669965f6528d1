#include "bench/ratios/compare.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace mc::ratios {
namespace {

using Clock = std::chrono::steady_clock;

/// Nanoseconds per call, over as many calls as take 0.2 ms.
double nanoseconds(const std::function<void()>& work) {
  constexpr double least = 2e-4;
  for (int calls = 1;; calls *= 2) {
    const auto start = Clock::now();
    for (int i = 0; i < calls; ++i) work();
    const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
    if (seconds >= least) return seconds * 1e9 / calls;
  }
}

std::multimap<int, void (*)()>& measurements() {
  static std::multimap<int, void (*)()> all;
  return all;
}

}  // namespace

volatile double sink = 0;

Measurements::Measurements(int place, void (*measure)()) {
  measurements().emplace(place, measure);
}

void compare(const Ratio& ratio, const std::function<void()>& ours,
             const std::function<void()>& other) {
  std::vector<std::pair<double, std::pair<double, double>>> ratios;
  for (int time = 0; time < 5; ++time) {
    double best_ours = std::numeric_limits<double>::infinity(), best_other = best_ours;
    for (int round = 0; round < 15; ++round) {
      best_ours = std::min(best_ours, nanoseconds(ours));
      best_other = std::min(best_other, nanoseconds(other));
    }
    ratios.push_back({best_other / best_ours, {best_ours, best_other}});
  }
  std::sort(ratios.begin(), ratios.end());
  const auto& [median, times] = ratios[2];
  std::printf("%s\t%s\t%.4g\t%.4g\t%.4g\t%.4g\n", ratio.name.c_str(), ratio.against.c_str(),
              ratio.wanted, median, times.first / ratio.values, times.second / ratio.values);
  std::fflush(stdout);
}

}  // namespace mc::ratios

int main() {
  for (const auto& [place, measure] : mc::ratios::measurements()) measure();
}
