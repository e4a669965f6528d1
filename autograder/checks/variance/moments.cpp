// 1.4, 1.8: Welford's update; the moments of a list, fast.

#include "list_results.hpp"

namespace mc::checks {
namespace {

const std::string of_mean = "the mean moves by (x - mean)/count, with the count that includes x";
const std::string of_m2 =
    "m2 grows by (x - old mean)(x - new mean): keep squared deviations from the mean, not the sum "
    "of x^2; use double everywhere";

/// `measure` requests the moments of each list, `floor` returns the required digits of m2.
template <class Measure, class Floor>
MomentsResults moments_of(const std::vector<List>& lists, Measure measure, Floor floor) {
  MomentsResults all;
  for (const List& list : lists) {
    const auto got = measure(list.x);
    all.add(got.call, got.value, list, list.x.size() > 1 ? floor(list) : 0);
  }
  return all;
}

MomentsResults welfords(const std::vector<List>& lists) {
  return moments_of(
      lists, [](const Values& x) { return MEASURE(welford, x); },
      [](const List& list) { return one_pass_floor(list.exact); });
}

const auto of_moments = [](const Values& x) { return MEASURE(moments, x); };

CHECK_CASE("1.4 add keeps count and mean and m2", "[1.4][main][points:6]") {
  const std::vector<List> lists = tame_lists(rng, 1, 1, 2);
  MomentsResults all = welfords(lists);
  all.is_tame = true;
  all.expect(because_one_pass, of_mean, of_m2);
  const auto none = MEASURE(welford, {});
  expect_nothing(none.call, none.value, "keep the members' initial values");
}

CHECK_CASE("1.4 the variance of moments", "[1.4][points:2]") {
  std::vector<std::uint64_t> counts = domain::words(~std::uint64_t{0}, rng);
  std::erase_if(counts, [](std::uint64_t count) { return count < 2; });
  Results variances;
  const auto judge = [&](std::uint64_t count) {
    const double m2 = uniform(rng, 1, 9), n = static_cast<double>(count);
    const double exact = m2 / static_cast<double>(count - 1);
    const auto got = MEASURE(variance_of, {count, uniform(rng, -9, 9), m2});
    variances.add_digits(got.call, got.value, exact, 14.5, [=]() -> std::vector<Suspect> {
      return {{m2 / n, "this divides by n; a sample variance divides by n - 1"_likely}};
    });
  };
  // A different neighbor of each power of two.
  for (std::size_t i = 0; i < counts.size(); i += 3) judge(counts[i]);
  for (const std::uint64_t count : {3u, 2u}) judge(count);
  variances.expect(
      "one division, rounded once or twice",
      "m2 / (count - 1) for counts from 2 on; keep the count an unsigned 64-bit integer");
  for (const double m2 : {nan, infinity}) {
    const auto got = MEASURE(variance_of, {3, 1, m2});
    expect_not_finite(got.call, got.value, {m2});
  }
}

CHECK_CASE("1.4 the variance of fewer than two values is NaN", "[1.4][edge][points:1]") {
  for (const std::uint64_t count : {1u, 0u}) {
    const auto got = MEASURE(variance_of, {count, count == 0 ? 0 : 2.5, 0});
    expect_nan(got.call, got.value, "a sample variance needs two values; " + because_undefined);
  }
}

CHECK_CASE("1.4 Welford keeps his digits under a large mean", "[1.4][points:4]") {
  const std::vector<List> lists = lists_with_large_means(rng, {1000, 4});
  welfords(lists).expect(because_one_pass, of_mean, of_m2);
}

CHECK_CASE("1.4 Welford on constant data and hard cases", "[1.4][points:3]") {
  for (const double c : {0.1, 1e8 / 3, uniform(rng, 1, 2), -uniform(rng, 1, 2)}) {
    const auto got = MEASURE(welford, Values(1000, c));
    const double bound = 1000 * eps * c;
    expect_that(
        got.value.m2 >= 0 && got.value.m2 <= 999 * bound * bound,
        fmt::format("{}.m2 = {}", got.call, got.value.m2),
        fmt::format("from 0 to {:.3g}", 999 * bound * bound),
        "the mean has errors of at most n eps |c|, and m2 is a sum of products of such errors",
        of_m2);
  }
  for (const std::vector<List>& lists :
       {short_hard_lists(rng), lists_of_any_scale(rng), lists_with_outliers(rng, 1)}) {
    welfords(lists).expect(because_one_pass, of_mean, of_m2);
  }
  std::vector<Values> lists = without_finite_variance(rng);
  lists.insert(lists.end(), {{infinity}, {nan}});
  for (const Values& x : lists) {
    const auto got = MEASURE(welford, x);
    expect_not_finite(got.call + ".m2", got.value.m2, x);
  }
}

CHECK_CASE("1.4 one more value after very many", "[1.4][edge][points:2]") {
  const std::string rule = "keep the count an unsigned 64-bit integer";
  const std::pair<int, Likely> ends[] = {{24, "a float counts only to 2^24"_likely},
                                         {31, "an int counts only to 2^31"_likely},
                                         {32, "32 bits count only to 2^32"_likely},
                                         {53, "a double counts only to 2^53"_likely},
                                         {62, {}},
                                         {63, {}}};
  // Just before the limit of exact counting in a type, and past it, where odd counts are lost.
  for (const auto& [bits, hint] : ends) {
    const std::uint64_t power = std::uint64_t{1} << bits;
    for (const std::uint64_t count :
         {power - 1, power + 2 * (1 + rng() % 50), power + (power - 2)}) {
      const Moments many{count, uniform(rng, 1, 2), uniform(rng, 1, 2)};
      // So far away that this value moves the mean by 1 or more, and dominates m2.
      const double x = static_cast<double>(count) * uniform(rng, 1, 2);
      const ExactMoments exact = exact_merge(many, {1, x, 0});
      const auto got = MEASURE(stream, many, {x}, 1);
      expect_equal(got.call + ".count", got.value.count, count + 1, "one more value was added",
                   rule, hint);
      // A float keeps seven digits; a count that wrapped around changes all of them.
      Results values;
      values.add_digits(got.call + ".mean", got.value.mean, static_cast<double>(exact.mean), 9);
      values.add_digits(got.call + ".m2", got.value.m2, static_cast<double>(exact.m2), 9);
      values.expect("a correct count keeps all digits; nine are required here", rule);
    }
  }
}

// One more value does not show errors that grow with the stream.
CHECK_CASE("1.4 Welford survives a stream of 1e8 values", "[1.4][edge][points:2]") {
  // A few values, repeated: the mean stays the same, m2 grows in proportion.
  const Values x = tame_values(rng, 4 + 2 * (rng() % 3), 4, 16);
  const auto of_x = exact_moments(x);
  // The first part of the stream, one where a float stops counting, and the last one. Each starts
  // from the exact moments of all values before it: adding all 1e8 values would take a second.
  const std::uint64_t size = x.size(), length = 5'000'000 / size * size;
  const double mean = static_cast<double>(of_x.mean),
               m2 = static_cast<double>(of_x.m2) / static_cast<double>(size);
  for (const std::uint64_t before :
       {std::uint64_t{0}, 14'000'000 / size * size, 100'000'000 / size * size - length}) {
    const Moments start = {before, before == 0 ? 0 : mean, m2 * static_cast<double>(before)};
    const auto got = MEASURE(stream, start, x, length);
    const std::uint64_t count = before + length;
    expect_equal(got.call + ".count", got.value.count, count, "",
                 "a float counts only to 2^24, an int to 2^31");
    // Repeated values have the same rounding errors: n/4 eps at most, 8.3 digits for 1e8. The mean
    // and m2 were measured to keep 9.0 or more.
    const double floor = repeating_floor(static_cast<double>(count));
    Results values;
    values.add_digits(got.call + ".mean", got.value.mean, mean, floor);
    values.add_digits(got.call + ".m2", got.value.m2, m2 * static_cast<double>(count), floor);
    values.expect(because_repeating,
                  "if short lists are correct: use double everywhere, and no growing sums");
  }
}

CHECK_CASE("1.8 the moments of a list of any length", "[1.8][main][stretch]") {
  const std::vector<List> lists = tame_lists(rng, 1, 1, 2);
  // Only lengths matter here, digits below: one value more or less changes m2 by 1/n of it.
  MomentsResults all = moments_of(lists, of_moments, [](const List& list) {
    const double kappa = condition(list.exact);
    return floor_of(list.exact.count * eps * kappa * kappa);
  });
  all.is_tame = true;
  const std::string once = "every value counts once, including those of a shorter last block";
  all.expect("even E{X^2} - E{X}^2 loses no more than n eps E{X^2} / Var{X}",
             once + "; add the shift back to the mean", once);
}

CHECK_CASE("1.8 the moments of no values", "[1.8][edge][stretch]") {
  const auto none = MEASURE(moments, {});
  expect_nothing(none.call, none.value, "return Moments{} for an empty list");
}

/// The floor is 1.5 digits below what the algorithm of 1.3 keeps, which is measured but limited: to
/// 15 digits, and to those that n random rounding errors leave, sqrt(n) eps, since more is luck. (n
/// equal rounding errors lose n/4 eps: for the repeating values here, n < 5000, this is within
/// that.)
void judge_moments(const std::vector<List>& lists, const std::string& rule) {
  const auto floor = [](const List& list) {
    return std::min({digits(two_pass_here(list.x), list.exact.variance), 15.0,
                     -std::log10(std::sqrt(list.exact.count) * eps)}) -
           1.5;
  };
  moments_of(lists, of_moments, floor)
      .expect("two corrected passes keep 1.5 digits more for these data", rule, rule);
}

CHECK_CASE("1.8 the moments keep their digits on hard data", "[1.8][stretch]") {
  const std::string rounded = "do not subtract a rounded mean: subtract a value near the data";
  judge_moments(lists_with_large_means(rng, {4096, 4, 33}), rounded);
  Values sorted = uniform_values(rng, 10'000, 1e9, 1e9 + 1), trend(100'000);
  std::ranges::sort(sorted);
  judge_moments({List(sorted, ", sorted")}, rounded);
  for (std::size_t i = 0; i < trend.size(); ++i) trend[i] = uniform(rng) + static_cast<double>(i);
  judge_moments({List(trend, ", a trend")}, "a shift must be near all of the data");
  judge_moments(lists_of_any_scale(rng), "small is not zero: use no threshold and no float");
  for (const double c : {0.1, uniform(rng, 1e8, 1e9), -uniform(rng, 1, 2)}) {
    for (const std::size_t n : {4096u, 2u, 63u, 1000u, 5u, 1u}) {
      const auto got = MEASURE(moments, Values(n, c));
      const double most = static_cast<double>(n) * eps * eps * c * c;  // as in 1.3
      expect_that(got.value.m2 >= 0 && got.value.m2 <= most,
                  fmt::format("{}.m2 = {}", got.call, got.value.m2),
                  fmt::format("from 0 to {:.3g}", most),
                  "these values do not vary: m2 <= n (eps c)^2, and no sum of squares is negative",
                  got.value.m2 < 0 ? stop_at_zero : rounded);
    }
  }
  for (const Values& x : without_finite_variance(rng)) {
    const auto got = MEASURE(moments, x);
    expect_not_finite(got.call + ".m2", got.value.m2, x);
  }
}

CHECK_CASE("1.8 the moments keep their digits in spite of outliers", "[1.8][stretch]") {
  const std::string far_shift = "do not measure from a value that may be far from all others";
  const std::vector<List> lists = lists_with_outliers(rng, 5);
  const auto floor = [](const List& list) { return repeating_floor(list.exact.count); };
  moments_of(lists, of_moments, floor).expect(because_repeating, far_shift, far_shift);
  std::vector<List> others;
  for (const std::size_t n : {1'000'000u, 100'000u, 5000u, 100u, 64u, 16u}) {
    for (const std::size_t place : {std::size_t{0}, n / 4, n / 2, n - 1, std::size_t{rng() % n}}) {
      if (n > 100'000 && place > 0) break;  // the first few values alone may give the shift
      for (const auto& [count, apart] :
           {std::pair{1u, std::size_t{1}}, {3u, 1u}, {2u, n / 2}, {3u, n - 1}}) {
        Values x = uniform_values(rng, n, 0, 1);
        for (std::size_t i = 0; i < count; ++i) x[(place + i * apart) % n] = 1e9;
        others.emplace_back(x, fmt::format(", {} large from {}, {} apart", count, place, apart));
      }
    }
  }
  // Outliers at equal distances, where a shift may be looked for: if it is one of them, 32 are a
  // share of 2^-12 of the squares about it, which are as large for all other values.
  for (const std::size_t places : {4u, 16u, 32u, 64u}) {
    Values x = uniform_values(rng, std::size_t{1} << 17, 0, 1e-3);
    for (std::size_t i = 0; i < x.size(); i += x.size() / places) x[i] = uniform(rng, 1, 2);
    others.emplace_back(x, fmt::format(", {} outliers at equal distances", places));
  }
  judge_moments(others, far_shift);
}

}  // namespace
}  // namespace mc::checks
