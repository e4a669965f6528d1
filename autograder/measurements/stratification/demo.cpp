// Lab 3 in the lecture's demo.

#include "measurements/support/demo.hpp"
#include "checks/support/catch.hpp"
#include "measurements/stratification/samplers.hpp"

namespace mc::checks {
namespace {

/// n = 2^k cells, twice as many along x as along y where k is odd.
Grid grid_of_cells(std::uint64_t n) {
  Grid grid{1, 1};
  while (grid.nx * grid.ny < n) (grid.nx > grid.ny ? grid.ny : grid.nx) *= 2;
  return grid;
}

}  // namespace

TEST_CASE("demo jittered", "[.demo]") {
  DemoPoints points{.name = "jittered"};
  points.points = [](std::uint64_t n, std::uint64_t sets, std::uint64_t seed) {
    return plane_sets(n, sets, TRY_MEASURE(stratified_2d, grid_of_cells(n), sets, seed));
  };
  write_demo("2-jittered", points);
}

TEST_CASE("demo multi-jittered", "[.demo]") {
  DemoPoints points{.name = "multi-jittered"};
  points.points = [](std::uint64_t n, std::uint64_t sets, std::uint64_t seed) {
    return plane_sets(n, sets, TRY_MEASURE(multi_jittered, grid_of_cells(n), sets, seed));
  };
  write_demo("3-multi-jittered", points);
}

}  // namespace mc::checks
