#include "mutation.hpp"

#include <sys/random.h>

#include <cmath>
#include <limits>

namespace mc::fuzz {
namespace {

/// How this program lies. The proof writes the plan into the program's file
/// (tests/self_test/fuzz.cpp), because a jailed program can read nothing.
struct Plan {
  char mark[16];
  std::uint8_t value;    ///< index into `values`; beyond: each process draws one
  std::uint8_t size;     ///< index into the sizes below; beyond: drawn
  std::uint8_t few;      ///< 0: any number; else one of `few` values
  std::uint8_t honesty;  ///< of 256 processes, this many are honest
};
volatile const Plan plan{
    {'m', 'c', '-', 'f', 'u', 'z', 'z', '-', 'p', 'l', 'a', 'n', '-', '-', '>', '>'}, 0, 0, 0, 0};

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
constexpr std::uint8_t size_count = 6;

std::uint32_t random_bits() {
  std::uint32_t bits = 0;
  if (getrandom(&bits, sizeof bits, 0) != sizeof bits) return 1;
  return bits;
}

/// The plan of this process.
struct ProcessPlan {
  bool lies = random_bits() % 256 >= plan.honesty;
  double value = values[(plan.value < value_count ? plan.value : random_bits()) % value_count];
  std::uint32_t size = (plan.size < size_count ? plan.size : random_bits()) % size_count;
  std::uint32_t count = 0;
};
ProcessPlan& process_plan() {
  static ProcessPlan one;
  return one;
}

/// Is this number one of those to replace?
bool is_chosen() {
  ProcessPlan& now = process_plan();
  return now.lies && (plan.few == 0 || now.count++ % plan.few == plan.few / 2u);
}

}  // namespace

double mutated_double(double value) {
  return is_chosen() ? process_plan().value : value;
}

std::uint64_t mutated_integer(std::uint64_t value) {
  if (!is_chosen()) return value;
  if (plan.value < value_count) {
    // In addition to numbers that no right answer has, integers that none has either.
    const double lie = values[plan.value];
    return plan.few == 0 && !(std::abs(lie) <= 1) ? ~value : value;
  }
  const std::uint64_t odd[] = {0, 1, value + 1, value - 1, 1000, ~std::uint64_t{0}};
  return odd[random_bits() % 6];
}

std::size_t mutated_size(std::size_t size) {
  if (!process_plan().lies) return size;
  const std::size_t sizes[size_count] = {size, 0, 1, size / 2, size + 1, 2 * size};
  return sizes[process_plan().size];
}

}  // namespace mc::fuzz
