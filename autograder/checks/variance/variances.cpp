// 1.2, 1.3: the textbook formula; two passes, corrected.

#include "list_results.hpp"

namespace mc::checks {
namespace {

/// The digits that the formula keeps: n additions lose n eps, and the difference magnifies it.
double textbook_floor(const ExactMoments& exact) {
  return floor_of(exact.count * eps * condition(exact) * condition(exact));
}
const std::string because_textbook = "the difference magnifies n eps by E{X^2} / Var{X}";

const auto by_textbook = [](const Values& x) { return MEASURE(variance_textbook, x); };

CHECK_CASE("1.2 the textbook formula gives the variance of tame data", "[1.2][main][points:6]") {
  const std::vector<List> lists = tame_lists(rng, 2, 0.5, 2.5), others = lists_of_any_scale(rng);
  Results variances = variances_of(lists, by_textbook, textbook_floor);
  variances.is_tame = true;
  variances.expect(because_textbook, "E{X^2} - E{X}^2, times n/(n-1)");
  variances_of(others, by_textbook, textbook_floor)
      .expect(because_textbook, "small is not zero: use no threshold and no float");
}

CHECK_CASE("1.2 the textbook formula is undefined or infinite where the variance is",
           "[1.2][edge][points:1]") {
  expect_no_variance(rng, by_textbook);
}

CHECK_CASE("1.2 the textbook formula loses two digits for each digit of the mean",
           "[1.2][edge][points:5]") {
  constexpr std::size_t size = 4, lists = 40;
  double least = 0;
  for (const double offset : {1e9, 1e11, 1e3, 1e5, 1e7}) {
    Values x(size * lists);
    for (double& value : x) value = offset + uniform(rng, 0, 20);
    const auto got = MEASURE(variances, 2, x, size);
    const auto& variances = got.exactly(lists, any_number);
    Results results;
    double squares = 0;
    const double unit = eps * offset * offset;
    for (std::size_t i = 0; i < lists; ++i) {
      const View part = View(x).subspan(i * size, size);
      const List list(Values(part.begin(), part.end()));
      results.add(fmt::format("{}[{}]", got.call, i), variances[i], list.exact.variance,
                  10 * size * unit, [=] { return variance_suspects(list); });
      squares += std::pow((variances[i] - list.exact.variance) / unit, 2);
    }
    results.expect(because_textbook, "E{X^2} - E{X}^2 in double, times n/(n-1)");
    // E{X^2} is rounded to a multiple of at least eps E{X^2} / 2, so the RMS error is 0.14 eps
    // E{X^2} or more. A seventh of that in forty lists has a probability below 1e-30.
    const double rms = std::sqrt(squares / lists);
    expect_that(
        rms > 0.02, fmt::format("{} has an RMS error of {:.2g}", got.call, rms * unit),
        fmt::format(
            "errors of about eps E{{X^2}} = {:.2g}, as E{{X^2}} - E{{X}}^2 has here in double",
            unit),
        "this task shows how the formula fails: it subtracts two nearly equal, rounded numbers",
        "this is a better algorithm than the textbook formula, or a wider type; use it for 1.3");
    // A quarter of 80 results is negative for the two largest offsets: none once in 1e10 runs.
    least = std::min(least, *std::ranges::min_element(variances));
    expect_that(offset != 1e11 || least < 0, got.call + " is never negative",
                "negative variances, as the formula has here",
                "the formula is not corrected: this task shows how it fails",
                "do not replace a negative result by 0");
  }
}

const auto by_two_passes = [](const Values& x) { return MEASURE(variance_two_pass, x); };

CHECK_CASE("1.3 the two-pass variance of tame data", "[1.3][main][points:6][needs:1.1]") {
  const std::vector<List> lists = tame_lists(rng, 2, 0.5, 2.5);
  Results variances = variances_of(lists, by_two_passes, two_pass_floor);
  variances.is_tame = true;
  variances.expect(because_sum, "sum (x - mean)^2 in double, and divide by n - 1");
}

CHECK_CASE("1.3 the variance is undefined or infinite where it has no value",
           "[1.3][edge][points:1]") {
  expect_no_variance(rng, by_two_passes);
}

CHECK_CASE("1.3 two passes keep their digits under a large mean", "[1.3][points:5][needs:1.1]") {
  std::vector<List> lists = lists_with_large_means(rng, {1000, 4, 4097});
  lists.emplace_back(Values{1e15, 1e15 + 1});  // a small deviation
  variances_of(lists, by_two_passes, two_pass_floor)
      .expect(because_sum, "in double, (sum d^2 - (sum d)^2 / n) / (n - 1), with d = x - mean");
}

CHECK_CASE("1.3 the variance of constant data is zero", "[1.3][edge][points:3][needs:1.1]") {
  const auto judge_signs = [](const std::string& call, const Values& variances) {
    for (std::size_t k = 0; k < variances.size(); ++k) {
      expect_that(variances[k] >= 0, fmt::format("{}[{}] = {}", call, k, variances[k]),
                  "at least 0", "a variance is a mean of squares", stop_at_zero);
    }
  };
  // The mean, and so every deviation, is off by at most d = n/4 eps |c|. The correction leaves the
  // rounding error of n d^2, 3/4 n eps of it: 1 % of (eps c)^2 for n = 1e5, 10 % for some.
  const Values constants{0.1, 1e8 / 3, uniform(rng, 1, 2), -uniform(rng, 1e5, 1e6), 0};
  for (const std::size_t n : {1000u, 100'000u, 65'537u, 99u, 77u, 40u, 3u, 2u}) {
    const auto got = MEASURE(two_pass_of_constants, constants, n);
    const auto& variances = got.exactly(constants.size(), any_number);
    Results zeros;
    for (std::size_t k = 0; k < constants.size(); ++k) {
      const double c = constants[k];
      zeros.add(fmt::format("{}[{}]", got.call, k), variances[k], 0, eps * eps * c * c, [=] {
        std::vector<Suspect> all = variance_suspects(List(Values(n, c)));
        all.resize(3);  // the textbook formula, and an uncorrected mean
        return all;
      });
    }
    zeros.expect(
        "the correction of the rounded mean leaves less than one rounding error of c, squared",
        "subtract the mean, and correct for its rounding error");
    judge_signs(got.call, variances);
  }
  // Up to about n = 3e5 the two terms of eq. 1.7 are integer multiples of ulp(c)^2 and equal. For
  // this n their difference is negative for half of all constants if the sum is sequential, and for
  // one in fourteen if it has sixteen lanes. These constants were selected from 700 random ones: at
  // least three give a negative difference for each way to sum in 1 to 16 lanes.
  const double scale = std::ldexp(rng() % 2 == 0 ? 1 : -1, static_cast<int>(rng() % 40) - 20);
  for (Values some : {Values{1.9913159685236592, 1.2969464825440495, 1.3617208224630535},
                      Values{1.0744250400711668, 1.8192433745648477},
                      Values{1.021024228416727, 1.6582207134973537}, uniform_values(rng, 3, 1, 2),
                      uniform_values(rng, 3, 1, 2)}) {
    for (double& constant : some) constant *= scale;
    const auto got = MEASURE(two_pass_of_constants, some, 3'000'000);
    judge_signs(got.call, got.exactly(some.size(), any_number));
  }
  // Sums of these overflow, their mean does not. It is exact for 2 and 4 values, whether a right
  // answer divides before it adds or takes a running mean, so that no deviation overflows.
  for (const std::size_t n : {2u, 4u}) {
    const auto got = MEASURE(two_pass_of_constants, Values{1e308, -1.5e308}, n);
    for (const double variance : got.exactly(2, any_number)) {
      expect_that(variance >= 0, fmt::format("{} gave {}", got.call, variance), "0",
                  "the mean is a double, and no value deviates from it",
                  "take the mean of 1.1: the sum overflows although the mean does not");
    }
  }
}

CHECK_CASE("1.3 two passes on hard cases", "[1.3][points:3][needs:1.1]") {
  const std::vector<List> hard = short_hard_lists(rng), outliers = lists_with_outliers(rng, 2);
  variances_of(hard, by_two_passes, two_pass_floor)
      .expect(because_sum, "do not start a sum far from the mean");
  const auto repeating = [](const ExactMoments& exact) {
    return std::min(two_pass_floor(exact), repeating_floor(exact.count));
  };
  variances_of(outliers, by_two_passes, repeating)
      .expect(because_repeating, "do not measure from a value that may be far from all others");
}

CHECK_CASE("1.3 sigma of aX is the absolute value of a times sigma of X",
           "[1.3][points:2][needs:1.1]") {
  std::vector<List> lists = lists_of_any_scale(rng);
  for (const double a : {1.0, 0x1p-100, -0x1p100, -0x1p-20}) {
    Values x(100);
    for (double& value : x) value = a * static_cast<double>(rng() >> 44);
    lists.emplace_back(x);
  }
  const double c = uniform(rng, 1, 2);  // values that differ by one rounding unit only
  lists.emplace_back(Values{c, c, c, std::nextafter(c, 2.0)});
  variances_of(lists, by_two_passes, two_pass_floor)
      .expect(because_sum + "; Var{aX} = a^2 Var{X}",
              "small is not zero: the result depends on the scale of the data; use no threshold");
}

}  // namespace
}  // namespace mc::checks
