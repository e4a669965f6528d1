// 1.7: dependence.

#include "1-variance/experiments.hpp"
#include "data_sets.hpp"
#include "list_results.hpp"

namespace mc::checks {
namespace {

struct Table {
  std::size_t rows, columns;
  Values joint;
};

Table random_table(Rng& rng, std::size_t rows, std::size_t columns, double low, double high) {
  return {rows, columns, uniform_values(rng, rows * columns, low, high)};
}

/// Compares each dependence with the definition. The first table may be known to be independent, up
/// to so much eps.
void judge_tables(const std::vector<Table>& tables, std::size_t eps_of_the_first = 0);

CHECK_CASE("1.7 the dependence of a joint table", "[1.7][main][points:3]") {
  std::vector<Table> tables;
  constexpr std::pair<unsigned, unsigned> sizes[] = {{3, 5},   {3, 5},  {7, 2},  {2, 2},
                                                     {17, 33}, {64, 3}, {5, 65}, {2, 1000}};
  for (const auto& [rows, columns] : sizes) {
    tables.push_back(random_table(rng, rows, columns, 0, uniform(rng, 0.1, 50)));
  }
  // The largest difference is negative (an empty cell among similar ones), then positive.
  for (const double odd_one : {0.0, 10.0, 0.0}) {
    tables.push_back(random_table(rng, 3, 5, 1, 1.1));
    tables.back().joint[rng() % 15] = odd_one;
  }
  // The largest difference in the first cell, in the last, or anywhere.
  for (const auto& [rows, columns] : {std::pair{17u, 33u}, {64u, 3u}, {2u, 1000u}, {5u, 5u}}) {
    const std::size_t cells = rows * columns;
    for (const std::size_t cell : {std::size_t{rng() % cells}, std::size_t{0}, cells - 1}) {
      tables.push_back(random_table(rng, rows, columns, 1, 1.1));
      tables.back().joint[cell] = 10;
    }
  }
  for (const auto& [rows, columns] :
       {std::pair{1u, 3u}, {3u, 1u}, {1u, 1u}, {100'003u, 1u}, {1u, 100'003u}}) {
    tables.push_back(random_table(rng, rows, columns, 0.1, 9));
  }
  judge_tables(tables);
}

CHECK_CASE("1.7 weights of any scale are valid", "[1.7][edge][points:1]") {
  std::vector<Table> tables;
  for (const double scale : {1e300, 1e-300, 1e-310}) {
    tables.push_back(random_table(rng, 4, 3, 0, scale));
  }
  tables.back().joint[rng() % 12] = -0.0;
  judge_tables(tables);
}

CHECK_CASE("1.7 independent variables have a dependence of zero", "[1.7][points:2]") {
  for (const auto& [rows, columns] : {std::pair{2u, 5u}, {4u, 3u}, {3u, 2u}}) {
    // Integers below 2^20 multiply and add exactly: this table is independent in double too.
    Values joint, of_row(rows), of_column(columns);
    for (double& weight : of_row) weight = 1 + static_cast<double>(rng() % 1000);
    for (double& weight : of_column) weight = 1 + static_cast<double>(rng() % 1000);
    if (rows == 4) of_row[rng() % rows] = 0;  // an empty row
    for (const double row : of_row) {
      for (const double column : of_column) joint.push_back(row * column);
    }
    const std::size_t cell = rng() % joint.size();
    std::vector<Table> tables(2, {rows, columns, joint});
    tables.push_back(tables[0]);
    tables[1].joint[cell] += 1e6;  // a dependent table, for which 0 is wrong
    tables[2].joint[cell] += 0x1p-38 * (1 + joint[cell]);  // hardly dependent, but not rounding
    judge_tables(tables, 4);
  }
  // One row is independent of its columns. Here each sum is rounded, up to eps for each cell: 1 and
  // eleven weights that are rounded up to eps, or half of the total in one weight of a thousand.
  Values small(12, 1.2e-16), large = uniform_values(rng, 1000, 0.5, 1);
  small[0] = 1;
  large[rng() % 1000] = 750;
  for (const Values& weights : {small, large}) {
    const std::size_t cells = weights.size();
    judge_tables({{1, cells, weights}}, 4 + cells);
    judge_tables({{cells, 1, weights}}, 4 + cells);
  }
}

CHECK_CASE("1.7 the circle is uncorrelated and yet dependent", "[1.7][points:2][needs:1.6]") {
  // Eight points of a circle, (±a, ±b) and (±b, ±a): y does not depend linearly on x.
  const double a = uniform(rng, 1, 5), b = uniform(rng, 5, 9);
  const auto covariance =
      MEASURE(covariance, {a, a, -a, -a, b, b, -b, -b}, {b, -b, b, -b, a, -a, a, -a});
  expect_each({covariance.call, std::span(&covariance.value, 1)},
              {.exact = {0},
               .tolerance = {8 * eps * b * b},
               .because = "for each point (x, y) of the circle there is one at (x, -y)",
               .rule = "see 1.6"});
  // The four points on the axes as a table over x, y in {-r, 0, r}, with one weight per axis. At
  // the center p(x,y) = 0, but p(x) p(y) > 0.
  const double v = uniform(rng, 1, 9), w = uniform(rng, 1, 9);
  judge_tables({{3, 3, {0, v, 0, w, 0, w, 0, v, 0}}});
}

// What the cases above use ------------------------------------------------------------------------

/// p(x,y) - p(x) p(y) of every cell, by the definition. A wrong total gives the result for weights
/// that were not normalized; a wrong number of columns, that for a transposed table.
Values differences(const Values& joint, std::size_t columns, long double total) {
  std::vector<long double> of_row(joint.size() / columns), of_column(columns);
  for (std::size_t i = 0; i < joint.size(); ++i) {
    of_row[i / columns] += joint[i];
    of_column[i % columns] += joint[i];
  }
  Values all(joint.size());
  for (std::size_t i = 0; i < joint.size(); ++i) {
    const long double product = of_row[i / columns] / total * (of_column[i % columns] / total);
    all[i] = static_cast<double>(joint[i] / total - product);
  }
  return all;
}

double largest_size(const Values& values) {
  double most = 0;
  for (const double value : values) most = std::max(most, std::abs(value));
  return most;
}

std::vector<Suspect> dependence_suspects(const Table& table) {
  const Values& joint = table.joint;
  const double total = sum_of(joint);
  const Values right = differences(joint, table.columns, total);
  double of_filled_cells = 0, sum = 0;
  for (std::size_t i = 0; i < joint.size(); ++i) {
    if (joint[i] > 0) of_filled_cells = std::max(of_filled_cells, std::abs(right[i]));
    sum += std::abs(right[i]);
  }
  const auto [least, most] = std::ranges::minmax_element(right);
  const Likely one_side = "p(x,y) may be below p(x) p(y) as well as above: abs() is missing"_likely;
  return {{largest_size(differences(joint, table.columns, 1)),
           "the weights are not probabilities yet: divide by their total"_likely},
          {largest_size(differences(joint, table.rows, total)),
           "rows and columns are swapped: cell i is in row i / columns and in "
           "column i % columns"_likely},
          {*most, one_side},
          {-*least, one_side},
          {of_filled_cells,
           "the largest difference is in an empty cell, and negative: include empty cells"_likely},
          {sum,
           "this is the sum of all cells' differences: the task asks for the "
           "largest difference"_likely}};
}

void judge_tables(const std::vector<Table>& tables, std::size_t eps_of_the_first) {
  Results dependences;
  const bool first_is_independent = eps_of_the_first > 0;
  for (const Table& table : tables) {
    const bool is_independent = first_is_independent && &table == &tables[0];
    const auto right = differences(table.joint, table.columns, sum_of(table.joint));
    const double tolerance = is_independent ? static_cast<double>(eps_of_the_first) : 32;
    const auto got = MEASURE(dependence, table.joint, table.columns);
    dependences.add(got.call, got.value, is_independent ? 0 : largest_size(right), tolerance * eps,
                    [&] { return dependence_suspects(table); });
  }
  dependences.expect(first_is_independent
                         ? "p(x,y) = p(x) p(y) here, perhaps but for one cell; small is not zero"
                         : "rounding errors of a few sums and products of probabilities",
                     "p(x) is the sum of a row and p(y) that of a column, both of weights divided "
                     "by their total; return the largest |p(x,y) - p(x)p(y)|");
}

}  // namespace
}  // namespace mc::checks
