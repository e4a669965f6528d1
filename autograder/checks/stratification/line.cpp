// 3.1: strata on the line. Where points must lie is exact: strata are counted, with the edges that
// double division gives. How they lie there is random. Nothing depends on the order in which a
// submission draws.

#include <cmath>
#include <numbers>

#include "checks/stratification/levels.hpp"
#include "checks/support/catch.hpp"
#include "checks/support/inversions.hpp"
#include "checks/support/strata.hpp"

namespace mc::checks {
namespace {

const std::string one_in_each = "one point in each stratum: (i + u) / N for i = 0 … N-1";

Sets lines(std::size_t n, std::size_t sets, std::uint64_t seed) {
  return sets_from_columns(MEASURE(stratified_1d, n, sets, seed), n, 1, sets, n);
}

/// Point i of n lies in stratum i, for all i.
void require_order(const Sets& sets) {
  for (std::size_t set = 0; set < sets.size(); ++set) {
    const auto strata = expect_one_in_each_cell(sets, set, line_of(sets.n), one_in_each);
    for (std::size_t i = 0; i < sets.n; ++i) {
      if (strata[i] == i) continue;
      fail(Failure{fmt::format("{}: x[{}] = {}", sets.call, i, sets.column(set, 0)[i]),
                   fmt::format("a value in [{}/{}, {}/{})", i, sets.n, i + 1, sets.n),
                   "point i lies in stratum i",
                   "every stratum has its point, but they do not come in order"});
    }
  }
}

CHECK_CASE("3.1 one point in each stratum and in order", "[3.1][main][points:3]") {
  Rng rng = check_rng();
  for (const std::size_t n : domain::sizes(999983, rng)) {
    require_order(lines(n, n < 5000 ? 2 : 1, fresh_seed(rng)));
  }
  expect_fresh(lines(64, 2, fresh_seed(rng)), lines(64, 1, fresh_seed(rng)), {{line_of(64)}});
}

CHECK_CASE("3.1 each point is uniform in its stratum and independent", "[3.1][points:7]") {
  Rng rng = check_rng();
  for (const std::size_t n : {16u, 37u, 100u, 1025u, 1u}) {
    const std::size_t sets = std::max<std::size_t>(200, 20000 / n);
    const std::uint64_t seed = fresh_seed(rng);
    const std::vector<Pattern> line{line_of(n)};
    const Uniforms jitters = jitters_of(lines(n, sets, seed), line, one_in_each);
    expect_independent_uniforms(jitters, random_jitters("3.1"));
    if (n > 40) continue;
    const Uniforms other_seed = jitters_of(lines(n, sets, seed + 1), line, one_in_each);
    expect_independent_uniforms(side_by_side(jitters, other_seed), random_jitters("3.1"));
  }
}

CHECK_CASE("3.1 the error falls as N^-1.5", "[3.1][points:3]") {
  Rng rng = check_rng();
  for (const std::size_t n : {64u, 16u, 256u}) {
    expect_level(lines(n, 1000, fresh_seed(rng)),
                 level_of("exp(x)", sum_over_axes(exponential), strata_of(exponential, n)));
  }
  // Every stratum has a whole period: mean 0, variance 1/2, kurtosis 3/2, as the whole line.
  constexpr double n = 64;
  expect_level(lines(64, 1000, fresh_seed(rng)),
               {"cos(2 pi N x)", [](View x) { return std::cos(2 * std::numbers::pi * n * x[0]); },
                0, 0.5 / n, 3 - 1.5 / n, 0,
                "all variance of a wave with N periods is within the strata: nothing is gained"});
}

CHECK_CASE("3.1 no point leaves its stratum whatever the bits", "[3.1][edge][points:2]") {
  Rng rng = check_rng();
  for (const std::size_t n :
       {std::size_t{1000}, std::size_t{49}, 2 + rng() % 5000, std::size_t{1009},
        std::size_t{999983}, std::size_t{5}, std::size_t{3}, std::size_t{2}, std::size_t{1}}) {
    for (const std::uint64_t word : domain::constant_words(rng)) {
      require_order(sets_from_columns(MEASURE(stratified_1d_constant, n, word), n, 1, 1, n));
    }
  }
}

}  // namespace
}  // namespace mc::checks
