// The closed form of a rectangular light against values computed independently to 24 digits.
#include "checks/support/catch.hpp"
#include "checks/support/rect_light_exact.hpp"

using namespace mc;
using namespace mc::checks;

TEST_CASE("irradiance of a rectangular light") {
  const RectLight light;  // [-1, 1] x [-1/2, 1/2] at height 1
  CHECK(irradiance(light) == Approx(1.133290224099014525738617).epsilon(1e-14));
  const auto value = [&](double x, double y) {
    const double distance2 = x * x + y * y + 1;
    return area(light) / (distance2 * distance2);
  };
  const double mean = mean_over(light, value);
  CHECK(mean == Approx(irradiance(light)).epsilon(1e-7));
  CHECK(mean_over(light, [&](double x, double y) { return value(x, y) * value(x, y); }) -
            mean * mean ==
        Approx(0.19407819334767491552).epsilon(1e-6));
}

TEST_CASE("irradiance adds up over parts of a light, for any partition") {
  const RectLight whole{-0.3, 1.7, 0.4, 1.1, 0.6, 5};
  RectLight left = whole, right = whole;
  left.x1 = right.x0 = 0.8;
  CHECK(irradiance(left) + irradiance(right) == Approx(irradiance(whole)).epsilon(1e-14));
}
