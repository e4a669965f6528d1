// What the functions of lab 5 refuse, one table per task: the "throws:" lines of the header.

#include "5-halton/experiments.hpp"
#include "checks/halton/exact_points.hpp"

namespace mc::checks {
namespace {

const std::string no_digits = "a base is at least 2";
const std::string past_the_end = "the last index is 2^64 - 1";

CHECK_CASE("5.1 a base below 2 is refused", "[5.1][points:1][edge]") {
  std::vector<InvalidCall> calls;
  for (const unsigned base : {0u, 1u}) {
    for (const std::uint64_t index : {5u, 0u}) {
      calls.push_back({MEASURE_OUTCOME(radical_inverse, base, {index}), "base", no_digits});
    }
  }
  expect_refused_by_name(calls);
}

CHECK_CASE("5.2 a column past the last index is refused", "[5.2][stretch][edge]") {
  const std::string range = "first|column|index|indices";
  expect_refused_by_name(
      {{MEASURE_OUTCOME(radical_inverses, 0, 0, 10), "base", no_digits},
       {MEASURE_OUTCOME(radical_inverses, 1, 0, 10), "base", no_digits},
       {MEASURE_OUTCOME(radical_inverses, 1, 7, 1), "base", no_digits},
       {MEASURE_OUTCOME(radical_inverses, 1, 7, 0), "base", no_digits},
       {MEASURE_OUTCOME(radical_inverses, 3, last_index - 1, 3), range, past_the_end},
       {MEASURE_OUTCOME(radical_inverses, 2, last_index, 2), range, past_the_end},
       {MEASURE_OUTCOME(radical_inverses, 2, last_index - 4094, 4097), range, past_the_end}});
}

CHECK_CASE("5.3 points past the last index are refused", "[5.3][points:1][edge]") {
  const std::string range = "first|points|point|index|indices";
  expect_refused_by_name({{MEASURE_OUTCOME(halton, 3, 2, last_index - 1), range, past_the_end},
                          {MEASURE_OUTCOME(halton, 2, 1, last_index), range, past_the_end}});
}

std::vector<InvalidCall> no_such_points() {
  const std::string dimensions = "the table has 32 dimensions, from 0 to 31";
  const std::string indices = "the last index is 2^32 - 1", range = "first|column|index|indices";
  return {{MEASURE_OUTCOME(sobol, 32, 0, 4), "dimension", dimensions},
          {MEASURE_OUTCOME(sobol, 33, 0, 0), "dimension", dimensions},
          {MEASURE_OUTCOME(sobol, 4294967295u, 0, 4), "dimension", dimensions},
          {MEASURE_OUTCOME(sobol, 0, sobol_end - 2, 3), range, indices},
          {MEASURE_OUTCOME(sobol, 31, sobol_end, 1), range, indices},
          {MEASURE_OUTCOME(sobol, 1, last_index, 2), range, indices}};
}

REFUSAL_CASES("5.5", "Sobol' points that do not exist are refused", "1",
              "a refusal names its argument", "1", no_such_points())

std::vector<InvalidCall> no_points_of_the_square() {
  const std::string none = "there are no points";
  std::vector<InvalidCall> calls{
      {MEASURE_OUTCOME(star_discrepancy_1d, {}), "x|point|empty", none},
      {MEASURE_OUTCOME(star_discrepancy_2d, {}, {}), "x|y|point|empty", none}};
  for (const auto& [x, y] :
       {std::pair{Values{0.1, 0.2}, Values{0.3}}, {{0.1}, {0.3, 0.4}}, {{}, {0.3}}, {{0.3}, {}}}) {
    calls.push_back({MEASURE_OUTCOME(star_discrepancy_2d, x, y), "x|y|size|point",
                     "x and y must have the same size"});
  }
  for (const double outside : {1.5, -0.1, -1e-300, 1 + 2 * half_ulp, infinity, -infinity, nan}) {
    const std::string because = "a point has coordinates in [0, 1]";
    calls.push_back({MEASURE_OUTCOME(star_discrepancy_1d, {0.5, outside}), "x", because});
    calls.push_back({MEASURE_OUTCOME(star_discrepancy_1d, {outside, 0.5}), "x", because});
    calls.push_back({MEASURE_OUTCOME(star_discrepancy_1d, {outside}), "x", because});
    calls.push_back(
        {MEASURE_OUTCOME(star_discrepancy_2d, {0.5, 0.1}, {0.2, outside}), "y", because});
    calls.push_back(
        {MEASURE_OUTCOME(star_discrepancy_2d, {outside, 0.1}, {0.2, 0.3}), "x", because});
  }
  return calls;
}

REFUSAL_CASES("5.6", "points outside the unit square are refused", "1",
              "a refusal names its argument", "1", no_points_of_the_square())

CHECK_CASE("5.9 no other bases and no later indices", "[5.9][points:0.5][edge]") {
  const std::string bases = "bases from 2 to 2^16", range = "first|column|index|indices";
  std::vector<InvalidCall> calls{
      {MEASURE_OUTCOME(radical_inverses_scrambled, 3, last_index - 1, 3, {1}), range, past_the_end},
      {MEASURE_OUTCOME(radical_inverses_scrambled, 2, last_index, 2, {1}), range, past_the_end}};
  for (const unsigned base : {0u, 1u, 65537u, 4294967295u}) {
    calls.push_back({MEASURE_OUTCOME(radical_inverses_scrambled, base, 0, 10, {1}), "base", bases});
    calls.push_back({MEASURE_OUTCOME(radical_inverses_scrambled, base, 7, 0, {1}), "base", bases});
  }
  expect_refused_by_name(calls);
}

CHECK_CASE("5.10 more dimensions than the vector has are refused", "[5.10][stretch][edge]") {
  const std::string because = "lattice_vector has 16 numbers";
  expect_refused_by_name({{MEASURE_OUTCOME(lattice, 4, 17, {1}), "points|dims", because},
                          {MEASURE_OUTCOME(lattice, 2, 1000, {1}), "points|dims", because}});
}

}  // namespace
}  // namespace mc::checks
