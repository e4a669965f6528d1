// The judge's distributions against an independent implementation, Boost.Math, if it is installed.

#if __has_include(<boost/math/distributions/fisher_f.hpp>)

#include <boost/math/distributions/binomial.hpp>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/distributions/normal.hpp>

#include "checks/support/catch.hpp"
#include "checks/support/distributions.hpp"
#include "common/normal_quantile.hpp"

using mc::checks::Tails;

namespace {

/// The accuracy that distributions.hpp states: relative, in both tails, down to 1e-300.
template <class Distribution, class X>
void check_tails(const Tails& got, const Distribution& distribution, X x) {
  CAPTURE(x);
  const double lower = cdf(distribution, x), upper = cdf(complement(distribution, x));
  if (lower > 1e-300) CHECK(got.lower == Approx(lower).epsilon(1e-9));
  if (upper > 1e-300) CHECK(got.upper == Approx(upper).epsilon(1e-9));
}

}  // namespace

TEST_CASE("tails agree with Boost.Math") {
  for (const double z : {-37.0, -8.5, -3.0, -0.1, 0.0, 1e-9, 0.7, 4.0, 12.0, 36.0}) {
    check_tails(mc::checks::normal_tails(z), boost::math::normal(), z);
  }
  for (const double degrees : {0.5, 1.0, 2.0, 7.5, 63.0, 1000.0, 1e5}) {
    for (const double part : {1e-6, 0.01, 0.3, 0.9, 1.0, 1.1, 2.0, 5.0}) {
      const double x = part * degrees;
      check_tails(mc::checks::chi_squared_tails(x, degrees), boost::math::chi_squared(degrees), x);
      for (const double below : {1.0, 9.0, 400.0}) {
        check_tails(mc::checks::f_tails(part, degrees, below),
                    boost::math::fisher_f(degrees, below), part);
      }
    }
  }
}

TEST_CASE("binomial tails agree with Boost.Math; both include k") {
  for (const std::uint64_t n : {1u, 10u, 1000u, 100'000u}) {
    for (const double p : {1e-3, 0.25, 0.5, 0.95}) {
      const boost::math::binomial distribution(static_cast<double>(n), p);
      for (const std::uint64_t k : {std::uint64_t{0}, n / 100, n / 4, n / 2, n - 1, n}) {
        CAPTURE(n, p, k);
        const auto trials = static_cast<double>(k);
        const Tails got = mc::checks::binomial_tails(k, n, p);
        const double lower = cdf(distribution, trials);
        const double upper = k == 0 ? 1 : cdf(complement(distribution, trials - 1));
        if (lower > 1e-300) CHECK(got.lower == Approx(lower).epsilon(1e-9));
        if (upper > 1e-300) CHECK(got.upper == Approx(upper).epsilon(1e-9));
      }
    }
  }
}

TEST_CASE("the normal quantile agrees with Boost.Math") {
  for (const double p : {1e-300, 1e-20, 1e-5, 0.02, 0.3, 0.5, 0.75, 0.99, 1 - 1e-9}) {
    CAPTURE(p);
    CHECK(mc::normal_quantile(p) == Approx(quantile(boost::math::normal(), p)).margin(1e-12));
  }
}

#endif
