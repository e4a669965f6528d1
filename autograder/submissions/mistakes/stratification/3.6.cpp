// Mistakes in task 3.6.
#include "stratification.hpp"

#define latin_hypercube right_latin_hypercube
#include "solutions/stratification.cpp"
#undef latin_hypercube

// mistake: shuffles the same jittered column for every axis
// hint: one column is used for two axes
namespace mc::one_jitter_for_all_axes {
void latin_hypercube(PointSet& points, Rng& rng) {
  for (std::size_t d = 0; d < points.dims(); ++d) {
    if (d == 0) {
      stratified_1d(points.column(0), rng);
    } else {
      std::ranges::copy(points.column(0), points.column(d).begin());
    }
  }
  for (std::size_t d = 0; d < points.dims(); ++d) shuffle(points.column(d), rng);
}
}  // namespace mc::one_jitter_for_all_axes

// mistake: permutes two axes alike: the points lie along the diagonal
// hint: shuffle each one separately
namespace mc::one_order_for_two_axes {
void latin_hypercube(PointSet& points, Rng& rng) {
  for (std::size_t d = 0; d < points.dims(); ++d) stratified_1d(points.column(d), rng);
}
}  // namespace mc::one_order_for_two_axes

// mistake: draws a random stratum for every point and axis
// hint: each column is a pattern of 3.1
namespace mc::strata_drawn_with_replacement {
void latin_hypercube(PointSet& points, Rng& rng) {
  const Strata strata(points.size());
  for (std::size_t d = 0; d < points.dims(); ++d) {
    for (double& x : points.column(d)) {
      x = strata.place(static_cast<double>(rng() % points.size()), to_unit(rng()));
    }
  }
}
}  // namespace mc::strata_drawn_with_replacement

// mistake: permutes axis 3 as axis 0, axis 4 as axis 1, …
// hint: one order for several
namespace mc::three_orders_for_all_axes {
void latin_hypercube(PointSet& points, Rng& rng) {
  const Rng start(rng());
  for (std::size_t d = 0; d < points.dims(); ++d) {
    stratified_1d(points.column(d), rng);
    Rng order = start;
    for (std::size_t k = 0; k < d % 3; ++k) order = Rng(order());
    shuffle(points.column(d), order);
  }
}
}  // namespace mc::three_orders_for_all_axes
