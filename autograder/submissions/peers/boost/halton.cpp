// peer: Boost.Random: sobol
// fails: 5.5 the first points
// fails: 5.5 a column of Sobol' points
// fails: 5.5 the first two dimensions
// fails: 5.5 integrals by Sobol' points
// because: Boost leaves out the origin, point 0, and goes on in the order of Gray codes
#include "halton.hpp"

#include <memory>
#include <stdexcept>

#include <boost/random/sobol.hpp>

#include "autograder/submissions/peers/columns.hpp"
#include "common/todo.hpp"

namespace mc {
namespace {

using Engine = boost::random::sobol;

/// Points first, first + 1, … as Boost counts them; it gives their coordinates one by one.
void fill(PointSet& points, std::uint64_t first) {
  static std::unique_ptr<Engine> engine;
  if (!engine || engine->dimension() != points.dims()) {
    engine = std::make_unique<Engine>(points.dims());
  }
  engine->seed(first);
  static std::vector<double*> columns;
  columns.clear();
  for (std::size_t d = 0; d < points.dims(); ++d) columns.push_back(points.column(d).data());
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (double* const column : columns) column[i] = static_cast<double>((*engine)()) * 0x1p-64;
  }
}

}  // namespace

void sobol(unsigned dimension, std::uint64_t first, std::span<double> column) {
  constexpr std::uint64_t end = std::uint64_t{1} << 32;
  if (dimension >= joe_kuo.size()) throw std::invalid_argument("dimension: at most 31");
  if (first > end || end - first < column.size()) {
    throw std::invalid_argument("first: the column leads past the last index");
  }
  static peers::Columns columns;
  columns.take(dimension, first, column, fill);
}

double radical_inverse(unsigned, std::uint64_t) {
  throw todo("5.1");
}
void radical_inverses(unsigned, std::uint64_t, std::span<double>) {
  throw todo("5.2");
}
std::vector<unsigned> primes(std::size_t) {
  throw todo("5.3");
}
void halton(PointSet&, std::uint64_t) {
  throw todo("5.3");
}
void hammersley(PointSet&) {
  throw todo("5.4");
}
double star_discrepancy(std::span<const double>) {
  throw todo("5.6");
}
double star_discrepancy(std::span<const double>, std::span<const double>) {
  throw todo("5.6");
}
void random_shift(PointSet&, Rng&) {
  throw todo("5.7");
}
void owen_scramble(std::span<double>, std::uint64_t) {
  throw todo("5.8");
}
void radical_inverses_scrambled(unsigned, std::uint64_t, std::span<double>, std::uint64_t) {
  throw todo("5.9");
}

}  // namespace mc
