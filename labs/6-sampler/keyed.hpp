#pragma once
// Numbers for 6.5 and 6.6 that depend on a key in the request: a sampler and scenes made of them
// give the expected mean only if every sample is evaluated once, in order.

#include <bit>
#include <cstdint>

#include "common/rng.hpp"

namespace mc::experiments {

/// A number in [0,1) that depends on all of its arguments.
template <class... Words>
double keyed(std::uint64_t key, Words... words) {
  ((key = mix_bits(key + 0x9e3779b97f4a7c15u) ^ static_cast<std::uint64_t>(words)), ...);
  return static_cast<double>(mix_bits(key) >> 11) * 0x1p-53;
}

/// What next() of the keyed sampler returns in a sample of generate(samples, seed).
inline double keyed_next(std::uint64_t key, std::uint64_t samples, std::uint64_t seed,
                         std::uint64_t sample) {
  return keyed(key, samples, seed, sample);
}

/// The value of the keyed scene at a pixel, in its k-th evaluation there, if next() returns u.
inline double keyed_value(std::uint64_t key, std::uint64_t column, std::uint64_t row,
                          std::uint64_t k, double u) {
  return keyed(~key, column, row, k, std::bit_cast<std::uint64_t>(u));
}

}  // namespace mc::experiments
