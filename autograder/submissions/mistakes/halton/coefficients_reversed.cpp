// mistake: reads the coefficients of the Sobol' recurrence from the wrong end
// caught by: 5.5 the first points
// caught by: 5.5 a column of Sobol
// hint: a_1 the highest bit
#include "halton.hpp"

#define sobol right_sobol
#include "solutions/halton.cpp"
#undef sobol

namespace mc {

void sobol(unsigned dimension, std::uint64_t first, std::span<double> column) {
  right_sobol(dimension, first, column);
  JoeKuo given = joe_kuo[dimension];
  unsigned reversed = 0;
  for (unsigned j = 1; j < given.degree; ++j) {
    reversed |= (given.coefficients >> (j - 1) & 1u) << (given.degree - 1 - j);
  }
  given.coefficients = reversed;
  const auto v = definition::directions_of(given);
  for (std::size_t i = 0; i < column.size(); ++i)
    column[i] = definition::sobol_word(v, first + i) * 0x1p-32;
}

}  // namespace mc
