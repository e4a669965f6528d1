// 6.4: what holds for every kind of sampler.

#include <set>

#include "checks/sampler/walks.hpp"
#include "checks/support/catch.hpp"
#include "checks/support/strata.hpp"

namespace mc::checks {
namespace {

CHECK_CASE("6.4 there are numbers for N samples and no others", "[6.4][edge][points:4]") {
  Rng rng = check_rng();
  const Step next{next_call}, next2{next2_call}, advance{advance_call};
  for (const std::string& kind : sampler_kinds) {
    const std::vector<Step> steps{
        next,    next2,          advance, next,    generate(2, fresh_seed(rng)),
        next,    next2,          advance, next2,   next,
        advance, next,           next2,   advance, advance,
        next,    generate(1, 7), next,    advance, next};
    const Played got = played(kind, steps);
    const std::set<std::size_t> refused{0, 1, 3, 11, 12, 15, 19};
    for (std::size_t i = 0; i < steps.size(); ++i) {
      const std::string when = i < 4    ? "before the first generate()"
                               : i < 11 ? "within the samples"
                               : i < 16 ? "after the last of two samples"
                               : i < 19 ? "after a second generate()"
                                        : "after the last of its samples";
      check_thrown(got, i, refused.contains(i) ? 1 : 0, when,
                   "next() and next2() need a sample; advance() never throws");
    }
  }
  pass();
}

CHECK_CASE("6.4 no samples and too many are refused", "[6.4][edge][points:1]") {
  for (const std::string& kind : sampler_kinds) {
    const Played got = played(kind, {generate(0, 1),
                                     generate(most_samples + 1, 1),
                                     generate(~std::uint64_t{0}, 1),
                                     generate(3, 1),
                                     {next_call}});
    for (std::size_t i = 0; i < got.steps.size(); ++i) {
      check_thrown(got, i, i < 3 ? 2 : 0,
                   i < 3 ? fmt::format("with {} samples", got.steps[i].samples) : "after that",
                   "there must be samples, and memory for a column of them");
    }
  }
  pass();
}

CHECK_CASE("6.4 the same seed gives the same numbers", "[6.4][points:4]") {
  Rng rng = check_rng();
  const std::string left_over =
      "what is left over from the integration before? Counters, columns of that size or of "
      "another, permutations, generators";
  for (const std::string& kind : sampler_kinds) {
    const std::size_t n = 9;
    const std::uint64_t seed = fresh_seed(rng);
    const std::vector<Uses> all(n, Uses{1, 2, 2, 1, 1});
    const Played alone = played(kind, walk(n, seed, all));
    const ByUse due = by_use(alone);
    check_different(alone, due);
    check_same(alone, due, by_use(played(kind, walk(n, seed, all))),
               "the same kind, seed and calls in another object",
               "nothing but the seed may decide: no clock, no global generator");
    // One object, asked for these; for as many with another seed, and left in the middle of a
    // sample; for these again; for fewer, and left in the middle; and for these again: each is what
    // a new object has.
    const std::vector<Step> walks[] = {
        walk(n, seed, all), walk(n, seed + 1, {{1, 2, 2, 1}, {1}, {1, 2, 2}}), walk(n, seed, all),
        walk(4, seed + 2, {{2, 1, 1}, {1}, {2, 1}}), walk(n, seed, all)};
    std::vector<Step> steps;
    std::vector<std::size_t> ends;
    for (const std::vector<Step>& one : walks) {
      const bool is_whole = one.size() > n * 2;
      steps.insert(steps.end(), one.begin(), one.end() - (is_whole ? 0 : 1));
      ends.push_back(steps.size());
    }
    const Played reused = played(kind, steps);
    std::size_t begin = 0;
    for (const std::size_t end : ends) {
      const Played fresh = played(kind, {steps.begin() + static_cast<std::ptrdiff_t>(begin),
                                         steps.begin() + static_cast<std::ptrdiff_t>(end)});
      check_same(reused, by_use(fresh), by_use(reused, begin, end, left_over),
                 "generate() begins anew, whatever the object was used for before: a new object "
                 "has that number",
                 left_over);
      begin = end;
    }
  }
}

CHECK_CASE("6.4 two samplers at once share nothing", "[6.4][points:2]") {
  Rng rng = check_rng();
  for (const std::string& kind : sampler_kinds) {
    const std::uint64_t seed = fresh_seed(rng);
    const std::vector<Uses> uses(6, Uses{1, 2, 1});
    const std::vector<Step> steps = walk(6, seed, uses), of_other = walk(6, seed + 1, uses);
    const auto got = MEASURE(play_two, kind, steps);
    const auto& answers = got.exactly(2 * steps.size(), any_number);
    const auto both = std::span(answers);
    const std::string hint = "is there anything static, or global, that both of them change?";
    const std::string because = "two samplers, asked in turn, are those of two programs";
    const Played one = admitted(kind, steps, both.first(steps.size()), ", one of two in turn");
    const ByUse due = by_use(played(kind, steps));
    check_same(one, due, by_use(one), because, hint);
    const Played other =
        admitted(kind, of_other, both.last(steps.size()), ", the other of two in turn");
    check_same(other, by_use(played(kind, of_other)), by_use(other), because, hint);
    if (is_sequence(kind)) continue;  // whether it is randomised, 6.3 looks
    expect_that(
        one.answers[1].x != other.answers[1].x || one.answers[2].x != other.answers[2].x,
        fmt::format("{} gave {}, and with another seed too", one.until(1), one.answers[1].x),
        "other numbers", "the seed decides", same_for_seeds);
  }
}

/// Whoever deals out numbers as they come has no columns: of every kind but independent, the first
/// next() has one number in each of n strata, n a power of two.
void check_first_column(const Played& got, const ByUse& values, std::size_t n) {
  if (got.kind == "independent") return;
  Values column;
  for (std::size_t i = 0; i < n; ++i) column.push_back(values.at({next_call, 0, i}).point.x);
  expect_that(is_stratified(column, n),
              fmt::format("{}: the first next() of {} samples is not a column of the kind",
                          got.until(got.steps.size() - 1), n),
              fmt::format("one number in each of {} strata, sample by sample", n),
              "the k-th next() of all samples is one column, filled as 6.2 and 6.3 say",
              "the numbers of a sample dimension belong together: make the whole column");
}

CHECK_CASE("6.4 a sample may ask for less than the one before", "[6.4][main][points:4]") {
  Rng rng = check_rng();
  for (const std::string& kind : sampler_kinds) {
    const std::size_t n = 16;
    const std::uint64_t seed = fresh_seed(rng);
    Uses all =
        repeated(17, {1, 2});  // and 16 more of next(): many uses, most of them never asked for
    all.insert(all.end(), 16, 1);
    std::vector<Uses> some{all};
    while (some.size() < n) {
      Uses fewer = all;
      fewer.resize(rng() % (some.size() % 2 == 0 ? all.size() + 1 : 6));
      some.push_back(fewer);
    }
    some[3] = {};
    const Played full = played(kind, walk(n, seed, std::vector<Uses>(n, all)));
    const ByUse due = by_use(full);
    check_different(full, due);
    check_first_column(full, due, n);
    const Played fewer = played(kind, walk(n, seed, some));
    check_same(
        fewer, due, by_use(fewer),
        "sample i's value in a sample dimension does not depend on what other samples ask for",
        "a sample that ends early must not hand its numbers to the next one");
    // The other way round, uses are first asked for in the same order, but by later samples.
    std::vector<Uses> growing;
    for (std::size_t i = 0; i < n; ++i) {
      growing.push_back(all);
      growing.back().resize(i == n - 1 ? all.size() : i / 2);
    }
    const Played late = played(kind, walk(n, seed, growing));
    check_same(
        late, due, by_use(late),
        "a sample dimension may first be asked for by a later sample: its values are the same",
        "make a whole column, also for the samples before, and hand out this sample's");
  }
}

CHECK_CASE("6.4 next and next2 are counted apart", "[6.4][points:2]") {
  Rng rng = check_rng();
  for (const std::string& kind : sampler_kinds) {
    const std::size_t n = 12;
    const std::uint64_t seed = fresh_seed(rng);
    const Uses all{1, 2, 1, 2, 1, 2};
    std::vector<Uses> mixed{all};
    while (mixed.size() < n) {
      Uses other = all;
      for (std::size_t i = other.size(); i > 1; --i) std::swap(other[i - 1], other[rng() % i]);
      mixed.push_back(other);
    }
    const Played plain = played(kind, walk(n, seed, std::vector<Uses>(n, all)));
    const ByUse due = by_use(plain);
    check_different(plain, due);
    const Played other = played(kind, walk(n, seed, mixed));
    check_same(other, due, by_use(other),
               "the k-th next() of a sample is the same sample dimension, wherever next2() stands",
               "count the calls of next() and those of next2() in counters of their own, and set "
               "both to 0 in advance()");
  }
}

}  // namespace
}  // namespace mc::checks
