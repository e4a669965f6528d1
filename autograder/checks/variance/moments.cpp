// 1.4, 1.8: Welford's update; the moments of a list, fast.

#include "list_results.hpp"

namespace mc::checks {
namespace {

const std::string of_mean = "the mean moves by (x - mean)/count, with the count that includes x";
const std::string of_m2 = "m2 grows by (x - old mean)(x - new mean), and keeps no sum of x^2";

/// Of each list: `measure` asks for its moments, `floor` gives the digits that m2 keeps.
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

CHECK_CASE("1.4 add keeps count and mean and m2", "[1.4][main][points:5]") {
  Rng rng = check_rng();
  const std::vector<List> lists = tame_lists(rng, 1, 1, 2);
  MomentsResults all = welfords(lists);
  all.is_tame = true;
  all.expect(because_one_pass, of_mean, of_m2);
  const auto none = MEASURE(welford, {});
  expect_nothing(none.call, none.value, "leave the members' initial values as they are");
}

CHECK_CASE("1.4 the variance of moments", "[1.4][points:2]") {
  Rng rng = check_rng();
  std::vector<std::uint64_t> counts = domain::words(~std::uint64_t{0}, rng);
  std::erase_if(counts, [](std::uint64_t count) { return count < 2; });
  Results variances;
  const auto judge = [&](std::uint64_t count) {
    const double m2 = uniform(rng, 1, 9), n = static_cast<double>(count);
    const double exact = m2 / static_cast<double>(count - 1);
    const auto got = MEASURE(variance_of, {count, uniform(rng, -9, 9), m2});
    variances.add_digits(got.call, got.value, exact, 14.5, [=]() -> std::vector<Suspect> {
      return {{m2 / n, "this divides by n; a sample variance divides by n - 1"},
              {m2, "this is m2: divide it by count - 1"}};
    });
  };
  // Of each power of two, another neighbor.
  for (std::size_t i = 0; i < counts.size(); i += 3) judge(counts[i]);
  for (const std::uint64_t count : {3u, 2u}) judge(count);
  variances.expect("one division, rounded once or twice",
                   "m2 / (count - 1) for counts from 2 on; a whole number of 64 bits all the way?");
  for (const double m2 : {domain::not_a_number, domain::infinity}) {
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

CHECK_CASE("1.4 Welford keeps his digits under a large mean", "[1.4][points:3]") {
  Rng rng = check_rng();
  const std::vector<List> lists = lists_with_large_means(rng, {1000, 4});
  welfords(lists).expect(
      because_one_pass, of_mean,
      "keep the mean and the squared deviations from it, not the sum of x^2; is anything a float?");
}

CHECK_CASE("1.4 Welford on constant data and hard cases", "[1.4][points:3]") {
  Rng rng = check_rng();
  for (const double c : {0.1, 1e8 / 3, uniform(rng, 1, 2), -uniform(rng, 1, 2)}) {
    const auto got = MEASURE(welford, Values(1000, c));
    const double bound = 1000 * eps * c;
    expect_that(got.value.m2 >= 0 && got.value.m2 <= 999 * bound * bound,
                fmt::format("{}.m2 = {}", got.call, got.value.m2),
                fmt::format("from 0 to {:.3g}", 999 * bound * bound),
                "n roundings of the mean lose at most n eps |c|, and m2 is a sum of squares of "
                "that; no product of deviations on one side is negative",
                "keep the mean and the squared deviations from it, not the sum of x^2; is anything "
                "a float?");
  }
  for (const std::vector<List>& lists :
       {short_hard_lists(rng), lists_of_any_scale(rng), lists_with_outliers(rng, 1)}) {
    welfords(lists).expect(because_one_pass, of_mean, of_m2);
  }
  std::vector<Values> lists = without_finite_variance(rng);
  lists.insert(lists.end(), {{domain::infinity}, {domain::not_a_number}});
  for (const Values& x : lists) {
    const auto got = MEASURE(welford, x);
    expect_not_finite(got.call + ".m2", got.value.m2, x);
  }
}

CHECK_CASE("1.4 one more value after very many", "[1.4][edge][points:2]") {
  Rng rng = check_rng();
  const std::pair<int, std::string> ends[] = {
      {24, "a float counts to 2^24 only"},
      {31, "an int counts to 2^31 only"},
      {32, "32 bits count to 2^32 only"},
      {53, "a double counts to 2^53 only: ++ a whole number of 64 bits"},
      {62, "count is a whole number of 64 bits: keep it one"},
      {63, "count is a whole number of 64 bits without a sign: keep it one"}};
  // Just before the end of what a type counts exactly, and past it, where every second count is
  // none of its numbers.
  for (const auto& [bits, hint] : ends) {
    const std::uint64_t power = std::uint64_t{1} << bits;
    for (const std::uint64_t count :
         {power - 1, power + 2 * (1 + rng() % 50), power + (power - 2)}) {
      const Moments many{count, uniform(rng, 1, 2), uniform(rng, 1, 2)};
      // So far away that one value moves the mean by 1 or more, and m2 is that distance squared.
      const double x = static_cast<double>(count) * uniform(rng, 1, 2);
      const ExactMoments exact = exact_merge(many, {1, x, 0});
      const auto got = MEASURE(stream, many, {x}, 1);
      expect_that(got.value.count == count + 1,
                  fmt::format("{}.count = {}", got.call, got.value.count),
                  fmt::format("{}", count + 1), "one value more was added", hint);
      // A float keeps seven digits; a count that wrapped round changes all of them.
      Results values;
      values.add_digits(got.call + ".mean", got.value.mean, static_cast<double>(exact.mean), 9);
      values.add_digits(got.call + ".m2", got.value.m2, static_cast<double>(exact.m2), 9);
      values.expect("a correct count keeps all digits; nine are required here", hint);
    }
  }
}

CHECK_CASE("1.4 Welford survives a stream of 1e8 values", "[1.4][edge][points:2]") {
  Rng rng = check_rng();
  // The same few values over and over: their mean, and their m2 as often as they come.
  const Values x = tame_values(rng, 4 + 2 * (rng() % 3), 4, 16);
  const auto of_x = exact_moments(x);
  // A piece at the beginning, one where floats stop counting, and the last one. Each goes on from
  // the exact moments of what is before it: all 1e8 values take a second.
  const std::uint64_t size = x.size(), length = 5'000'000 / size * size;
  const double mean = static_cast<double>(of_x.mean),
               m2 = static_cast<double>(of_x.m2) / static_cast<double>(size);
  for (const std::uint64_t before :
       {std::uint64_t{0}, 14'000'000 / size * size, 100'000'000 / size * size - length}) {
    const Moments start = {before, before == 0 ? 0 : mean, m2 * static_cast<double>(before)};
    const auto got = MEASURE(stream, start, x, length);
    const std::uint64_t count = before + length;
    expect_that(got.value.count == count, fmt::format("{}.count = {}", got.call, got.value.count),
                fmt::format("{}", count), "", "a float counts to 2^24 only, an int to 2^31");
    // The same values over and over are rounded in the same way over and over: n/4 eps at most, 8.3
    // digits for 1e8. 9.0 and more were measured, of the mean and of m2.
    const double floor = repeating_floor(static_cast<double>(count));
    Results values;
    values.add_digits(got.call + ".mean", got.value.mean, mean, floor);
    values.add_digits(got.call + ".m2", got.value.m2, m2 * static_cast<double>(count), floor);
    values.expect(
        because_repeating,
        "if short lists are right: is anything a float? Does anything grow with the count "
        "that need not?");
  }
}

const std::string far_off =
    "if the mean is far off: was the shift put back, are the parts weighted by their counts?";

CHECK_CASE("1.8 the moments of a list of any length", "[1.8][main][points:4]") {
  Rng rng = check_rng();
  const std::vector<List> lists = tame_lists(rng, 1, 1, 2);
  // Lengths are judged here, digits below: a value too many or too few changes m2 by a part 1/n.
  MomentsResults all = moments_of(lists, of_moments, [](const List& list) {
    const double kappa = condition(list.exact);
    return floor_of(list.exact.count * eps * kappa * kappa);
  });
  all.is_tame = true;
  all.expect("even E{X^2} - E{X}^2 loses no more than n eps E{X^2} / Var{X}", far_off,
             "does every value count once, also those in a last, shorter block?");
}

CHECK_CASE("1.8 the moments of no values", "[1.8][edge][points:1]") {
  const auto none = MEASURE(moments, {});
  expect_nothing(none.call, none.value, "nothing to add, nothing to divide by");
}

/// As many digits as 1.3 keeps, 15 at most, less a digit and a half. What 1.3 keeps is measured,
/// but not taken at more than n roundings leave that scatter, sqrt(n) eps: beyond that it was luck,
/// which is not a standard for another order of additions. (n equal roundings lose n/4 eps: for the
/// values here that can repeat, n < 5000, this is within the digit and a half.)
void judge_moments(const std::vector<List>& lists, const std::string& otherwise) {
  const auto floor = [](const List& list) {
    return std::min({digits(two_pass_here(list.x), list.exact.variance), 15.0,
                     -std::log10(std::sqrt(list.exact.count) * eps)}) -
           1.5;
  };
  moments_of(lists, of_moments, floor)
      .expect("two corrected passes keep 1.5 digits more of these data", otherwise, otherwise);
}

CHECK_CASE("1.8 the moments keep their digits on hard data", "[1.8][points:3]") {
  Rng rng = check_rng();
  const std::string rounded =
      "is a mean rounded here before it is compared? Near 1e9 that costs 1e-7; offsets from one "
      "value near the data have nothing to lose";
  judge_moments(lists_with_large_means(rng, {4096, 4, 33}), rounded);
  Values sorted = uniform_values(rng, 10'000, 1e9, 1e9 + 1), trend(100'000);
  std::sort(sorted.begin(), sorted.end());
  judge_moments({List(sorted, ", sorted")}, rounded);
  for (std::size_t i = 0; i < trend.size(); ++i) trend[i] = uniform(rng) + static_cast<double>(i);
  judge_moments({List(trend, ", a trend")}, "a shift must be near all of the data");
  judge_moments(lists_of_any_scale(rng), "small is not zero: use no threshold, no float");
  for (const double c : {0.1, uniform(rng, 1e8, 1e9), -uniform(rng, 1, 2)}) {
    for (const std::size_t n : {4096u, 2u, 63u, 1000u, 5u, 1u}) {
      const auto got = MEASURE(moments, Values(n, c));
      const double most = static_cast<double>(n) * eps * eps * c * c;  // a variance as 1.3 promises
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

CHECK_CASE("1.8 the moments keep their digits in spite of outliers", "[1.8][points:2]") {
  Rng rng = check_rng();
  const std::string far_shift =
      "is everything measured from a value that may lie far from all others? A shift belongs near "
      "most of the data";
  const std::vector<List> lists = lists_with_outliers(rng, 5);
  moments_of(lists, of_moments, [](const List& list) {
    return repeating_floor(list.exact.count);
  }).expect(because_repeating, far_shift, far_shift);
  std::vector<List> others;
  for (const std::size_t n : {100'000u, 5000u, 100u, 64u, 16u}) {
    for (const std::size_t place : {std::size_t{0}, n / 4, n / 2, n - 1, std::size_t{rng() % n}}) {
      Values x = uniform_values(rng, n, 0, 1);
      x[place] = 1e9;
      others.emplace_back(x, fmt::format(", an outlier at {}", place));
    }
  }
  judge_moments(others, far_shift);
}

}  // namespace
}  // namespace mc::checks
