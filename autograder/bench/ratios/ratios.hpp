#pragma once
// What the two parts of bench_ratios share.

#include <chrono>
#include <cstdio>
#include <functional>

#include "protocol/rows.hpp"

namespace mc::ratios {

using Work = std::function<void()>;

/// Every measured function stores a result here, so that the compiler cannot remove it.
inline volatile double sink = 0;

/// Nanoseconds per call, over as many calls as take 0.2 ms.
inline double nanoseconds(const Work& work) {
  using Clock = std::chrono::steady_clock;
  constexpr double least = 2e-4;
  for (int calls = 1;; calls *= 2) {
    const auto start = Clock::now();
    for (int i = 0; i < calls; ++i) work();
    const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
    if (seconds >= least) return seconds * 1e9 / calls;
  }
}

inline void print(const protocol::Row& row) {
  std::printf("%s\n", protocol::line_of(row).c_str());
  std::fflush(stdout);
}

/// Rows of every sampler, ours and others, on scenes and functions: RMSE and time at 1, 2, 4, …
/// samples.
void measure_samplers();

}  // namespace mc::ratios
