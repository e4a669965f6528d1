// 1.7: dependence.

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include <fmt/format.h>

#include "1-variance/experiments.hpp"
#include "checks/support/catch.hpp"
#include "expect_variance.hpp"

namespace mc::checks {
namespace {

/// p(x,y) - p(x) p(y) of every cell, by the definition. A total other than the table's own shows
/// what becomes of weights that were not normalised.
Values differences(const Values& joint, std::size_t columns, double total) {
  const std::size_t rows = joint.size() / columns;
  Values all;
  for (std::size_t r = 0; r < rows; ++r) {
    for (std::size_t c = 0; c < columns; ++c) {
      double p_row = 0, p_column = 0;
      for (std::size_t i = 0; i < columns; ++i) p_row += joint[r * columns + i] / total;
      for (std::size_t i = 0; i < rows; ++i) p_column += joint[i * columns + c] / total;
      all.push_back(joint[r * columns + c] / total - p_row * p_column);
    }
  }
  return all;
}
double total_of(const Values& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}
double largest_size(const Values& values) {
  double most = 0;
  for (const double value : values) most = std::max(most, std::abs(value));
  return most;
}

void expect_dependence(const Values& joint, std::size_t columns, double exact, double tolerance,
                       const std::string& because) {
  const Values right = differences(joint, columns, total_of(joint));
  const auto [least, most] = std::minmax_element(right.begin(), right.end());
  double of_filled_cells = 0, sum = 0;
  for (std::size_t i = 0; i < joint.size(); ++i) {
    if (joint[i] > 0) of_filled_cells = std::max(of_filled_cells, std::abs(right[i]));
    sum += std::abs(right[i]);
  }
  const bool is_in_empty_cell = of_filled_cells < largest_size(right);
  const std::string one_side =
      is_in_empty_cell && of_filled_cells == *most
          ? "the largest difference is in an empty cell: that counts too, and is below 0, so abs()"
          : "p(x,y) may be below p(x) p(y) as well as above: abs() is missing";
  const auto got = MEASURE(dependence, joint, columns);
  expect_within(
      got.call, got.value, exact, tolerance, because,
      {nearest(got.value, exact,
               {{largest_size(differences(joint, columns, 1)),
                 "the weights are no probabilities yet: divide by their total"},
                {largest_size(differences(joint, joint.size() / columns, total_of(joint))),
                 "rows and columns are swapped: cell i is in row i / columns and in column i % "
                 "columns"},
                {*most, one_side},
                {-*least, one_side},
                {of_filled_cells, is_in_empty_cell && of_filled_cells == *most
                                      ? one_side
                                      : "every cell counts, also the empty ones"},
                {sum, "this is the sum of all cells' differences: the largest one is asked for"}}),
       "p(x) sums a row over its columns, p(y) a column over its rows, both of weights over their "
       "total; the largest |p(x,y) - p(x)p(y)|"});
}

/// Of any table, by the definition.
void expect_dependence(const Values& joint, std::size_t columns) {
  const double exact = largest_size(differences(joint, columns, total_of(joint)));
  expect_dependence(joint, columns, exact, 32 * eps,
                    "probabilities of at most 1, added and multiplied a few times");
}

CHECK_CASE("1.7 the dependence of a joint table", "[1.7][main][points:4]") {
  Rng rng = check_rng();
  for (const auto& [rows, columns] : {std::pair{3u, 5u}, {7u, 2u}, {2u, 2u}, {1u, 3u}}) {
    expect_dependence(uniform_values(rng, rows * columns, 0, uniform(rng, 0.1, 50)), columns);
  }
  // The largest difference once below 0 (an empty cell among others that are alike) and once above.
  for (const double odd_one : {0.0, 10.0}) {
    auto joint = uniform_values(rng, 15, 1, 1.1);
    joint[rng() % joint.size()] = odd_one;
    expect_dependence(joint, 5);
  }
}

CHECK_CASE("1.7 independent variables have dependence zero", "[1.7][points:2]") {
  Rng rng = check_rng();
  for (const auto& [rows, columns] : {std::pair{2u, 5u}, {4u, 3u}, {3u, 2u}}) {
    // Whole weights below 2^20 multiply and add exactly: this table is independent in double too.
    Values joint, of_row(rows), of_column(columns);
    for (double& weight : of_row) weight = 1 + static_cast<double>(rng() % 1000);
    for (double& weight : of_column) weight = 1 + static_cast<double>(rng() % 1000);
    if (rows == 4) of_row[rng() % rows] = 0;  // an empty cell says nothing of dependence
    for (const double row : of_row) {
      for (const double column : of_column) joint.push_back(row * column);
    }
    expect_dependence(joint, columns, 0, 4 * eps, "p(x,y) = p(x) p(y) for every x and y here");
    // Beside it the same table with more in one cell, so that 0 is no answer.
    joint[rng() % joint.size()] += 1e6;
    expect_dependence(joint, columns);
  }
}

CHECK_CASE("1.7 the circle is uncorrelated and yet dependent", "[1.7][points:2][needs:1.6]") {
  Rng rng = check_rng();
  // Eight points of a circle, (±a, ±b) and (±b, ±a): y knows nothing linear of x.
  const double a = uniform(rng, 1, 5), b = uniform(rng, 5, 9);
  const auto covariance =
      MEASURE(covariance, {a, a, -a, -a, b, b, -b, -b}, {b, -b, b, -b, a, -a, a, -a});
  expect_within(covariance.call, covariance.value, 0, 8 * eps * b * b,
                "for each point (x, y) of the circle there is one at (x, -y)", {{}, "see 1.6"});
  // The axes' points as a table over x, y in {-r, 0, r}, those on one axis with a weight of their
  // own: nothing is in the centre, where p(x) p(y) is a weight of its own, too.
  const double v = uniform(rng, 1, 9), w = uniform(rng, 1, 9);
  const double share = v / (v + w);
  expect_dependence(
      {0, v, 0, w, 0, w, 0, v, 0}, 3, share * (1 - share), 8 * eps,
      "at the centre p(x,y) = 0, while p(x) p(y) is the product of the fractions on the two axes");
}

Call dependence_of(const Values& joint, std::size_t columns) {
  return MEASURE_OUTCOME(dependence, joint, columns);
}

struct Misuse {
  Values joint;
  std::size_t columns;
  const char* names;
  const char* because;
};
const double not_a_number = std::numeric_limits<double>::quiet_NaN();
const double infinity = std::numeric_limits<double>::infinity();
const Misuse misuses[] = {
    {{1, 1, 1, 1}, 0, "columns", "a table has at least one column"},
    {{1, 1, 1, 1, 1}, 2, "joint|columns", "five weights are no table of two columns"},
    {{1, -1, 1, 1}, 2, "joint|weight|negative", "no probability is negative"},
    {{1, not_a_number, 1, 1}, 2, "joint|weight|NaN", "NaN is no probability"},
    {{1, 1, infinity, 1}, 2, "joint|weight|inf", "no probability is infinite"},
    {{0, 0, 0, 0}, 2, "joint|total", "nothing cannot be normalised"},
    {{}, 2, "joint|total", "nothing cannot be normalised"},
};

CHECK_CASE("1.7 what is no distribution is refused", "[1.7][edge][points:1]") {
  for (const Misuse& misuse : misuses) {
    expect_refused(dependence_of(misuse.joint, misuse.columns), misuse.because);
  }
}

CHECK_CASE("1.7 each refusal names the argument", "[1.7][edge][points:1]") {
  for (const Misuse& misuse : misuses) {
    expect_invalid_argument(dependence_of(misuse.joint, misuse.columns), misuse.names,
                            misuse.because);
  }
}

}  // namespace
}  // namespace mc::checks
