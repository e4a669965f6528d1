#include <random>

#include "1-variance/experiments.hpp"
#include "data_sets.hpp"

namespace mc::checks {
namespace {

ExactMoments exact_of_counts(std::span<const std::pair<double, double>> values_and_counts) {
  Exact count, sum, m2;
  for (const auto& [value, times] : values_and_counts) {
    count = count + Exact(times);
    sum = sum + Exact(value) * Exact(times);
  }
  const Exact mean = sum / count;
  for (const auto& [value, times] : values_and_counts) {
    m2 = m2 + (Exact(value) - mean) * (Exact(value) - mean) * Exact(times);
  }
  ExactMoments all;
  all.count = static_cast<double>(count);
  all.mean = mean;
  all.m2 = m2;
  all.variance = static_cast<double>(m2 / (count - Exact(1)));
  return all;
}

Values numacc(int number, double scale) {
  if (number == 1) return {10000001 * scale, 10000003 * scale, 10000002 * scale};
  const double whole = number == 2 ? 1 : number == 3 ? 1000000 : 10000000;
  Values x{(whole + 0.2) * scale};
  for (int i = 0; i < 500; ++i) {
    x.insert(x.end(), {(whole + 0.1) * scale, (whole + 0.3) * scale});
  }
  return x;
}

double either_sign(Rng& rng, double size) {
  return rng() % 2 == 0 ? size : -size;
}

/// Mean and m2 from sums relative to a shift.
Moments shifted_sums(std::span<const double> x, double shift) {
  double sum = 0, squares = 0;
  for (const double value : x) {
    sum += value - shift;
    squares += (value - shift) * (value - shift);
  }
  const auto n = static_cast<double>(x.size());
  return {x.size(), shift + sum / n, squares - sum * sum / n};
}

Likely relative_to(const char* which) {
  return likely("these are sums relative to the {} value, which may be far from all others", which);
}
const Likely large_numbers = "this has the rounding errors of E{X^2} - E{X}^2"_likely;

/// The sums of squared deviations by other algorithms, correct and wrong.
std::vector<Suspect> ways_to_m2(std::span<const double> x) {
  const auto n = static_cast<double>(x.size());
  const double sum = sum_of(x), mean = sum / n;
  double squares = 0, uncorrected = 0;
  for (const double value : x) {
    squares += value * value;
    uncorrected += (value - mean) * (value - mean);
  }
  double running = 0, count = 0, welford = 0, from_old_means = 0, from_new_means = 0;
  for (const double value : x) {
    const double before = value - running;
    running += before / ++count;
    const double after = value - running;
    welford += before * after;
    from_old_means += before * before;
    from_new_means += after * after;
  }
  const double whole = integer_sum(x) / n;
  return {
      {(squares / n - mean * mean) * n, large_numbers},
      {squares - sum * sum / n, large_numbers},
      {uncorrected,
       "the mean was rounded: subtract (sum of deviations)^2 / n from the sum of squares"_likely},
      {welford, "this has the rounding errors of a running mean, as in 1.4"_likely},
      {from_old_means,
       "m2 grows by (x - old mean)(x - new mean); here the old mean is used twice"_likely},
      {from_new_means,
       "m2 grows by (x - old mean)(x - new mean); here the new mean is used twice"_likely},
      {shifted_sums(x, x.front()).m2, relative_to("first")},
      {shifted_sums(x, x.back()).m2, relative_to("last")},
      {shifted_sums(x, x[x.size() / 2]).m2, relative_to("middle")},
      {squares - n * whole * whole,
       "the mean was added up in integers: start std::accumulate with 0.0"_likely}};
}

}  // namespace

List::List(Values values, std::string words)
    : x(std::move(values)), name(std::move(words)), exact(exact_moments(x)) {}
List::List(Values values, std::string words, ExactMoments moments)
    : x(std::move(values)), name(std::move(words)), exact(moments) {}

Values tame_values(Rng& rng, std::size_t n, double low, double high) {
  Values x = uniform_values(rng, n, low, high);
  const double quarter = (high - low) / 4;
  if (n > 1) {
    x[0] = uniform(rng, low, low + quarter);
    x[1] = uniform(rng, high - quarter, high);
  }
  return x;
}

std::vector<List> tame_lists(Rng& rng, std::size_t least, double low, double high) {
  const Values first = tame_values(rng, 12, low, high);
  Values in_the_middle = first, at_the_end = first;
  in_the_middle[5] = uniform(rng, low, high);
  at_the_end[11] = 0;
  std::vector<List> all{List(first), List(in_the_middle), List(at_the_end)};
  for (const std::uint64_t n : domain::sizes(65537, rng)) {
    if (n >= least) all.emplace_back(tame_values(rng, n, low, high));
  }
  return all;
}

Values shifted_pattern(Rng& rng, double offset, std::size_t n) {
  const double base = offset + static_cast<double>(rng() % 1000);
  const double pattern[] = {4, 7, 13, 16};
  Values x(n);
  for (std::size_t i = 0; i < n; ++i) x[i] = base + pattern[i % 4];
  std::ranges::shuffle(x, rng);
  return x;
}

std::vector<List> lists_with_large_means(Rng& rng, std::vector<std::size_t> sizes) {
  std::vector<List> all;
  for (const double offset : {1e9, 1e12, 1e15, 1e6, -1e13, 1e14}) {
    for (const std::size_t n : sizes) all.emplace_back(shifted_pattern(rng, offset, n));
  }
  for (const int number : {1, 2, 3, 4}) {
    const double scale = std::ldexp(1.0, static_cast<int>(rng() % 17) - 8);
    all.emplace_back(numacc(number, scale), fmt::format(", NIST's NumAcc{}", number));
  }
  return all;
}

std::vector<List> lists_with_outliers(Rng& rng, int of_each) {
  constexpr std::size_t n = 100'001;  // odd: there is one middle value
  std::vector<List> lists;
  for (const auto& [name, place] : {std::pair{", the outlier comes first", std::size_t{0}},
                                    {", the outlier is in the middle", n / 2},
                                    {", the outlier comes last", n - 1}}) {
    for (int i = 0; i < of_each; ++i) {
      const double usual = uniform(rng, 1, 2), outlier = either_sign(rng, uniform(rng, 1e9, 2e9));
      Values x(n, usual);
      x[place] = outlier;
      const std::pair<double, double> counts[] = {{usual, n - 1}, {outlier, 1}};
      lists.emplace_back(std::move(x), name, exact_of_counts(counts));
    }
  }
  constexpr std::size_t many = std::size_t{1} << 20;
  const double usual = uniform(rng, 1, 2);
  std::vector<std::pair<double, double>> counts{{usual, many - 3}};
  Values x(many, usual);
  for (const std::size_t place : {std::size_t{0}, many / 2, many - 1}) {
    x[place] = either_sign(rng, uniform(rng, 1e9, 9e9));
    counts.emplace_back(x[place], 1);
  }
  lists.emplace_back(std::move(x), ", three outliers: first, in the middle, and last",
                     exact_of_counts(counts));
  return lists;
}

std::vector<List> short_hard_lists(Rng& rng) {
  Values one_outlier(1000, 1.0), trend(1000), alternating{1.0}, around_0{0, 0, -3, 3};
  one_outlier[rng() % 1000] = uniform(rng, 1e9, 1e10);
  Values sorted = uniform_values(rng, 1000, 0, 1);
  std::ranges::sort(sorted);
  std::iota(trend.begin(), trend.end(), uniform(rng, 1e5, 1e6));
  for (int i = 0; i < 500; ++i) alternating.insert(alternating.end(), {1e8, -1e8});
  for (int i = 0; i < 9; ++i) around_0.push_back(uniform(rng, 1, 2));
  return {List(around_0, ", running means of 0"), List(one_outlier, ", one outlier"),
          List(sorted, ", sorted"), List(trend, ", a trend"), List(alternating, ", alternating")};
}

std::vector<List> lists_of_any_scale(Rng& rng) {
  std::vector<List> all;
  for (const double scale : {1e150, -1e150, 1e-140, 1e-160, 0.0}) {
    const double c = uniform(rng, 1, 9) * scale;
    ExactMoments exact = exact_moments(Values{1, 2, 3});  // a denormal has no room for 106 bits
    exact.mean = Exact(2 * c);
    exact.variance = c * c;
    exact.m2 = Exact(2 * c * c);
    all.emplace_back(Values{c, 2 * c, 3 * c}, "", exact);
  }
  return all;
}

std::vector<Values> without_finite_variance(Rng& rng) {
  std::vector<Values> lists = with_a_value_that_is_not_finite(rng);
  lists.insert(lists.end(), {{1e300, 2e300, 3e300}, {1.7e308, -1.7e308, 1.7e308, -1.7e308}});
  return lists;
}

std::vector<Values> with_a_value_that_is_not_finite(Rng& rng) {
  std::vector<Values> lists;
  for (const double odd_one : {nan, infinity, -infinity}) {
    lists.insert(lists.end(), {Values{5, odd_one, 5}, Values(64, odd_one), Values(2, odd_one)});
    for (const std::size_t place : {1 + rng() % 98, std::uint64_t{0}, std::uint64_t{99}}) {
      Values x = uniform_values(rng, 100, 1, 2);
      x[place] = odd_one;
      lists.push_back(std::move(x));
    }
  }
  return lists;
}

void expect_not_finite(const std::string& call, double got, const Values& x) {
  const bool is_finite = std::ranges::all_of(x, [](double value) { return std::isfinite(value); });
  expect_not_finite(call, got,
                    is_finite
                        ? "the variance is above 1e600, which a double cannot hold"
                        : "one of the values is infinite or NaN: a finite result would hide it",
                    "skip and replace no value, and use no threshold; std::max(0.0, NaN) is 0");
}

double two_pass_here(const Values& x) {
  const auto n = static_cast<double>(x.size());
  return shifted_sums(x, sum_of(x) / n).m2 / (n - 1);
}

std::vector<Suspect> mean_suspects(const List& list) {
  const auto mean = static_cast<double>(list.exact.mean);
  const double n = list.exact.count;
  double restarted = 0, count = 0;
  for (const double x : list.x) {
    ++count;
    restarted += restarted == 0 ? x : (x - restarted) / count;
  }
  return {
      {restarted, "a mean of 0 was taken for no values yet: test the count"_likely},
      {integer_sum(list.x) / n,
       "the sum is truncated to an integer at each step: start std::accumulate with 0.0"_likely},
      {mean * n / (n - 1), "this divides by n - 1; only a variance does"_likely},
      {list.x[0],
       "the mean stays at the first value: 1 / count is an integer division, which gives 0"_likely},
      {n == 1 ? infinity : nan,
       "the first value was divided by a count of 0: increment the count first"_likely}};
}

std::vector<Suspect> variance_suspects(const List& list) {
  std::vector<Suspect> all = ways_to_m2(list.x);
  const double n = list.exact.count, variance = list.exact.variance;
  for (Suspect& way : all) way.value /= n - 1;
  all.insert(
      all.end(),
      {{variance * (n - 1) / n, "this divides by n; a sample variance divides by n - 1"_likely},
       {variance * (n - 1) / n * std::floor(n / (n - 1)),
        "n/(n-1) was an integer division, which gives 1, or 2 for two values"_likely},
       {std::sqrt(variance), "this is the standard deviation: the variance is its square"_likely}});
  return all;
}

std::vector<Suspect> m2_suspects(const List& list) {
  std::vector<Suspect> all = ways_to_m2(list.x);
  all.push_back({list.exact.variance * list.exact.count,
                 "this is n times the sample variance: m2 is n - 1 times it"_likely});
  return all;
}

}  // namespace mc::checks
