#pragma once
// The values that a lying program replaces.

#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace mc::fuzz {

/// Each process draws at its start whether it lies: some answers of a check must be honest, or the
/// check would never get past its first one.
double mutated_double(double value);
std::uint64_t mutated_integer(std::uint64_t value);
std::size_t mutated_size(std::size_t size);

template <class T>
T mutated(T value) {
  if constexpr (std::is_floating_point_v<T>) {
    return static_cast<T>(mutated_double(static_cast<double>(value)));
  } else {
    return static_cast<T>(mutated_integer(static_cast<std::uint64_t>(value)));
  }
}

}  // namespace mc::fuzz
