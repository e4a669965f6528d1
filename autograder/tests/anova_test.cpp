// The variance by order, for functions with known values.

#include <cmath>

#include "checks/support/catch.hpp"
#include "measurements/sampler/anova.hpp"

namespace mc::checks {
namespace {

/// Mean 0, variance 1.
double centered(double x) {
  return std::sqrt(12.0) * (x - 0.5);
}

/// (1 + a h(x0)) (1 + b h(x1)) (1 + c h(x2)): a set of factors makes the product of their squares.
struct Product {
  static constexpr std::string_view uses = "next2 next";
  double a = 0.6, b = 0.3, c = 0.8;
  double operator()(Sampler& sampler) const {
    const Point2 p = sampler.next2();
    return (1 + a * centered(p.x)) * (1 + b * centered(p.y)) * (1 + c * centered(sampler.next()));
  }
};

TEST_CASE("the variance by order of a product") {
  const Product f;
  const double a = f.a * f.a, b = f.b * f.b, c = f.c * f.c;
  const double whole = (1 + a) * (1 + b) * (1 + c) - 1;
  Rng rng(5);
  const Anova anova = anova_of(f, 1 << 17, rng);
  REQUIRE(anova.by_order.size() == 3);
  // Fractions of a variance, from 131,072 points: a standard error of some 0.003.
  CHECK(anova.by_order[0] == Approx((a + b + c) / whole).margin(0.015));
  CHECK(anova.by_order[1] == Approx((a * b + a * c + b * c) / whole).margin(0.015));
  CHECK(anova.by_order[2] == Approx(a * b * c / whole).margin(0.015));
  CHECK(anova.by_order[0] + anova.by_order[1] + anova.by_order[2] == Approx(1).epsilon(1e-9));
  // The second use alone, and the first use with both of its dimensions.
  CHECK(anova.within_uses == Approx((a + b + a * b + c) / whole).margin(0.015));
}

/// Depends on only one of its two dimensions.
struct OneDimension {
  static constexpr std::string_view uses = "next next";
  double operator()(Sampler& sampler) const {
    const double x = sampler.next();
    return sampler.next() < 0.3 ? 1 : 0 * x;
  }
};

TEST_CASE("a function of one dimension has no variance of higher order") {
  Rng rng(6);
  const Anova anova = anova_of(OneDimension{}, 1 << 14, rng);
  CHECK(anova.by_order[0] == Approx(1).margin(0.03));
  CHECK(anova.by_order[1] == Approx(0).margin(0.03));
  CHECK(anova.within_uses == Approx(anova.by_order[0]).epsilon(1e-9));
}

}  // namespace
}  // namespace mc::checks
