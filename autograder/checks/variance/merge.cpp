// 1.5: merging.

#include "list_results.hpp"

namespace mc::checks {
namespace {

struct Parts {
  Moments a, b;
};

/// Merges a with b and b with a; `scale` is that of the means, a power of two.
void judge_merges(const std::vector<Parts>& all, const std::string& rule = {}, double scale = 1);

const std::string merged_mean =
    "weight the means by the counts, n_a / n mean_a + n_b / n mean_b, however small a part is";
const std::string merged_m2 =
    "add the variation between the parts, (mean_b - mean_a)^2 n_a n_b / n, to m2; the product of "
    "the counts may overflow 64 bits";

Moments some_moments(Rng& rng, std::uint64_t count) {
  return {count, uniform(rng, -9, 9), count == 1 ? 0 : uniform(rng, 0, 99)};
}

CHECK_CASE("1.5 merging two parts equals adding all values", "[1.5][main][points:5]") {
  std::vector<Parts> parts;
  for (const std::uint64_t n : domain::sizes(65537, rng)) {
    parts.push_back({some_moments(rng, n), some_moments(rng, 2 + rng() % 100)});
  }
  parts.push_back({some_moments(rng, 1), some_moments(rng, 1)});
  // Nearly equal counts.
  for (const std::uint64_t n : {100u, 1000u, 65537u, 100'000'000u}) {
    for (const std::uint64_t more : {std::uint64_t{1}, 1 + n / 300, 1 + n / 50}) {
      parts.push_back({some_moments(rng, n), some_moments(rng, n + more)});
    }
  }
  // Equal counts, equal means, and equal parts.
  const Moments one = some_moments(rng, 40), other = some_moments(rng, 40);
  for (const Moments& part : {one, other, {40, one.mean, other.m2}, {60, one.mean, other.m2}}) {
    parts.push_back({one, part});
  }
  // Parts of equal counts, which reveal state kept between calls.
  for (int i = 0; i < 3; ++i) parts.push_back({some_moments(rng, 40), some_moments(rng, 50)});
  judge_merges(parts);
}

CHECK_CASE("1.5 parts of real data merge to the whole", "[1.5][points:2][needs:1.4]") {
  const std::vector<List> lists{List(shifted_pattern(rng, 0, 1000)),
                                List(shifted_pattern(rng, 1e6, 1000))};
  MomentsResults all;
  for (const List& list : lists) {
    std::vector<std::uint64_t> sizes{1, rng() % 200, 0, 300, 2};
    sizes.push_back(1000 - std::accumulate(sizes.begin(), sizes.end(), std::uint64_t{0}));
    const auto got = MEASURE(merge_parts, list.x, sizes);
    all.add(got.call, got.value, list, one_pass_floor(list.exact));
  }
  all.expect(because_one_pass, merged_mean + "; do not divide by the count of an empty part",
             merged_m2);
}

CHECK_CASE("1.5 merging with an empty part changes nothing", "[1.5][edge][points:3]") {
  judge_merges({{some_moments(rng, 2 + rng() % 100), {}}, {some_moments(rng, 1), {}}, {{}, {}}},
               "a part without values changes nothing; its share of the count may be 0/0");
}

CHECK_CASE("1.5 merging very unequal and very long parts", "[1.5][edge][points:3]") {
  const double m = uniform(rng, 1, 2);
  const std::uint64_t billion = 1'000'000'000, trillion = billion * 1000;
  std::vector<Parts> parts{
      {{billion, m, 5}, {trillion, 2 * m, 7}},  // the counts multiply to 1e21 > 2^64
      {{billion, m, 0}, {1, 3 * m, 0}},
      {{billion, 1e9, 100}, {3, 1e9 + 2, 0.5}},  // the merged mean is rounded to 1e9
      {{trillion, m, 1e12}, {1000, m + 1e-7, 1000}},
      {{billion / 2, 1e9, 1}, {billion / 2, 1e9 + 2, 1}},
      {{trillion * 1000, 10, 2.25e16}, {7, 0, 0}},
      {{trillion * 1000, m, 0}, {7, 1e20, 0}},
      {{~std::uint64_t{0} - 1, m, 5}, {1, -m, 0}},
      {{std::uint64_t{1} << 63, m, 5}, {(std::uint64_t{1} << 62) - 1, 3 * m, 7}}};
  for (int bit = 20; bit < 63; ++bit) {  // counts that an int, a float or a double cannot hold
    const std::uint64_t power = std::uint64_t{1} << bit;
    parts.push_back({some_moments(rng, power + 1 + 2 * (rng() % 1000)),
                     some_moments(rng, 2 + (rng() >> (64 - bit)))});
  }
  judge_merges(parts);
  for (const double odd_one : {nan, infinity, -infinity}) {
    const auto got = MEASURE(merge, {5, odd_one, nan}, {rng() % 9, 1, 1});
    expect_not_finite(got.call + ".m2", got.value.m2, {odd_one});
  }
}

CHECK_CASE("1.5 merging parts with means of any size", "[1.5][edge][points:1]") {
  const double m = uniform(rng, 1, 2);
  // Means so close that their squared distance underflows, but not its product with the weight;
  // then so far apart that their distance overflows, but not a fraction of it.
  const std::uint64_t count = std::uint64_t{1} << 60;
  judge_merges({{{count, m, 0}, {count, -m, 0}}, {{count, 0, 0}, {count / 3, m, 0}}},
               "(mean_b - mean_a)^2 underflows to 0: multiply by the weight before squaring",
               0x1p-540);
  for (const auto& [n_a, n_b] : {std::pair{3u, 5u}, {5u, 3u}, {1u, 1u}, {40u, 40u}}) {
    for (const double ratio : {-1.0, 0.9, 1.0}) {  // also of means whose sum overflows
      const double a = uniform(rng, 1.45e308, 1.7e308);
      const double share = (n_a + ratio * n_b) / (n_a + n_b);
      const auto got = MEASURE(merge, {n_a, a, 0}, {n_b, ratio * a, 0});
      Results means;
      means.add(got.call + ".mean", got.value.mean, a * share, 16 * eps * a);
      means.expect("a mean lies between the two means, so it is finite",
                   "mean_b - mean_a, mean_a + mean_b and n_a mean_a may overflow: multiply each "
                   "mean by its fraction of the count, n_a / n or n_b / n, then add");
      if (ratio != 1) expect_not_finite(got.call + ".m2", got.value.m2, {});
    }
  }
}

// What the cases above use ------------------------------------------------------------------------

std::vector<Suspect> merged_mean_suspects(const Moments& a, const Moments& b) {
  return {{(a.mean + b.mean) / 2, "the mean of two means is correct only for equal counts"_likely},
          {a.mean,
           "this is the first part's mean alone: the weight n_b / n of the other part is an "
           "integer division: 0"_likely}};
}

std::vector<Suspect> merged_m2_suspects(const Moments& a, const Moments& b, double mean) {
  const auto n_a = static_cast<double>(a.count), n_b = static_cast<double>(b.count);
  const double n = n_a + n_b, apart = b.mean - a.mean, within = a.m2 + b.m2;
  const std::uint64_t whole_product = a.count * b.count, count = a.count + b.count;
  return {
      {within,
       "parts with different means vary between each other: add (mean_b - "
       "mean_a)^2 n_a n_b / n"_likely},
      {a.m2 + n_a * (a.mean - mean) * (a.mean - mean) +  //
           b.m2 + n_b * (b.mean - mean) * (b.mean - mean),
       "both parts were measured from the merged mean, which is rounded: use "
       "mean_b - mean_a"_likely},
      {within + apart * apart * static_cast<double>(whole_product) / n,
       "the counts were multiplied as 64-bit integers, and overflowed: multiply doubles"_likely},
      {within + apart * apart * (count == 0 ? 0 : static_cast<double>(whole_product / count)),
       "n_a n_b / n was an integer division, which truncates: divide doubles"_likely},
      {within + std::abs(apart) * n_a * n_b / n,
       "the distance of the means must be squared"_likely}};
}

void judge_merges(const std::vector<Parts>& all, const std::string& rule, double scale) {
  constexpr double last_bits = 4 * std::numeric_limits<double>::denorm_min();
  Results means, m2s;
  const auto add = [&](const Moments& a, const Moments& b) {
    const ExactMoments exact = exact_merge(a, b);
    const double mean = static_cast<double>(exact.mean) * scale;
    const double m2 = static_cast<double>(exact.m2) * scale * scale;
    const Moments part_a{a.count, a.mean * scale, a.m2 * scale * scale};
    const Moments part_b{b.count, b.mean * scale, b.m2 * scale * scale};
    const auto got = MEASURE(merge, part_a, part_b);
    expect_equal(got.call + ".count", got.value.count, a.count + b.count, "",
                 "add the counts as 64-bit integers",
                 got.value.count == a.count || got.value.count == b.count
                     ? "one part was left out: a part is empty only if its count is 0"_likely
                     : ""_likely);
    means.add(got.call + ".mean", got.value.mean, mean,
              16 * eps * scale * std::max(std::abs(a.mean), std::abs(b.mean)) + last_bits,
              [=] { return merged_mean_suspects(part_a, part_b); });
    // The difference of the two means is rounded only once.
    m2s.add(got.call + ".m2", got.value.m2, m2, 64 * eps * m2 + last_bits,
            [=] { return merged_m2_suspects(part_a, part_b, got.value.mean); });
  };
  for (const auto& [a, b] : all) add(a, b);
  for (const auto& [a, b] : all) add(b, a);
  const std::string because = "a dozen operations, each rounded once";
  means.is_tame = m2s.is_tame = rule.empty();
  means.expect(because, rule.empty() ? merged_mean : rule);
  m2s.expect(because, rule.empty() ? merged_m2 : rule);
}

}  // namespace
}  // namespace mc::checks
