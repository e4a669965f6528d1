#include "checks/support/battery_parts.hpp"

namespace mc::checks {
namespace {

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
  const double width = battery::width_of_equal(numbers);
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
          battery::name_of(numbers, p), numbers.values[p], and_repeated);
    }
  }
  if (const auto bits = grid_of(numbers); bits && *bits > 0) {
    return fmt::format("the random numbers have too few bits: these have {}, to_unit gives 53",
                       *bits);
  }
  const std::string from_one =
      claim.same.empty() ? "draw a random number for each of them" : claim.same;
  if (positions > 1 && replicates >= 20) {
    for (const auto& [p, q] : battery::compared_pairs(positions)) {
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
        return fmt::format("{} and {} share one random number: {}", battery::name_of(numbers, p),
                           battery::name_of(numbers, q), from_one);
      }
      if (always([](double u, double v) { return u + v; })) {
        return fmt::format("{} and {} are u and 1 - u of one random number: {}",
                           battery::name_of(numbers, p), battery::name_of(numbers, q), from_one);
      }
    }
  }
  if (10 * battery::repeats_in(numbers.values, width) > numbers.values.size()) {
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

}  // namespace mc::checks
