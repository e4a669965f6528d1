// 5.8: nested uniform scrambling: the flips of bits, and the errors of scrambled nets.

#include <set>

#include "5-halton/experiments.hpp"
#include "checks/halton/exact_points.hpp"
#include "checks/support/constructions.hpp"

namespace mc::checks {
namespace {

double value_of(std::uint64_t bits) {
  return static_cast<double>(bits) * half_ulp;
}

/// For each k, two values that share k bits and differ in the next; the others are random.
Values pairs_that_share(Rng& rng);
SampleSets scrambled(const Values& x, const std::vector<std::uint64_t>& seeds);
/// Pair k of x shares k bits in a set, too, which `seed` scrambled.
void check_pair(const Values& x, const SampleSets& got, std::size_t set, std::uint64_t seed, int k);
Likely flips_hint(const Uniforms& of_zero);
void check_pairs(Rng& rng);
void check_triples(int depth, Rng& rng);
void check_first_flips(Rng& rng);
void check_last_flips(Rng& rng);
void judge_errors_of_a_net(int depth, Rng& rng);

CHECK_CASE("5.8 scrambled values share the bits that the values share", "[5.8][points:2][main]") {
  const Values x = pairs_that_share(rng);
  const auto seeds = domain::seeds(rng, 3);
  const SampleSets got = scrambled(x, seeds);
  for (std::size_t set = 0; set < 3; ++set) {
    for (int k = 0; k < 53; ++k) check_pair(x, got, set, seeds[set], k);
  }
  // Unscrambled values pass this, too.
  const SampleSets of_zero = scrambled({0}, domain::seeds(rng, 400));
  const Uniforms zeros{of_zero.call, 1, {of_zero.values().begin(), of_zero.values().end()}};
  expect_independent_uniforms(zeros,
                              {.words = "a scrambled value is uniform",
                               .rule = "flip each of the 53 bits with probability 1/2",
                               .explain = [&] { return flips_hint(zeros); }},
                              true);
}

CHECK_CASE("5.8 all 64 bits of the seed count", "[5.8][needs:5.8][points:2][edge]") {
  const SeededConstruction of_zero{
      {.words = "different seeds give independent numbers",
       .rule = "different seeds have different states of 64 bits: do not truncate a hash"},
      numbers_by([](const Seeds& seeds) { return MEASURE(owen_scramble, {0}, seeds); }),
      50'000};
  expect_all_seeds(of_zero, 2, "level", rng);
  // Numbers that depend on 32 bits of a hash have ten repeats among this many seeds.
  expect_random_seeds(of_zero, {domain::seeds(rng, 300'000)});
}

CHECK_CASE("5.8 each bit is flipped at random for each string before it",
           "[5.8][needs:5.8][points:5]") {
  check_pairs(rng);
  for (const int depth : {0, 20, 31, 44}) check_triples(depth, rng);
  check_first_flips(rng);
  check_last_flips(rng);
}

CHECK_CASE("5.8 a value is scrambled the same way in any column",
           "[5.8][needs:5.8][points:1][edge]") {
  for (const std::size_t n : domain::sizes(65537, rng)) {
    Values x(n);
    for (double& value : x) {  // on average every 7th has bits after the 32nd
      value = rng() % 7 == 0 ? value_of(rng() >> 11) : static_cast<double>(rng() >> 32) * 0x1p-32;
    }
    const std::uint64_t seed = rng();
    const SampleSets got = scrambled(x, {seed});
    Values longer(x.rbegin(), x.rend());
    longer.insert(longer.begin(), 2 + n % 5, 1 - half_ulp);
    const SampleSets there = scrambled(longer, {seed});
    const View column = there.column(0, 0), all = got.values();
    expect_each(
        {there.call, {column.rbegin().base() - static_cast<std::ptrdiff_t>(n), column.end()}},
        {.exact = {all.rbegin(), all.rend()},
         .because = "a function of value and seed only: the same values in reverse, after others"});
    const std::size_t skip = rng() % n, size = 1 + (rng() % (n - skip) >> rng() % 8);
    const View some = View(x).subspan(skip, size), exact = all.subspan(skip, size);
    const SampleSets part = scrambled({some.begin(), some.end()}, {seed});
    expect_each(
        {part.call, part.values()},
        {.exact = {exact.begin(), exact.end()},
         .because = "a function of value and seed only: a part of the column of " + got.call});
  }
}

CHECK_CASE("5.8 a scrambled net has Gaussian errors", "[5.8][needs:5.8][points:2]") {
  for (const int depth : {0, 20}) judge_errors_of_a_net(depth, rng);
}

Values pairs_that_share(Rng& rng) {
  Values x;
  for (int k = 0; k < 53; ++k) {
    const std::uint64_t word = rng() >> 11, bit = std::uint64_t{1} << (52 - k);
    x.insert(x.end(), {value_of(word), value_of(word ^ bit ^ (rng() & (bit - 1)))});
  }
  return x;
}

SampleSets scrambled(const Values& x, const std::vector<std::uint64_t>& seeds) {
  return sets_from_columns(MEASURE(owen_scramble, x, seeds), x.size(), 1, seeds.size());
}

void check_pair(const Values& x, const SampleSets& got, std::size_t set, std::uint64_t seed,
                int k) {
  const auto are_multiples = [](View pair, double unit) {
    return std::fmod(pair[0], unit) + std::fmod(pair[1], unit) == 0;
  };
  const auto holds = [&](View pair) {
    return shared_bits(pair[0], pair[1]) == k && are_multiples(pair, half_ulp);
  };
  const View from = View(x).subspan(2 * static_cast<std::size_t>(k), 2);
  const View in_list = got.column(set, 0).subspan(2 * static_cast<std::size_t>(k), 2);
  if (holds(in_list)) return;
  const SampleSets alone = scrambled({from.begin(), from.end()}, {seed});  // easier to repeat
  const bool is_alone = !holds(alone.values());
  const View to = is_alone ? View(alone.values()) : in_list;
  expect_that(false,
              fmt::format("{}: {:.17g} and {:.17g} became {:.17g} and {:.17g}, which share {} bits",
                          is_alone ? alone.call : got.call, from[0], from[1], to[0], to[1],
                          shared_bits(to[0], to[1])),
              fmt::format("{} bits, of 53, as the values themselves", k),
              "the flip of a bit depends only on the bits before it, which are the same here",
              "the flip of a bit must not depend on the bits after it",
              k >= 31 && are_multiples(to, 0x1p-32)
                  ? "only 32 bits were scrambled; scramble all 53"_likely
                  : ""_likely);
}

Likely flips_hint(const Uniforms& of_zero) {
  const auto is_alike = [](double u) { return u == 0 || u == 1 - half_ulp; };
  if (std::ranges::all_of(of_zero.values, is_alike)) {
    return "all bits of 0 are flipped in the same way: 0 and 00 are different strings "
           "before a bit"_likely;
  }
  const std::size_t different = std::set(of_zero.values.begin(), of_zero.values.end()).size();
  if (different < of_zero.values.size() / 2) {
    return likely(
        "{} seeds flip the bits of 0 in only {} ways: mix seed, position and bits "
        "by a hash, such as mix_bits of common/rng.hpp",
        of_zero.values.size(), different);
  }
  return {};
}

const std::string nested =
    "a separate flip for each string of bits before a bit, for each seed; if there is one, its "
    "hash "
    "mixes too little";
const std::string independent = "flips after different strings are independent";
constexpr std::size_t many_seeds = 1500;

/// The flips of the bits after bit k, of two values that differ in bit k. Each pair is tested
/// separately: larger groups need only be nearly independent.
void check_pairs(Rng& rng) {
  const Values pairs = pairs_that_share(rng);
  const SampleSets got = scrambled(pairs, domain::in_a_row(rng() >> 1, many_seeds));
  for (std::size_t k = 0; k < 52; ++k) {
    const double a = pairs[2 * k], b = pairs[2 * k + 1];
    const std::uint64_t after = (std::uint64_t{1} << (52 - k)) - 1;
    Uniforms apart{fmt::format("{}: the flips of {:.17g} after bit {} XOR those of {:.17g}",
                               got.call, a, k, b)};
    bool is_shift = true;
    for (std::size_t set = 0; set < many_seeds; ++set) {
      const View column = got.column(set, 0);
      const std::uint64_t both =
          (bits_of(column[2 * k]) ^ bits_of(a) ^ bits_of(column[2 * k + 1]) ^ bits_of(b)) & after;
      is_shift = is_shift && both == 0;
      apart.values.push_back(value_of(both << (k + 1) | (rng() >> (63 - k))));
    }
    expect_independent_uniforms(
        apart,
        {.words = independent,
         .alpha = 1e-8 / 52,
         .rule = nested,
         .is_certain = true,
         .explain = [&] {
           return k > 0 || !is_shift
                      ? Likely{}
                      : "every bit is flipped in the same way for all strings before it: that is a "
                        "digital shift; draw a flip for each string of bits before"_likely;
         }});
  }
}

/// Any three of the 15 decisions about four bits after the first `depth` bits are independent: the
/// number of flips among the three is odd for half of all seeds. (After one multiplication by a
/// random number and one addition, three bits have five random bits for seven decisions. With a
/// fixed mixing step after it some three decisions depend: four of eight results never occur.)
void check_triples(int depth, Rng& rng) {
  constexpr std::size_t decisions = 15, seeds = 1500;
  constexpr double alpha = 1e-8 / 455 / 4;  // 455 triples, four depths: |odd - 750| >= 134
  const double before = std::ldexp(std::floor(std::ldexp(uniform(rng), depth)), -depth);
  Values x = steps(16);
  for (double& value : x) value = before + std::ldexp(value, -depth);
  const SampleSets got = scrambled(x, domain::in_a_row(rng() >> 1, seeds));
  std::vector<std::vector<bool>> is_flipped(decisions, std::vector<bool>(seeds));
  const auto first_of = [](std::size_t i) {  // a value that shows decision i: level by level
    return (i + 1 - std::bit_floor(i + 1)) * 16 / std::bit_floor(i + 1);
  };
  const auto bit_of = [&](std::size_t i) {
    return depth + static_cast<int>(std::bit_width(i + 1)) - 1;
  };
  for (std::size_t i = 0; i < decisions; ++i) {
    const std::size_t k = first_of(i);
    for (std::size_t set = 0; set < seeds; ++set) {
      const std::uint64_t flips = bits_of(x[k]) ^ bits_of(got.column(set, 0)[k]);
      is_flipped[i][set] = flips >> (52 - bit_of(i)) & 1;
    }
  }
  using Triple = std::array<std::size_t, 3>;
  const auto odd = [&](const Triple& three) {
    std::uint64_t count = 0;
    for (std::size_t set = 0; set < seeds; ++set) {
      count +=
          is_flipped[three[0]][set] != (is_flipped[three[1]][set] != is_flipped[three[2]][set]);
    }
    return count;
  };
  // The worst triple if it fails; otherwise any triple, whose p-value is uniform.
  std::vector<std::pair<double, Triple>> all;
  for (std::size_t i = 0; i < decisions; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      for (std::size_t k = 0; k < j; ++k) {
        const Triple three{k, j, i};
        all.emplace_back(std::abs(static_cast<double>(odd(three)) - seeds / 2.), three);
      }
    }
  }
  const Triple worst = std::ranges::max_element(all)->second;
  const bool fails = binomial_tails(odd(worst), seeds, 0.5).two_sided() < alpha;
  const Triple shown = fails ? worst : all[side_rng()() % all.size()].second;
  const auto name = [&](std::size_t i) {
    return fmt::format("bit {} of {:.17g}", bit_of(i) + 1, x[first_of(i)]);
  };
  expect_proportion(
      got.call,
      fmt::format("of {}, {} and {}, one or all three were flipped", name(shown[0]), name(shown[1]),
                  name(shown[2])),
      odd(shown), seeds, 0.5, {"any three decisions of 5.8 are independent", alpha},
      {{},
       "pairs of decisions are independent, but not triples: a decision must be random for each "
       "string of bits before. One random multiplication and addition is too little; add a second "
       "one, after the fixed steps"});
}

/// All flips that the first 32 points show.
void check_first_flips(Rng& rng) {
  const Values points = sobol_points(0, 0, 32);
  const SampleSets all = scrambled(points, domain::in_a_row(rng() >> 1, many_seeds));
  Uniforms decided{all.call, 32};
  decided.name = [](std::size_t i) {
    return fmt::format("the flips that value {} shows first", i);
  };
  for (std::size_t set = 0; set < many_seeds; ++set) {
    append(decided.values, uniforms_of_flips(points, all.column(set, 0), rng));
  }
  expect_independent_uniforms(decided, {.words = independent, .rule = nested});
}

/// No flips of the last 46 bits occur twice: two of 455 random strings are equal with probability
/// 1.5e-9.
void check_last_flips(Rng& rng) {
  Values x{0};
  for (int k = 1; k < 7; ++k) x.push_back(std::ldexp(1, -k));
  const SampleSets by_bit = scrambled(x, domain::seeds_by_bit(rng));
  std::set<std::uint64_t> seen;
  for (std::size_t i = 0; i < by_bit.values().size(); ++i) {
    const double value = x[i % x.size()];
    const std::uint64_t flips = bits_of(by_bit.values()[i]) ^ bits_of(value);
    expect_that(seen.insert(flips % (std::uint64_t{1} << 46)).second,
                fmt::format("{}: seed {} of the list flips the last 46 bits of {} as other bits "
                            "were flipped",
                            by_bit.call, i / x.size(), value),
                "different flips for each seed and value", "",
                "hash the seed and then the string, not their exclusive or or sum");
  }
}

/// N scrambled points, equally spaced in an interval of length 2^-depth, lie one in each of N
/// strata of an interval. If they are independent, the error of the integral of exp(x) over it,
/// scaled to length 1, is a sum of N independent terms, hence Gaussian, with the variance (e^2 -
/// 1)/(24 N^3), up to N^-2 of it. Then half of all errors are below the quartile, 0.6745 standard
/// deviations. If only pairs are independent, most errors are small.
void judge_errors_of_a_net(int depth, Rng& rng) {
  constexpr std::size_t n = 1024, sets = 250, replicates = 1000;
  const double deviation = std::sqrt((std::exp(2.) - 1) / 24 / (double{n} * n * n));
  const double quartile = 0.6744897501960817 * deviation;
  const auto interval = static_cast<double>(rng() % (std::uint64_t{1} << depth));
  Values x = steps(n);
  for (double& value : x) value = std::ldexp(interval + value, -depth);
  std::string call;
  std::size_t below = 0, huge = 0;
  for (std::size_t done = 0; done < replicates; done += sets) {
    const SampleSets got = scrambled(x, domain::seeds(rng, sets));
    call = got.call;
    for (std::size_t set = 0; set < sets; ++set) {
      double sum = 0;
      for (const double value : got.column(set, 0)) {
        sum += std::exp(wrapped(std::ldexp(value, depth))) - (std::exp(1.) - 1);
      }
      below += std::abs(sum / n) < quartile ? 1u : 0u;
      huge += std::abs(sum / n) > 5 * deviation ? 1u : 0u;
    }
  }
  // For a Gaussian 500 of 1,000 are below, and 634 once in 1e17 runs. This small alpha accepts
  // hashes that are not quite independent: one with the kurtosis 4.6 (two random multiply-and-adds
  // with a mixing step between them: 548 on average) fails once in 1e8 runs. Hashes that are
  // correct only in pairs fail: one multiply-and-add with a mixing step has 743; power 1 - 1e-14.
  expect_proportion(
      fmt::format("{}, the average of exp over an interval of length 2^-{}, scaled to 1", call,
                  depth),
      fmt::format("the error was below {:.3g}, the quartile of a Gaussian with Owen's variance",
                  quartile),
      below, replicates, 0.5, {"the errors of scrambled points of the line are Gaussian", 1e-17},
      {{},
       below < replicates / 2
           ? ""
           : fmt::format(
                 "pairs and triples of decisions are independent, but larger groups are not: {} "
                 "errors are above 5 standard deviations (1 in 1,700,000 for a Gaussian), and the "
                 "others are small; a decision must not be a sum of the bits before it",
                 huge)});
}

}  // namespace
}  // namespace mc::checks
