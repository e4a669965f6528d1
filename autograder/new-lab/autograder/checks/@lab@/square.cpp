// @number@.1: the square.

#include "@folder@/experiments.hpp"
#include "checks/support/checks.hpp"

namespace mc::checks {
namespace {

CHECK_CASE("@number@.1 the square of a number", "[@number@.1][main][points:100]") {
  std::vector<double> x{0, 1, -1, 1e-160, 1e160};
  for (int i = 0; i < 100; ++i) x.push_back(uniform(rng, -10, 10));
  std::vector<double> exact;
  for (const double value : x) exact.push_back(value * value);  // one rounding, as for everyone
  const auto got = MEASURE(squares, x);
  expect_each({got.call, got.exactly(x.size(), any_number)},
              {.exact = exact,
               .because = "one multiplication is rounded once",
               .suspects = {{x, "this is x itself, not its square"_likely}},
               .rule = "multiply x by itself"});
}

}  // namespace
}  // namespace mc::checks
