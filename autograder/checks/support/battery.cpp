#include "checks/support/battery_parts.hpp"
#include "checks/support/checks.hpp"

namespace mc::checks {
namespace {

using namespace battery;

/// The upper-tail probability of chi-squared for these counts of equally likely cells. Counts that
/// are too even are left to other tests: with few cells, chi-squared is often 0.
double p_of_counts(std::span<const std::uint32_t> counts) {
  const auto n = std::accumulate(counts.begin(), counts.end(), 0.0);
  const double each = n / static_cast<double>(counts.size());
  double chi_squared = 0;
  for (const std::uint32_t count : counts) {
    const double off = static_cast<double>(count) - each;
    chi_squared += off * off / each;
  }
  return chi_squared_tails(chi_squared, static_cast<double>(counts.size() - 1)).upper;
}

std::optional<Failure> test_bits(const Uniforms& numbers, const Randomness& claim) {
  const std::size_t n = numbers.values.size();
  const std::size_t cells = n >= 3200 ? 32 : n >= 800 ? 8 : 2;
  const int width = static_cast<int>(std::bit_width(cells)) - 1;
  std::vector<int> shifts{
      0};  // also the first bits: Kolmogorov-Smirnov hardly sees a value that is too frequent
  for (int k = 8; k + width < numbers.bits; k += 5) shifts.push_back(k);
  Family family(numbers, claim, "bits", shifts.size());
  for (const int k : shifts) {
    std::vector<std::uint32_t> counts(cells);
    const double scale = std::ldexp(1.0, k);
    for (const double u : numbers.values) {
      const double scaled = u * scale, rest = scaled - std::floor(scaled);
      ++counts[static_cast<std::size_t>(rest * static_cast<double>(cells))];
    }
    family.add(p_of_counts(counts), cells >= 8, [&] {
      return width == 1
                 ? fmt::format("bit {} of the numbers is not uniform", k + 1)
                 : fmt::format("bits {} to {} of the numbers are not uniform", k + 1, k + width);
    });
  }
  return family.failure();
}

std::optional<Failure> test_extremes(const Uniforms& numbers, const Randomness& claim) {
  const auto [low, high] = std::ranges::minmax_element(numbers.values);
  const auto n = static_cast<double>(numbers.values.size());
  Family family(numbers, claim, "extremes", 2);
  for (const auto& [gap, where] : {std::pair{*low, "below"}, {1 - *high, "above 1 -"}}) {
    family.add(std::exp(n * std::log1p(-gap)), true, [&, g = gap, w = where] {
      return fmt::format("none of {} numbers is {} {:.4g}", n, w, g);
    });
  }
  return family.failure();
}

std::optional<Failure> test_repeats(const Uniforms& numbers, const Randomness& claim) {
  const auto n = static_cast<double>(numbers.values.size());
  const double width = width_of_equal(numbers);
  const double expected = n * (n - 1) * width;  // each pair is this close with probability 2 width
  const std::size_t repeats = repeats_in(numbers.values, width);
  Family family(numbers, claim, "repeats", 1);
  // P(Poisson >= k) is a chi-squared probability with 2 k degrees of freedom.
  const double p =
      repeats == 0 ? 1 : chi_squared_tails(2 * expected, 2 * static_cast<double>(repeats)).lower;
  family.add(p, false, [&] {
    return fmt::format("{} of {} numbers are repeats; {:.2g} are expected by chance", repeats, n,
                       expected);
  });
  return family.failure();
}

std::optional<Failure> test_values(const Uniforms& numbers, const Randomness& claim) {
  std::vector<double> all = numbers.values;
  const double distance = distance_from_uniform(all);
  Family family(numbers, claim, "values", 1);
  family.add(kolmogorov_tails(distance, all.size()).two_sided(), true, [&] {
    return fmt::format("the distribution of {} numbers differs from uniform by {:.3g}", all.size(),
                       distance);
  });
  return family.failure();
}

std::optional<Failure> test_positions(const Uniforms& numbers, const Randomness& claim) {
  const std::size_t replicates = numbers.replicates();
  if (numbers.positions < 2 || replicates < 100) return {};
  Family family(numbers, claim, "positions", numbers.positions);
  std::vector<double> column(replicates);
  for (std::size_t position = 0; position < numbers.positions; ++position) {
    for (std::size_t r = 0; r < replicates; ++r) {
      column[r] = numbers.values[r * numbers.positions + position];
    }
    const double distance = distance_from_uniform(column);
    family.add(kolmogorov_tails(distance, replicates).two_sided(), true, [&] {
      return fmt::format(
          "{}: {} values from {:.4g} to {:.4g}; their distribution differs from uniform by {:.3g}",
          name_of(numbers, position), replicates, column.front(), column.back(), distance);
    });
  }
  return family.failure();
}

/// Pairs of values a lag apart: counted in up to 8 x 8 cells, and as waves.
std::optional<Failure> test_lags(const Uniforms& numbers, const Randomness& claim,
                                 std::span<const Complex> z) {
  const std::size_t n = std::min<std::size_t>(numbers.values.size(), 1 << 18);
  std::vector<std::size_t> lags{n / 2};
  for (std::size_t lag = 1; 2 * lag <= n && lag <= 4096; lag *= 2) lags.push_back(lag);
  for (std::size_t rows = 1; 2 * rows * numbers.positions <= n && rows <= 64; rows *= 2) {
    lags.push_back(rows * numbers.positions);
  }
  std::ranges::sort(lags);
  lags.erase(std::unique(lags.begin(), lags.end()), lags.end());
  Family family(numbers, claim, "lags", 3 * lags.size());
  for (const std::size_t lag : lags) {
    const std::size_t side = n >= 12800 ? 8 : n >= 3200 ? 4 : 2;
    std::vector<std::uint32_t> counts(side * side);
    std::complex<double> difference, sum;
    double pairs = 0;
    for (std::size_t start = 0; start + lag < n; start += 2 * lag) {  // no value is in two pairs
      for (std::size_t i = start; i < std::min(start + lag, n - lag); ++i) {
        const double u = numbers.values[i], v = numbers.values[i + lag];
        const auto size = static_cast<double>(side);
        ++counts[static_cast<std::size_t>(u * size) * side + static_cast<std::size_t>(v * size)];
        difference += std::complex<double>(z[i] * std::conj(z[i + lag]));
        sum += std::complex<double>(z[i] * z[i + lag]);
        ++pairs;
      }
    }
    const auto describe = [&] {
      const bool in_rows = lag % numbers.positions == 0 && numbers.positions > 1;
      const std::size_t apart = in_rows ? lag / numbers.positions : lag;
      return fmt::format("{} pairs of numbers that are {} {}{} apart are not independent", pairs,
                         apart, in_rows ? "replicate" : "number", apart == 1 ? "" : "s");
    };
    const double many = pairs * pairs / 16;
    family.add(p_of_resultant(std::norm(difference), pairs), false, describe);
    family.add(p_of_resultant(std::norm(sum), pairs), false, describe,
               std::norm(sum) > many
                   ? "many such numbers are nearly mirror images, u and 1 - u"_likely
                   : Likely{});
    family.add(pairs >= 50 * static_cast<double>(side * side) ? p_of_counts(counts) : 1, false,
               describe);
  }
  return family.failure();
}

/// The sums of u - 1/2 and of cos(2 pi u) over a replicate have the correct variance.
std::optional<Failure> test_rows(const Uniforms& numbers, const Randomness& claim,
                                 std::span<const Complex> z) {
  const std::size_t positions = numbers.positions, replicates = numbers.replicates();
  if (positions < 2 || replicates < 100) return {};
  Family family(numbers, claim, "rows", 2);
  const auto add = [&](const char* words, double variance, double kurtosis, auto f) {
    double squares = 0;
    for (std::size_t r = 0; r < replicates; ++r) {
      double sum = 0;
      for (std::size_t p = 0; p < positions; ++p) sum += f(r * positions + p);
      squares += sum * sum;
    }
    const double of_sum = 3 + (kurtosis - 3) / static_cast<double>(positions);
    const auto count = static_cast<double>(replicates);
    const double degrees = 2 * count / (of_sum - 1);  // Satterthwaite 1946
    const double ratio = squares / (count * variance * static_cast<double>(positions));
    family.add(chi_squared_tails(ratio * degrees, degrees).two_sided(), true, [&] {
      return fmt::format(
          "the sum of {} over a replicate of {} has {:.4g} times the correct variance", words,
          positions, ratio);
    });
  };
  add("u - 1/2", 1.0 / 12, 1.8, [&](std::size_t i) { return numbers.values[i] - 0.5; });
  add("cos(2 pi u)", 0.5, 1.5, [&](std::size_t i) { return z[i].real(); });
  return family.failure();
}

}  // namespace

std::optional<Failure> dependence_in(const Uniforms& numbers, const Randomness& claim,
                                     bool only_each) {
  for (const double u : numbers.values) {
    if (u >= 0 && u < 1) continue;
    return Failure{fmt::format("{}: a random number is {}", numbers.call, u),
                   "numbers in [0, 1)",
                   claim.words,
                   {},
                   claim.rule};
  }
  const auto pairs = compared_pairs(numbers.positions);
  const bool has_replicates = numbers.replicates() >= 100;
  const auto z = only_each ? std::vector<Complex>() : phases_of(numbers.values);
  std::optional<Failure> found;
  const auto run = [&](bool wanted, auto test) {
    if (wanted && !found) found = test();
  };
  run(true, [&] { return test_positions(numbers, claim); });
  run(true, [&] { return test_values(numbers, claim); });
  run(true, [&] { return test_extremes(numbers, claim); });
  run(true, [&] { return test_bits(numbers, claim); });
  run(!only_each && has_replicates && !pairs.empty(),
      [&] { return test_waves(numbers, claim, pairs, z); });
  run(!only_each && has_replicates, [&] { return test_triples(numbers, claim, z); });
  run(!only_each && has_replicates, [&] { return test_bit_pairs(numbers, claim, pairs); });
  run(!only_each, [&] { return test_repeats(numbers, claim); });
  run(!only_each, [&] { return test_lags(numbers, claim, z); });
  run(!only_each, [&] { return test_rows(numbers, claim, z); });
  return found;
}

void expect_independent_uniforms(const Uniforms& numbers, const Randomness& claim, bool only_each) {
  if (const auto failure = dependence_in(numbers, claim, only_each)) fail(*failure);
  pass();
}

namespace {

/// The smallest k for which all numbers are multiples of 2^-k, within their accuracy.
std::optional<int> grid_of(const Uniforms& numbers) {
  for (int k = 0; k + 8 < numbers.bits; ++k) {
    const double scale = std::ldexp(1.0, k), near = std::ldexp(1.0, k - numbers.bits + 2);
    const bool fits = std::ranges::all_of(
        numbers.values, [=](double u) { return std::abs(std::remainder(u * scale, 1.0)) <= near; });
    if (fits) return k;
  }
  return {};
}

/// The m <= 2^24 for which at least m numbers are multiples of 1 / m within their accuracy; else 0.
std::uint64_t multiples_in(const Uniforms& numbers, double width) {
  std::vector<double> sorted = numbers.values;
  sort_uniforms(sorted);
  double gap = 1;
  for (std::size_t i = 0; i + 1 < sorted.size(); ++i) {
    const double here = sorted[i + 1] - sorted[i];
    if (here > width) gap = std::min(gap, here);
  }
  const double m = std::round(1 / gap);
  if (m < 2 || m > std::min(0x1p24, static_cast<double>(sorted.size()))) return 0;
  const bool fits = std::ranges::all_of(
      sorted, [=](double u) { return std::abs(std::remainder(u * m, 1.0)) <= m * width; });
  return fits ? static_cast<std::uint64_t>(m) : 0;
}

}  // namespace

Likely visible_fault(const Uniforms& numbers, const Randomness& claim) {
  const auto [low, high] = std::ranges::minmax_element(numbers.values);
  const double width = battery::width_of_equal(numbers);
  const std::string& repeated = claim.repeated.text;
  const std::string and_repeated = repeated.empty() ? "" : "; " + repeated;
  if (*high - *low < 1e-6) {
    return likely("every number is {:.3g}: draw a new random number for each{}", *low,
                  and_repeated);
  }
  const std::size_t replicates = numbers.replicates(), positions = numbers.positions;
  for (std::size_t p = 0; p < positions && positions > 1 && replicates >= 20; ++p) {
    bool is_constant = true;
    for (std::size_t r = 1; r < replicates && is_constant; ++r) {
      is_constant = std::abs(numbers.values[r * positions + p] - numbers.values[p]) < width;
    }
    if (is_constant) {
      return likely(
          "{} has the same random number, {:.4g}, in every set: draw it from the given generator, "
          "not from a "
          "copy{}",
          battery::name_of(numbers, p), numbers.values[p], and_repeated);
    }
  }
  if (const auto bits = grid_of(numbers); bits && *bits > 0) {
    return likely("the random numbers have too few bits: only {} of 53{}", *bits,
                  *bits > 20 ? "; compute in double" : "");
  }
  if (const std::uint64_t m = multiples_in(numbers, width); m > 0) {
    return likely("the random numbers are multiples of 1/{}: use 53 bits of a random word", m);
  }
  const std::string& same = claim.same.text;
  if (positions > 1 && replicates >= 20) {
    for (const auto& [p, q] : battery::compared_pairs(positions)) {
      for (const int sign : {-1, 1}) {
        bool always = true;
        for (std::size_t r = 0; r < replicates && always; ++r) {
          const double* const u = &numbers.values[r * positions];
          const double off = u[p] - numbers.values[p] + sign * (u[q] - numbers.values[q]);
          always = std::abs(std::remainder(off, 1.0)) <= 4 * width;
        }
        if (!always) continue;
        return likely("{} and {} share one random number{}: {}", battery::name_of(numbers, p),
                      battery::name_of(numbers, q), sign < 0 ? "" : ", as u and 1 - u",
                      same.empty() ? "draw a random number for each" : same);
      }
    }
  }
  if (10 * battery::repeats_in(numbers.values, width) > numbers.values.size()) {
    return claim.repeated;
  }
  // At a sharp end, the numbers are as frequent as elsewhere.
  const auto n = static_cast<double>(numbers.values.size());
  const double gap = std::max(*low, 1 - *high);
  const auto at_ends = std::ranges::count_if(
      numbers.values, [&](double u) { return u < *low + gap || u > *high - gap; });
  if (n * gap > 40 && static_cast<double>(at_ends) > n * gap) {
    return likely("the numbers cover only [{:.4g}, {:.4g}]: u is uniform in [0, 1)", *low, *high);
  }
  double squares = 0;
  for (const double u : numbers.values) squares += (u - 0.5) * (u - 0.5);
  if (squares / n < 0.6 / 12 && claim.expected.empty()) {
    return "too many numbers lie near 1/2, as means of several random numbers do: use one number "
           "for each"_likely;
  }
  return {};
}

}  // namespace mc::checks
