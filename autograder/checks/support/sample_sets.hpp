#pragma once
// Validated point sets from a program: the requested number of values, each in [0, 1).

#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "checks/support/battery.hpp"
#include "checks/support/domain.hpp"
#include "checks/support/measure.hpp"
#include "common/points.hpp"

namespace mc::checks {

using Values = std::vector<double>;
using View = std::span<const double>;

/// `size()` point sets in [0, 1)^dims, one after the other, each column by column.
class SampleSets {
 public:
  SampleSets(std::string from, std::span<const std::uint64_t> sizes, std::size_t axes,
             Values values)
      : call(std::move(from)),
        n(sizes.empty() ? 0 : sizes[0]),
        dims(axes),
        values_(std::move(values)) {
    for (const std::uint64_t points : sizes) first_.push_back(first_.back() + points);
  }
  SampleSets(std::string from, std::size_t sets, std::size_t points, std::size_t axes,
             Values values)
      : SampleSets(std::move(from), std::vector<std::uint64_t>(sets, points), axes,
                   std::move(values)) {}

  std::string call;
  std::size_t n, dims;  ///< n points in each set, or in the first if sizes differ

  std::size_t size() const { return first_.size() - 1; }
  std::size_t points(std::size_t set) const { return first_[set + 1] - first_[set]; }
  View column(std::size_t set, std::size_t d) const {
    return View(values_).subspan(first_[set] * dims + d * points(set), points(set));
  }
  const Values& values() const { return values_; }
  /// Adds the sets of another call, with the same number of dimensions.
  void add(const SampleSets& more) {
    append(values_, more.values_);
    for (std::size_t set = 0; set < more.size(); ++set) {
      first_.push_back(first_.back() + more.points(set));
    }
  }

 private:
  Values values_;
  std::vector<std::size_t> first_{0};  ///< the number of points in earlier sets
};

/// From the x of all sets and the y of all sets.
SampleSets sets_from_xy(std::string call, View x, View y, std::span<const std::uint64_t> sizes);

/// Ends the check if a value is not in [0, 1), with a hint: never written, rounded up to 1, not
/// divided by the number of `strata`, divided by that of the `other` axis. `name` is that of the
/// list.
void require_in_cube(const std::string& call, const std::string& name, View x,
                     std::size_t strata = 1, std::size_t other = 1);

/// From an experiment that returns sets column by column; `strata` along every axis is for hints.
SampleSets sets_from_columns(const Measured<Values>& got, std::size_t n, std::size_t dims,
                             std::size_t sets, std::size_t strata = 1);

/// From an experiment that returns fields x and y.
template <class Points>
SampleSets sets_from_xy(const Measured<Points>& got, Grid grid, std::size_t sets) {
  const std::size_t n = grid.nx * grid.ny;
  const Points& points = got.exactly(n * sets, any_number);
  require_in_cube(got.call, "x", points.x, grid.nx, grid.ny);
  require_in_cube(got.call, "y", points.y, grid.ny, grid.nx);
  return sets_from_xy(got.call, points.x, points.y, std::vector<std::uint64_t>(sets, n));
}

/// Some columns of point sets, with one point in each cell of a grid over them.
struct Pattern {
  std::vector<std::size_t> dims;
  std::vector<std::size_t> strata;  ///< along each of these dimensions
};

/// A grid over columns d and d + 1; n strata of column d.
inline Pattern plane_of(Grid grid, std::size_t d = 0) {
  return {{d, d + 1}, {grid.nx, grid.ny}};
}
inline Pattern line_of(std::size_t n, std::size_t d = 0) {
  return {{d}, {n}};
}

inline std::vector<Pattern> lines_of(std::size_t n, std::size_t dims) {
  std::vector<Pattern> lines;
  for (std::size_t d = 0; d < dims; ++d) lines.push_back(line_of(n, d));
  return lines;
}

/// The cell of each point of a set; ends the check if a cell does not have exactly one point.
/// `rule` is printed if the points do not show what is wrong.
std::vector<std::size_t> expect_one_in_each_cell(const SampleSets& sets, std::size_t set,
                                                 const Pattern& pattern, const std::string& rule);

/// The same for all sets and patterns.
void expect_one_in_each_cell(const SampleSets& sets, std::span<const Pattern> patterns,
                             const std::string& rule);

/// The positions of points within their cells, as independent uniform numbers: one replicate per
/// set, one position per coordinate of each cell. Ends the check if a cell does not have one point.
Uniforms jitters_of(const SampleSets& sets, std::span<const Pattern> patterns,
                    const std::string& rule);

/// How many values occur in both lists.
std::size_t common_values(View a, View b);

/// Two sets of one call, and a set with another seed, share less than half of their coordinates in
/// the columns of these patterns: random sets never share that many by chance.
void expect_fresh(const SampleSets& sets, const SampleSets& other_seed,
                  std::span<const Pattern> patterns);

}  // namespace mc::checks
