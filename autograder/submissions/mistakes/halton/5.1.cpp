// Mistakes in task 5.1.
#include "halton.hpp"

#define radical_inverse right_radical_inverse
#define radical_inverses right_radical_inverses
#include "solutions/halton.cpp"
#undef radical_inverse
#undef radical_inverses

namespace mc {
namespace {

/// The digits mirrored in a Word, which overflows, over a power of the base, of type Size.
template <class Word, class Size>
double mirrored_in(unsigned base, std::uint64_t index) {
  require_base(base);
  Word mirrored = 0;
  Size size = 1;
  for (; index > 0; index /= base, size *= base) {
    mirrored = mirrored * base + static_cast<Word>(index % base);
  }
  return std::min(below_one, static_cast<double>(mirrored) / static_cast<double>(size));
}

}  // namespace
}  // namespace mc

// mistake: sums in a float
// hint: only about seven digits are correct
namespace mc::in_floats {
double radical_inverse(unsigned base, std::uint64_t index) {
  require_base(base);
  float sum = 0, part = 1;
  for (; index > 0; index /= base) {
    part /= static_cast<float>(base);
    sum += part * static_cast<float>(index % base);
  }
  return sum;
}
}  // namespace mc::in_floats

// mistake: calls itself for the remaining digits, even if there are none
// hint: infinite recursion
namespace mc::inverts_without_an_end {
double radical_inverse(unsigned base, std::uint64_t index) {
  require_base(base);
  const double digit = static_cast<double>(index % base);
  return (digit + radical_inverse(base, index / base)) / base;
}
}  // namespace mc::inverts_without_an_end

// mistake: adds the largest terms first, so every sum is rounded near 1
// hint: add the smallest terms first
namespace mc::large_digits_first {
double radical_inverse(unsigned base, std::uint64_t index) {
  require_base(base);
  double sum = 0, part = 1;
  for (; index > 0; index /= base) {
    part /= base;
    sum += part * static_cast<double>(index % base);
  }
  return std::min(below_one, sum);
}
}  // namespace mc::large_digits_first

// mistake: mirrors the digits in 32 bits, which overflow
// hint: the mirrored digits do not fit in 32 bits
// hint: overflows; compute with a double from the highest digit on
namespace mc::mirrors_in_32_bits {
double radical_inverse(unsigned base, std::uint64_t index) {
  return mirrored_in<std::uint32_t, double>(base, index);
}
}  // namespace mc::mirrors_in_32_bits

// mistake: mirrors the digits in 64 bits, which overflow
// hint: the mirrored digits do not fit in 64 bits
namespace mc::mirrors_in_64_bits {
double radical_inverse(unsigned base, std::uint64_t index) {
  return mirrored_in<std::uint64_t, double>(base, index);
}
}  // namespace mc::mirrors_in_64_bits

// mistake: mirrors the digits in 64 bits and divides by a power of the base, which overflows, too
// hint: the mirrored digits do not fit in 64 bits
namespace mc::mirrors_and_divides_in_64_bits {
double radical_inverse(unsigned base, std::uint64_t index) {
  return mirrored_in<std::uint64_t, std::uint64_t>(base, index);
}
}  // namespace mc::mirrors_and_divides_in_64_bits

// mistake: does not mirror the digits: writes them after the point in the order of the index
// hint: the digits are not mirrored
namespace mc::not_mirrored {
double radical_inverse(unsigned base, std::uint64_t index) {
  require_base(base);
  double size = 1;
  for (std::uint64_t rest = index; rest > 0; rest /= base) size *= base;
  return std::min(below_one, static_cast<double>(index) / size);
}
}  // namespace mc::not_mirrored

// mistake: rounds an index of more than 53 ones up to 1
// hint: the upper end is not in the range
namespace mc::rounds_to_one {
double radical_inverse(unsigned base, std::uint64_t index) {
  require_base(base);
  if (index == 0) return 0;
  const double last = static_cast<double>(index % base);
  return (last + mc::radical_inverse(base, index / base)) / base;
}
}  // namespace mc::rounds_to_one

// mistake: rounds an index of more than 53 ones up to 1, and so does its loop in 5.2
// hint: the upper end is not in the range
namespace mc::rounds_to_one_in_a_loop {
double radical_inverse(unsigned base, std::uint64_t index) {
  require_base(base);
  if (index == 0) return 0;
  return (static_cast<double>(index % base) + radical_inverse(base, index / base)) / base;
}

void radical_inverses(unsigned base, std::uint64_t first, std::span<double> column) {
  require_base(base);
  require_indices(first, column.size(), last_index);
  for (std::size_t i = 0; i < column.size(); ++i) column[i] = radical_inverse(base, first + i);
}
}  // namespace mc::rounds_to_one_in_a_loop

// mistake: limits values to 1 - 1e-10
// hint: no value is above 0.9999999999: something limits the values
namespace mc::limited {
double radical_inverse(unsigned base, std::uint64_t index) {
  return std::min(1 - 1e-10, right_radical_inverse(base, index));
}
}  // namespace mc::limited
