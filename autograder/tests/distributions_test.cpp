// The null distributions against values computed with mpmath to 60 digits, and the p-values of the
// tests that use them against the uniform distribution.

#include "checks/support/distributions.hpp"

#include <cmath>
#include <utility>
#include <vector>

#include "checks/support/catch.hpp"
#include "checks/support/domain.hpp"
#include "checks/support/statistics.hpp"
#include "common/normal_quantile.hpp"

using namespace mc;
using namespace mc::checks;

TEST_CASE("tails have a relative accuracy of 1e-9 down to 1e-300") {
  const struct {
    Tails got;
    double lower, upper;
  } cases[] = {
      {normal_tails(-37.0), 5.7255712225245768e-300, 1},
      {normal_tails(-8.5), 9.4795348222033184e-18, 1},
      {normal_tails(-0.1), 0.46017216272297102, 0.53982783727702898},
      {normal_tails(1e-9), 0.50000000039894228, 0.49999999960105772},
      {normal_tails(1.96), 0.97500210485177956, 0.024997895148220436},
      {normal_tails(5.0), 0.99999971334842812, 2.8665157187919391e-7},
      {normal_tails(36.0), 1, 4.1826240657972833e-284},
      {chi_squared_tails(5e-7, 0.5), 0.024669701620415345, 0.97533029837958465},
      {chi_squared_tails(0.075, 7.5), 2.6303989831411709e-7, 0.99999973696010169},
      {chi_squared_tails(18.307, 10), 0.94999941090860188, 0.05000058909139812},
      {chi_squared_tails(70, 63), 0.7456326948472805, 0.2543673051527195},
      {chi_squared_tails(2000, 1000), 1, 4.1436785914549917e-69},
      {chi_squared_tails(90000, 100000), 7.0554989738953195e-119, 1},
      {f_tails(1e-6, 0.5, 1), 0.020282909081714189, 0.97971709091828581},
      {f_tails(2, 7.5, 9), 0.83742262334653255, 0.16257737665346745},
      {f_tails(5, 63, 400), 1, 6.19233012267744e-24},
      {f_tails(0.3, 1000, 400), 4.5385101387583437e-53, 1},
      {f_tails(1.1, 100000, 9), 0.51593721756171089, 0.48406278243828911},
      {binomial_tails(0, 10, 0.25), 0.056313514709472656, 1},
      {binomial_tails(3, 10, 0.5), 0.171875, 0.9453125},
      {binomial_tails(10, 1000, 1e-3), 0.99999999040004481, 1.0742833868464873e-7},
      {binomial_tails(250, 1000, 0.25), 0.51698654590917137, 0.51213755997453372},
      {binomial_tails(49000, 100000, 0.5), 1.2943580191734489e-10, 0.99999999987575886},
      {binomial_tails(10, 10, 0.25), 1, 0x1p-20},
  };
  for (const auto& one : cases) {
    CAPTURE(one.lower, one.upper);
    CHECK(one.got.lower == Approx(one.lower).epsilon(1e-9));
    CHECK(one.got.upper == Approx(one.upper).epsilon(1e-9));
  }
  for (const Tails& of_nan : {normal_tails(NAN), chi_squared_tails(NAN, 3), f_tails(NAN, 3, 3),
                              kolmogorov_tails(NAN, 3)}) {
    CHECK(of_nan.two_sided() == 0);
  }
}

TEST_CASE("Kolmogorov's distribution against exact values") {
  // Marsaglia, Tsang, Wang 2003, "Evaluating Kolmogorov's distribution": two they print, the others
  // computed with their algorithm.
  CHECK(kolmogorov_tails(0.274, 10).lower == Approx(0.6284796154565).epsilon(2e-3));
  CHECK(kolmogorov_tails(0.04, 2000).upper == Approx(1 - 0.99676943191713677).epsilon(1e-6));
  CHECK(kolmogorov_tails(0.13403, 100).upper == Approx(1 - 0.950005687599185).epsilon(2e-3));
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
}

// The root of log(erfc(-x / sqrt(2)) / 2) - log(p), where p is the exact value of the double.
TEST_CASE("normal quantiles over the whole range of double") {
  const std::pair<double, double> exact[] = {{0.4, -0.2533471031357997413247},
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
  for (const auto& [p, x] : exact) {
    CHECK(std::abs(normal_quantile(p) - x) <= 1e-14 * std::abs(x) + 1e-16);
  }
  CHECK(std::abs(normal_quantile(0.5)) <= 1e-16);
  CHECK(normal_quantile(0.975) == -normal_quantile(1 - 0.975));
  CHECK(normal_quantile(0) == -HUGE_VAL);
  CHECK(normal_quantile(1) == HUGE_VAL);
  for (const double p : {-0.1, 1.1, std::nan("")}) CHECK(std::isnan(normal_quantile(p)));
}

namespace {

/// `count` means of n uniform numbers: mean 1/2, variance 1/(12n), kurtosis 3 - 1.2/n.
std::vector<double> means_of_uniform(Rng& rng, std::size_t count, int n) {
  std::vector<double> means(count);
  for (double& mean : means) {
    for (int i = 0; i < n; ++i) mean += uniform(rng) / n;
  }
  return means;
}

}  // namespace

/// With 4000 p-values a distance of 0.04 has probability 1e-5; the seed is fixed, so the outcome is
/// the same in every run.
TEST_CASE("p-values of means, variances and proportions are uniform") {
  constexpr double never = 1e-15;  // the tests themselves must not fail here
  const auto of_mean = [](Rng& rng) {
    return expect_mean({"", means_of_uniform(rng, 50, 8), 8}, 0.5, 1.0 / (12 * 8), {"", never}, {});
  };
  const auto of_variance = [](Rng& rng) {
    return expect_variance({"", means_of_uniform(rng, 100, 8), 8}, 0.5, 1.0 / (12 * 8), 3 - 1.2 / 8,
                           {"", never}, {});
  };
  const auto of_proportion = [](Rng& rng) {
    std::uint64_t count = 0;
    for (int i = 0; i < 30; ++i) count += uniform(rng) < 0.1 ? 1 : 0;
    return expect_proportion("", "", count, 30, 0.1, {"", never}, {});
  };
  for (double (*test)(Rng&) : {+of_mean, +of_variance, +of_proportion}) {
    Rng rng(20260101);
    std::vector<double> p(4000);
    for (double& value : p) value = test(rng);
    const double distance = distance_from_uniform(p);
    CHECK(distance < 0.04);
    CHECK(kolmogorov_tails(distance, p.size()).two_sided() > 1e-3);
  }
}
