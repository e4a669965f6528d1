// 5.2, 5.5 and 5.8 against GSL's Halton and Sobol' sequences. Interleaved rounds, the best of each,
// in blocks of 4,096 points. Every column is made in the same 32 KB, as GSL makes every point in the
// same few bytes: what is timed is making numbers, not storing them beyond the first-level cache.
// Beside them stands what storing alone costs, a column of ones.

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <limits>
#include <vector>

#include <gsl/gsl_qrng.h>

#include "halton.hpp"

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t points = 4096;

template <class Work>
double nanoseconds(std::size_t dims, Work work) {
  constexpr int rounds = 5;
  const auto start = Clock::now();
  for (int round = 0; round < rounds; ++round) work();
  return std::chrono::duration<double>(Clock::now() - start).count() * 1e9 /
         static_cast<double>(rounds * points * dims);
}

void compare(unsigned dims) {
  gsl_qrng* const gsl_halton = gsl_qrng_alloc(gsl_qrng_halton, dims);
  gsl_qrng* const gsl_sobol = gsl_qrng_alloc(gsl_qrng_sobol, dims);
  std::vector<double> point(dims);
  const auto bases = mc::primes(dims);
  std::vector<double> column(points);
  volatile double sink = 0;
  const auto from_gsl = [&](gsl_qrng* sequence) {
    gsl_qrng_init(sequence);
    for (std::size_t i = 0; i < points; ++i) gsl_qrng_get(sequence, point.data());
    sink = point[0];
  };
  const double never = std::numeric_limits<double>::infinity();
  double ones = never, halton_gsl = never, halton = never, sobol_gsl = never, sobol = never,
         scrambled = never;
  for (int i = 0; i < 60; ++i) {
    ones = std::min(ones, nanoseconds(dims, [&] {
                      for (unsigned d = 0; d < dims; ++d) {
                        std::fill(column.begin(), column.end(), 1.0);
                        sink = column[d];
                      }
                    }));
    halton_gsl = std::min(halton_gsl, nanoseconds(dims, [&] { from_gsl(gsl_halton); }));
    halton = std::min(halton, nanoseconds(dims, [&] {
                        for (const unsigned base : bases) mc::radical_inverses(base, 0, column);
                        sink = column.back();
                      }));
    sobol_gsl = std::min(sobol_gsl, nanoseconds(dims, [&] { from_gsl(gsl_sobol); }));
    sobol = std::min(sobol, nanoseconds(dims, [&] {
                       for (unsigned d = 0; d < dims; ++d) mc::sobol(d, 0, column);
                       sink = column.back();
                     }));
    scrambled = std::min(scrambled, nanoseconds(dims, [&] {
                           for (unsigned d = 0; d < dims; ++d) {
                             mc::sobol(d, 0, column);
                             mc::owen_scramble(column, d);
                           }
                           sink = column.back();
                         }));
  }
  std::printf(
      "  %2uD, ns a coordinate: Halton %.3f (GSL %.2f, %.0f times), Sobol' %.3f (GSL %.2f, %.1f "
      "times), scrambled %.2f (%.1f times), ones %.3f\n",
      dims, halton, halton_gsl, halton_gsl / halton, sobol, sobol_gsl, sobol_gsl / sobol, scrambled,
      sobol_gsl / scrambled, ones);
  gsl_qrng_free(gsl_halton);
  gsl_qrng_free(gsl_sobol);
}

}  // namespace

int main() {
  for (const unsigned dims : {2u, 4u, 8u, 16u}) compare(dims);
}
