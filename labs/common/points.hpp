#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <stdexcept>
#include <vector>

#include "common/rng.hpp"

namespace mc {

/// A point in the plane, usually in the unit square [0,1)^2.
struct Point2 {
  double x = 0, y = 0;
};

/// A grid of nx * ny equal cells on the unit square: `nx` along x and `ny` along y.
struct Grid {
  std::size_t nx = 1, ny = 1;
};

/// N points in [0,1)^dims, stored by coordinate: column d holds coordinate d of all points, so that
/// a generator can fill one column at a time.
class PointSet {
 public:
  PointSet() = default;
  /// `size` points at the origin.
  PointSet(std::size_t size, std::size_t dims) : size_(size), dims_(dims), values_(size * dims) {}

  /// The number of points, N.
  std::size_t size() const { return size_; }
  /// The number of coordinates of each point.
  std::size_t dims() const { return dims_; }

  /// Coordinate `d` of every point, d from 0: a span of size() values.
  /// throws: std::out_of_range if d >= dims().
  std::span<double> column(std::size_t d) {
    require(d);
    return {values_.data() + d * size_, size_};
  }
  std::span<const double> column(std::size_t d) const {
    require(d);
    return {values_.data() + d * size_, size_};
  }

 private:
  void require(std::size_t d) const {
    if (d >= dims_) throw std::out_of_range("column: the point set has fewer dimensions");
  }

  std::size_t size_ = 0, dims_ = 0;
  std::vector<double> values_;
};

/// A function that fills a point set: it writes every value and takes its random numbers from the
/// Rng.
using Generator = std::function<void(PointSet&, Rng&)>;

}  // namespace mc
