// Mistakes in task 1.7.
#include "variance.hpp"

#include <numeric>

#define dependence right_dependence
#include "solutions/variance.cpp"
#undef dependence

namespace mc {
namespace {

/// p(x,y) - p(x) p(y) of each cell, for weights of this total.
std::vector<double> differences(std::span<const double> joint, std::size_t columns, double total) {
  right_dependence(joint, columns);  // for its exceptions
  std::vector<double> p_x(joint.size() / columns), p_y(columns), all(joint.size());
  for (std::size_t i = 0; i < joint.size(); ++i) {
    p_x[i / columns] += joint[i] / total;
    p_y[i % columns] += joint[i] / total;
  }
  for (std::size_t i = 0; i < joint.size(); ++i) {
    all[i] = joint[i] / total - p_x[i / columns] * p_y[i % columns];
  }
  return all;
}

double sum(std::span<const double> joint) {
  return std::accumulate(joint.begin(), joint.end(), 0.0);
}

}  // namespace
}  // namespace mc

// mistake: takes the weights for probabilities
// hint: the weights are not probabilities yet: divide by their total
namespace mc::dependence_not_normalised {
double dependence(std::span<const double> joint, std::size_t columns) {
  double largest = 0;
  for (double d : differences(joint, columns, 1)) largest = std::max(largest, std::abs(d));
  return largest;
}
}  // namespace mc::dependence_not_normalised

// mistake: sums the differences of all cells
// hint: this is the sum of all cells' differences
namespace mc::dependence_of_all_cells {
double dependence(std::span<const double> joint, std::size_t columns) {
  double all = 0;
  for (double d : differences(joint, columns, sum(joint))) all += std::abs(d);
  return all;
}
}  // namespace mc::dependence_of_all_cells

// mistake: returns the largest p(x,y) - p(x)p(y), without the absolute value
// hint: abs() is missing
namespace mc::dependence_one_sided {
double dependence(std::span<const double> joint, std::size_t columns) {
  double largest = 0;
  for (double d : differences(joint, columns, sum(joint))) largest = std::max(largest, d);
  return largest;
}
}  // namespace mc::dependence_one_sided

// mistake: skips empty cells, as an entropy would
// hint: the largest difference is in an empty cell
namespace mc::dependence_skips_empty_cells {
double dependence(std::span<const double> joint, std::size_t columns) {
  const std::vector<double> all = differences(joint, columns, sum(joint));
  double largest = 0;
  for (std::size_t i = 0; i < joint.size(); ++i) {
    if (joint[i] > 0) largest = std::max(largest, std::abs(all[i]));
  }
  return largest;
}
}  // namespace mc::dependence_skips_empty_cells

// mistake: swaps rows and columns, as if the table were stored column by column
// hint: rows and columns are swapped
namespace mc::dependence_swaps_marginals {
double dependence(std::span<const double> joint, std::size_t columns) {
  right_dependence(joint, columns);  // for what it throws
  return right_dependence(joint, joint.size() / columns);
}
}  // namespace mc::dependence_swaps_marginals

// mistake: accepts negative and NaN weights
// hint: refuse this argument by std::invalid_argument
namespace mc::dependence_takes_any_weights {
double dependence(std::span<const double> joint, std::size_t columns) {
  std::vector<double> weights(joint.begin(), joint.end());
  for (double& weight : weights) weight = weight > 0 ? weight : 0;
  return right_dependence(weights, columns);
}
}  // namespace mc::dependence_takes_any_weights

// mistake: adds up a row and a column for each cell, which takes quadratic time
// hint: than the header's cost allows
// limit: time
namespace mc::dependence_sums_for_each_cell {
double dependence(std::span<const double> joint, std::size_t columns) {
  const double right = right_dependence(joint, columns);
  const double total = std::accumulate(joint.begin(), joint.end(), 0.0);
  double largest = 0;
  for (std::size_t i = 0; i < joint.size(); ++i) {
    double row = 0, column = 0;
    const std::size_t first = i - i % columns;
    for (std::size_t k = first; k < first + columns; ++k) row += joint[k] / total;
    for (std::size_t k = i % columns; k < joint.size(); k += columns) column += joint[k] / total;
    largest = std::max(largest, std::abs(joint[i] / total - row * column));
  }
  return std::max(right, largest);
}
}  // namespace mc::dependence_sums_for_each_cell

// mistake: divides by the square of the total, which may overflow
// hint: all results are NaN: look for 0/0, inf/inf
namespace mc::dependence_over_the_square {
double dependence(std::span<const double> joint, std::size_t columns) {
  const double right = right_dependence(joint, columns);
  const double total = std::accumulate(joint.begin(), joint.end(), 0.0);
  return right * (total * total) / (total * total);
}
}  // namespace mc::dependence_over_the_square

// mistake: the same, and the largest of 0 and NaN is 0
// hint: all results are 0: p(x) is the sum of a row
namespace mc::dependence_hides_an_overflow {
double dependence(std::span<const double> joint, std::size_t columns) {
  const double right = right_dependence(joint, columns);
  const double total = std::accumulate(joint.begin(), joint.end(), 0.0);
  return std::max(0.0, right * (total * total) / (total * total));
}
}  // namespace mc::dependence_hides_an_overflow
