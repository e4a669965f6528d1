// The null distributions against published values, and the p-values of every test against the
// uniform distribution.

#include "checks/support/statistics.hpp"

#include <algorithm>
#include <cmath>

#include "checks/support/catch.hpp"
#include "checks/support/distributions.hpp"
#include "checks/support/domain.hpp"

using namespace mc;
using namespace mc::checks;

namespace {

/// `got` rounds to the published decimal, whose last digit is worth `unit`.
void check_published(double got, double published, double unit) {
  CHECK(std::abs(got - published) <= unit / 2 * (1 + 1e-9));
}

}  // namespace

TEST_CASE("tails against published tables") {
  // Abramowitz and Stegun, "Handbook of Mathematical Functions", table 26.8: the upper percentage
  // points of chi-squared, here as probabilities to the digits that the points carry.
  check_published(chi_squared_tails(18.3070, 10).upper, 0.05, 2e-6);
  check_published(chi_squared_tails(3.94030, 10).lower, 0.05, 1e-6);
  check_published(chi_squared_tails(149.449, 100).upper, 0.001, 2e-7);
  check_published(chi_squared_tails(67.3276, 100).lower, 0.005, 1e-6);
  // Table 26.9: F at Q = 0.05 and 0.01, to three or four digits.
  check_published(f_tails(2.98, 10, 10).upper, 0.05, 2e-3);
  check_published(f_tails(5.64, 5, 10).upper, 0.01, 1e-4);
  // Table 26.1: the normal probability function, and its complement far out (table 26.2).
  check_published(normal_tails(1.96).lower, 0.975002104851780, 1e-15);
  CHECK(normal_tails(5).upper == Approx(2.866515719e-7).epsilon(1e-9));
  // Ten tosses of a coin: (1 + 10 + 45)/1024 and (120 + … + 1)/1024.
  CHECK(binomial_tails(2, 10, 0.5).lower == Approx(56.0 / 1024).epsilon(1e-14));
  CHECK(binomial_tails(3, 10, 0.5).upper == Approx(968.0 / 1024).epsilon(1e-14));
  CHECK(binomial_tails(0, 10, 0.25).lower == Approx(std::pow(0.75, 10)).epsilon(1e-14));
  CHECK(binomial_tails(0, 10, 0.25).upper == 1);
  CHECK(binomial_tails(10, 10, 0.25).upper == Approx(std::pow(0.25, 10)).epsilon(1e-14));
}

TEST_CASE("Kolmogorov's distribution against exact values") {
  // Marsaglia, Tsang, Wang 2003, "Evaluating Kolmogorov's distribution": two they print, the others
  // computed with their algorithm.
  CHECK(kolmogorov_tails(0.274, 10).lower == Approx(0.6284796154565).epsilon(2e-3));
  CHECK(kolmogorov_tails(0.04, 2000).upper == Approx(1 - 0.99676943191713677).epsilon(1e-6));
  CHECK(kolmogorov_tails(0.13403, 100).upper == Approx(1 - 0.950005687599185).epsilon(2e-3));
  CHECK(kolmogorov_tails(0.0614, 200).lower == Approx(0.5789050735157332).epsilon(2e-3));
  CHECK(kolmogorov_tails(0.026, 1000).lower == Approx(0.4997362481165897).epsilon(2e-3));
  CHECK(kolmogorov_tails(0.02, 1000).lower == Approx(0.18910286892978506).epsilon(2e-3));
  CHECK(kolmogorov_tails(0.05, 100).lower == Approx(0.046784028936427455).epsilon(2e-3));
  CHECK(kolmogorov_tails(1, 100).upper < 1e-100);
  CHECK(kolmogorov_tails(0, 100).lower == 0);
}

TEST_CASE("central intervals") {
  const auto chi_squared = [](double ratio) { return chi_squared_tails(200 * ratio, 200); };
  const Interval a = central_interval(chi_squared, 1e-6, 0, 100);
  CHECK(a.low == Approx(0.5847188686849145).epsilon(1e-9));
  CHECK(a.high == Approx(1.5676738874304263).epsilon(1e-9));
  const Interval z = central_interval(normal_tails, 1e-6, -40, 40);
  CHECK(z.low == Approx(-4.891638475698591).epsilon(1e-10));
  CHECK(z.high == Approx(4.891638475698591).epsilon(1e-10));
  const auto f = [](double ratio) { return f_tails(ratio, 400, 400); };
  CHECK(std::log(central_interval(f, 1e-6, 0, 100).high) / (2 * std::log(16)) ==
        Approx(0.08871038188355673).epsilon(1e-9));
}

TEST_CASE("NaN is impossible") {
  const double nan = std::nan("");
  CHECK(normal_tails(nan).two_sided() == 0);
  CHECK(chi_squared_tails(nan, 3).two_sided() == 0);
  CHECK(f_tails(nan, 3, 3).two_sided() == 0);
  CHECK(kolmogorov_tails(nan, 3).two_sided() == 0);
}

// Uniform p-values --------------------------------------------------------------------------------

namespace {

constexpr int repetitions = 4000;
constexpr double never = 1e-15;  // the tests themselves must not fail here

/// Are p-values of `test` uniform? With 4000 of them a distance of 0.04 has probability 1e-5; the
/// seed is fixed, so the outcome is the same in every run.
template <class Test>
void check_uniform(Test test) {
  Rng rng(20260101);
  std::vector<double> p(repetitions);
  for (double& value : p) value = test(rng);
  std::sort(p.begin(), p.end());
  double distance = 0;
  for (int i = 0; i < repetitions; ++i) {
    const double below = static_cast<double>(i) / repetitions;
    distance = std::max({distance, p[static_cast<std::size_t>(i)] - below,
                         below + 1.0 / repetitions - p[static_cast<std::size_t>(i)]});
  }
  CHECK(distance < 0.04);
  CHECK(kolmogorov_tails(distance, repetitions).two_sided() > 1e-3);
}

/// `count` means of n uniform numbers: mean 1/2, variance 1/(12n), kurtosis 3 - 1.2/n.
std::vector<double> means_of_uniform(Rng& rng, std::size_t count, int n) {
  std::vector<double> means(count);
  for (double& mean : means) {
    for (int i = 0; i < n; ++i) mean += uniform(rng) / n;
  }
  return means;
}

}  // namespace

TEST_CASE("p-values of a mean are uniform") {
  check_uniform([](Rng& rng) {
    const auto means = means_of_uniform(rng, 50, 8);
    return expect_mean({"", means, 8}, 0.5, 1.0 / (12 * 8), {"", never}, {});
  });
}

TEST_CASE("p-values of a variance are uniform") {
  check_uniform([](Rng& rng) {
    const auto means = means_of_uniform(rng, 100, 8);
    return expect_variance({"", means, 8}, 0.5, 1.0 / (12 * 8), 3 - 1.2 / 8, {"", never}, {});
  });
}

TEST_CASE("p-values of a proportion are uniform") {
  check_uniform([](Rng& rng) {
    std::uint64_t count = 0;
    for (int i = 0; i < 30; ++i) count += uniform(rng) < 0.1 ? 1 : 0;
    return expect_proportion("", "", count, 30, 0.1, {"", never}, {});
  });
}
