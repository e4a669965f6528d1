#include "checks/support/checks.hpp"

namespace mc::checks {
namespace {

/// The coordinates of points along one axis of a grid.
struct Axis {
  std::string name;  ///< "x"
  View values;
  std::size_t strata;
};

std::size_t cells_in(std::span<const Axis> axes) {
  std::size_t cells = 1;
  for (const Axis& axis : axes) cells *= axis.strata;
  return cells;
}

/// The cell of point k, with coordinates in [0, 1).
std::size_t cell_of(std::span<const Axis> axes, std::size_t k) {
  std::size_t cell = 0;
  for (std::size_t d = axes.size(); d-- > 0;) {
    cell = cell * axes[d].strata + stratum_of(axes[d].values[k], axes[d].strata).value_or(0);
  }
  return cell;
}

/// The cell of each point, the first axis fastest; empty if a cell does not have one point.
std::vector<std::size_t> cells_of(std::span<const Axis> axes) {
  const std::size_t n = axes[0].values.size();
  std::vector<std::size_t> cells(n);
  std::vector<bool> taken(cells_in(axes));
  for (std::size_t k = 0; k < n; ++k) {
    for (const Axis& axis : axes) {
      if (!stratum_of(axis.values[k], axis.strata)) return {};
    }
    cells[k] = cell_of(axes, k);
    if (taken[cells[k]]) return {};
    taken[cells[k]] = true;
  }
  return cells;
}

/// "cell (1, 3) of 4 x 4", "stratum 4 of 16".
std::string name_of(std::span<const Axis> axes, std::size_t cell) {
  if (axes.size() == 1) return fmt::format("stratum {} of {}", cell, axes[0].strata);
  std::string place, grid;
  for (const Axis& axis : axes) {
    place += fmt::format("{}{}", place.empty() ? "" : ", ", cell % axis.strata);
    grid += fmt::format("{}{}", grid.empty() ? "" : " x ", axis.strata);
    cell /= axis.strata;
  }
  return fmt::format("cell ({}) of {}", place, grid);
}

bool is_stratified(const Axis& axis, std::size_t n) {
  const Axis finer{axis.name, axis.values, n};
  return !cells_of(std::span(&finer, 1)).empty();
}

/// Whether all strata of x have the same number of points.
bool is_even(std::span<const double> x, std::size_t strata) {
  std::vector<std::size_t> points(strata);
  for (const double value : x) ++points[*stratum_of(value, strata)];
  return std::ranges::all_of(points, [&](std::size_t count) { return count * strata == x.size(); });
}

/// Whether each cell would have one point if coordinates next to an edge were moved across it.
bool are_right_when(std::span<const Axis> axes, double (*moved)(double x, std::size_t n)) {
  std::vector<Values> columns;
  std::vector<Axis> others(axes.begin(), axes.end());
  for (const Axis& axis : axes) {
    Values& column = columns.emplace_back();
    for (const double x : axis.values) column.push_back(moved(x, axis.strata));
  }
  for (std::size_t d = 0; d < axes.size(); ++d) others[d].values = columns[d];
  return !cells_of(others).empty();
}
double moved_down(double x, std::size_t n) {
  const std::size_t i = *stratum_of(x, n);
  return i > 0 && x == static_cast<double>(i) / static_cast<double>(n) ? std::nextafter(x, 0.0) : x;
}
double moved_up(double x, std::size_t n) {
  const double above = std::nextafter(x, 1.0);
  return above < 1 && *stratum_of(above, n) != *stratum_of(x, n) ? above : x;
}

/// Whether the points, in order, lie in their strata up to a rounding error.
bool are_near_their_strata(const Axis& axis) {
  Values sorted(axis.values.begin(), axis.values.end());
  std::ranges::sort(sorted);
  const auto n = static_cast<double>(axis.strata);
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    const auto low = static_cast<double>(i) / n, high = static_cast<double>(i + 1) / n;
    if (sorted[i] < low * (1 - 4 * eps) || sorted[i] > high * (1 + 4 * eps)) return false;
  }
  return true;
}

Likely hint_for(std::span<const Axis> axes, std::span<const std::size_t> points,
                const std::string& rule) {
  const std::size_t n = axes[0].values.size(), dims = axes.size();
  const auto each_axis = [&](auto holds) { return std::ranges::all_of(axes, holds); };
  if (n > 2 && points[0] == n) {
    return dims == 1 ? "every point lies in the first stratum: i / N of two integers is 0"_likely
                     : "every point lies in cell (0, 0): i / nx of two integers is 0"_likely;
  }
  if (are_right_when(axes, moved_down)) {
    return "a point was rounded up to the edge: keep it below (i + 1) / N"_likely;
  }
  if (are_right_when(axes, moved_up)) {
    return "a point was rounded down below the edge: divide by N, because 1 / N is rounded"_likely;
  }
  if (dims == 1 && are_near_their_strata(axes[0])) {
    return "points were rounded across an edge: divide by N, because 1 / N is rounded, and keep "
           "them below (i + 1) / N"_likely;
  }
  if (dims == 1) return {};
  // A few points fit by chance, a dozen only once in 1e4 runs.
  const Axis turned[] = {{"y", axes[1].values, axes[0].strata},
                         {"x", axes[0].values, axes[1].strata}};
  if (dims == 2 && n >= 12 && axes[0].strata != axes[1].strata && !cells_of(turned).empty()) {
    return "nx and ny are swapped: nx cells along x, ny along y"_likely;
  }
  if (dims == 2 && n >= 4 && each_axis([&](const Axis& axis) { return is_stratified(axis, n); })) {
    return "two 1D patterns are not a 2D pattern: fill the cells of the grid, and shuffle x and y "
           "together"_likely;
  }
  if (n >= 12 && each_axis([](const Axis& axis) {
        return axis.strata > 1 && is_even(axis.values, axis.strata);
      })) {
    return likely(
        "each axis is evenly filled, but not each cell: {}; are the coordinates of a "
        "point moved together?",
        rule);
  }
  return {};
}

}  // namespace

std::vector<std::size_t> expect_one_in_each_cell(const SampleSets& sets, std::size_t set,
                                                 const Pattern& pattern, const std::string& rule) {
  std::vector<Axis> axes;
  for (std::size_t i = 0; i < pattern.dims.size(); ++i) {
    const std::size_t d = pattern.dims[i];
    axes.push_back({sets.dims <= 2 ? (d == 0 ? "x" : "y") : fmt::format("coordinate {}", d),
                    sets.column(set, d), pattern.strata[i]});
  }
  const std::size_t n = axes[0].values.size();
  for (const Axis& axis : axes) {
    if (axis.values.size() != cells_in(axes)) {
      fail(fmt::format("measured  {}: {} values of {} for {} cells", sets.call, axis.values.size(),
                       axis.name, cells_in(axes)));
    }
    require_in_cube(sets.call, axis.name, axis.values, axis.strata);
  }
  auto cells = cells_of(axes);
  if (!cells.empty()) {
    pass();
    return cells;
  }
  std::vector<std::size_t> points(n);
  for (std::size_t k = 0; k < n; ++k) ++points[cell_of(axes, k)];
  const auto odd = static_cast<std::size_t>(
      std::ranges::find_if(points, [](auto count) { return count != 1; }) - points.begin());
  std::string names;
  for (const Axis& axis : axes) names += (names.empty() ? "" : ", ") + axis.name;
  fail(Failure{
      fmt::format("{}: {} points in {} ({})", sets.call, points[odd], name_of(axes, odd), names),
      "one point", "each cell has one point, in any order; edges are i / n, divided in double",
      hint_for(axes, points, rule), rule});
}

void expect_one_in_each_cell(const SampleSets& sets, std::span<const Pattern> patterns,
                             const std::string& rule) {
  for (std::size_t set = 0; set < sets.size(); ++set) {
    for (const Pattern& pattern : patterns) expect_one_in_each_cell(sets, set, pattern, rule);
  }
}

}  // namespace mc::checks
