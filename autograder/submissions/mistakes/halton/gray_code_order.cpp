// mistake: point i is chosen by the Gray code of i
// caught by: 5.5 the first points
// caught by: 5.5 a column of Sobol
// hint: in Gray-code order
#include "halton.hpp"

#define sobol right_sobol
#include "solutions/halton.cpp"
#undef sobol

namespace mc {

void sobol(unsigned dimension, std::uint64_t first, std::span<double> column) {
  right_sobol(dimension, first, column);
  const auto v = definition::directions_of(joe_kuo[dimension]);
  for (std::size_t i = 0; i < column.size(); ++i) {
    column[i] = definition::sobol_word(v, (first + i) ^ (first + i) >> 1) * 0x1p-32;
  }
}

}  // namespace mc
