// What the functions of lab 3 refuse, one table per task: the "throws:" lines of the header.

#include "checks/stratification/common.hpp"

namespace mc::checks {
namespace {

using IntoGrid = Call(std::uint64_t size_x, std::uint64_t size_y, Grid grid);

/// Invalid calls of functions that fill a grid. In the last ones, nx * ny wraps around to 4 and 0.
std::vector<InvalidCall> wrong_grids(IntoGrid into) {
  // If the sizes differ, the grid does not fit one of them, and may be named, too.
  const std::string grid = "grid|nx|ny", sizes = "x|y|size|grid|nx|ny";
  const std::string wraps = "the product of 64-bit numbers wraps around: divide instead";
  const std::uint64_t half = std::uint64_t{1} << 32;
  const std::string of_points = "x and y are the coordinates of the same points",
                    cells = "a grid has at least one cell";
  return {{into(6, 5, {3, 2}), sizes, of_points},
          {into(6, 7, {3, 2}), sizes, of_points},
          {into(5, 6, {3, 2}), sizes, of_points},
          {into(7, 6, {3, 2}), sizes, of_points},
          {into(6, 0, {3, 2}), sizes, of_points},
          {into(6, 6, {3, 3}), grid, "six points do not fill nine cells"},
          {into(6, 6, {2, 2}), grid, "four cells do not hold six points"},
          {into(6, 6, {6, 2}), grid, "six points do not fill twelve cells"},
          {into(6, 6, {4, 1}), grid, "four cells do not hold six points"},
          {into(0, 0, {0, 5}), grid, cells},
          {into(0, 0, {5, 0}), grid, cells},
          {into(0, 0, {0, 0}), grid, cells},
          {into(0, 0, {1, 1}), grid, "zero points do not fill a cell"},
          {into(6, 6, {0, 6}), grid, cells},
          {into(6, 6, {6, 0}), grid, cells},
          {into(4, 4, {(std::uint64_t{1} << 62) + 1, 4}), grid, "nx * ny = 2^64 + 4, not 4", wraps},
          {into(4, 4, {4, (std::uint64_t{1} << 62) + 1}), grid, "nx * ny = 2^64 + 4, not 4", wraps},
          {into(0, 0, {half, half}), grid, "nx * ny = 2^64, not 0", wraps}};
}

REFUSAL_CASES("3.2", "n = 0 is refused", "0.25", "the refusal names the argument", "0.25",
              {{MEASURE_OUTCOME(strata, {0}), "n|strata|cell", "a grid has at least one cell"}})

REFUSAL_CASES("3.3", "grids of another size are refused", "0.75", "the refusals name the argument",
              "0.25", wrong_grids([](std::uint64_t size_x, std::uint64_t size_y, Grid grid) {
                return MEASURE_OUTCOME(stratified_2d_into, size_x, size_y, grid);
              }))

std::vector<InvalidCall> wrong_powers() {
  const auto made = [](std::uint64_t n, std::uint64_t dims, std::uint64_t per_axis) {
    return MEASURE_OUTCOME(stratified_nd, n, dims, per_axis, 1, 1);
  };
  const std::string divide = "the product of 64-bit numbers wraps around: divide first";
  const std::string name = "per_axis";
  return {{made(9, 3, 2), name, "2^3 is not 9"},
          {made(4, 3, 2), name, "2^3 is not 4"},
          {made(16, 3, 2), name, "2^3 is not 16"},
          {made(2, 1, 1), name, "1^1 is not 2"},
          {made(1, 2, 3), name, "3^2 is not 1"},
          {made(0, 2, 0), name, "an axis has at least one stratum"},
          {made(4, 2, 0), name, "an axis has at least one stratum"},
          {made(4, 2, (std::uint64_t{1} << 63) + 2), name,
           "per_axis^2 = 2^126 + 2^65 + 4, which only in 64 bits is 4", divide},
          {made(16, 40, 65536), name, "65536^40 is 0 in 64 bits", divide}};
}

REFUSAL_CASES("3.5", "sizes that are not a power of per_axis are refused", "0.25",
              "the refusals name the argument", "0.25", wrong_powers())

REFUSAL_CASES("3.7", "grids of another size are refused", "0.75", "the refusals name the argument",
              "0.25", wrong_grids([](std::uint64_t size_x, std::uint64_t size_y, Grid grid) {
                return MEASURE_OUTCOME(multi_jittered_into, size_x, size_y, grid);
              }))

std::vector<InvalidCall> nothing_to_average() {
  return {
      {MEASURE_OUTCOME(estimate_replicated, {1, 2}, 0, 1, 2), "n|point", "a mean needs a point"},
      {MEASURE_OUTCOME(estimate_replicated, {1, 2}, 2, 1, 0), "replicate",
       "a mean needs a replicate"}};
}

REFUSAL_CASES("3.8", "no points and no replicates are refused", "0.5",
              "the refusals name the argument", "0.5", nothing_to_average())

std::vector<InvalidCall> no_strata() {
  const auto made = [](Grid grid, std::uint64_t replicates) {
    return MEASURE_OUTCOME(irradiance_stratified, {}, grid, replicates, 1, 1);
  };
  const std::string cells = "a grid has at least one cell";
  return {{made({0, 3}, 2), "grid|nx|ny", cells},
          {made({3, 0}, 2), "grid|nx|ny", cells},
          {made({0, 0}, 2), "grid|nx|ny", cells},
          {made({3, 2}, 0), "replicate", "a mean needs a replicate"}};
}

REFUSAL_CASES("3.9", "no cells and no replicates are refused", "0.25",
              "the refusals name the argument", "0.25", no_strata())

}  // namespace
}  // namespace mc::checks
