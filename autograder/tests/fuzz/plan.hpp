#pragma once
// How a program lies. The proof writes a plan into the program's file (tests/self_test/fuzz.cpp),
// because a jailed program can read nothing.

#include <cstdint>
#include <limits>

namespace mc::fuzz {

constexpr double values[] = {std::numeric_limits<double>::quiet_NaN(),
                             std::numeric_limits<double>::infinity(),
                             -std::numeric_limits<double>::infinity(),
                             -0.0,
                             -1,
                             1,
                             1 - 0x1p-53,
                             1e300,
                             5e-324,
                             0.5};
constexpr std::uint8_t value_count = sizeof values / sizeof *values;
constexpr std::uint8_t size_count = 6;  ///< of a list of n: n, 0, 1, n/2, n + 1, 2n

struct Plan {
  char mark[17] = "mc-fuzz-plan-->>";  ///< by which the proof finds it
  std::uint8_t value = 0;              ///< index into `values`; beyond: each process draws one
  std::uint8_t size = 0;               ///< index of a size; beyond: drawn
  std::uint8_t few = 0;                ///< 0: any number; else one of `few` values
  std::uint8_t honesty = 0;            ///< of 256 processes, this many are honest
};

/// Can no right answer have this value?
constexpr bool is_impossible(std::uint8_t value) {
  return value < value_count && !(values[value] >= -1 && values[value] <= 1);
}

}  // namespace mc::fuzz
