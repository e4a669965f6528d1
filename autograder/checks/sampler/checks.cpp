// What lab 6 checks. A use of a sampler is a column of N numbers, so most of it is exact, for any
// right answer: strata are counted, digits and bits are compared with those of the sequence, and
// the numbers of one walk through the samples with those of another. All seeds, sizes where they
// are free, and scenes' parameters are fresh in each run.
//
// Random tests have an alpha of 1e-8 each; there are fewer than sixty of them. Besides these a few
// bounds hold with room to spare for whatever is right; each has the chance of failing a right
// answer beside it, and all of those together come to less than 3e-7.

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include <fmt/format.h>

#include "6-sampler/experiments.hpp"
#include "checks/support/catch.hpp"
#include "checks/support/data.hpp"
#include "checks/support/expect.hpp"
#include "checks/support/known_scenes.hpp"
#include "checks/support/measure.hpp"
#include "checks/support/sobol_exact.hpp"
#include "checks/support/spectrum.hpp"
#include "checks/support/statistics.hpp"
#include "checks/support/strata.hpp"

namespace mc::checks {
namespace {

using experiments::Answer;
using experiments::Step;
using Values = std::vector<double>;
using View = std::span<const double>;
using Uses = std::vector<unsigned>;
using Seeds = std::vector<std::uint64_t>;

constexpr double alpha = 1e-8;
const std::array<std::string, 5> kinds{"independent", "stratified", "halton", "sobol",
                                       "blue_noise"};

std::uint64_t fresh_seed(Rng& rng) {
  return rng() >> 32;  // short enough to be typed again
}

Seeds fresh_seeds(Rng& rng, std::size_t count) {
  Seeds seeds(count);
  for (auto& seed : seeds) seed = fresh_seed(rng);
  return seeds;
}

/// `one` use of each sort (1 is next, 2 is next2) again and again.
Uses repeated(std::size_t times, const Uses& some) {
  Uses uses;
  for (std::size_t i = 0; i < times; ++i) uses.insert(uses.end(), some.begin(), some.end());
  return uses;
}

/// What a sampler hands out, coordinate by coordinate.
struct Columns {
  std::string call;
  std::size_t n;
  Values all;

  std::size_t size() const { return all.size() / n; }
  View operator[](std::size_t c) const { return std::span(all).subspan(c * n, n); }
};

Columns columns_of(const std::string& kind, std::size_t n, std::uint64_t seed, const Uses& uses) {
  const auto got = MEASURE(columns, kind, n, seed, uses);
  std::size_t dims = 0;
  for (const unsigned use : uses) dims += use;
  if (got.value.size() != n * dims) {
    fail(fmt::format("measured  {}: {} numbers\nexpected  {}", got.call, got.value.size(),
                     n * dims));
  }
  Columns columns{got.call, n, got.value};
  for (std::size_t c = 0; c < dims; ++c) {
    expect_inside(columns.call, fmt::format("coordinate {}, sample", c).c_str(), columns[c]);
  }
  return columns;
}

/// Is x in [0, 1) for each of them? Then the pairs (u[i], v[i]) are counted in 8 x 8 cells.
void expect_uniform_pairs(const std::string& call, View u, View v, const std::string& words,
                          const std::string& hint) {
  std::vector<std::uint64_t> counts(64);
  for (std::size_t i = 0; i < u.size(); ++i) {
    ++counts[static_cast<std::size_t>(u[i] * 8) * 8 + static_cast<std::size_t>(v[i] * 8)];
  }
  const double each = 1.0 / 64;
  expect_counts(call, counts, std::span(&each, 1), {words, alpha}, {{}, hint});
}

void expect_uniform(const std::string& call, View x, const std::string& words,
                    const std::string& hint) {
  expect_distribution(call, Values(x.begin(), x.end()), [](double u) { return u; }, {words, alpha},
                      {{}, hint});
}

/// How many standard deviations of it the correlation of two columns is from 0, if one of them is
/// in random order: the sum of products has then the variance Sxx Syy / (N - 1), exactly.
double correlation_score(View x, View y) {
  const auto n = static_cast<double>(x.size());
  const double mean_x = std::accumulate(x.begin(), x.end(), 0.0) / n;
  const double mean_y = std::accumulate(y.begin(), y.end(), 0.0) / n;
  double xx = 0, yy = 0, xy = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    xx += (x[i] - mean_x) * (x[i] - mean_x);
    yy += (y[i] - mean_y) * (y[i] - mean_y);
    xy += (x[i] - mean_x) * (y[i] - mean_y);
  }
  return xy / std::sqrt(xx * yy / (n - 1));
}

/// Two columns, one of them in an order of its own, have nothing to do with each other. 6.8
/// standard deviations: the distribution is that of a rank correlation, all but normal for 1,000
/// samples, so it fails a right answer once in 1e11; some three thousand pairs are looked at.
void expect_unrelated(const std::string& call, View x, View y, const std::string& which,
                      const std::string& hint) {
  const double score = correlation_score(x, y);
  if (std::abs(score) <= 6.8) return;  // false for NaN
  expect_that(false,
              fmt::format("{}: {} have a correlation of {:.3f}", call, which,
                          score / std::sqrt(static_cast<double>(x.size() - 1))),
              fmt::format("between -{0:.3f} and {0:.3f}",
                          6.8 / std::sqrt(static_cast<double>(x.size() - 1))),
              "columns in random orders of their own are uncorrelated but for chance, "
              "1/sqrt(N - 1)",
              hint);
}

/// The first coordinate of sample 0, over `count` neighbouring seeds: generate() and one use each.
struct FirstSamples {
  std::string call;
  Values x, y;
};

FirstSamples first_samples(const std::string& kind, const Uses& uses, std::size_t samples,
                           std::uint64_t first, std::size_t count) {
  std::vector<Step> steps;
  for (std::size_t i = 0; i < count; ++i) {
    steps.push_back({0, samples, first + i});
    for (const unsigned use : uses) steps.push_back({use, 0, 0});
  }
  const auto got = MEASURE(play, kind, steps);
  if (got.value.size() != steps.size()) fail("measured  " + got.call + ": not an answer a call");
  FirstSamples firsts{got.call, {}, {}};
  for (std::size_t i = uses.size(); i < steps.size(); i += uses.size() + 1) {
    const Answer& answer = got.value[i];  // of the last use
    if (answer.thrown != 0) fail("measured  " + got.call + ": an exception");
    firsts.x.push_back(answer.x);
    if (uses.back() == 2) firsts.y.push_back(answer.y);
  }
  return firsts;
}

// 6.1 ---------------------------------------------------------------------------------------------

TEST_CASE("6.1 numbers are uniform and independent", "[6.1][points:4][needs:2]") {
  Rng rng = check_rng();
  const std::size_t n = 16384;
  const Columns got = columns_of("independent", n, fresh_seed(rng), {1, 2, 1});
  const std::string hint = "uniforms of lab 2, fresh ones for every coordinate of every sample";
  for (std::size_t c = 0; c < 4; ++c) {
    expect_uniform(fmt::format("{}, coordinate {}", got.call, c), got[c],
                   "each coordinate is uniform in [0, 1)", hint);
    Values before, after;
    for (std::size_t i = 0; i < n; i += 2) {
      before.push_back(got[c][i]);
      after.push_back(got[c][i + 1]);
    }
    expect_uniform_pairs(fmt::format("{}, coordinate {}", got.call, c), before, after,
                         "a sample has nothing to do with the one before it", hint);
  }
  for (const auto& [a, b] : {std::pair{0, 1}, {1, 2}, {0, 3}}) {
    expect_uniform_pairs(fmt::format("{}, coordinates {} and {}", got.call, a, b), got[a], got[b],
                         "different coordinates have nothing to do with each other",
                         "the same numbers come again for another use");
  }
}

TEST_CASE("6.1 the error is that of independent samples", "[6.1][points:4][needs:6.5][needs:2]") {
  Rng rng = check_rng();
  const std::uint64_t n = 16;
  for (const std::string scene : {"rect_light", "motion_edge", "pixel_time_lens"}) {
    const auto parameters = fresh_parameters(scene, rng);
    const Known known = known_scene(scene, parameters, n);
    const auto got =
        MEASURE(estimates, "independent", scene, parameters, 1, 0, n, fresh_seeds(rng, 600));
    const Replicates estimates{got.call, got.value, n};
    const Hints hints{{{0, "far too exact for random numbers"}},
                      "every sample and every coordinate of it wants a number of its own"};
    expect_mean(estimates, known.exact, known.variance,
                {"the estimates have the scene's exact mean", alpha}, hints);
    expect_variance(estimates, known.exact, known.variance, known.kurtosis,
                    {"independent samples have the variance sigma^2 / N", alpha}, hints);
  }
}

TEST_CASE("6.1 kinds that there are not are refused", "[6.1][points:2]") {
  Rng rng = check_rng();
  columns_of("independent", 2, fresh_seed(rng), {1});
  for (const std::string kind : {"random", "", "Sobol", "sobol "}) {
    const Call refused = MEASURE_OUTCOME(columns, kind, 2, 1, {1});
    expect_invalid_argument(refused, "kind", "there is no such kind of sampler");
    for (const std::string& known : kinds) {
      expect_that(refused.outcome.bytes.find(known) != std::string::npos,
                  fmt::format("{}: threw \"{}\"", refused.text, refused.outcome.bytes),
                  fmt::format("words that also name the kind {}", known),
                  "whoever mistypes a name wants to know the names there are", "");
    }
  }
}

// 6.2 ---------------------------------------------------------------------------------------------

constexpr std::size_t sizes[] = {1, 2, 3, 7, 12, 64, 1009, 10007};

Grid grid_of(std::size_t n) {
  std::size_t ny = 1;
  for (std::size_t divisor = 1; divisor * divisor <= n; ++divisor) {
    if (n % divisor == 0) ny = divisor;
  }
  return {n / ny, ny};
}

TEST_CASE("6.2 next has one number in each of N strata", "[6.2][points:4][needs:3]") {
  Rng rng = check_rng();
  for (const std::size_t n : sizes) {
    const Columns got = columns_of("stratified", n, fresh_seed(rng), {1, 1, 1});
    for (std::size_t c = 0; c < got.size(); ++c) {
      expect_one_in_each(got.call, fmt::format("next() {}", c).c_str(), got[c], n,
                         "a next() is stratified_1d, shuffled");
    }
  }
}

TEST_CASE("6.2 next2 has one point in each cell and stratum", "[6.2][points:5][needs:3]") {
  Rng rng = check_rng();
  for (const std::size_t n : sizes) {
    const Columns got = columns_of("stratified", n, fresh_seed(rng), {2, 2});
    for (std::size_t c = 0; c < got.size(); c += 2) {
      expect_one_in_each_cell(got.call, got[c], got[c + 1], grid_of(n));
      const std::string jittered =
          "a jittered grid has one point in each cell; multi-jittered points (3.7) have one in "
          "each stratum of either axis too";
      expect_one_in_each(got.call, "x", got[c], n, jittered);
      expect_one_in_each(got.call, "y", got[c + 1], n, jittered);
    }
  }
}

TEST_CASE("6.2 every use has a random order of its own", "[6.2][points:5][needs:6.4][needs:3]") {
  Rng rng = check_rng();
  const std::size_t n = 10007;
  const Columns got = columns_of("stratified", n, fresh_seed(rng), repeated(6, {1, 2}));
  const auto use_of = [](std::size_t c) { return c / 3 * 2 + (c % 3 > 0 ? 1 : 0); };
  Values index(n);
  std::iota(index.begin(), index.end(), 0.0);
  for (std::size_t c = 0; c < got.size(); ++c) {
    expect_unrelated(got.call, index, got[c],
                     fmt::format("the numbers of the samples and coordinate {}", c),
                     "the strata come in order: the pattern wants to be shuffled");
    for (std::size_t other = 0; other < c; ++other) {
      if (use_of(other) == use_of(c)) continue;
      expect_unrelated(got.call, got[other], got[c], fmt::format("coordinates {} and {}", other, c),
                       "one order for different uses: each wants a shuffle of its own");
    }
  }
  pass();
  // Where a point lies within its stratum: uniform, and of its own for every use.
  const auto jitter = [&](std::size_t c) {
    Values jitters;
    for (const double x : got[c]) {
      const double scaled = x * static_cast<double>(n);
      jitters.push_back(std::clamp(scaled - std::floor(scaled), 0.0, 1 - 0x1p-53));
    }
    return jitters;
  };
  const std::string hint = "points are uniform in their strata: a number for each";
  for (const std::size_t c : {0u, 1u}) {
    expect_uniform(fmt::format("{}, within the strata of coordinate {}", got.call, c), jitter(c),
                   "points are uniform in their strata", hint);
  }
  expect_uniform_pairs(got.call + ", within the strata", jitter(0), jitter(3),
                       "the jitter of different uses is independent", hint);
  // Which stratum the first sample is in.
  for (const unsigned use : {1u, 2u}) {
    const auto firsts = first_samples("stratified", {use}, 5, fresh_seed(rng), 600);
    const std::string always = "the first sample may lie anywhere: shuffle with the seed's numbers";
    expect_uniform(firsts.call + ": x", firsts.x, "the first sample is uniform over seeds", always);
    if (use == 2) {
      expect_uniform(firsts.call + ": y", firsts.y, "the first sample is uniform over seeds",
                     always);
    }
  }
}

/// What n strata of the line leave of the variance of a pixel of stripes: of the mean, and its
/// fourth moment over that squared.
struct Left {
  double variance, kurtosis;
};

Left left_of_stripes(const scenes::Stripes& pixel, std::size_t n) {
  const auto size = static_cast<double>(n);
  double variance = 0, fourth = 0;  // of the sum: cumulants of Bernoulli variables add up
  for (std::size_t i = 0; i < n; ++i) {
    scenes::Stripes part = pixel;
    const double height = pixel.bottom - pixel.top;
    part.top = pixel.top + height * (static_cast<double>(i) / size);
    part.bottom = pixel.top + height * (static_cast<double>(i + 1) / size);
    const double p = exact(part), pq = p * (1 - p);
    variance += pq;
    fourth += pq * (1 - 6 * pq);
  }
  return {variance / (size * size), 3 + fourth / (variance * variance)};
}

TEST_CASE("6.2 the error is that of stratified samples", "[6.2][points:4][needs:6.5][needs:3]") {
  Rng rng = check_rng();
  // A dozen stripes in the pixel: with 64 strata and more, one edge in a few of them.
  scenes::Stripes pixel;
  pixel.top = uniform(rng, 0.04, 0.05);
  pixel.bottom = 2 * pixel.top;
  pixel.rise = 12 * pixel.bottom;
  pixel.phase = uniform(rng);
  const Values parameters{pixel.top, pixel.bottom, pixel.rise, pixel.phase};
  const double mean = exact(pixel);
  std::vector<Replicates> estimates;
  std::vector<Values> values;
  std::vector<Known> known;
  values.reserve(2);
  for (const std::size_t n : {64u, 512u}) {
    const Left left = left_of_stripes(pixel, n);
    const auto got =
        MEASURE(estimates, "stratified", "stripes", parameters, 1, 0, n, fresh_seeds(rng, 600));
    values.push_back(got.value);
    estimates.push_back({got.call, values.back(), static_cast<double>(n)});
    known.push_back({mean, left.variance, left.kurtosis});
    const Hints hints{{{mean * (1 - mean) / static_cast<double>(n) / left.variance,
                        "these are independent samples: no strata"}},
                      "one number in each of the N strata, uniform in it"};
    expect_mean(estimates.back(), mean, left.variance,
                {"the estimates have the pixel's exact mean", alpha}, hints);
    expect_variance(estimates.back(), mean, left.variance, left.kurtosis,
                    {"what is left is the variance within the strata", alpha}, hints);
  }
  expect_rate(estimates[0], known[0], estimates[1], known[1],
              {"the error of stripes falls as the strata that an edge crosses", alpha},
              {{{0.5, "the error falls as that of independent samples"}}, ""});
}

/// The mean squared error of `replicates` estimates, over that of independent samples.
double gain_over_independent(const std::string& kind, const std::string& scene,
                             const Values& parameters, std::size_t n, std::size_t replicates,
                             Rng& rng, std::string& call) {
  const Known known = known_scene(scene, parameters, static_cast<double>(n));
  const auto got =
      MEASURE(estimates, kind, scene, parameters, 1, 0, n, fresh_seeds(rng, replicates));
  call = got.call;
  double squares = 0;
  for (const double value : got.value) squares += (value - known.exact) * (value - known.exact);
  return squares / static_cast<double>(got.value.size()) / known.variance;
}

void expect_gain(const std::string& kind, const std::string& scene, std::size_t n, double at_most,
                 const std::string& usual, const std::string& hint, Rng& rng) {
  std::string call;
  const double ratio =
      gain_over_independent(kind, scene, fresh_parameters(scene, rng), n, 100, rng, call);
  expect_that(
      ratio < at_most,
      fmt::format("{}: {:.3g} times the mean squared error of independent samples", call, ratio),
      fmt::format("less than {}; {} is usual", at_most, usual), "that is what these points are for",
      hint);
}

// 6.3 ---------------------------------------------------------------------------------------------

/// How many leading bits two coordinates have in common, up to 32.
int common_bits(double a, double b) {
  const auto word = [](double x) { return static_cast<std::uint32_t>(std::floor(x * 0x1p32)); };
  return std::countl_zero(word(a) ^ word(b));
}

/// Is the column that of dimension d of the Sobol' sequence, scrambled? Nested scrambling keeps how
/// many bits any two points have in common, and nothing else.
bool is_scrambled_sobol(View x, unsigned d) {
  const auto directions = sobol_directions(d);
  for (std::uint32_t i = 0; i < x.size(); ++i) {
    for (std::uint32_t j = 0; j < i; ++j) {
      const int exact = std::countl_zero(sobol_word(directions, i) ^ sobol_word(directions, j));
      if (common_bits(x[i], x[j]) != exact) return false;
    }
  }
  return true;
}

/// The number of a digit string's interval: x b^digits, rounded down; what lies 1e-11 below the next
/// one, where rounding may put a point and chance hardly does, counts as in it.
std::uint64_t interval_of(double x, unsigned base, unsigned digits) {
  return static_cast<std::uint64_t>(std::floor(x * std::pow(base, digits) + 1e-11));
}

/// Is the column that of the Halton sequence in this base, from index 0, its digits permuted? Then
/// the digit at each position is that of the index, exchanged: an equal one for equal ones, another
/// one for others.
bool is_permuted_halton(View x, unsigned base) {
  std::uint64_t power = 1;
  for (unsigned position = 1; position == 1 || power < x.size(); ++position, power *= base) {
    std::vector<std::uint64_t> permuted(base, base), came_from(base, base);  // base: by none yet
    for (std::size_t i = 0; i < x.size(); ++i) {
      const std::uint64_t from = i / power % base;
      const std::uint64_t to = interval_of(x[i], base, position) % base;
      if (permuted[from] == base && came_from[to] == base) {
        permuted[from] = to;
        came_from[to] = from;
      }
      if (permuted[from] != to) return false;
    }
  }
  return true;
}

constexpr unsigned first_primes[] = {2,  3,  5,  7,   11,  13,  17,  19,  23,  29, 31,
                                     37, 41, 43, 47,  53,  59,  61,  67,  71,  73, 79,
                                     83, 89, 97, 101, 103, 107, 109, 113, 127, 131};

/// Each coordinate, in the order in which uses were first asked for, is a dimension of its own.
template <class Is>
void expect_dimensions(const Columns& got, const std::string& what, const std::string& because,
                       Is is) {
  for (unsigned d = 0; d < got.size(); ++d) {
    if (is(got[d], d)) continue;
    std::string hint = "is it the sequence from index 0, in its own order, a sample a point?";
    for (unsigned other = 0; other < 10; ++other) {  // in larger primes few digits come twice
      if (is(got[d], other)) {
        hint = fmt::format("this is dimension {}, randomised: each new use takes the next ones",
                           other);
        break;
      }
    }
    expect_that(false, fmt::format("{}: coordinate {} is not dimension {}", got.call, d, d), what,
                because, hint);
  }
  pass();
}

TEST_CASE("6.3 the uses of sobol are Sobol' dimensions", "[6.3][points:5][needs:5]") {
  Rng rng = check_rng();
  for (const Uses& uses : {repeated(10, {1, 2}), repeated(8, {2}), repeated(32, {1})}) {
    const Columns got = columns_of("sobol", 61, fresh_seed(rng), uses);
    expect_dimensions(got, "a scrambled dimension of the Sobol' sequence, one after the other",
                      "nested scrambling keeps how many leading bits two points share",
                      is_scrambled_sobol);
  }
}

TEST_CASE("6.3 the uses of halton are Halton dimensions", "[6.3][points:5][needs:5]") {
  Rng rng = check_rng();
  for (const Uses& uses : {repeated(10, {1, 2}), repeated(8, {2}), repeated(32, {1})}) {
    const Columns got = columns_of("halton", 61, fresh_seed(rng), uses);
    expect_dimensions(
        got, "radical inverses in one prime after the other, digits permuted",
        "a permutation for each position: points have equal digits where their indices have",
        [](View x, unsigned d) { return is_permuted_halton(x, first_primes[d]); });
  }
}

TEST_CASE("6.3 each seed and each dimension is randomised anew", "[6.3][points:4][needs:5]") {
  Rng rng = check_rng();
  for (const std::string kind : {"halton", "sobol"}) {
    const std::size_t seeds = 800;
    const auto x = first_samples(kind, {1}, 8, fresh_seed(rng), seeds);
    const auto y = first_samples(kind, {1, 2}, 8, fresh_seed(rng), seeds);
    const bool is_plain = *std::max_element(x.x.begin(), x.x.end()) == 0;
    const std::string plain = is_plain
                                  ? "a sequence as it is has the origin for its first point"
                                  : "does the seed of generate() decide about every dimension?";
    expect_uniform(x.call, x.x, "the first sample is uniform over seeds", plain);
    expect_uniform(y.call + ": x", y.x, "the first sample is uniform over seeds", plain);
    expect_uniform(y.call + ": y", y.y, "the first sample is uniform over seeds", plain);
    expect_uniform_pairs(y.call, y.x, y.y, "dimensions are randomised independently",
                         "one seed for both axes: each dimension wants its own");
  }
}

/// Every box of 2^-k x 2^-(m-k) has one of the 2^m points.
void expect_net(const std::string& call, View x, View y, const std::string& which) {
  const auto m = static_cast<unsigned>(std::countr_zero(x.size()));
  for (unsigned k = 0; k <= m; ++k) {
    std::vector<unsigned> boxes(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) {
      const auto column = static_cast<std::size_t>(std::ldexp(x[i], static_cast<int>(k)));
      const auto row = static_cast<std::size_t>(std::ldexp(y[i], static_cast<int>(m - k)));
      ++boxes[column << (m - k) | row];
    }
    const auto odd = std::find_if(boxes.begin(), boxes.end(), [](auto in) { return in != 1; });
    if (odd == boxes.end()) continue;
    expect_that(
        false,
        fmt::format("{}: {} points of {} in a box of 2^-{} x 2^-{}", call, *odd, which, k, m - k),
        "one point in every such box", "the first two Sobol' dimensions are a (0,2)-sequence",
        "where no two dimensions are left, pad with the first two, scrambled");
  }
  pass();
}

TEST_CASE("6.3 sobol has any number of uses", "[6.3][points:4][needs:5]") {
  Rng rng = check_rng();
  const std::size_t n = 1024;
  // 31 dimensions are gone, and two are asked for; then sixty uses more.
  Uses uses = repeated(31, {1});
  const Uses more = repeated(30, {2, 1});
  uses.insert(uses.end(), more.begin(), more.end());
  const Columns got = columns_of("sobol", n, fresh_seed(rng), uses);
  Values index(n);
  std::iota(index.begin(), index.end(), 0.0);
  for (std::size_t c = 0; c < got.size(); ++c) {
    expect_one_in_each(got.call, fmt::format("coordinate {}", c).c_str(), got[c], n,
                       "every use of sobol is stratified in 2^m strata for 2^m samples");
  }
  // The 34th and 35th coordinate and whatever is from there on is padded: all in their own order.
  for (std::size_t c = 31; c < got.size(); c += 3) {
    expect_net(got.call, got[c], got[c + 1], fmt::format("coordinates {} and {}", c, c + 1));
  }
  for (std::size_t c = 34; c < got.size(); c += 3) {
    for (const std::size_t one : {c, c + 2}) {
      if (one >= got.size()) continue;
      expect_unrelated(got.call, index, got[one],
                       fmt::format("the numbers of the samples and coordinate {}", one),
                       "padded dimensions come in a random order");
      for (std::size_t other = 0; other < c; other += other < 31 ? 10 : 1) {
        expect_unrelated(got.call, got[other], got[one],
                         fmt::format("coordinates {} and {}", other, one),
                         "each padded use wants a random order of its own");
      }
    }
  }
  pass();
}

TEST_CASE("6.3 halton has any number of uses", "[6.3][points:2][needs:5]") {
  Rng rng = check_rng();
  const std::size_t seeds = 500;
  const auto last = first_samples("halton", repeated(40, {1, 2}), 3, fresh_seed(rng), seeds);
  const std::string hint =
      "beyond 32 dimensions: larger primes, or the first ones again, permuted "
      "by other seeds and shuffled";
  expect_uniform(last.call + ": x", last.x, "the hundredth dimension is uniform over seeds", hint);
  expect_uniform(last.call + ": y", last.y, "the hundredth dimension is uniform over seeds", hint);
  const Columns got = columns_of("halton", 1009, fresh_seed(rng), repeated(40, {1, 2}));
  std::set<double> firsts;
  for (std::size_t c = 0; c < got.size(); ++c) firsts.insert(got[c][0]);
  expect_that(firsts.size() == got.size(),
              fmt::format("{}: {} different numbers in the first sample", got.call, firsts.size()),
              fmt::format("{}, one for each coordinate", got.size()),
              "53 bits are the same twice once in 1e12 runs",
              "the same dimension, with the same permutations, comes twice");
  // The first bit of a coordinate says which half a sample is in. Base 2 twice in the same order
  // gives the same halves, or has them exchanged; a random order of its own, or another prime, does
  // not in 2^100 runs.
  const auto halves = [&](std::size_t c, std::size_t other) {
    std::size_t same = 0;
    for (std::size_t i = 0; i < got.n; ++i) same += (got[c][i] < 0.5) == (got[other][i] < 0.5);
    return same;
  };
  for (std::size_t c = 32; c < got.size(); ++c) {
    for (std::size_t other = 0; other < c; ++other) {
      const std::size_t same = halves(c, other);
      if (same != 0 && same != got.n) continue;
      expect_that(false,
                  fmt::format("{}: coordinates {} and {} are in {} half for all samples", got.call,
                              other, c, same == 0 ? "the other" : "the same"),
                  "coordinates that have nothing to do with each other",
                  "one dimension twice in the same order is one number for two uses", hint);
    }
  }
  pass();
}

// Sobol' points of 256 gain a factor of 50 and more over independent ones on a light, a hundred
// estimates know it within a factor of 2: a right answer never comes near the bounds below (chi
// squared with 100 degrees at five times its mean has a probability below 1e-50).

TEST_CASE("6.3 halton and sobol are better than independent samples",
          "[6.3][points:2][needs:6.5][needs:5]") {
  Rng rng = check_rng();
  const std::string hint =
      "are they the points of lab 5, and the pair of a next2() two dimensions?";
  expect_gain("sobol", "rect_light", 256, 0.1, "0.002", hint, rng);
  expect_gain("sobol", "pixel_edge", 256, 0.5, "0.1", hint, rng);
  expect_gain("halton", "rect_light", 256, 0.25, "0.02", hint, rng);
  expect_gain("halton", "pixel_edge", 256, 0.6, "0.15", hint, rng);
}

// 6.4 ---------------------------------------------------------------------------------------------

struct Played {
  std::string call;
  std::vector<Answer> answers;
};

Played played(const std::string& kind, const std::vector<Step>& steps) {
  const auto got = MEASURE(play, kind, steps);
  if (got.value.size() != steps.size()) fail("measured  " + got.call + ": not an answer a call");
  return {got.call + " of " + kind, got.value};
}

const char* name_of(unsigned call) {
  const char* const names[] = {"generate", "next", "next2", "advance"};
  return names[std::min(call, 3u)];
}

void expect_thrown(const Played& got, const std::vector<Step>& steps, std::size_t i,
                   unsigned thrown, const std::string& when, const std::string& because) {
  if (got.answers[i].thrown == thrown) return;
  const char* const words[] = {"no exception", "std::out_of_range", "std::invalid_argument",
                               "another exception"};
  expect_that(false,
              fmt::format("{}: {}() {}: {}", got.call, name_of(steps[i].call), when,
                          words[std::min(got.answers[i].thrown, 3u)]),
              words[thrown], because, "");
}

TEST_CASE("6.4 there are numbers for N samples and no others", "[6.4][points:4]") {
  Rng rng = check_rng();
  for (const std::string& kind : kinds) {
    const std::vector<Step> steps{
        {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {1, 0, 0}, {0, 2, fresh_seed(rng)},
        {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {2, 0, 0}, {1, 0, 0},
        {3, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {3, 0, 0},
        {1, 0, 0}, {0, 1, 7}, {1, 0, 0}, {3, 0, 0}, {1, 0, 0}};
    const Played got = played(kind, steps);
    const std::set<std::size_t> refused{0, 1, 3, 11, 12, 15, 19};
    for (std::size_t i = 0; i < steps.size(); ++i) {
      const std::string when = i < 4    ? "before the first generate()"
                               : i < 10 ? "within the samples"
                               : i < 16 ? "after the last of two samples"
                               : i < 19 ? "after a second generate()"
                                        : "after the last of its samples";
      expect_thrown(got, steps, i, refused.contains(i) ? 1 : 0, when,
                    "next() and next2() want a sample; advance() never throws");
    }
  }
  pass();
}

TEST_CASE("6.4 no samples and too many are refused", "[6.4][points:2]") {
  for (const std::string& kind : kinds) {
    const std::vector<Step> steps{
        {0, 0, 1}, {0, most_samples + 1, 1}, {0, ~std::uint64_t{0}, 1}, {0, 3, 1}, {1, 0, 0}};
    const Played got = played(kind, steps);
    for (std::size_t i = 0; i < steps.size(); ++i) {
      expect_thrown(got, steps, i, i < 3 ? 2 : 0,
                    i < 3 ? fmt::format("with {} samples", steps[i].samples) : "after that",
                    "there must be samples, and memory for a column of them");
    }
  }
  pass();
}

/// One generate() and, for every sample, its list of uses.
std::vector<Step> walk(std::size_t samples, std::uint64_t seed, const std::vector<Uses>& uses) {
  std::vector<Step> steps{{0, samples, seed}};
  for (const Uses& of_sample : uses) {
    for (const unsigned use : of_sample) steps.push_back({use, 0, 0});
    steps.push_back({3, 0, 0});
  }
  return steps;
}

/// What each use had for each sample in a walk that begins at step `first`.
std::map<std::array<std::size_t, 3>, Point2> by_use(const std::vector<Step>& steps,
                                                    const std::vector<Answer>& answers,
                                                    std::size_t first, std::size_t end) {
  std::map<std::array<std::size_t, 3>, Point2> values;
  std::size_t sample = 0;
  std::array<std::size_t, 4> count{};
  for (std::size_t i = first + 1; i < end; ++i) {
    const unsigned call = steps[i].call;
    if (call == 3) {
      ++sample;
      count = {};
    } else {
      values[{call, count[call]++, sample}] = {answers[i].x, answers[i].y};
    }
  }
  return values;
}

/// Whatever both walks asked for, both were told.
void expect_same(const std::string& call, const std::map<std::array<std::size_t, 3>, Point2>& a,
                 const std::map<std::array<std::size_t, 3>, Point2>& b, const std::string& because,
                 const std::string& hint) {
  for (const auto& [use, point] : b) {
    const auto other = a.find(use);
    if (other == a.end()) continue;
    if (other->second.x == point.x && other->second.y == point.y) continue;
    expect_that(false,
                fmt::format("{}: {}() {} of sample {} is {:.17g}", call,
                            name_of(static_cast<unsigned>(use[0])), use[1], use[2], point.x),
                fmt::format("{:.17g}", other->second.x), because, hint);
  }
  pass();
}

bool is_sequence(const std::string& kind) {
  return kind == "halton" || kind == "sobol";
}

/// Nothing can be said of numbers that are all the same, or of none. A sequence that is not
/// randomised has many twice, but that is the business of 6.3.
void expect_different(const std::string& kind, const std::string& call,
                      const std::map<std::array<std::size_t, 3>, Point2>& values) {
  if (is_sequence(kind)) return;
  std::set<double> different;
  for (const auto& [use, point] : values) different.insert(point.x);
  expect_that(different.size() == values.size(),
              fmt::format("{}: {} different numbers", call, different.size()),
              fmt::format("{}: one for each use of each sample", values.size()),
              "53 random bits are the same twice once in 1e11 runs",
              "does advance() move on, and next() to another use?");
}

TEST_CASE("6.4 the same seed gives the same numbers", "[6.4][points:4]") {
  Rng rng = check_rng();
  for (const std::string& kind : kinds) {
    const std::size_t n = 9;
    const std::uint64_t seed = fresh_seed(rng);
    const std::vector<Uses> all(n, Uses{1, 2, 2, 1, 1});
    std::vector<Step> steps = walk(n, seed, all);
    const std::size_t first_end = steps.size();
    // Something else in between, left in the middle of a sample.
    std::vector<Step> between = walk(4, seed + 1, {{2, 1}, {1}});
    for (const unsigned use : {2u, 1u, 1u}) between.push_back({use, 0, 0});
    steps.insert(steps.end(), between.begin(), between.end());
    const std::size_t second = steps.size();
    for (const Step& step : walk(n, seed, all)) steps.push_back(step);
    const Played got = played(kind, steps);
    const auto a = by_use(steps, got.answers, 0, first_end);
    const auto b = by_use(steps, got.answers, second, steps.size());
    const Played fresh = played(kind, walk(n, seed, all));
    expect_same(fresh.call, a, by_use(walk(n, seed, all), fresh.answers, 0, first_end),
                "the same kind, seed and uses in another object",
                "nothing but the seed may decide: no clock, no global generator");
    expect_same(got.call, a, b, "generate() begins anew, whatever the object was used for before",
                "what is left over from the integration before? Counters, columns, generators");
    const Played alone = played(kind, between);
    expect_same(got.call, by_use(between, alone.answers, 0, between.size()),
                by_use(steps, got.answers, first_end, second),
                "4 samples, in an object that has made 9 before, are those of a new object",
                "what is left over from the integration before? Columns of another size?");
    expect_different(kind, got.call, a);
  }
}

TEST_CASE("6.4 a sample may ask for less than the one before", "[6.4][points:4]") {
  Rng rng = check_rng();
  for (const std::string& kind : kinds) {
    const std::size_t n = 12;
    const std::uint64_t seed = fresh_seed(rng);
    const Uses all{1, 2, 1, 2, 1};
    std::vector<Uses> some{all};
    while (some.size() < n) {
      Uses fewer = all;
      fewer.resize(rng() % (all.size() + 1));
      some.push_back(fewer);
    }
    some[3] = {};
    const auto full = walk(n, seed, std::vector<Uses>(n, all)), part = walk(n, seed, some);
    const Played a = played(kind, full), b = played(kind, part);
    expect_different(kind, a.call, by_use(full, a.answers, 0, full.size()));
    expect_same(b.call, by_use(full, a.answers, 0, full.size()),
                by_use(part, b.answers, 0, part.size()),
                "what a sample is told does not depend on what others ask for",
                "a sample that ends early must not hand its numbers to the next one");
    // The other way round, uses are first asked for in the same order, but by later samples.
    std::vector<Uses> growing;
    for (std::size_t i = 0; i < n; ++i) {
      growing.push_back(all);
      growing.back().resize(std::min(i / 2, all.size()));
    }
    const auto late = walk(n, seed, growing);
    const Played c = played(kind, late);
    expect_same(c.call, by_use(full, a.answers, 0, full.size()),
                by_use(late, c.answers, 0, late.size()),
                "a use may be first asked for by a later sample: its number is the same",
                "make a whole column, also for the samples before, and hand out this sample's");
  }
}

TEST_CASE("6.4 next and next2 are counted apart", "[6.4][points:3]") {
  Rng rng = check_rng();
  for (const std::string& kind : kinds) {
    const std::size_t n = 12;
    const std::uint64_t seed = fresh_seed(rng);
    const Uses all{1, 2, 1, 2, 1, 2};
    std::vector<Uses> mixed{all};
    while (mixed.size() < n) {
      Uses other = all;
      for (std::size_t i = other.size(); i > 1; --i) std::swap(other[i - 1], other[rng() % i]);
      mixed.push_back(other);
    }
    const auto plain = walk(n, seed, std::vector<Uses>(n, all)), other = walk(n, seed, mixed);
    const Played a = played(kind, plain), b = played(kind, other);
    expect_different(kind, a.call, by_use(plain, a.answers, 0, plain.size()));
    expect_same(b.call, by_use(plain, a.answers, 0, plain.size()),
                by_use(other, b.answers, 0, other.size()),
                "the k-th next() of a sample is the same use wherever next2() stands between",
                "count the calls of next() and those of next2() in counters of their own, and set "
                "both to 0 in advance()");
  }
}

TEST_CASE("6.4 neighbouring seeds have nothing in common", "[6.4][points:3][needs:6.3]") {
  Rng rng = check_rng();
  for (const std::string& kind : kinds) {
    const auto got = first_samples(kind, {1}, 1, fresh_seed(rng), 2 * 800);
    Values before, after;
    for (std::size_t i = 0; i < got.x.size(); i += 2) {
      before.push_back(got.x[i]);
      after.push_back(got.x[i + 1]);
    }
    expect_uniform_pairs(got.call + " of " + kind, before, after,
                         "seeds s and s + 1 give unrelated numbers",
                         "mix the bits of the seed before they become a state or a counter");
  }
  // Nor have other uses of other seeds, near or far. 1,274 numbers of 53 bits for each kind: two of
  // them are the same once in 1e9 runs.
  const Uses uses{1, 2, 1, 2, 1};
  const std::size_t per_seed = 2 * uses.size();  // answers, in a walk of two samples
  for (const std::string& kind : kinds) {
    const std::uint64_t first = fresh_seed(rng);
    Seeds seeds(32);
    std::iota(seeds.begin(), seeds.end(), first);
    for (unsigned bit = 5; bit < 64; ++bit) seeds.push_back(first + (std::uint64_t{1} << bit));
    std::vector<Step> steps;
    for (const std::uint64_t seed : seeds) {
      for (const Step& step : walk(2, seed, {uses, uses})) steps.push_back(step);
    }
    const Played got = played(kind, steps);
    struct Place {
      std::uint64_t seed;
      std::size_t answer;  // which of those with this seed
      bool operator==(const Place&) const = default;
    };
    std::map<double, Place> places;
    std::size_t asked = 0;
    for (std::size_t i = 0; i < steps.size(); ++i) {
      if (steps[i].call != 1 && steps[i].call != 2) continue;
      const Place place{seeds[asked / per_seed], asked % per_seed};
      ++asked;
      Values numbers{got.answers[i].x};
      if (steps[i].call == 2) numbers.push_back(got.answers[i].y);
      for (const double x : numbers) {
        const Place before = places.insert({x, place}).first->second;
        if (before.seed == place.seed) continue;
        expect_that(
            false,
            fmt::format("{}: {:.17g} with seed {} and with seed {}", got.call, x, before.seed,
                        place.seed),
            "another number", "different seeds, even neighbours, give unrelated numbers",
            before.answer != place.answer
                ? "seed + use is the same for (s, use + 1) and (s + 1, use), and so is seed + "
                  "counter: hash them instead"
            : place.seed - before.seed >= std::uint64_t{1} << 32
                ? "was the seed cut to 32 bits?"
                : "does this number depend on the seed at all?");
      }
    }
  }
  pass();
}

// 6.5 ---------------------------------------------------------------------------------------------

TEST_CASE("6.5 integrate is the mean over the samples", "[6.5][points:3]") {
  Rng rng = check_rng();
  for (const std::size_t n : {1u, 2u, 3u, 1000u}) {
    const Values dealt = uniform_values(rng, n, 1, 2);
    const auto got = MEASURE(integrate_recorded, dealt, n, fresh_seed(rng));
    if (got.value.values.size() != 1) fail("measured  " + got.call + ": no value");
    const double mean = std::accumulate(dealt.begin(), dealt.end(), 0.0) / static_cast<double>(n);
    expect_within(got.call, got.value.values[0], mean, 2 * static_cast<double>(n) * 0x1p-52,
                  "the mean of what the scene had for each sample; n roundings of a sum below 2n",
                  {{{mean * static_cast<double>(n), "divide by the number of samples"},
                    {dealt[0], "advance() moves on to the next sample"}},
                   "every sample counts once"});
  }
}

/// A few numbers, as they are written.
std::string first_of(const Seeds& numbers) {
  std::string words;
  for (std::size_t i = 0; i < std::min<std::size_t>(numbers.size(), 5); ++i) {
    words += fmt::format("{} ", numbers[i]);
  }
  return words + "…";
}

TEST_CASE("6.5 integrate walks through the samples once", "[6.5][points:2]") {
  Rng rng = check_rng();
  const std::size_t n = 5 + rng() % 20;
  const std::uint64_t seed = fresh_seed(rng);
  const auto got = MEASURE(integrate_recorded, uniform_values(rng, n, 0, 1), n, seed);
  expect_that(got.value.samples == Seeds{n},
              fmt::format("{}: {} calls of generate()", got.call, got.value.samples.size()),
              fmt::format("one, with {} samples", n), "all samples belong to one point set",
              "generate() once before the loop, advance() at the end of each round");
  Seeds in_order(n);
  std::iota(in_order.begin(), in_order.end(), std::uint64_t{0});
  expect_that(got.value.positions == in_order,
              fmt::format("{}: the scene was evaluated {} times, for the samples {}", got.call,
                          got.value.positions.size(), first_of(got.value.positions)),
              "once for each sample, 0 1 2 …", "so many samples were paid for",
              "advance() once after each sample");
  const auto other = MEASURE(integrate_recorded, {1}, 1, seed + 1);
  expect_that(!got.value.seeds.empty() && got.value.seeds != other.value.seeds,
              fmt::format("{}: the same seed for generate() as with seed {}", got.call, seed + 1),
              "another one", "the seed decides about the samples", "hand it on to generate()");
  const auto far = MEASURE(integrate_recorded, {1}, 1, seed + (std::uint64_t{1} << 40));
  expect_that(far.value.seeds != got.value.seeds && far.value.seeds != other.value.seeds,
              far.call + ": the same seed for generate() as without its upper half", "another one",
              "seeds have 64 bits", "was the seed cut to 32 bits?");
  const auto twice =
      MEASURE(estimates, "independent", "rect_light", {}, 1, 0, n, {seed, seed + 1, seed});
  expect_that(twice.value.size() == 3 && twice.value[0] == twice.value[2],
              twice.call + ": another estimate when the first seed comes again", "the same",
              "the seed decides, not what was integrated before",
              "is there anything static, or a generator that goes on?");
  const Call none = MEASURE_OUTCOME(integrate_recorded, {}, 0, seed);
  expect_invalid_argument(none, "samples", "a mean of no samples is nothing");
}

// No kind may have more than e times the variance of independent samples: that is the most a
// scrambled (0,m,s)-net can have (Owen 1997), and the others have less. Within six standard
// deviations of that: once in 5e8 even for one that had it, and there are 80 of them; those that do
// have less are never near it.

TEST_CASE("6.5 every kind is unbiased on every scene", "[6.5][points:3][needs:6.3][needs:6.7]") {
  Rng rng = check_rng();
  const std::uint64_t n = 16, replicates = 200;
  for (const std::string& kind : kinds) {
    for (const KnownScene& one : known_scenes) {
      const std::string scene(one.name);
      const auto parameters = fresh_parameters(scene, rng);
      const Known known = known_scene(scene, parameters, static_cast<double>(n));
      const double a = uniform(rng, 0.5, 2), b = uniform(rng, -1, 1);
      const auto got =
          MEASURE(estimates, kind, scene, parameters, a, b, n, fresh_seeds(rng, replicates));
      double mean = 0;
      for (const double value : got.value) mean += value / static_cast<double>(replicates);
      const double exact = a * known.exact + b;
      const double sigma = a * std::sqrt(std::exp(1) * known.variance / replicates);
      expect_within(fmt::format("{}, the mean of {} estimates", got.call, replicates), mean, exact,
                    6 * sigma,
                    "six standard deviations of it, if the points were e times worse than "
                    "independent ones",
                    {{}, "is each coordinate uniform in [0, 1) on its own?"});
    }
  }
}

// 6.6 ---------------------------------------------------------------------------------------------

TEST_CASE("6.6 render puts every pixel in its place", "[6.6][points:3]") {
  Rng rng = check_rng();
  const std::size_t width = 3 + rng() % 4, height = 7 + rng() % 4, spp = 2 + rng() % 3;
  const auto got = MEASURE(render_recorded, width, height, spp, fresh_seed(rng));
  expect_that(got.value.values.size() == width * height,
              fmt::format("{}: {} pixels", got.call, got.value.values.size()),
              fmt::format("{}", width * height), "", "");
  const double within = (static_cast<double>(spp) - 1) / 2 / static_cast<double>(spp);
  for (std::size_t row = 0; row < height; ++row) {
    for (std::size_t column = 0; column < width; ++column) {
      const double x = static_cast<double>(column), y = static_cast<double>(row);
      expect_within(fmt::format("{}: pixel ({}, {})", got.call, column, row),
                    got.value.values[row * width + column], x + 10 * y + within, 1e-12,
                    "the mean of the samples of column + 10 row + sample / spp",
                    {{{y + 10 * x + within, "rows and columns have changed places"},
                      {x + 10 * (static_cast<double>(height) - 1 - y) + within,
                       "the first row is the top one"}},
                     "pixel (column, row) stands at row width + column"});
    }
  }
}

/// The seeds with which each pixel was generated, by pixel, with `spp` samples each.
Seeds seeds_of_pixels(const std::string& call, const experiments::Recorded& record,
                      std::size_t pixels, std::size_t spp) {
  expect_that(record.samples == Seeds(pixels, spp),
              fmt::format("{}: {} calls of generate()", call, record.samples.size()),
              fmt::format("{}, one for each pixel, with {} samples", pixels, spp),
              "every pixel is an integration of its own", "");
  return record.seeds;
}

TEST_CASE("6.6 no two pixels have the same random numbers", "[6.6][points:3]") {
  Rng rng = check_rng();
  const std::size_t width = 16, height = 12, spp = 2;
  const std::uint64_t seed = fresh_seed(rng);
  const auto one = MEASURE(render_recorded, width, height, spp, seed);
  const auto again = MEASURE(render_recorded, width, height, spp, seed);
  const Seeds seeds = seeds_of_pixels(one.call, one.value, width * height, spp);
  expect_that(seeds == again.value.seeds, one.call + ": other seeds for generate() the second time",
              "the same", "the same seed is the same picture", "");
  const std::size_t pixels = seeds.size();
  expect_that(std::set(seeds.begin(), seeds.end()).size() == pixels,
              fmt::format("{}: {} different seeds for {} pixels", one.call,
                          std::set(seeds.begin(), seeds.end()).size(), pixels),
              "a seed for each pixel", "the same pattern in every pixel shows as a pattern",
              "hash the picture's seed with the pixel's number");
  // Other pictures: the next, one as far away as neighbouring pixels are, one beyond 32 bits.
  const auto far = std::uint64_t{1} << 40;
  for (const std::uint64_t step :
       {std::uint64_t{1}, seeds[1] - seeds[0], seeds[width] - seeds[0], far}) {
    const auto other = MEASURE(render_recorded, width, height, spp, seed + step);
    std::set all(seeds.begin(), seeds.end());
    all.insert(other.value.seeds.begin(), other.value.seeds.end());
    expect_that(all.size() == 2 * pixels,
                fmt::format("{}, then with seed {}: {} different seeds for {} pixels", one.call,
                            seed + step, all.size(), 2 * pixels),
                "all different", "another picture's noise must not be this one's, moved by a pixel",
                step == far
                    ? "was the seed cut to 32 bits?"
                    : "seed + pixel is the same for (s, p + 1) and (s + 1, p): hash them instead");
  }
}

TEST_CASE("6.6 the noise of a picture is white across pixels", "[6.6][points:2][needs:6.4]") {
  Rng rng = check_rng();
  const std::size_t width = 80, height = 80;
  for (const std::string& kind : kinds) {
    const auto got = MEASURE(render_noise, kind, width, height, 1, fresh_seed(rng));
    if (got.value.pixels.size() != width * height) fail("measured  " + got.call + ": no picture");
    Values left, right, above, below;
    for (std::size_t row = 0; row < height; ++row) {
      for (std::size_t column = 0; column < width; column += 2) {
        left.push_back(got.value.pixels[row * width + column]);
        right.push_back(got.value.pixels[row * width + column + 1]);
      }
    }
    for (std::size_t row = 0; row < height; row += 2) {
      for (std::size_t column = 0; column < width; ++column) {
        above.push_back(got.value.pixels[row * width + column]);
        below.push_back(got.value.pixels[(row + 1) * width + column]);
      }
    }
    expect_inside(got.call, "pixel", got.value.pixels);
    const std::string hint = "the numbers of neighbouring pixels have something in common";
    expect_uniform_pairs(got.call, left, right, "neighbours in a row are independent", hint);
    expect_uniform_pairs(got.call, above, below, "neighbours in a column are independent", hint);
  }
}

TEST_CASE("6.6 pictures that cannot be are refused", "[6.6][points:2]") {
  const auto fine = MEASURE(render_recorded, 2, 1, 1, 1);
  expect_that(fine.value.values.size() == 2, fine.call + ": no picture", "two pixels", "", "");
  expect_invalid_argument(MEASURE_OUTCOME(render_recorded, 2, 2, 0, 1), "spp",
                          "a pixel is a mean of samples");
  for (const std::uint64_t side : {std::uint64_t{1} << 14, std::uint64_t{1} << 32}) {
    expect_invalid_argument(MEASURE_OUTCOME(render_recorded, side, side, 1, 1), "scene",
                            "more pixels than most_samples, whatever their product is in 64 bits");
  }
}

// 6.7 ---------------------------------------------------------------------------------------------

TEST_CASE("6.7 the first next2 is blue noise", "[6.7][points:4][needs:4]") {
  Rng rng = check_rng();
  constexpr std::size_t n = 256, sets = 40;
  double low = 0, radius = 0, radius_alone = 0;  // alone: no use before it
  std::string call;
  for (std::size_t set = 0; set < sets; ++set) {
    // Asked for after something else: it is the first next2() all the same.
    const Columns got =
        columns_of("blue_noise", n, fresh_seed(rng), set % 2 == 0 ? Uses{2} : Uses{1, 2});
    const View x = got[got.size() - 2], y = got[got.size() - 1];
    low += low_band(spectrum_of(x, y, 8), n) / sets;
    double least = 2;
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        const auto round = [](double d) { return d - std::round(d); };
        least = std::min(least, std::hypot(round(x[i] - x[j]), round(y[i] - y[j])));
      }
    }
    const double of_set = least / std::sqrt(2 / (std::sqrt(3) * n));  // of the hexagonal lattice
    radius += of_set / sets;
    if (set % 2 == 0) radius_alone += of_set / (sets / 2);
    call = got.call;
  }
  // One set has a standard deviation of 0.0075: 34 of them, for forty, between 0.089 and 0.13.
  const bool is_blue = low < 0.13;
  const std::string hint = radius <= 0.6 && radius_alone > 0.6
                               ? "the first next2() is blue noise also where a next() comes before"
                           : low > 0.25 ? "the first next2() is best_candidate of lab 4, with c = 1"
                                        : "as blue as a fixed number of candidates";
  expect_that(is_blue,
              fmt::format("{} and others: mean power {:.4f} over 0 < |k| <= 8, mean of {} sets",
                          call, low, sets),
              "less than 0.13; 0.089 on average for best candidates",
              "independent points have 1, jittered ones 0.33, ten candidates each 0.19", hint);
  expect_that(radius > 0.6,
              fmt::format("{} and others: the closest two are {:.3f} of the densest pattern's "
                          "distance apart, mean of {} sets",
                          call, radius, sets),
              "more than 0.6; 0.667 on average for best candidates",
              "a fixed number of candidates lets the last points come close", hint);
  const auto firsts = first_samples("blue_noise", {2}, 4, fresh_seed(rng), 600);
  const std::string anchored = "does every pattern begin at the same place?";
  expect_uniform(firsts.call + ": x", firsts.x, "the first sample is uniform over seeds", anchored);
  expect_uniform(firsts.call + ": y", firsts.y, "the first sample is uniform over seeds", anchored);
}

TEST_CASE("6.7 blue noise has exactly N points for any N", "[6.7][points:2][needs:4]") {
  Rng rng = check_rng();
  for (const std::size_t n : {1u, 2u, 3u, 7u, 1009u}) {
    const Columns got = columns_of("blue_noise", n, fresh_seed(rng), {2});
    std::set<std::pair<double, double>> points;
    for (std::size_t i = 0; i < n; ++i) points.insert({got[0][i], got[1][i]});
    expect_that(points.size() == n, fmt::format("{}: {} points", got.call, points.size()),
                fmt::format("{} different ones", n), "blue noise never has a point twice", "");
  }
}

TEST_CASE("6.7 all else of blue_noise is stratified", "[6.7][points:2][needs:3]") {
  Rng rng = check_rng();
  for (const std::size_t n : {3u, 12u, 1009u}) {
    const Columns got = columns_of("blue_noise", n, fresh_seed(rng), {2, 1, 2, 1});
    for (const std::size_t c : {2u, 5u}) {
      expect_one_in_each(got.call, "next()", got[c], n, "a next() is stratified_1d, shuffled");
    }
    expect_one_in_each_cell(got.call, got[3], got[4], grid_of(n));
    expect_one_in_each(got.call, "x of the second next2()", got[3], n, "multi-jittered points");
    if (n == 1009) {
      for (const std::size_t c : {2u, 3u, 4u, 5u}) {
        expect_unrelated(got.call, got[0], got[c], fmt::format("the blue x and coordinate {}", c),
                         "each use wants an order of its own");
      }
    }
  }
}

// 6.8 ---------------------------------------------------------------------------------------------

TEST_CASE("6.8 many samples are right too", "[6.8][points:2][needs:6.2][needs:6.3][needs:3]") {
  Rng rng = check_rng();
  const std::size_t n = std::size_t{1} << 17;
  for (const std::string kind : {"stratified", "sobol"}) {
    const Columns got = columns_of(kind, n, fresh_seed(rng), {1, 2, 1});
    for (std::size_t c = 0; c < got.size(); ++c) {
      expect_one_in_each(got.call, fmt::format("coordinate {}", c).c_str(), got[c], n,
                         "every use is stratified, of however many samples");
    }
  }
}

TEST_CASE("6.8 a use that nobody asks for costs no memory", "[6.8][points:2]") {
  // A column of so many samples is 512 MB, all that a program may have.
  const std::vector<Step> steps{
      {0, most_samples / 2, 1}, {3, 0, 0}, {3, 0, 0}, {0, 4, 1}, {1, 0, 0}, {2, 0, 0}};
  for (const std::string kind : {"independent", "stratified", "halton", "sobol"}) {
    const Played got = played(kind, steps);
    for (std::size_t i = 0; i < steps.size(); ++i) {
      expect_thrown(got, steps, i, 0,
                    i < 3 ? "with 2^26 samples, none of them asked for"
                          : "with 4 samples, after 2^26 of which none was asked for",
                    i < 3 ? "numbers are made for uses, and there was none"
                          : "a column has as many numbers as there are samples now");
    }
    const std::vector<Step> last(steps.end() - 3, steps.end());
    const Played alone = played(kind, last);
    expect_that(
        got.answers[4].x == alone.answers[1].x && got.answers[5].x == alone.answers[2].x &&
            (is_sequence(kind) || got.answers[4].x != got.answers[5].x),
        fmt::format("{}: {:.17g} and {:.17g} in the end", got.call, got.answers[4].x,
                    got.answers[5].x),
        fmt::format("{:.17g} and {:.17g}, two numbers", alone.answers[1].x, alone.answers[2].x),
        "what was not asked for has no effect on what comes after", "");
  }
  pass();
}

}  // namespace
}  // namespace mc::checks
