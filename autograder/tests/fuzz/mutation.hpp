#pragma once
// The values that a lying program replaces.

#include <sys/random.h>

#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "plan.hpp"

namespace mc::fuzz {

inline volatile const Plan plan{};

inline std::uint32_t random_bits() {
  std::uint32_t bits = 0;
  if (getrandom(&bits, sizeof bits, 0) != sizeof bits) return 1;
  return bits;
}

/// What this process does. It draws at its start whether it lies: some answers of a check must be
/// honest, or the check would never get past its first one.
struct ProcessPlan {
  bool lies = random_bits() % 256 >= plan.honesty;
  double value = values[(plan.value < value_count ? plan.value : random_bits()) % value_count];
  std::uint32_t size = (plan.size < size_count ? plan.size : random_bits()) % size_count;
  std::uint32_t count = 0;

  /// Is this number one of those to replace?
  bool chooses() { return lies && (plan.few == 0 || count++ % plan.few == plan.few / 2u); }
};
inline ProcessPlan& process_plan() {
  static ProcessPlan one;
  return one;
}

template <class T>
T mutated(T value) {
  if (!process_plan().chooses()) return value;
  if constexpr (std::is_floating_point_v<T>) {
    return static_cast<T>(process_plan().value);
  } else {
    const auto bits = static_cast<std::uint64_t>(value);
    // In addition to numbers that no right answer has, integers that none has either.
    if (plan.value < value_count) {
      return static_cast<T>(plan.few == 0 && is_impossible(plan.value) ? ~bits : bits);
    }
    const std::uint64_t odd[] = {0, 1, bits + 1, bits - 1, 1000, ~std::uint64_t{0}};
    return static_cast<T>(odd[random_bits() % 6]);
  }
}

inline std::size_t mutated_size(std::size_t size) {
  if (!process_plan().lies) return size;
  const std::size_t sizes[size_count] = {size, 0, 1, size / 2, size + 1, 2 * size};
  return sizes[process_plan().size];
}

}  // namespace mc::fuzz
