#pragma once
// Sets of points from a program, validated: as many values as were asked for, each in [0, 1).

#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "checks/support/battery.hpp"
#include "checks/support/measure.hpp"
#include "common/points.hpp"

namespace mc::checks {

using Values = std::vector<double>;
using View = std::span<const double>;

/// `size()` sets of points of [0, 1)^dims: set after set, of each one column after the other.
class SampleSets {
 public:
  /// Sets of these sizes.
  SampleSets(std::string from, std::span<const std::uint64_t> sizes, std::size_t axes,
             Values values)
      : call(std::move(from)),
        n(sizes.empty() ? 0 : sizes[0]),
        dims(axes),
        values_(std::move(values)) {
    for (const std::uint64_t points : sizes) first_.push_back(first_.back() + points);
  }
  /// So many sets of n points.
  SampleSets(std::string from, std::size_t sets, std::size_t points, std::size_t axes,
             Values values)
      : SampleSets(std::move(from), std::vector<std::uint64_t>(sets, points), axes,
                   std::move(values)) {}

  std::string call;
  std::size_t n, dims;  ///< n points in each set; in the first one, where sizes differ

  std::size_t size() const { return first_.size() - 1; }
  std::size_t points(std::size_t set) const { return first_[set + 1] - first_[set]; }
  View column(std::size_t set, std::size_t d) const {
    return View(values_).subspan(first_[set] * dims + d * points(set), points(set));
  }
  const Values& values() const { return values_; }
  /// Sets of another call, with as many dimensions.
  void add(const SampleSets& more) {
    values_.insert(values_.end(), more.values_.begin(), more.values_.end());
    for (std::size_t set = 0; set < more.size(); ++set) {
      first_.push_back(first_.back() + more.points(set));
    }
  }

 private:
  Values values_;
  std::vector<std::size_t> first_{0};  ///< how many points are in the sets before
};

/// Of sets of these sizes: first x of all of them, then y.
SampleSets sets_from_xy(std::string call, View x, View y, std::span<const std::uint64_t> sizes);

/// Ends the check where a value of a column does not lie in [0, 1), and says why that may be: never
/// written, rounded up to 1, not divided by the number of `strata`. `name` is the list's.
void require_in_cube(const std::string& call, const std::string& name, View x,
                     std::size_t strata = 1);

/// Of an experiment that gives sets column by column; `strata` along every axis, for hints.
SampleSets sets_from_columns(const Measured<Values>& got, std::size_t n, std::size_t dims,
                             std::size_t sets, std::size_t strata = 1);

/// Of an experiment that gives all x and all y, in fields of these names.
template <class Points>
SampleSets sets_from_xy(const Measured<Points>& got, Grid grid, std::size_t sets) {
  const std::size_t n = grid.nx * grid.ny;
  const Points& points = got.exactly(n * sets, any_number);
  require_in_cube(got.call, "x", points.x, grid.nx);
  require_in_cube(got.call, "y", points.y, grid.ny);
  return sets_from_xy(got.call, points.x, points.y, std::vector<std::uint64_t>(sets, n));
}

/// Some columns of sets of points, with one point in each cell of a grid over them.
struct Pattern {
  std::vector<std::size_t> dims;
  std::vector<std::size_t> strata;  ///< along each of these dimensions
};

/// A grid that columns d and d + 1 fill, and n strata of one column.
inline Pattern plane_of(Grid grid, std::size_t d = 0) {
  return {{d, d + 1}, {grid.nx, grid.ny}};
}
inline Pattern line_of(std::size_t n, std::size_t d = 0) {
  return {{d}, {n}};
}

/// The cell of each point of a set; ends the check where a cell does not have exactly one point.
/// `elsewhere` is the hint if the points do not show what is wrong.
std::vector<std::size_t> expect_one_in_each_cell(const SampleSets& sets, std::size_t set,
                                                 const Pattern& pattern,
                                                 const std::string& elsewhere);

/// Where the points lie within their cells, as independent uniform numbers: a replicate for each
/// set, a position for each coordinate of each cell of each pattern. Ends the check where a cell
/// does not have exactly one point.
Uniforms jitters_of(const SampleSets& sets, std::span<const Pattern> patterns,
                    const std::string& elsewhere);

/// Two sets of one call, and one of a call with another seed, have nothing in common in the columns
/// of these patterns: more than half of the same coordinates, in whatever order, are never there by
/// chance.
void expect_fresh(const SampleSets& sets, const SampleSets& other_seed,
                  std::span<const Pattern> patterns);

}  // namespace mc::checks
