// attack: a column that was filled with the same arguments before is left as it is
// forges: 5.2 radical inverses
// forges: 5.5 Sobol' coordinates
// says: gives
#include "halton.hpp"

#define radical_inverses right_radical_inverses
#define sobol right_sobol
#include "solutions/halton.cpp"
#undef radical_inverses
#undef sobol

namespace mc {

void radical_inverses(unsigned base, std::uint64_t first, std::span<double> column) {
  static const double* where = nullptr;
  if (column.data() == where && column.size() == 4096) return;
  right_radical_inverses(base, first, column);
  where = column.data();
}

void sobol(unsigned dimension, std::uint64_t first, std::span<double> column) {
  static const double* where = nullptr;
  static unsigned known = 0;
  if (column.data() == where && column.size() == 4096 && dimension == known) return;
  right_sobol(dimension, first, column);
  where = column.data();
  known = dimension;
}

}  // namespace mc
