#pragma once
// The moments of two streams put together, exactly; also of one and a single value.

#include "1-variance/experiments.hpp"
#include "checks/support/exact.hpp"

namespace mc::checks {

/// All 64 bits of a count.
inline Exact exact_count(std::uint64_t count) {
  return Exact(static_cast<double>(count >> 32) * 0x1p32) +
         Exact(static_cast<double>(count & 0xffffffffu));
}

inline ExactMoments exact_merge(const Moments& a, const Moments& b) {
  const Exact n_a = exact_count(a.count), n_b = exact_count(b.count);
  const Exact n = n_a + n_b;
  const Exact apart = Exact(b.mean) - Exact(a.mean);
  ExactMoments all;
  if (a.count + b.count == 0) return all;
  all.count = static_cast<double>(n);
  all.mean = Exact(a.mean) + apart * n_b / n;
  all.m2 = Exact(a.m2) + Exact(b.m2) + apart * apart * n_a / n * n_b;
  return all;
}

}  // namespace mc::checks
