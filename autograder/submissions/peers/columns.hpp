#pragma once
// Columns from a library that makes points.

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "common/points.hpp"

namespace mc::peers {

/// Makes points when a column is asked for, and keeps the columns before it: who asks from the last
/// dimension down to the first pays for each point once. No column is given out twice, so that
/// nothing is had for nothing when it is asked for again.
class Columns {
 public:
  /// `make(points, first)` fills points first, first + 1, …
  template <class Make>
  void take(unsigned dimension, std::uint64_t first, std::span<double> column, Make make) {
    const bool kept = first == first_ && column.size() == points_.size() &&
                      dimension < points_.dims() && !taken_[dimension];
    if (!kept) {
      if (points_.size() != column.size() || points_.dims() != dimension + 1) {
        points_ = PointSet(column.size(), dimension + 1);
      }
      make(points_, first);
      first_ = first;
      taken_.assign(dimension + 1, false);
    }
    taken_[dimension] = true;
    const auto from = points_.column(dimension);
    std::copy(from.begin(), from.end(), column.begin());
  }

 private:
  PointSet points_;
  std::uint64_t first_ = 0;
  std::vector<bool> taken_;
};

}  // namespace mc::peers
