#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <stdexcept>
#include <vector>

#include "common/rng.hpp"

namespace mc {

/// A point of the unit square.
struct Point2 {
  double x = 0, y = 0;
};

/// Cells along x and along y.
struct Grid {
  std::size_t nx = 1, ny = 1;
};

/// N points of [0,1)^dims, stored by coordinate: column d holds coordinate d of all of them. So a
/// generator fills a column at a time, and nobody pays for a dimension that is not asked for.
class PointSet {
 public:
  PointSet() = default;
  PointSet(std::size_t size, std::size_t dims) : size_(size), dims_(dims), values_(size * dims) {}

  std::size_t size() const { return size_; }
  std::size_t dims() const { return dims_; }

  /// Coordinate `d` of every point. Throws std::out_of_range where there is no such dimension.
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

/// Fills a point set, every value of it.
using Generator = std::function<void(PointSet&, Rng&)>;

}  // namespace mc
