// 6.4: the contract of every kind of sampler: any calls give the numbers of a new sampler; unused
// dimensions cost nothing.

#include <set>

#include "checks/sampler/samplers.hpp"

namespace mc::checks {
namespace {

using experiments::Answer;
using experiments::Step;

enum Called : unsigned { generate_call, next_call, next2_call, advance_call };

const Step next{next_call}, next2{next2_call}, advance{advance_call};
Step generate(std::uint64_t samples, std::uint64_t seed) {
  return {generate_call, samples, seed};
}

/// The calls of one integration, with a list of uses for each sample.
std::vector<Step> walk(std::size_t samples, std::uint64_t seed, const std::vector<Uses>& uses);
/// Random calls, in integrations with up to `most` samples.
std::vector<Step> any_calls(std::size_t count, std::size_t most, Rng& rng);
/// The answers fulfill 6.4: next() and next2() throw std::out_of_range if there is no sample;
/// otherwise they return the numbers of a new sampler whose samples all request all sample
/// dimensions, in the order of their first request here.
void expect_contract(const std::string& kind, const std::vector<Step>& steps, const Claim& claim);
void expect_answers(const std::string& kind, const char* which, const std::vector<Step>& steps,
                    std::span<const Answer> answers, const Claim& claim);
void check_columns(const std::string& kind, const SampleSets& got);

CHECK_CASE("6.4 there are numbers for exactly N samples", "[6.4][edge][points:3]") {
  for (const std::string& kind : sampler_kinds) {
    expect_contract(
        kind, {next,    next2,          advance, next,    generate(2, fresh_seed(rng)),
               next,    next2,          advance, next2,   next,
               advance, next,           next2,   advance, advance,
               next,    generate(1, 7), next,    advance, next},
        {"next() and next2() need a sample; advance() never throws",
         "a value belongs to its sample and its request, whatever was requested before: "
         "next() and next2() have a counter each, which advance() resets"});
  }
}

CHECK_CASE("6.4 the same seed gives the same numbers", "[6.4][points:4]") {
  for (const std::string& kind : sampler_kinds) {
    const std::uint64_t seed = fresh_seed(rng);
    const std::vector<Uses> all(9, Uses{1, 2, 2, 1, 1});
    expect_contract(
        kind, walk(9, seed, all),
        {"the same kind, seed and calls give the same numbers",
         "the numbers must depend on the seed only: use no clock and no global generator"});
    expect_contract(
        kind, walk(9, seed, {{1, 2}, {1, 1}}),
        {"the value of a sample does not depend on which one first requests its dimension",
         "make a sample dimension for all samples at once, from the seed and its own number only"});
    // Several integrations with one object; some stop within a sample.
    std::vector<Step> steps;
    for (auto walk : {walk(9, seed, all), walk(9, seed, all),
                      walk(9, seed + 1, {{1, 2, 2, 1}, {1}, {1, 2, 2}}), walk(9, seed, all),
                      walk(4, seed + 2, {{2, 1, 1}, {1}, {2, 1}}), walk(9, seed, {{1, 2}, {1, 1}}),
                      walk(9, seed, std::vector<Uses>(9, Uses{2, 1, 1, 2, 1})),  // another order
                      walk(2, 0, {{1, 2}, {1}}), walk(2, 0, {{1, 2}, {1}}),      // 0 is a seed, too
                      walk(9, seed, all), walk(33, seed, std::vector<Uses>(33, {2, 1}))}) {
      const bool is_whole = walk.size() > 18;
      steps.insert(steps.end(), walk.begin(), walk.end() - (is_whole ? 0 : 1));
    }
    expect_contract(kind, steps,
                    {"generate() starts anew, whatever was called before",
                     "the previous integration left something behind: reset "
                     "counters, columns and generators"});
    for (const std::size_t most : {3u, 40u}) {
      expect_contract(kind, any_calls(600, most, rng),
                      {"calls in any order give the numbers of a new object",
                       "check when counters, columns and generators are created and reset"});
    }
  }
}

CHECK_CASE("6.4 two samplers at once share nothing", "[6.4][points:2]") {
  for (const std::string& kind : sampler_kinds) {
    const std::uint64_t seed = fresh_seed(rng);
    const auto steps = walk(6, seed, std::vector<Uses>(6, Uses{1, 2, 1}));
    const auto other = walk(6, seed + 1, std::vector<Uses>(6, Uses{1, 2, 1}));
    const auto got = MEASURE(play_two, kind, steps);
    const auto both = std::span(got.exactly(2 * steps.size(), any_number));
    const Claim claim{"two samplers used in turn behave as in two programs",
                      "both samplers change a static or global variable"};
    expect_answers(kind, ", first of two", steps, both.first(steps.size()), claim);
    expect_answers(kind, ", second of two", other, both.last(steps.size()), claim);
  }
}

CHECK_CASE("6.4 a sample may request less than the one before", "[6.4][main][points:4]") {
  for (const std::string& kind : sampler_kinds) {
    const std::size_t n = 16;
    const std::uint64_t seed = fresh_seed(rng);
    Uses all = repeated(17, {1, 2});
    all.insert(all.end(), 16, 1);
    check_columns(kind, columns_of(kind, n, {seed}, all));
    check_columns(kind, columns_of(kind, 1, {seed}, repeated(300, {1, 2})));
    expect_contract(
        kind, walk(n, seed, std::vector<Uses>(n, all)),
        {"all samples request the same dimensions",
         "advance() must move to the next sample, and back to the first sample dimension"});
    std::vector<Uses> fewer{all}, growing;
    while (fewer.size() < n) {
      fewer.push_back(all);
      fewer.back().resize(rng() % (fewer.size() % 2 == 0 ? all.size() + 1 : 6));
    }
    fewer[3] = {};
    expect_contract(
        kind, walk(n, seed, fewer),
        {"sample i's value in a dimension does not depend on the requests of other samples",
         "a sample that ends early must not leave its numbers to the next one"});
    // Conversely, later samples are the first to request most dimensions, in the same order.
    for (std::size_t i = 0; i < n; ++i) {
      growing.push_back(all);
      growing.back().resize(i == n - 1 ? all.size() : i / 2);
    }
    expect_contract(
        kind, walk(n, seed, growing),
        {"a later sample may be the first to request a sample dimension: its values are the same",
         "make the whole column, including earlier samples, and return the value of this sample"});
  }
}

CHECK_CASE("6.4 next and next2 are counted separately", "[6.4][points:2]") {
  for (const std::string& kind : sampler_kinds) {
    std::vector<Uses> mixed(12, Uses{1, 2, 1, 2, 1, 2});
    for (std::size_t sample = 1; sample < mixed.size(); ++sample) {
      Uses& uses = mixed[sample];
      for (std::size_t i = uses.size(); i > 1; --i) std::swap(uses[i - 1], uses[rng() % i]);
    }
    expect_contract(kind, walk(mixed.size(), fresh_seed(rng), mixed),
                    {"the k-th next() of a sample is the same dimension wherever next2() is called",
                     "count next() and next2() in separate counters, and reset both in advance()"});
  }
}

CHECK_CASE("6.4 neighboring seeds have nothing in common",
           "[6.4][points:3][needs:6.1][needs:6.2][needs:6.3]") {
  for (const std::string& kind : sampler_kinds) {
    const auto first =
        numbers_by([&](const Seeds& seeds) { return MEASURE(columns, kind, 1, seeds, {1}); });
    expect_all_seeds({{}, first}, 2, "sample dimension", rng);
    // The same holds for different sample dimensions of different seeds.
    for (const std::size_t i : {0u, 2u}) {
      const SeededConstruction sample =
          sample_of(kind, 3, i, repeated(3, {1, 2}),
                    {.words = "different seeds, even neighbors, give independent numbers",
                     .rule = "mix the bits of the seed before using them as a state or a counter",
                     .repeated = numbers_repeat});
      expect_random_seeds(sample,
                          {domain::in_a_row(fresh_seed(rng), 1500), domain::seeds_by_bit(rng, 20)});
    }
  }
}

TEST_CASE("6.4 an unused sample dimension costs no memory", "[6.4][edge][points:1][needs:6.1]") {
  // A column of this many samples takes 1 GB, more than a program may use.
  for (const std::string kind : {"independent", "stratified", "halton", "sobol"}) {
    expect_contract(
        kind, {generate(most_samples, 1), advance, advance, generate(4, 1), next, next2},
        {"first 2^27 samples without requests, then 4 samples",
         "make a column when it is first requested, with one number per sample, and keep no other "
         "list of that size"});
  }
}

std::vector<Step> walk(std::size_t samples, std::uint64_t seed, const std::vector<Uses>& uses) {
  std::vector<Step> steps{generate(samples, seed)};
  for (const Uses& of_sample : uses) {
    for (const unsigned use : of_sample) steps.push_back({use, 0, 0});
    steps.push_back({advance_call, 0, 0});
  }
  return steps;
}

std::vector<Step> any_calls(std::size_t count, std::size_t most, Rng& rng) {
  std::vector<Step> steps;
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint64_t word = rng() >> 32;
    const unsigned call = static_cast<unsigned>(word % 16);
    steps.push_back(i == 0 || word % 67 == 0 ? generate(1 + rng() % most, fresh_seed(rng))
                    : call < 7               ? next
                    : call < 12              ? next2
                                             : advance);
  }
  return steps;
}

/// "sobol: generate(2, 7); next()": the calls up to step i, shortened if they are many.
std::string calls_until(std::size_t i, const std::string& of, const std::vector<Step>& steps) {
  constexpr std::size_t most = 24;
  std::string words = of + ": ";
  for (std::size_t k = 0; k <= i; ++k) {
    if (i >= most && k == most / 2) {
      words += fmt::format("… {} more …; ", i + 1 - most);
      k += i + 1 - most;
    }
    words += experiments::spelled(steps[k]) + (k < i ? "; " : "");
  }
  return words;
}

/// The numbers that the calls of one integration, or the calls before the first one, request.
struct Integration {
  struct Number {
    std::size_t sample, coordinate;
  };
  Uses uses = {};                                   ///< in the order of their first request
  std::vector<std::optional<Number>> numbers = {};  ///< one per call; empty if it requests none

  Integration(std::span<const Step> calls, std::uint64_t samples) {
    std::array<std::vector<std::size_t>, 3> coordinates;  // of the k-th next() and the k-th next2()
    std::array<std::size_t, 3> count{};                   // requested by this sample
    std::size_t sample = 0, dims = 0;
    for (const auto& [call, of_generate, seed] : calls) {
      if (call == advance_call) ++sample, count = {};
      auto& number = numbers.emplace_back();
      if ((call != next_call && call != next2_call) || sample >= samples) continue;
      if (count[call] == coordinates[call].size()) {
        coordinates[call].push_back(dims);
        uses.push_back(call);
        dims += call;
      }
      number = {sample, coordinates[call][count[call]++]};
    }
  }
};

void expect_answers(const std::string& kind, const char* which, const std::vector<Step>& steps,
                    std::span<const Answer> answers, const Claim& claim) {
  const auto fail_at = [&](std::size_t i, const std::string& gave, const std::string& expected,
                           const Claim& why) {
    expect_that(false, calls_until(i, kind + which, steps) + ' ' + gave, expected, why.because,
                why.rule);
  };
  for (std::size_t first = 0, end = 0; first < steps.size(); first = end) {
    for (++end; end < steps.size() && steps[end].call != generate_call;) ++end;
    const auto [_, samples, seed] = steps[first];
    const Integration all(std::span<const Step>(steps).subspan(first, end - first), samples);
    std::optional<SampleSets> columns;
    if (!all.uses.empty()) columns = columns_of(kind, samples, {seed}, all.uses);
    for (std::size_t i = first; i < end; ++i) {
      const auto& [thrown, x, y] = answers[i];
      const auto& number = all.numbers[i - first];
      const unsigned call = steps[i].call;
      const bool must_throw = !number && (call == next_call || call == next2_call);
      if (thrown != (must_throw ? 1 : 0)) {
        constexpr const char* words[] = {"threw nothing", "threw std::out_of_range",
                                         "threw std::invalid_argument"};
        const Claim why =
            must_throw ? Claim{"there is no sample before generate() and after the last one",
                               "throw if there is no sample; do not start again at the first"}
            : call == advance_call
                ? Claim{"advance() never throws", "after the last sample, do nothing"}
            : call == generate_call ? Claim{"1 to most_samples samples are allowed",
                                            "find the condition that refuses this number of them"}
                                    : claim;
        fail_at(i, words[std::min(thrown, 2u)],
                must_throw ? "std::out_of_range: there is no sample" : "no exception", why);
      }
      if (!number) continue;
      const double expected_x = columns->column(0, number->coordinate)[number->sample];
      const double expected_y =
          call == next2_call ? columns->column(0, number->coordinate + 1)[number->sample] : y;
      if (x == expected_x && y == expected_y) continue;
      const auto words = [&](double a, double b) {
        return call == next_call ? fmt::format("{:.17g}", a)
                                 : fmt::format("({:.17g}, {:.17g})", a, b);
      };
      fail_at(i, "gave " + words(x, y),
              fmt::format("{} for this dimension of sample {}, as in {}",
                          words(expected_x, expected_y), number->sample, columns->call),
              claim);
    }
  }
  pass();
}

void expect_contract(const std::string& kind, const std::vector<Step>& steps, const Claim& claim) {
  const Call call = MEASURE_OUTCOME(play, kind, steps);
  if (call.outcome.answered && call.outcome.status == wire::Status::other_exception) {
    fail(Failure{fmt::format("{} threw {}", call.text, call.outcome.bytes),
                 "no exception",
                 claim.because,
                 {},
                 claim.rule});
  }
  expect_answers(kind, "", steps,
                 result_of<std::vector<Answer>>(call).exactly(steps.size(), any_number), claim);
}

/// For every kind except independent, all numbers of an integration are different, and the first
/// next() of all but halton has one number in each stratum. (6.1, 6.3 and 6.7 test the others.)
void check_columns(const std::string& kind, const SampleSets& got) {
  if (kind == "independent") return;
  std::multiset<double> all;
  for (std::size_t c = 0; c < got.dims; ++c) {
    const View x = got.column(0, c);
    const bool is_blue = kind == "blue_noise" && (c == 1 || c == 2);  // next(), next2()
    if (!is_blue && kind != "halton" && kind != "sobol") all.insert(x.begin(), x.end());
  }
  for (std::size_t c = 1; c < got.dims && got.n > 1; ++c) {
    for (std::size_t before = 0; before < c; ++before) {
      expect_that(
          !std::ranges::equal(got.column(0, c), got.column(0, before)),
          fmt::format("{}: coordinate {} has the numbers of coordinate {}", got.call, c, before),
          "other numbers", "different columns are independent",
          "make a new column for each sample dimension, however many there are");
    }
  }
  const std::size_t different = std::set(all.begin(), all.end()).size();
  expect_that(different == all.size(), fmt::format("{}: {} different numbers", got.call, different),
              fmt::format("{}, one for each sample dimension of each sample", all.size()),
              "equal numbers with 53 random bits occur here once in 1e10 runs",
              "advance() must move to the next sample, and next() to the next sample dimension");
  if (kind == "halton") return;
  expect_one_in_each_cell(got, 0, line_of(got.n, 0),
                          "make the whole column of a next() at once: stratified, or a sequence");
}

}  // namespace
}  // namespace mc::checks
