// The parts of the battery that test pairs and triples of positions.

#include <tuple>

#include "checks/support/battery_parts.hpp"
#include "checks/support/checks.hpp"

namespace mc::checks::battery {
namespace {

/// m u + n v, whose fraction is uniform for any m, n != 0, as a wave: exp(2 pi i (m u + n v)).
struct Wave {
  int m, n;
  const char* words;  ///< its name in reports
};
constexpr Wave waves[] = {{1, -1, "u - v"},  {1, 1, "u + v"},   {2, -1, "2u - v"},
                          {2, 1, "2u + v"},  {1, -2, "u - 2v"}, {1, 2, "u + 2v"},
                          {3, -1, "3u - v"}, {1, -3, "u - 3v"}, {4, -1, "4u - v"}};

/// Bit k of position p in all replicates, packed 64 per word.
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

}  // namespace

std::vector<Complex> phases_of(std::span<const double> values) {
  std::vector<Complex> all(values.size());
  std::transform(values.begin(), values.end(), all.begin(), [](double u) {
    const double angle = 2 * std::numbers::pi * u;
    return Complex(static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle)));
  });
  return all;
}

Pairs compared_pairs(std::size_t positions) {
  Pairs pairs;
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
                                  const Pairs& pairs, std::span<const Complex> z) {
  const std::size_t replicates = std::min<std::size_t>(numbers.replicates(), 2000);
  const std::size_t stride = numbers.positions;
  constexpr std::size_t lanes = 8;
  const std::size_t padded = (replicates + lanes - 1) / lanes * lanes;  // zeros add nothing
  struct Plane {
    std::vector<float> re, im;
  };
  const Plane empty{std::vector<float>(padded * stride), std::vector<float>(padded * stride)};
  std::array<Plane, 4> powers{empty, empty, empty, empty};
  for (std::size_t i = 0; i < stride; ++i) {  // by position, so that sums read memory in order
    for (std::size_t r = 0; r < replicates; ++r) {
      const Complex w = z[r * stride + i];
      float re = 1, im = 0;
      for (Plane& plane : powers) {
        std::tie(re, im) = std::pair{re * w.real() - im * w.imag(), re * w.imag() + im * w.real()};
        plane.re[i * padded + r] = re;
        plane.im[i * padded + r] = im;
      }
    }
  }
  Family family(numbers, claim, "pairs", pairs.size() * std::size(waves));
  for (const auto& [i, j] : pairs) {
    for (const Wave& wave : waves) {
      const Plane& a = powers[static_cast<std::size_t>(wave.m) - 1];
      const Plane& b = powers[static_cast<std::size_t>(std::abs(wave.n)) - 1];
      const float *const ar = &a.re[i * padded], *const ai = &a.im[i * padded];
      const float *const br = &b.re[j * padded], *const bi = &b.im[j * padded];
      const float sign = wave.n < 0 ? -1.f : 1.f;
      float res[lanes] = {}, ims[lanes] = {};  // additions to one sum wait for each other
      for (std::size_t r = 0; r < padded; r += lanes) {
        for (std::size_t l = 0; l < lanes; ++l) {
          res[l] += ar[r + l] * br[r + l] - sign * ai[r + l] * bi[r + l];
          ims[l] += sign * ar[r + l] * bi[r + l] + ai[r + l] * br[r + l];
        }
      }
      const float re = std::accumulate(res, res + lanes, 0.f);
      const float im = std::accumulate(ims, ims + lanes, 0.f);
      const double squared = static_cast<double>(re) * re + static_cast<double>(im) * im;
      const auto n = static_cast<double>(replicates);
      family.add(p_of_resultant(squared, n), true, [&, i = i, j = j] {
        return fmt::format(
            "u = {} and v = {} are not independent: {} is {} in {} replicates", name_of(numbers, i),
            name_of(numbers, j), wave.words,
            squared > 0.98 * n * n ? "always the same, modulo 1" : "not uniform, modulo 1",
            replicates);
      });
    }
  }
  return family.failure();
}

/// Three positions in a row, and the first two with the last: pairwise independent numbers may
/// still determine a third.
std::optional<Failure> test_triples(const Uniforms& numbers, const Randomness& claim,
                                    std::span<const Complex> z) {
  const std::size_t positions = numbers.positions, replicates = numbers.replicates();
  if (positions < 3) return {};
  std::vector<std::size_t> thirds{positions - 1};  // with positions 0 and 1, or the two before it
  for (std::size_t k = 2; k < std::min<std::size_t>(positions, 64); ++k) thirds.push_back(k);
  Family family(numbers, claim, "triples", 4 * thirds.size());
  for (std::size_t t = 0; t < thirds.size(); ++t) {
    const std::size_t k = thirds[t], i = t == 0 ? 0 : k - 2, j = i + 1;
    std::array<std::complex<double>, 4> sums;
    for (std::size_t r = 0; r < replicates; ++r) {
      const Complex* const row = &z[r * positions];
      const Complex sum = row[i] * row[j], difference = row[i] * std::conj(row[j]), w = row[k];
      const Complex waves_of_three[] = {sum * w, sum * std::conj(w), difference * w,
                                        difference * std::conj(w)};
      for (std::size_t s = 0; s < 4; ++s) sums[s] += std::complex<double>(waves_of_three[s]);
    }
    constexpr const char* words[] = {"u + v + w", "u + v - w", "u - v + w", "u - v - w"};
    for (std::size_t s = 0; s < 4; ++s) {
      family.add(p_of_resultant(std::norm(sums[s]), static_cast<double>(replicates)), true, [&] {
        return fmt::format(
            "u = {}, v = {} and w = {} are not independent: {} is not uniform modulo 1",
            name_of(numbers, i), name_of(numbers, j), name_of(numbers, k), words[s]);
      });
    }
  }
  return family.failure();
}

/// Any two bits, of one number or of two, are equal in half of the replicates.
std::optional<Failure> test_bit_pairs(const Uniforms& numbers, const Randomness& claim,
                                      const Pairs& pairs) {
  const std::size_t replicates = numbers.replicates();
  // Of all pairs the first bits; of a few neighbors, and of the first number and those a power of
  // two away, every bit of one with every bit of the other.
  const auto planes = static_cast<std::size_t>(std::clamp(numbers.bits - 3, 1, 50));
  const std::size_t first = std::min<std::size_t>(planes, 32);
  const std::size_t inside = std::min<std::size_t>(numbers.positions, 64);
  constexpr std::size_t neighbors = 8;
  const auto crossed = [=](std::size_t p, std::size_t q) {
    const bool all = p == 0 ? std::has_single_bit(q) : p + 1 == q && p < neighbors;
    return all ? planes : std::min<std::size_t>(planes, 8);
  };
  const BitPlanes bits(numbers, planes);
  std::size_t tests = inside * planes * (planes - 1) / 2;
  for (const auto& [p, q] : pairs) tests += first + crossed(p, q) * (crossed(p, q) - 1);
  Family family(numbers, claim, "bits of pairs", tests);
  // Below this deviation nothing can fail: it saves most binomial tails.
  const auto n = static_cast<double>(replicates);
  const double bound = std::sqrt(n * 10);
  const auto compare = [&](std::size_t p, std::size_t k, std::size_t q, std::size_t l) {
    const std::size_t equal = bits.equal(p, k, q, l, replicates);
    if (std::abs(static_cast<double>(equal) - n / 2) < bound)
      return family.add(1, false, [] { return std::string(); });
    const auto describe = [&] {
      return fmt::format("bit {} of {} and bit {} of {} are equal in {} of {} replicates", k + 1,
                         name_of(numbers, p), l + 1, name_of(numbers, q), equal, replicates);
    };
    const bool is_shared = p != q && (equal == 0 || equal == replicates);
    family.add(binomial_tails(equal, replicates, 0.5).two_sided(), false, describe,
               is_shared ? "two numbers share bits of one word: make each from a new one"_likely
                         : Likely{});
  };
  for (const auto& [p, q] : pairs) {
    for (std::size_t k = 0; k < first; ++k) compare(p, k, q, k);
    for (std::size_t k = 0; k < crossed(p, q); ++k) {
      for (std::size_t l = 0; l < crossed(p, q); ++l) {
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

}  // namespace mc::checks::battery
