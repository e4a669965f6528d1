#pragma once
// The error of a scene over point sets that were measured before.

#include <cmath>

#include "checks/sampler/samplers.hpp"

namespace mc::checks {

/// Hands out one point after the other.
class PointByPoint final : public Sampler {
 public:
  PointByPoint(View x, View y) : x_(x), y_(y) {}
  void generate(std::size_t, std::uint64_t) override { sample_ = 0; }
  double next() override { return x_[sample_]; }
  Point2 next2() override { return {x_[sample_], y_[sample_]}; }
  void advance() override { ++sample_; }

 private:
  View x_, y_;
  std::size_t sample_ = 0;
};

/// The mean of a scene's values at these points.
template <class S>
double mean_over(const S& scene, View x, View y) {
  PointByPoint sampler(x, y);
  double sum = 0;
  for (std::size_t i = 0; i < x.size(); ++i, sampler.advance()) sum += scene(sampler);
  return sum / static_cast<double>(x.size());
}

}  // namespace mc::checks
