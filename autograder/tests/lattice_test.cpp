// The generating vector that students are given is the one that the search finds.

#include "checks/support/catch.hpp"
#include "common/lattice_vector.hpp"
#include "measurements/halton/lattice_search.hpp"

namespace mc::measurements {
namespace {

TEST_CASE("lattice_vector is what the search finds") {
  LatticeSearch search;
  for (const std::uint64_t z : lattice_vector) CHECK(search.next() == z);
}

/// On the line e^2 is known: the sum of w over the multiples of 1/N is 2 pi^2 / (6 N).
TEST_CASE("the worst-case error of N points of the line") {
  LatticeSearch search;
  search.next();
  double n = 4;
  for (const double square : search.worst_case()) {
    const double exact = 0.1 * std::numbers::pi * std::numbers::pi / (6 * n * n);
    CHECK(std::abs(square - exact) < 1e-12);
    n *= 2;
  }
  CHECK(n == 131'072);
}

}  // namespace
}  // namespace mc::measurements
