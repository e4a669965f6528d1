// normal_quantile() against values computed with mpmath to 22 digits, by the root of
// log(erfc(-x / sqrt(2)) / 2) - log(p), where p is the exact value of the double.

#include "common/normal_quantile.hpp"

#include <cmath>
#include <utility>

#include "checks/support/catch.hpp"

TEST_CASE("normal quantiles over the whole range of double") {
  const std::pair<double, double> published[] = {
      {0.4, -0.2533471031357997413247},
      {0.1, -1.281551565544600435335},
      {0.025, -1.95996398454005421178},
      {1e-3, -3.090232306167813535358},
      {1e-10, -6.3613409024040561991},
      {1e-100, -21.27345356096532429418},
      {1e-299, -36.98493649690257222911},
      {1e-300, -37.04709629936119923655},
      {1e-301, -37.1091521319159184383},
      {1e-305, -37.35634609306710368901},
      {2.2250738585072014e-308, -37.51937934714449982068},
      {1e-310, -37.66306033194952373189},
      {1e-320, -38.26912534303265101818},
      {5e-324, -38.46740561714434625078}};
  for (const auto& [p, x] : published) {
    CHECK(std::abs(mc::normal_quantile(p) - x) <= 1e-14 * std::abs(x) + 1e-16);
  }
  CHECK(std::abs(mc::normal_quantile(0.5)) <= 1e-16);
  CHECK(mc::normal_quantile(0.975) == -mc::normal_quantile(1 - 0.975));
  CHECK(mc::normal_quantile(0) == -HUGE_VAL);
  CHECK(mc::normal_quantile(1) == HUGE_VAL);
  for (const double p : {-0.1, 1.1, std::nan("")}) CHECK(std::isnan(mc::normal_quantile(p)));
}
