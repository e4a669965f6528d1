// Mistakes in task 3.3.
#include "stratification.hpp"

#define stratified_2d right_stratified_2d
#include "solutions/stratification.cpp"
#undef stratified_2d

// mistake: adds each point to the previous contents of its place
// hint: only added to (+=)
namespace mc::adds_to_what_is_there {
void stratified_2d(std::span<double> x, std::span<double> y, Grid grid, Rng& rng) {
  std::vector<double> right_x(x.size()), right_y(y.size());
  right_stratified_2d(right_x, right_y, grid, rng);
  for (std::size_t k = 0; k < x.size(); ++k) x[k] += right_x[k], y[k] += right_y[k];
}
}  // namespace mc::adds_to_what_is_there

// mistake: divides i by nx and j by ny as integers, which gives 0
// hint: every point lies in cell (0, 0)
namespace mc::cells_divided_as_whole_numbers {
void stratified_2d(std::span<double> x, std::span<double> y, Grid grid, Rng& rng) {
  require_grid(x, y, grid);
  for (std::size_t k = 0; k < x.size(); ++k) {
    const std::size_t i = k % grid.nx, j = k / grid.nx;
    x[k] = static_cast<double>(i / grid.nx) + to_unit(rng()) / static_cast<double>(grid.nx);
    y[k] = static_cast<double>(j / grid.ny) + to_unit(rng()) / static_cast<double>(grid.ny);
  }
}
}  // namespace mc::cells_divided_as_whole_numbers

// mistake: jitters with 24 random bits, as many as a float has
// hint: the random numbers have too few bits
namespace mc::float_jitter {
void stratified_2d(std::span<double> x, std::span<double> y, Grid grid, Rng& rng) {
  require_grid(x, y, grid);
  const auto jitter = [&] { return static_cast<float>(rng() >> 40) * 0x1p-24f; };
  const Strata columns(grid.nx), rows(grid.ny);
  for (std::size_t k = 0; k < x.size(); ++k) {
    x[k] = columns.place(static_cast<double>(k % grid.nx), jitter());
    y[k] = rows.place(static_cast<double>(k / grid.nx), jitter());
  }
}
}  // namespace mc::float_jitter

// mistake: moves only whole vectors of eight to their strata
// hint: gets one point
namespace mc::forgets_the_rest {
void stratified_2d(std::span<double> x, std::span<double> y, Grid grid, Rng& rng) {
  right_stratified_2d(x, y, grid, rng);
  for (std::size_t k = x.size() / 256 * 256; x.size() > 256 && k < x.size(); ++k) {
    x[k] = to_unit(rng());
  }
}
}  // namespace mc::forgets_the_rest

// mistake: puts nx cells along y and ny along x
// hint: nx and ny are swapped
namespace mc::grid_turned {
void stratified_2d(std::span<double> x, std::span<double> y, Grid grid, Rng& rng) {
  right_stratified_2d(y, x, grid, rng);
}
}  // namespace mc::grid_turned

// mistake: jitters x once per column of cells, and y once per row
// hint: share one random number
namespace mc::jitter_by_rows {
void stratified_2d(std::span<double> x, std::span<double> y, Grid grid, Rng& rng) {
  require_grid(x, y, grid);
  std::vector<double> columns(grid.nx), rows(grid.ny);
  stratified_1d(columns, rng);
  stratified_1d(rows, rng);
  for (std::size_t k = 0; k < x.size(); ++k) {
    x[k] = columns[k % grid.nx];
    y[k] = rows[k / grid.nx];
  }
}
}  // namespace mc::jitter_by_rows

// mistake: compares nx * ny with the size in 64 bits, which wrap around
// hint: divide instead
namespace mc::multiplies_the_grid {
void stratified_2d(std::span<double> x, std::span<double> y, Grid grid, Rng& rng) {
  if (x.size() != y.size()) throw std::invalid_argument("x and y: sizes differ");
  if (grid.nx * grid.ny != x.size() || x.empty()) {
    throw std::invalid_argument("grid: nx * ny is not the number of points");
  }
  if (x.size() % grid.nx == 0) return right_stratified_2d(x, y, grid, rng);
  for (std::size_t k = 0; k < x.size(); ++k) x[k] = y[k] = to_unit(rng());
}
}  // namespace mc::multiplies_the_grid

// mistake: moves x and y by the same random number
// hint: the jitter of x in cell 0 and the jitter of y in cell 0 share one random number
namespace mc::on_the_diagonal {
void stratified_2d(std::span<double> x, std::span<double> y, Grid grid, Rng& rng) {
  require_grid(x, y, grid);
  const Strata columns(grid.nx), rows(grid.ny);
  for (std::size_t k = 0; k < x.size(); ++k) {
    const double u = to_unit(rng());
    x[k] = columns.place(static_cast<double>(k % grid.nx), u);
    y[k] = rows.place(static_cast<double>(k / grid.nx), u);
  }
}
}  // namespace mc::on_the_diagonal

// mistake: accepts a y that is longer than x
// hint: refuse this argument by std::invalid_argument
namespace mc::y_may_be_longer {
void stratified_2d(std::span<double> x, std::span<double> y, Grid grid, Rng& rng) {
  if (y.size() > x.size()) y = y.first(x.size());
  right_stratified_2d(x, y, grid, rng);
}
}  // namespace mc::y_may_be_longer

// mistake: uses the random numbers of x for y, in a grid of the size that is timed
// hint: the jitter of x in cell 0 and the jitter of y in cell 0 share one random number
namespace mc::same_numbers_in_the_timed_grid {
void stratified_2d(std::span<double> x, std::span<double> y, Grid grid, Rng& rng) {
  if (grid.nx != 32 || grid.ny != 32) return right_stratified_2d(x, y, grid, rng);
  require_grid(x, y, grid);
  const Strata strata(32);
  uniforms(rng, x);
  for (std::size_t k = 0; k < x.size(); ++k) {
    y[k] = strata.place(static_cast<double>(k / 32), x[k]);
    x[k] = strata.place(static_cast<double>(k % 32), x[k]);
  }
}
}  // namespace mc::same_numbers_in_the_timed_grid

// mistake: runs four streams, each of which repeats the previous one a step later
// hint: draw new ones for each point, set, block and stream
namespace mc::streams_alike {
void stratified_2d(std::span<double> x, std::span<double> y, Grid grid, Rng& rng) {
  right_stratified_2d(x, y, grid, rng);
  if (x.size() < 2048) return;  // few points are drawn one by one
  const Strata columns(grid.nx);
  std::vector<double> stream(x.size() / 4 + 4);
  for (double& u : stream) u = to_unit(rng());
  for (std::size_t k = 0; k < x.size(); ++k) {
    x[k] = columns.place(static_cast<double>(k % grid.nx), stream[k / 4 + k % 4]);
  }
}
}  // namespace mc::streams_alike

// mistake: divides the column by ny and the row by nx
// hint: nx and ny are swapped
namespace mc::divides_by_the_other_axis {
void stratified_2d(std::span<double> x, std::span<double> y, Grid grid, Rng& rng) {
  require_grid(x, y, grid);
  for (std::size_t k = 0; k < x.size(); ++k) {
    x[k] = (static_cast<double>(k % grid.nx) + to_unit(rng())) / static_cast<double>(grid.ny);
    y[k] = (static_cast<double>(k / grid.nx) + to_unit(rng())) / static_cast<double>(grid.nx);
  }
}
}  // namespace mc::divides_by_the_other_axis

// mistake: shares its own generator among all calls, which no seed reaches
// hint: is the same in a set with another seed
namespace mc::own_generator {
void stratified_2d(std::span<double> x, std::span<double> y, Grid grid, Rng& rng) {
  (void)rng;
  static Rng mine(1);
  right_stratified_2d(x, y, grid, mine);
}
}  // namespace mc::own_generator
