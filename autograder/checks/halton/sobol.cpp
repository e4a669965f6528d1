// 5.5: Sobol' points, bit by bit.

#include "5-halton/experiments.hpp"
#include "checks/halton/expect_axes.hpp"
#include "checks/halton/sobol_points.hpp"
#include "checks/support/catch.hpp"
#include "checks/support/measure.hpp"

namespace mc::checks {
namespace {

constexpr std::uint64_t sobol_end = std::uint64_t{1} << 32;

CHECK_CASE("5.5 the first points of all 32 dimensions", "[5.5][points:4][main]") {
  for (unsigned d = 0; d < joe_kuo.size(); ++d) {
    const auto measured = MEASURE(sobol, d, 0, 600);
    expect_sobol(measured.call, measured.exactly(600, any_number), d, 0, "");
  }
}

CHECK_CASE("5.5 a column of Sobol' points may begin anywhere", "[5.5][points:4]") {
  Rng rng = check_rng();
  for (int i = 0; i < 12; ++i) {
    const auto dimension = static_cast<unsigned>(rng() % joe_kuo.size());
    const std::uint64_t count = i == 11 ? 0 : 300 + rng() % 3000;
    const std::uint64_t first = i == 0   ? sobol_end - count
                                : i == 1 ? sobol_end / 2 - rng() % count
                                : i < 7  ? 1 + rng() % 5000
                                         : rng() % (sobol_end - count);
    const auto measured = MEASURE(sobol, dimension, first, count);
    expect_sobol(measured.call, measured.exactly(count, any_number), dimension, first,
                 "right from 0 on, and not from here? Look at the first and the last few values of "
                 "the column");
  }
}

CHECK_CASE("5.5 the first two dimensions are a net", "[5.5][points:2][edge]") {
  Rng rng = check_rng();
  constexpr unsigned m = 8;
  constexpr std::uint64_t n = 1u << m;
  const std::uint64_t first = n * (rng() % (sobol_end / n));
  const auto along_x = MEASURE(sobol, 0, first, n), along_y = MEASURE(sobol, 1, first, n);
  const auto &x = along_x.exactly(n, unit), &y = along_y.exactly(n, unit);
  for (unsigned k = 0; k <= m; ++k) {  // boxes of 2^-k by 2^-(m-k); powers of two multiply exactly
    const double nx = std::ldexp(1, static_cast<int>(k)), ny = n / nx;
    std::vector<int> points(n);
    for (std::size_t i = 0; i < n; ++i) {
      ++points[static_cast<std::size_t>(x[i] * nx) * static_cast<std::size_t>(ny) +
               static_cast<std::size_t>(y[i] * ny)];
    }
    const auto odd =
        std::find_if(points.begin(), points.end(), [](int count) { return count != 1; });
    expect_that(odd == points.end(),
                fmt::format("{} and dimension 1: {} points in one of {} x {} elementary intervals",
                            along_x.call, odd == points.end() ? 1 : *odd, nx, ny),
                "one point in each", "dimensions 0 and 1 are a (0,m,2)-net in base 2",
                "dimension 0 is the van der Corput sequence; dimension 1 has m_k = 1, 3, 5, 15, …");
  }
}

CHECK_CASE("5.5 integrals by Sobol' points", "[5.5][points:1]") {
  const Estimates known[] = {
      {16, 113. / 512, 0.58792582336016108, 3. / 4, 2.7746497629458409},
      {256, 32513. / 131072, 0.55959439866573157, 131. / 256, 2.9410041658562869},
      {4096, 8384641. / 33554432, 0.55786294647667745, 2057. / 4096, 2.95178215259374}};
  for (const Estimates& each : known) {
    const auto x = MEASURE(sobol, 0, 0, each.n), y = MEASURE(sobol, 1, 0, each.n);
    expect_estimates(x.call + " and dimension 1", x.exactly(each.n, unit), y.exactly(each.n, unit),
                     each, "dimensions 0 and 1, from the origin on");
  }
}

struct Misuse {
  Call call;
  const char *argument, *because;
};
std::vector<Misuse> misuses() {
  return {
      {MEASURE_OUTCOME(sobol, 32, 0, 4), "dimension", "the table has 32 dimensions, from 0 to 31"},
      {MEASURE_OUTCOME(sobol, 4294967295u, 0, 4), "dimension",
       "the table has 32 dimensions, from 0 to 31"},
      {MEASURE_OUTCOME(sobol, 0, sobol_end - 2, 3), "first",
       "the last index is 2^32 - 1, and the third one would be 2^32"},
      {MEASURE_OUTCOME(sobol, 0, last_index, 2), "first", "no index has more than 32 bits"}};
}

CHECK_CASE("5.5 Sobol' points that do not exist are refused", "[5.5][points:2][edge]") {
  for (const Misuse& misuse : misuses()) expect_refused(misuse.call, misuse.because);
}

CHECK_CASE("5.5 a refusal names its argument", "[5.5][points:1][edge]") {
  // Where nothing is refused there is nothing to read; that is the check before this one.
  std::size_t refused = 0;
  for (const Misuse& misuse : misuses()) {
    if (!misuse.call.outcome.answered) continue;
    if (misuse.call.outcome.status != wire::Status::invalid_argument) continue;
    expect_invalid_argument(misuse.call, misuse.argument, misuse.because);
    ++refused;
  }
  if (refused == 0) expect_refused(misuses()[0].call, misuses()[0].because);
}

}  // namespace
}  // namespace mc::checks
