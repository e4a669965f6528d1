// Exact variances of stratified estimates against values computed independently, in high precision,
// by symbolic integration over the strata.
#include "checks/support/exact_stratified.hpp"
#include "checks/support/catch.hpp"

using namespace mc::checks;

namespace {

double exponential(double x) {
  return std::exp(x);
}
double gaussian(double x) {
  return std::exp(-x * x);
}
double identity(double x) {
  return x;
}
Approx near(double value) {
  return Approx(value).epsilon(1e-10);
}

}  // namespace

TEST_CASE("exact variances of exp(x) over N strata") {
  CHECK(stratified_variance(strata_of(exponential, 1)) == near(0.242035607452765357));
  CHECK(stratified_variance(strata_of(exponential, 4)) == near(0.00413370797718057278));
  CHECK(stratified_variance(strata_of(exponential, 64)) == near(1.01548832574989783e-6));
  CHECK(stratified_variance(strata_of(exponential, 1024)) == near(2.47927983664862434e-10));
}

TEST_CASE("exact variances of jittered grids") {
  const auto gauss8 = strata_of(gaussian, 8), gauss32 = strata_of(gaussian, 32);
  CHECK(stratified_variance(product_of(gauss8, gauss8)) == near(0.0000112477699241881353));
  CHECK(stratified_variance(product_of(gauss32, gauss32)) == near(4.39963442571125873e-8));
  CHECK(stratified_variance(edge_strata(0.1, 1)) == near(0.235877170725626081));
  CHECK(stratified_variance(edge_strata(0.1, 8)) == near(0.000389377394737158537));
  CHECK(stratified_variance(edge_strata(0.1, 32)) == near(5.97968504178021536e-6));
  CHECK(mean_of(edge_strata(0.1, 7)) == near(0.61883951057781212162615994523746));
}

TEST_CASE("exact variances of Latin hypercubes") {
  const auto gauss64 = strata_of(gaussian, 64), gauss1024 = strata_of(gaussian, 1024);
  CHECK(shuffled_product_variance(gauss64, gauss64) == near(0.0000260683025964323714));
  CHECK(shuffled_product_variance(gauss1024, gauss1024) == near(1.59532441126581342e-6));
  const auto x4 = strata_of(identity, 4), x64 = strata_of(identity, 64);
  CHECK(shuffled_product_variance(x4, x4) == near(0.00289577907986111111));
  CHECK(shuffled_product_variance(x64, x64) == near(0.000110387381735361285));
}

TEST_CASE("the first n of N shuffled strata") {
  // All of them: the stratified variance. One of them: the variance of the function itself.
  const auto strata = strata_of(exponential, 16);
  CHECK(variance_of_first(strata, 16) == near(stratified_variance(strata)));
  CHECK(variance_of_first(strata, 1) == near(0.242035607452765357));
  CHECK(independent_variance(strata, 10) == near(0.0242035607452765357));
  // Two of two: their mean is known in any order.
  CHECK(variance_of_first(strata_of(exponential, 2), 2) ==
        near(stratified_variance(strata_of(exponential, 2))));
}
