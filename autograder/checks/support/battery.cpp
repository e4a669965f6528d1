#include "checks/support/battery.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>

#include <fmt/format.h>

#include "checks/support/data.hpp"
#include "checks/support/distributions.hpp"

namespace mc::checks {
namespace {

constexpr double parts = 9;  // of the battery: the alpha of a call is divided among them

std::string name_of(const Uniforms& numbers, std::size_t position) {
  if (numbers.name) return numbers.name(position);
  return numbers.positions == 1 ? "values" : fmt::format("position {}", position);
}

/// The tests of one part: remembers the smallest p-value, and records one of them, chosen at
/// random, which is uniform under the null hypothesis as the smallest is not.
class Family {
 public:
  Family(const Uniforms& numbers, const Randomness& claim, const char* part, std::size_t size)
      : numbers_(numbers),
        claim_(claim),
        part_(part),
        size_(std::max<std::size_t>(size, 1)),
        chosen_(fresh_index(size_)) {}

  /// `describe` says what was measured; asked where the test fails.
  template <class Describe>
  void add(double p, bool is_continuous, Describe describe) {
    if (count_++ == chosen_ && is_continuous) {
      record(protocol::RecordKind::p_value,
             protocol::text_of({claim_.words + ": " + part_, p, claim_.alpha / parts}));
    }
    const double alpha = claim_.alpha / parts / static_cast<double>(size_);
    if (p >= alpha) return;
    if (p < least_ || measured_.empty()) {
      least_ = p;
      measured_ = describe();
    }
  }

  /// Of the test that rejected with the smallest p-value.
  std::optional<Failure> failure() const {
    if (measured_.empty()) return {};
    record(protocol::RecordKind::p_value,
           protocol::text_of({claim_.words + ": " + part_,
                              std::min(1.0, least_ * static_cast<double>(size_)),
                              claim_.alpha / parts}));
    const std::string fault = visible_fault(numbers_, claim_);
    return Failure{numbers_.call + ": " + measured_,
                   "independent random numbers, uniform in [0, 1)",
                   fmt::format("{}: a right answer fails here once in {:.1g} runs", claim_.words,
                               parts / claim_.alpha),
                   fault.empty() ? claim_.otherwise : fault};
  }

 private:
  static std::size_t fresh_index(std::size_t size) {
    static std::uint64_t calls = 0;
    return Rng(check_rng()() ^ mix_bits(++calls))() % size;
  }

  const Uniforms& numbers_;
  const Randomness& claim_;
  const char* part_;
  std::size_t size_, chosen_, count_ = 0;
  double least_ = 1;
  std::string measured_;
};

/// P(chi-squared of these counts, or more), all cells equally likely. Counts that are too even are
/// left to the distances: with few cells, chi-squared is often exactly 0.
double p_of_counts(std::span<const std::uint32_t> counts) {
  const auto n =
      static_cast<double>(std::accumulate(counts.begin(), counts.end(), std::uint64_t{0}));
  const double each = n / static_cast<double>(counts.size());
  double chi_squared = 0;
  for (const std::uint32_t count : counts) {
    const double off = static_cast<double>(count) - each;
    chi_squared += off * off / each;
  }
  return chi_squared_tails(chi_squared, static_cast<double>(counts.size() - 1)).upper;
}

/// P(|sum of n independent random directions|^2 >= squared): Rayleigh's test, with the second-order
/// correction of Zar, "Biostatistical analysis", 27.1; an upper bound far out.
double p_of_resultant(double squared, double n) {
  return std::exp(std::sqrt(1 + 4 * n + 4 * (n * n - std::min(squared, n * n))) - (1 + 2 * n));
}

double distance_from_uniform(std::vector<double>& sorted) {
  std::sort(sorted.begin(), sorted.end());
  const auto n = static_cast<double>(sorted.size());
  double distance = 0;
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    const double below = static_cast<double>(i) / n;
    distance = std::max({distance, sorted[i] - below, below + 1 / n - sorted[i]});
  }
  return distance;
}

std::optional<Failure> test_bits(const Uniforms& numbers, const Randomness& claim) {
  const std::size_t n = numbers.values.size();
  const std::size_t cells = n >= 3200 ? 32 : n >= 800 ? 8 : 2;
  const int width = static_cast<int>(std::bit_width(cells)) - 1;
  std::vector<int> shifts;
  for (int k = 8; k + width < numbers.bits; k += 5) shifts.push_back(k);
  if (shifts.empty()) return {};
  Family family(numbers, claim, "bits", shifts.size());
  for (const int k : shifts) {
    std::vector<std::uint32_t> counts(cells);
    const double scale = std::ldexp(1.0, k);
    for (const double u : numbers.values) {
      const double scaled = u * scale, rest = scaled - std::floor(scaled);
      ++counts[static_cast<std::size_t>(rest * static_cast<double>(cells))];
    }
    family.add(p_of_counts(counts), cells >= 8, [&] {
      return fmt::format("bits {} to {} of the numbers are not uniform", k + 1, k + width);
    });
  }
  return family.failure();
}

std::optional<Failure> test_extremes(const Uniforms& numbers, const Randomness& claim) {
  const auto [low, high] = std::minmax_element(numbers.values.begin(), numbers.values.end());
  const auto n = static_cast<double>(numbers.values.size());
  const double bottom = *low, top = 1 - *high;
  Family family(numbers, claim, "extremes", 2);
  family.add(std::exp(n * std::log1p(-bottom)), true,
             [&] { return fmt::format("{} numbers, none below {:.4g}", n, bottom); });
  family.add(std::exp(n * std::log1p(-top)), true,
             [&] { return fmt::format("{} numbers, none above 1 - {:.4g}", n, top); });
  return family.failure();
}

/// Values as near to each other as rounding allows count as equal.
double width_of_equal(const Uniforms& numbers) {
  return std::ldexp(1.0, -std::min(44, numbers.bits - 2));
}

std::size_t repeats_in(std::vector<double> sorted, double width) {
  std::sort(sorted.begin(), sorted.end());
  std::size_t repeats = 0;
  for (std::size_t i = 0; i + 1 < sorted.size(); ++i) repeats += sorted[i + 1] - sorted[i] < width;
  return repeats;
}

std::optional<Failure> test_repeats(const Uniforms& numbers, const Randomness& claim) {
  const auto n = static_cast<double>(numbers.values.size());
  const double width = width_of_equal(numbers);
  const double expected = n * (n - 1) * width;  // each pair is that near with probability 2 width
  const std::size_t repeats = repeats_in(numbers.values, width);
  Family family(numbers, claim, "repeats", 1);
  // P(Poisson >= k) is a chi-squared probability of 2 k degrees of freedom.
  const double p =
      repeats == 0 ? 1 : chi_squared_tails(2 * expected, 2 * static_cast<double>(repeats)).lower;
  family.add(p, false, [&] {
    return fmt::format("{} of {} numbers come again; {:.2g} would by chance", repeats, n, expected);
  });
  return family.failure();
}

std::optional<Failure> test_values(const Uniforms& numbers, const Randomness& claim) {
  std::vector<double> all = numbers.values;
  const double distance = distance_from_uniform(all);
  Family family(numbers, claim, "values", 1);
  family.add(kolmogorov_tails(distance, all.size()).two_sided(), true, [&] {
    return fmt::format("the distribution of {} numbers is {:.3g} away from uniform", all.size(),
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
      return fmt::format("{}, {} times: from {:.4g} to {:.4g}, {:.3g} away from uniform",
                         name_of(numbers, position), replicates, column.front(), column.back(),
                         distance);
    });
  }
  return family.failure();
}

/// m u + n v, whose fraction is uniform for any m, n != 0, as a wave: exp(2 pi i (m u + n v)).
struct Wave {
  int m, n;
  const char* words;  ///< what it means where that is constant
};
constexpr Wave waves[] = {{1, -1, "u - v"},  {1, 1, "u + v"},   {2, -1, "2u - v"},
                          {2, 1, "2u + v"},  {1, -2, "u - 2v"}, {1, 2, "u + 2v"},
                          {3, -1, "3u - v"}, {1, -3, "u - 3v"}, {4, -1, "4u - v"}};

using Complex = std::complex<float>;

/// exp(2 pi i u) of all values; its powers give all waves.
std::vector<Complex> turned(std::span<const double> values) {
  std::vector<Complex> all(values.size());
  std::transform(values.begin(), values.end(), all.begin(), [](double u) {
    const double angle = 2 * std::numbers::pi * u;
    return Complex(static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle)));
  });
  return all;
}

Complex power(Complex z, int k) {
  Complex result(1, 0);
  if (k < 0) z = std::conj(z), k = -k;
  for (; k > 0; --k)
    result = {result.real() * z.real() - result.imag() * z.imag(),
              result.real() * z.imag() + result.imag() * z.real()};
  return result;
}

/// The pairs of positions that are compared: all of few; of many, those a power of two apart and a
/// thousand others.
std::vector<std::pair<std::size_t, std::size_t>> compared_pairs(std::size_t positions) {
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  if (positions <= 40) {
    for (std::size_t i = 0; i < positions; ++i) {
      for (std::size_t j = i + 1; j < positions; ++j) pairs.emplace_back(i, j);
    }
    return pairs;
  }
  for (std::size_t apart = 1; apart < positions; apart *= 2) {
    for (std::size_t i = 0; i + apart < positions && i < 100; ++i) pairs.emplace_back(i, i + apart);
  }
  Rng rng = check_rng();
  for (int k = 0; k < 500; ++k) {
    const std::size_t i = rng() % positions, j = rng() % positions;
    if (i != j) pairs.emplace_back(i, j);
  }
  for (std::size_t i = 0; 2 * i + 1 < positions && i < 100; ++i) {
    pairs.emplace_back(i, positions - 1 - i);
  }
  return pairs;
}

std::optional<Failure> test_waves(const Uniforms& numbers, const Randomness& claim,
                                  std::span<const std::pair<std::size_t, std::size_t>> pairs) {
  const std::size_t replicates = std::min<std::size_t>(numbers.replicates(), 2000);
  const std::size_t stride = numbers.positions;
  const auto z = turned(std::span(numbers.values).first(replicates * stride));
  constexpr std::size_t highest = 4;
  std::array<std::vector<Complex>, highest> powers;
  for (std::size_t k = 0; k < highest; ++k) {
    powers[k].resize(z.size());
    for (std::size_t i = 0; i < stride; ++i) {  // by position, so that sums run along memory
      for (std::size_t r = 0; r < replicates; ++r) {
        powers[k][i * replicates + r] = power(z[r * stride + i], static_cast<int>(k) + 1);
      }
    }
  }
  Family family(numbers, claim, "pairs", pairs.size() * std::size(waves));
  for (const auto& [i, j] : pairs) {
    for (const Wave& wave : waves) {
      const Complex* const a = powers[static_cast<std::size_t>(wave.m) - 1].data() + i * replicates;
      const Complex* const b =
          powers[static_cast<std::size_t>(std::abs(wave.n)) - 1].data() + j * replicates;
      const float sign = wave.n < 0 ? -1.f : 1.f;
      float re = 0, im = 0;
      for (std::size_t r = 0; r < replicates; ++r) {
        const float bi = sign * b[r].imag();
        re += a[r].real() * b[r].real() - a[r].imag() * bi;
        im += a[r].real() * bi + a[r].imag() * b[r].real();
      }
      const double squared = static_cast<double>(re) * re + static_cast<double>(im) * im;
      const auto n = static_cast<double>(replicates);
      family.add(p_of_resultant(squared, n), true, [&, i = i, j = j] {
        return fmt::format(
            "u, {}, and v, {}, are not independent: {} is {} ({} times)", name_of(numbers, i),
            name_of(numbers, j), wave.words,
            squared > 0.98 * n * n ? "always the same, modulo 1" : "not uniform, modulo 1",
            replicates);
      });
    }
  }
  return family.failure();
}

/// Bit k of position p in all replicates, 64 in a word.
class BitPlanes {
 public:
  BitPlanes(const Uniforms& numbers, std::size_t planes)
      : planes_(planes), words_((numbers.replicates() + 63) / 64) {
    bits_.resize(numbers.positions * planes * words_);
    for (std::size_t r = 0; r < numbers.replicates(); ++r) {
      for (std::size_t p = 0; p < numbers.positions; ++p) {
        const auto word =
            static_cast<std::uint64_t>(numbers.values[r * numbers.positions + p] * 0x1p53);
        for (std::size_t k = 0; k < planes; ++k) {
          at(p, k)[r / 64] |= (word >> (52 - k) & 1) << r % 64;
        }
      }
    }
  }
  /// In how many replicates two bits are equal.
  std::size_t equal(std::size_t p, std::size_t k, std::size_t q, std::size_t l,
                    std::size_t replicates) const {
    const std::uint64_t* const a = bits_.data() + (p * planes_ + k) * words_;
    const std::uint64_t* const b = bits_.data() + (q * planes_ + l) * words_;
    std::size_t differ = 0;
    for (std::size_t w = 0; w < words_; ++w) {
      differ += static_cast<std::size_t>(std::popcount(a[w] ^ b[w]));
    }
    return replicates - differ;
  }

 private:
  std::uint64_t* at(std::size_t p, std::size_t k) {
    return bits_.data() + (p * planes_ + k) * words_;
  }
  std::size_t planes_, words_;
  std::vector<std::uint64_t> bits_;
};

/// Two bits are equal in half of the replicates: bits of one number, and of two.
std::optional<Failure> test_bit_pairs(const Uniforms& numbers, const Randomness& claim,
                                      std::span<const std::pair<std::size_t, std::size_t>> pairs) {
  const std::size_t replicates = numbers.replicates();
  const auto planes = static_cast<std::size_t>(std::clamp(numbers.bits - 3, 1, 32));
  const std::size_t crossed = std::min<std::size_t>(planes, 8);  // all with all, of the first
  const BitPlanes bits(numbers, planes);
  const std::size_t inside = std::min<std::size_t>(numbers.positions, 64);
  Family family(
      numbers, claim, "bits of pairs",
      pairs.size() * (planes + crossed * (crossed - 1)) + inside * planes * (planes - 1) / 2);
  // |k - R/2| is so large with the binomial's tail; the bound saves computing most of them.
  const auto n = static_cast<double>(replicates);
  const double bound = std::sqrt(n * 10);
  const auto compare = [&](std::size_t p, std::size_t k, std::size_t q, std::size_t l) {
    const std::size_t equal = bits.equal(p, k, q, l, replicates);
    if (std::abs(static_cast<double>(equal) - n / 2) < bound)
      return family.add(1, false, [] { return std::string(); });
    family.add(binomial_tails(equal, replicates, 0.5).two_sided(), false, [&] {
      return fmt::format("bit {} of {} and bit {} of {} are equal in {} of {} replicates", k + 1,
                         name_of(numbers, p), l + 1, name_of(numbers, q), equal, replicates);
    });
  };
  for (const auto& [p, q] : pairs) {
    for (std::size_t k = 0; k < planes; ++k) compare(p, k, q, k);
    for (std::size_t k = 0; k < crossed; ++k) {
      for (std::size_t l = 0; l < crossed; ++l) {
        if (k != l) compare(p, k, q, l);
      }
    }
  }
  for (std::size_t p = 0; p < inside; ++p) {
    for (std::size_t k = 0; k < planes; ++k) {
      for (std::size_t l = k + 1; l < planes; ++l) compare(p, k, p, l);
    }
  }
  return family.failure();
}

/// Values at a distance in the order in which they came, pooled: in 8 x 8 cells, and as waves.
std::optional<Failure> test_lags(const Uniforms& numbers, const Randomness& claim) {
  const std::size_t n = std::min<std::size_t>(numbers.values.size(), 200000);
  std::vector<std::size_t> lags;
  for (std::size_t lag = 1; 2 * lag <= n && lag <= 4096; lag *= 2) lags.push_back(lag);
  for (std::size_t rows = 1; 2 * rows * numbers.positions <= n && rows <= 64; rows *= 2) {
    lags.push_back(rows * numbers.positions);
  }
  std::sort(lags.begin(), lags.end());
  lags.erase(std::unique(lags.begin(), lags.end()), lags.end());
  const auto z = turned(std::span(numbers.values).first(n));
  Family family(numbers, claim, "lags", 3 * lags.size());
  for (const std::size_t lag : lags) {
    const std::size_t side = n >= 12800 ? 8 : n >= 3200 ? 4 : 2;
    std::vector<std::uint32_t> counts(side * side);
    std::complex<double> difference, sum;
    double pairs = 0;
    for (std::size_t i = 0; i + lag < n; ++i) {
      if (i / lag % 2 != 0) continue;  // no value is in two pairs
      const double u = numbers.values[i], v = numbers.values[i + lag];
      const auto size = static_cast<double>(side);
      ++counts[static_cast<std::size_t>(u * size) * side + static_cast<std::size_t>(v * size)];
      difference += std::complex<double>(z[i] * std::conj(z[i + lag]));
      sum += std::complex<double>(z[i] * z[i + lag]);
      ++pairs;
    }
    const auto describe = [&] {
      const bool in_rows = lag % numbers.positions == 0 && numbers.positions > 1;
      return fmt::format("{} pairs of numbers, the second {} after the first, are not independent",
                         pairs,
                         in_rows ? fmt::format("{} replicates", lag / numbers.positions)
                                 : fmt::format("{} numbers", lag));
    };
    family.add(pairs >= 50 * static_cast<double>(side * side) ? p_of_counts(counts) : 1, false,
               describe);
    family.add(p_of_resultant(std::norm(difference), pairs), false, describe);
    family.add(p_of_resultant(std::norm(sum), pairs), false, describe);
  }
  return family.failure();
}

/// Sums over a replicate, of u - 1/2 and of cos(2 pi u), have the variance of independent numbers:
/// not too even and not too clumped.
std::optional<Failure> test_rows(const Uniforms& numbers, const Randomness& claim) {
  const std::size_t positions = numbers.positions, replicates = numbers.replicates();
  if (positions < 2 || replicates < 100) return {};
  Family family(numbers, claim, "rows", 2);
  const auto add = [&](const char* words, double variance, double kurtosis, auto f) {
    double squares = 0;
    for (std::size_t r = 0; r < replicates; ++r) {
      double sum = 0;
      for (std::size_t p = 0; p < positions; ++p) sum += f(numbers.values[r * positions + p]);
      squares += sum * sum;
    }
    const double of_sum = 3 + (kurtosis - 3) / static_cast<double>(positions);
    const auto count = static_cast<double>(replicates);
    const double degrees = 2 * count / (of_sum - 1);  // Satterthwaite 1946
    const double ratio = squares / (count * variance * static_cast<double>(positions));
    family.add(chi_squared_tails(ratio * degrees, degrees).two_sided(), true, [&] {
      return fmt::format(
          "the sum of {} over the {} numbers of a replicate has {:.4g} times the "
          "variance of independent numbers",
          words, positions, ratio);
    });
  };
  add("u - 1/2", 1.0 / 12, 1.8, [](double u) { return u - 0.5; });
  add("cos(2 pi u)", 0.5, 1.5, [](double u) { return std::cos(2 * std::numbers::pi * u); });
  return family.failure();
}

/// The smallest k for which all numbers are multiples of 2^-k, as nearly as they are known.
std::optional<int> grid_of(const Uniforms& numbers) {
  for (int k = 0; k + 8 < numbers.bits; ++k) {
    const double scale = std::ldexp(1.0, k), near = std::ldexp(1.0, k - numbers.bits + 2);
    const bool fits = std::all_of(numbers.values.begin(), numbers.values.end(), [=](double u) {
      return std::abs(std::remainder(u * scale, 1.0)) <= near;
    });
    if (fits) return k;
  }
  return {};
}

}  // namespace

std::string visible_fault(const Uniforms& numbers, const Randomness& claim) {
  const auto [low, high] = std::minmax_element(numbers.values.begin(), numbers.values.end());
  const double width = width_of_equal(numbers);
  const std::string and_repeated = claim.repeated.empty() ? "" : "; " + claim.repeated;
  if (*high - *low < 1e-6) {
    return fmt::format("every number is {:.3g}: draw one at random for each{}", *low, and_repeated);
  }
  const std::size_t replicates = numbers.replicates(), positions = numbers.positions;
  for (std::size_t p = 0; p < positions && positions > 1 && replicates >= 20; ++p) {
    bool is_constant = true;
    for (std::size_t r = 1; r < replicates && is_constant; ++r) {
      is_constant = std::abs(numbers.values[r * positions + p] - numbers.values[p]) < width;
    }
    if (is_constant) {
      return fmt::format(
          "{} has the same random number, {:.4g}, in every set: draw it from the "
          "generator that is passed in{}",
          name_of(numbers, p), numbers.values[p], and_repeated);
    }
  }
  if (const auto bits = grid_of(numbers); bits && *bits > 0) {
    return fmt::format("the random numbers have too few bits: these have {}, to_unit gives 53",
                       *bits);
  }
  const std::string from_one =
      claim.same.empty() ? "draw a random number for each of them" : claim.same;
  if (positions > 1 && replicates >= 20) {
    for (const auto& [p, q] : compared_pairs(positions)) {
      const auto always = [&, p = p, q = q](auto f) {
        const double first = f(numbers.values[p], numbers.values[q]);
        for (std::size_t r = 1; r < replicates; ++r) {
          const double here =
              f(numbers.values[r * positions + p], numbers.values[r * positions + q]);
          if (std::abs(std::remainder(here - first, 1.0)) > 4 * width) return false;
        }
        return true;
      };
      if (always([](double u, double v) { return u - v; })) {
        return fmt::format("{} and {} share one random number: {}", name_of(numbers, p),
                           name_of(numbers, q), from_one);
      }
      if (always([](double u, double v) { return u + v; })) {
        return fmt::format("{} and {} are u and 1 - u of one random number: {}",
                           name_of(numbers, p), name_of(numbers, q), from_one);
      }
    }
  }
  if (10 * repeats_in(numbers.values, width) > numbers.values.size()) {
    return claim.repeated.empty()
               ? "the same random numbers come again and again: draw one for each, all from the "
                 "generator that is passed in"
               : claim.repeated;
  }
  const auto n = static_cast<double>(numbers.values.size());
  if (n * std::max(*low, 1 - *high) > 40) {
    return fmt::format("the numbers cover only [{:.2g}, {:.2g}]: u is uniform in [0, 1)", *low,
                       *high);
  }
  return {};
}

std::optional<Failure> dependence_in(const Uniforms& numbers, const Randomness& claim,
                                     bool only_each) {
  for (const double u : numbers.values) {
    if (u >= 0 && u < 1) continue;
    return Failure{fmt::format("{}: a random number comes out as {}", numbers.call, u),
                   "numbers in [0, 1)", claim.words, claim.otherwise};
  }
  const auto pairs = compared_pairs(numbers.positions);
  const bool has_replicates = numbers.replicates() >= 100;
  std::optional<Failure> found;
  const auto run = [&](bool wanted, auto test) {
    if (wanted && !found) found = test();
  };
  run(true, [&] { return test_positions(numbers, claim); });
  run(true, [&] { return test_values(numbers, claim); });
  run(true, [&] { return test_extremes(numbers, claim); });
  run(true, [&] { return test_bits(numbers, claim); });
  run(!only_each && has_replicates && !pairs.empty(),
      [&] { return test_waves(numbers, claim, pairs); });
  run(!only_each && has_replicates, [&] { return test_bit_pairs(numbers, claim, pairs); });
  run(!only_each, [&] { return test_repeats(numbers, claim); });
  run(!only_each, [&] { return test_lags(numbers, claim); });
  run(!only_each, [&] { return test_rows(numbers, claim); });
  return found;
}

void expect_independent_uniforms(const Uniforms& numbers, const Randomness& claim, bool only_each) {
  if (const auto failure = dependence_in(numbers, claim, only_each)) fail(*failure);
  pass();
}

}  // namespace mc::checks
