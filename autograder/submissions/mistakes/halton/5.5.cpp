// Mistakes in task 5.5.
#include "halton.hpp"

#define sobol right_sobol
#include "solutions/halton.cpp"
#undef sobol

namespace mc {
namespace {

/// The definition with these direction numbers, and with of(index) for an index.
template <class Of>
void by_words(unsigned dimension, std::uint64_t first, std::span<double> column,
              const JoeKuo& given, Of of) {
  right_sobol(dimension, first, column);  // for its exceptions
  const auto v = definition::directions_of(given);
  for (std::size_t i = 0; i < column.size(); ++i) {
    column[i] = definition::sobol_word(v, of(first + i)) * 0x1p-32;
  }
}

}  // namespace
}  // namespace mc

/// The points of other indices: index(i) for i.
#define SOBOL_OF(index)                                                                        \
  void sobol(unsigned dimension, std::uint64_t first, std::span<double> column) {              \
    by_words(dimension, first, column, joe_kuo[dimension % 32], [](auto i) { return index; }); \
  }

// mistake: reads the coefficients of the Sobol' recurrence from the wrong end
// hint: a_1 the highest bit
namespace mc::coefficients_reversed {
void sobol(unsigned dimension, std::uint64_t first, std::span<double> column) {
  JoeKuo given = joe_kuo[dimension % 32];
  unsigned reversed = 0;
  for (unsigned j = 1; j < given.degree; ++j) {
    reversed |= (given.coefficients >> (j - 1) & 1u) << (given.degree - 1 - j);
  }
  given.coefficients = reversed;
  by_words(dimension, first, column, given, [](std::uint64_t i) { return i; });
}
}  // namespace mc::coefficients_reversed

// mistake: generates the points in Gray-code order
// hint: in Gray-code order
namespace mc::gray_code_order {
SOBOL_OF(i ^ i >> 1)
}  // namespace mc::gray_code_order

// mistake: fills only whole blocks of four Sobol' coordinates
// hint: never written
namespace mc::sobol_last_values_unwritten {
void sobol(unsigned dimension, std::uint64_t first, std::span<double> column) {
  const auto rest = column.last(column.size() % 4);
  const std::vector<double> before(rest.begin(), rest.end());
  right_sobol(dimension, first, column);
  std::copy(before.begin(), before.end(), rest.begin());
}
}  // namespace mc::sobol_last_values_unwritten

// mistake: starts at index first + 1
// hint: point 0 is the origin
namespace mc::sobol_without_the_origin {
SOBOL_OF((i + 1) & 0xffffffffu)
}  // namespace mc::sobol_without_the_origin

// mistake: takes m_k for m_(k+1): in dimension 1 that looks like Gray-code order
// hint: m_k is used in place of m_(k+1)
namespace mc::m_one_too_early {
void sobol(unsigned dimension, std::uint64_t first, std::span<double> column) {
  right_sobol(dimension, first, column);
  auto v = definition::directions_of(joe_kuo[dimension]);
  for (std::size_t k = 31; k > 0; --k) v[k] = v[k - 1] >> 1;
  for (std::size_t i = 0; i < column.size(); ++i)
    column[i] = definition::sobol_word(v, first + i) * 0x1p-32;
}
}  // namespace mc::m_one_too_early

// mistake: loops over 31 bits of the index only
// hint: the result is off by v_31, that of bit 31, which is 1 here
namespace mc::index_of_31_bits {
SOBOL_OF(i & 0x7fffffffu)
}  // namespace mc::index_of_31_bits

// mistake: keeps the last column of a dimension, also for another first index
// hint: a static or global variable keeps its value between calls
namespace mc::keeps_its_columns {
void sobol(unsigned dimension, std::uint64_t first, std::span<double> column) {
  static std::array<std::vector<double>, 32> kept;
  right_sobol(dimension, first, column);
  auto& last = kept[dimension];
  if (last.size() != column.size()) last.assign(column.begin(), column.end());
  std::copy(last.begin(), last.end(), column.begin());
}
}  // namespace mc::keeps_its_columns
