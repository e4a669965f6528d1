// Lab 1: one accurate pass against the two sums that lose digits.

#include <span>
#include <vector>

#include "bench/ratios/compare.hpp"
#include "variance.hpp"

namespace mc::ratios {
namespace {

struct Sums {
  double sum = 0, squares = 0;
};
[[gnu::noinline]] Sums two_sums(std::span<const double> x) {
  Sums sums;
  for (const double value : x) {
    sums.sum += value;
    sums.squares += value * value;
  }
  return sums;
}

void moments_of(const char* name, double wanted, std::size_t n) {
  std::vector<double> x(n);
  for (std::size_t i = 0; i < n; ++i) x[i] = 1e9 + static_cast<double>(i * 7919 % 1000) * 1e-3;
  compare(
      {name, "two sums in a loop", wanted, static_cast<double>(n)}, [&] { sink = moments(x).m2; },
      [&] { sink = two_sums(x).squares; });
}

const Measurements here(1, [] {
  moments_of("moments, in cache", 8, block);
  moments_of("moments, out of cache", 1.8, std::size_t{1} << 23);  // 64 MB
});

}  // namespace
}  // namespace mc::ratios
