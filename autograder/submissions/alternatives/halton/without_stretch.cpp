// alternative: the tasks with points alone; Halton and Hammersley points by a loop over 5.1
#include "halton.hpp"

#include "common/todo.hpp"

#define radical_inverses right_radical_inverses
#define halton right_halton
#define hammersley right_hammersley
#define lattice right_lattice
#define tent right_tent
#include "solutions/halton.cpp"
#undef radical_inverses
#undef halton
#undef hammersley
#undef lattice
#undef tent

namespace mc {
namespace {

void fill(std::span<double> column, unsigned base, std::uint64_t first) {
  for (double& x : column) x = radical_inverse(base, first++);
}

}  // namespace

void radical_inverses(unsigned, std::uint64_t, std::span<double>) {
  throw todo("5.2");
}

void halton(PointSet& points, std::uint64_t first) {
  require_indices(first, points.size(), last_index);
  const auto bases = primes(points.dims());
  for (std::size_t d = 0; d < points.dims(); ++d) fill(points.column(d), bases[d], first);
}

void hammersley(PointSet& points) {
  double i = 0;
  for (double& x : points.column(0)) x = i++ / static_cast<double>(points.size());
  const auto bases = primes(points.dims() - 1);
  for (std::size_t d = 1; d < points.dims(); ++d) fill(points.column(d), bases[d - 1], 0);
}

void lattice(PointSet&, std::uint64_t) {
  throw todo("5.10");
}

void tent(std::span<double>) {
  throw todo("5.10");
}

}  // namespace mc
