#pragma once
// The strata of a rectangular light (3.9): the mean and the variance of the value at a uniform
// point of each cell, by quadrature.

#include "checks/support/exact_stratified.hpp"
#include "checks/support/rect_light_exact.hpp"
#include "common/points.hpp"

namespace mc::checks {

/// The value at a point: area · radiance · height^2 / distance^4, both cosines height / distance.
inline double light_value(const RectLight& light, double x, double y) {
  const double h2 = light.height * light.height, distance2 = x * x + y * y + h2;
  return area(light) * light.radiance * h2 / (distance2 * distance2);
}

/// Calls visit(cell, mean) for the cells of a grid on the light, row by row, with the mean of the
/// value over the cell.
template <class Visit>
void for_each_cell(const RectLight& light, Grid grid, Visit visit) {
  const double width = (light.x1 - light.x0) / static_cast<double>(grid.nx);
  const double depth = (light.y1 - light.y0) / static_cast<double>(grid.ny);
  for (std::size_t j = 0; j < grid.ny; ++j) {
    for (std::size_t i = 0; i < grid.nx; ++i) {
      RectLight cell = light;
      cell.x0 = light.x0 + static_cast<double>(i) * width, cell.x1 = cell.x0 + width;
      cell.y0 = light.y0 + static_cast<double>(j) * depth, cell.y1 = cell.y0 + depth;
      visit(cell, mean_over(cell, [&](double x, double y) { return light_value(light, x, y); }));
    }
  }
}

/// The mean of (value - mean)^power over a cell.
inline double central_moment(const RectLight& light, const RectLight& cell, double mean,
                             int power) {
  return mean_over(
      cell, [&](double x, double y) { return std::pow(light_value(light, x, y) - mean, power); });
}

inline WithinStrata light_strata(const RectLight& light, Grid grid) {
  WithinStrata cells;
  for_each_cell(light, grid, [&](const RectLight& cell, double mean) {
    cells.mean.push_back(mean);
    cells.variance.push_back(central_moment(light, cell, mean, 2));
  });
  return cells;
}

/// The kurtosis of the mean of one point in each cell: fourth cumulants add up.
inline double light_kurtosis(const RectLight& light, Grid grid) {
  double variance = 0, fourth = 0;
  for_each_cell(light, grid, [&](const RectLight& cell, double mean) {
    const double square = central_moment(light, cell, mean, 2);
    variance += square;
    fourth += central_moment(light, cell, mean, 4) - 3 * square * square;
  });
  return 3 + fourth / (variance * variance);
}

/// What is added to the variance within the strata if the y of all points of a jittered grid are
/// paired anew with the x: the interaction of the cells' means (Hoeffding, as in
/// shuffled_product_variance()).
inline double paired_anew_variance(const WithinStrata& cells, Grid grid) {
  std::vector<double> in_column(grid.nx), in_row(grid.ny);
  for (std::size_t k = 0; k < cells.size(); ++k) {
    in_column[k % grid.nx] += cells.mean[k] / static_cast<double>(grid.ny);
    in_row[k / grid.nx] += cells.mean[k] / static_cast<double>(grid.nx);
  }
  const double mean = mean_of(cells), n = static_cast<double>(cells.size());
  double squares = 0;
  for (std::size_t k = 0; k < cells.size(); ++k) {
    const double rest = cells.mean[k] - in_column[k % grid.nx] - in_row[k / grid.nx] + mean;
    squares += rest * rest;
  }
  return squares / n / (n - 1);
}

}  // namespace mc::checks
