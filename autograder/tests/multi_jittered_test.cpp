// Task 3.7 by rotations of one permutation: verifies docs/multi-jittered.md numerically.

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <numeric>
#include <vector>

#include "checks/support/catch.hpp"
#include "checks/support/distributions.hpp"
#include "common/rng.hpp"
#include "stratification.hpp"

namespace {

using Strata = std::vector<std::size_t>;
struct Cell {
  std::size_t column, row;
};
using Cells = std::vector<Cell>;

/// How often each of several equally likely outcomes occurs.
struct OutcomeCounts {
  std::map<Strata, std::uint64_t> counts;
  std::uint64_t total = 0;

  bool operator==(const OutcomeCounts& other) const {
    if (counts.size() != other.counts.size()) return false;
    return std::equal(counts.begin(), counts.end(), other.counts.begin(),
                      [&](const auto& a, const auto& b) {
                        return a.first == b.first && a.second * other.total == b.second * total;
                      });
  }
};

std::vector<Strata> permutations_of(std::size_t n) {
  Strata order(n);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::vector<Strata> all;
  do all.push_back(order);
  while (std::next_permutation(order.begin(), order.end()));
  return all;
}

/// Calls visit with each list of `length` numbers below `below`.
template <class Visit>
void for_all(std::size_t length, std::size_t below, Visit visit) {
  Strata digits(length, 0);
  for (;;) {
    visit(digits);
    std::size_t d = 0;
    while (d < length && ++digits[d] == below) digits[d++] = 0;
    if (d == length) return;
  }
}

/// The stratum of its column (one of ny) for each of some cells: with a permutation for each of the
/// nx columns, or with one permutation, which each column starts at a different place.
OutcomeCounts outcomes_of(const Cells& cells, std::size_t nx, std::size_t ny, bool rotate) {
  const auto permutations = permutations_of(ny);
  OutcomeCounts law;
  const auto add = [&](auto stratum_of) {
    Strata outcome;
    for (const Cell& cell : cells) outcome.push_back(stratum_of(cell));
    ++law.counts[outcome];
    ++law.total;
  };
  if (!rotate) {
    for_all(nx, permutations.size(), [&](const Strata& which) {
      add([&](const Cell& cell) { return permutations[which[cell.column]][cell.row]; });
    });
    return law;
  }
  for (const Strata& permutation : permutations) {
    for_all(nx, ny, [&](const Strata& begins) {
      add([&](const Cell& cell) { return permutation[(begins[cell.column] + cell.row) % ny]; });
    });
  }
  return law;
}

/// All sets of `size` cells of nx columns and ny rows.
std::vector<Cells> sets_of_cells(std::size_t count, std::size_t nx, std::size_t ny) {
  std::vector<Cells> all;
  std::vector<bool> chosen(nx * ny, false);
  std::fill_n(chosen.begin(), count, true);
  do {
    Cells cells;
    for (std::size_t k = 0; k < chosen.size(); ++k) {
      if (chosen[k]) cells.push_back({k % nx, k / nx});
    }
    all.push_back(cells);
  } while (std::prev_permutation(chosen.begin(), chosen.end()));
  return all;
}

/// The number of sets of cells for which the two distributions differ.
std::size_t differing(std::size_t count, std::size_t nx, std::size_t ny) {
  std::size_t sets = 0;
  for (const Cells& cells : sets_of_cells(count, nx, ny)) {
    sets += !(outcomes_of(cells, nx, ny, false) == outcomes_of(cells, nx, ny, true));
  }
  return sets;
}

TEST_CASE("rotated permutations give three points strata like independent ones, but not four") {
  for (const auto& [nx, ny] :
       {std::pair<std::size_t, std::size_t>{2, 2}, {2, 3}, {3, 2}, {3, 3}, {2, 4}, {4, 2}}) {
    CAPTURE(nx, ny);
    for (const std::size_t count : {1u, 2u, 3u}) CHECK(differing(count, nx, ny) == 0);
  }
  CHECK(differing(4, 2, 2) == 0);
  CHECK(differing(4, 4, 2) == 0);
  CHECK(differing(4, 2, 3) > 0);  // if a column has three cells or more
  CHECK(differing(4, 3, 3) > 0);
}

/// The result of the solution for each cell: the stratum of x within its column, and of y within
/// its row.
struct StratumAssignment {
  std::vector<std::size_t> x, y;
};
StratumAssignment solution_strata(mc::Grid grid, mc::Rng& rng) {
  const std::size_t n = grid.nx * grid.ny;
  std::vector<double> x(n), y(n);
  mc::multi_jittered(x, y, grid, rng);
  StratumAssignment strata{std::vector<std::size_t>(n), std::vector<std::size_t>(n)};
  for (std::size_t k = 0; k < n; ++k) {
    const auto in_x = static_cast<std::size_t>(x[k] * static_cast<double>(n));
    const auto in_y = static_cast<std::size_t>(y[k] * static_cast<double>(n));
    const std::size_t cell = in_x / grid.ny + grid.nx * (in_y / grid.nx);
    strata.x[cell] = in_x % grid.ny;
    strata.y[cell] = in_y % grid.nx;
  }
  return strata;
}

TEST_CASE("the solution of 3.7 gives pairs of points strata as its definition does") {
  constexpr std::size_t side = 3, n = side * side, sets = 50'000;
  mc::Rng rng(20260101);
  std::vector<StratumAssignment> all;
  for (std::size_t set = 0; set < sets; ++set) {
    all.push_back(solution_strata({side, side}, rng));
  }
  double smallest = 1;
  std::size_t pairs = 0;
  for (std::size_t a = 0; a < n; ++a) {
    for (std::size_t b = a + 1; b < n; ++b, ++pairs) {
      std::map<std::array<std::size_t, 4>, double> counts;
      for (const StratumAssignment& one : all) ++counts[{one.x[a], one.x[b], one.y[a], one.y[b]}];
      // Two different strata of x in one column; two different ones of y in one row; else any two.
      const std::size_t of_x = a % side == b % side ? 6 : 9, of_y = a / side == b / side ? 6 : 9;
      const auto outcomes = static_cast<double>(of_x * of_y), expected = sets / outcomes;
      CHECK(counts.size() == of_x * of_y);
      double squares = 0;
      for (const auto& [outcome, count] : counts)
        squares += (count - expected) * (count - expected);
      smallest = std::min(
          smallest, mc::checks::chi_squared_tails(squares / expected, outcomes - 1).two_sided());
    }
  }
  CHECK(pairs == 36);
  CHECK(smallest > 1e-3 / static_cast<double>(pairs));  // one seed: the same verdict in every run
}

}  // namespace
