// What the functions of lab 1 refuse, one table per task: the "throws:" lines of the header.

#include "1-variance/experiments.hpp"
#include "checks/support/checks.hpp"

namespace mc::checks {
namespace {

std::vector<InvalidCall> lists_of_two_sizes() {
  std::vector<InvalidCall> calls;
  for (const auto& [n_x, n_y] : {std::pair{3u, 2u}, {2u, 3u}, {1u, 0u}, {0u, 1u}, {64u, 1000u}}) {
    calls.push_back({MEASURE_OUTCOME(covariance, Values(n_x, 1.5), Values(n_y, 2.5)), "x|y",
                     "lists of different sizes have no pairs"});
  }
  return calls;
}

REFUSAL_CASES("1.6", "lists of different sizes are refused", "1", "the refusal names the argument",
              "1", lists_of_two_sizes())

std::vector<InvalidCall> invalid_tables() {
  std::vector<InvalidCall> calls;
  const auto add = [&](Values joint, std::size_t columns, const char* argument,
                       const char* because) {
    calls.push_back({MEASURE_OUTCOME(dependence, std::move(joint), columns), argument, because});
  };
  add({1, 1, 1, 1}, 0, "columns", "a table has at least one column");
  add({}, 0, "columns|joint|total", "a table has at least one column");
  for (const std::uint64_t columns : {2u, 3u, 4u, 6u}) {
    add({1, 1, 1, 1, 1}, columns, "joint|columns",
        "five weights do not fill a table with this number of columns");
  }
  add({1, 1}, std::uint64_t{1} << 63, "joint|columns",
      "two weights do not fill a table with 2^63 columns");
  for (const double wrong : {-1.0, -1e-300, nan, infinity, -infinity}) {
    for (const std::size_t cell : {1u, 0u, 3u}) {
      Values joint{5, 4, 3, 2};
      joint[cell] = wrong;
      add(joint, 2, "joint|weight", "a weight must be finite, and not negative");
    }
  }
  add({0, 0, 0, 0}, 2, "joint|total", "a total of 0 cannot be normalized");
  add({}, 2, "joint|total", "a total of 0 cannot be normalized");
  return calls;
}

REFUSAL_CASES("1.7", "invalid tables are refused", "1", "each refusal names the argument", "1",
              invalid_tables())

}  // namespace
}  // namespace mc::checks
