// Exact moments and variances of checks against values computed independently, in high precision.

#include <cmath>
#include <vector>

#include "checks/support/catch.hpp"
#include "checks/support/exact.hpp"
#include "checks/support/exact_stratified.hpp"
#include "checks/support/light_strata.hpp"

using namespace mc;
using namespace mc::checks;

TEST_CASE("exact moments of NIST's data") {
  // The moments of the doubles nearest to NIST's decimals, to 16 digits, in decimal arithmetic.
  std::vector<double> numacc3{1000000.2}, numacc4{10000000.2};
  for (int i = 0; i < 500; ++i) {
    numacc3.insert(numacc3.end(), {1000000.1, 1000000.3});
    numacc4.insert(numacc4.end(), {10000000.1, 10000000.3});
  }
  CHECK(exact_moments(numacc3).variance == 0.0100000000069849193108392);
  CHECK(exact_moments(numacc4).variance == 0.01000000011175870926697414);
  CHECK(static_cast<double>(exact_mean(numacc3)) == 1000000.200000000011583383);
  CHECK(exact_moments(std::vector<double>{10000001, 10000003, 10000002}).variance == 1);
}

// By symbolic integration over the strata.
TEST_CASE("exact variances of stratified estimates") {
  const auto exponential = [](std::size_t n) {
    return strata_of([](double x) { return std::exp(x); }, n);
  };
  const auto gaussian = [](std::size_t n) {
    return strata_of([](double x) { return std::exp(-x * x); }, n);
  };
  const auto identity = [](std::size_t n) { return strata_of([](double x) { return x; }, n); };
  const double of_exponential = 0.242035607452765357;
  const auto strata = exponential(16), two = exponential(2);
  const struct {
    double got, expected;
  } cases[] = {
      {stratified_variance(exponential(1)), of_exponential},
      {stratified_variance(exponential(4)), 0.00413370797718057278},
      {stratified_variance(exponential(64)), 1.01548832574989783e-6},
      {stratified_variance(exponential(1024)), 2.47927983664862434e-10},
      // jittered grids
      {stratified_variance(product_of(gaussian(8), gaussian(8))), 0.0000112477699241881353},
      {stratified_variance(product_of(gaussian(32), gaussian(32))), 4.39963442571125873e-8},
      {stratified_variance(edge_strata(0.1, 1)), 0.235877170725626081},
      {stratified_variance(edge_strata(0.1, 8)), 0.000389377394737158537},
      {stratified_variance(edge_strata(0.1, 32)), 5.97968504178021536e-6},
      {mean_of(edge_strata(0.1, 7)), 0.61883951057781212162615994523746},
      // Latin hypercubes
      {shuffled_product_variance(gaussian(64), gaussian(64)), 0.0000260683025964323714},
      {shuffled_product_variance(gaussian(1024), gaussian(1024)), 1.59532441126581342e-6},
      {shuffled_product_variance(identity(4), identity(4)), 0.00289577907986111111},
      {shuffled_product_variance(identity(64), identity(64)), 0.000110387381735361285},
      // The first n of N shuffled strata: all of them, one of them, two of two in any order.
      {variance_of_first(strata, 16), stratified_variance(strata)},
      {variance_of_first(strata, 1), of_exponential},
      {independent_variance(strata, 10), of_exponential / 10},
      {variance_of_first(two, 2), stratified_variance(two)},
  };
  for (const auto& one : cases) CHECK(one.got == Approx(one.expected).epsilon(1e-10));
}

// By quadrature with 48 x 48 nodes per part in long double.
TEST_CASE("exact variances within the strata of a light") {
  const RectLight near{}, off_axis{0.25, 1.75, -0.5, 0.5, 0.75, 2}, far{-0.5, 0.5, -0.5, 0.5, 4, 3};
  const struct {
    RectLight light;
    Grid grid;
    double expected;
  } cases[] = {{near, {1, 1}, 0.194078193347675},      {near, {3, 2}, 0.0127798491377495},
               {near, {5, 1}, 0.0086495693603652},     {near, {8, 8}, 0.000166964609450934},
               {off_axis, {3, 2}, 0.0380052741096373}, {off_axis, {12, 7}, 0.000186315799671413},
               {far, {1, 1}, 5.68821231534276e-06},    {far, {16, 16}, 4.26021839163041e-10}};
  for (const auto& [light, grid, expected] : cases) {
    CHECK(stratified_variance(light_strata(light, grid)) == Approx(expected).epsilon(1e-9));
  }
  CHECK(irradiance(off_axis) == Approx(1.03025120834571112).epsilon(1e-14));
}
