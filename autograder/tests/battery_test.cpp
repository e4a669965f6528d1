// The battery for randomness: accepts independent uniform numbers, and detects the usual ways in
// which random numbers go wrong.

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>

#include "checks/support/battery.hpp"
#include "checks/support/catch.hpp"
#include "checks/support/domain.hpp"
#include "checks/support/inversions.hpp"

namespace mc::checks {
namespace {

Uniforms independent_numbers(std::uint64_t seed, std::size_t positions, std::size_t replicates) {
  Rng rng(seed);
  Uniforms numbers{"test", positions};
  numbers.values = uniform_values(rng, positions * replicates, 0, 1);
  return numbers;
}

const Randomness claim{"independent uniform numbers", 1e-8, "otherwise"};

TEST_CASE("the battery passes independent uniform numbers") {
  // Alpha is 1e-8: at 1e-3 it must still pass about 999 of 1000, and Bonferroni errs towards
  // passing. 12 failures of 200 at 1e-2 have a probability below 1e-6.
  int failures = 0;
  for (std::uint64_t run = 0; run < 200; ++run) {
    const auto numbers = independent_numbers(run, 1 + run % 13, 100 + run);
    const auto failure = dependence_in(numbers, claim);
    INFO((failure ? failure->measured : ""));
    CHECK_FALSE(failure);
    failures += dependence_in(numbers, {"loose", 1e-2, ""}) ? 1 : 0;
  }
  CHECK(failures < 12);
  CHECK_FALSE(dependence_in(independent_numbers(1, 1, 100000), claim));
  CHECK_FALSE(dependence_in(independent_numbers(2, 200, 500), claim));
}

using Row = std::span<double>;

/// One way to spoil a replicate of 16 numbers, and what the battery finds ("" if it is not named).
struct Fault {
  std::string found;
  std::function<void(Row u, std::size_t replicate)> spoil;
};

/// A change of each number on its own.
std::function<void(Row, std::size_t)> each(double (*change)(double)) {
  return [change](Row u, std::size_t) { std::transform(u.begin(), u.end(), u.begin(), change); };
}

TEST_CASE("the battery names what is visibly wrong, and detects what is not visible") {
  std::vector<double> before(16);
  const Fault faults[] = {
      {"every number is 0.5", each([](double) { return 0.5; })},
      {"cover only [0.01", each([](double x) { return 0.01 + 0.98 * x; })},
      {"multiples of 1/1000", each([](double x) { return std::floor(x * 1000) / 1000; })},
      {"too few bits: only 24", each([](double x) { return std::floor(x * 0x1p24) * 0x1p-24; })},
      {"too few bits: only 32", each([](double x) { return std::floor(x * 0x1p32) * 0x1p-32; })},
      {"position 3 and position 15 share one random number", [](Row u, auto) { u[15] = u[3]; }},
      {"share one random number, as u and 1 - u", [](Row u, auto) { u[15] = 1 - 0x1p-53 - u[3]; }},
      {"share one random number", [](Row u, auto) { u[7] = std::fmod(u[6] + 0.3, 1.0); }},
      {"position 15 has the same random number", [](Row u, auto) { u[15] = 0.25; }},
      {"",  // XOR with a constant
       [](Row u, auto) {
         const auto bits = static_cast<std::uint64_t>(u[2] * 0x1p53) ^ 0x15a3c5d2e1f7b3;
         u[9] = static_cast<double>(bits) * 0x1p-53;
       }},
      {"", [](Row u, auto) { u[5] = std::fmod(2 * u[4], 1.0); }},
      {"", [](Row u, auto) { u[15] = u[15] * 0.5; }},
      {"", [](Row u, auto) { u[0] = std::sqrt(u[0]); }},
      {"",  // 16 strata instead of 16 independent numbers
       [](Row u, auto) {
         for (std::size_t i = 0; i < 16; ++i) u[i] = (static_cast<double>(i) + u[i]) / 16;
       }},
      {"",  // every second replicate repeats the previous one
       [&](Row u, std::size_t replicate) {
         if (replicate % 2 == 1) std::copy(before.begin(), before.end(), u.begin());
         std::copy(u.begin(), u.end(), before.begin());
       }},
      {"", each([](double x) { return 0.997 * x; })},  // a margin of 3e-3
  };
  for (const Fault& fault : faults) {
    auto numbers = independent_numbers(3, 16, 1000);
    for (std::size_t r = 0; r < numbers.replicates(); ++r) {
      fault.spoil(Row(numbers.values).subspan(r * 16, 16), r);
    }
    const auto failure = dependence_in(numbers, claim);
    CAPTURE(&fault - faults, fault.found);
    REQUIRE(failure);
    CHECK((failure->measured + " -> " + failure->likely.text).find(fault.found) !=
          std::string::npos);
  }
}

TEST_CASE("random permutations map to independent uniform numbers") {
  Rng rng(4);
  const auto uniforms_of = [&](auto shuffle) {
    Uniforms numbers{"test", 6};
    std::vector<std::size_t> order(7);
    for (int i = 0; i < 20000; ++i) {
      std::iota(order.begin(), order.end(), 0);
      shuffle(order);
      const auto more = uniforms_of_permutation(order, rng);
      numbers.values.insert(numbers.values.end(), more.begin(), more.end());
    }
    return numbers;
  };
  const auto is_random = [&](auto shuffle) { return !dependence_in(uniforms_of(shuffle), claim); };
  CHECK(is_random([&](auto& order) {  // Fisher-Yates
    for (std::size_t i = order.size() - 1; i > 0; --i) std::swap(order[i], order[rng() % (i + 1)]);
  }));
  CHECK_FALSE(is_random([&](auto& order) {  // swaps each with any other
    for (auto& value : order) std::swap(value, order[rng() % order.size()]);
  }));
  CHECK_FALSE(is_random([&](auto& order) {
    std::rotate(order.begin(), order.begin() + static_cast<long>(rng() % 7), order.end());
  }));
  CHECK_FALSE(is_random([&](auto& order) {  // never keeps a value in place
    for (std::size_t i = 6; i > 0; --i) std::swap(order[i], order[rng() % i]);
  }));
}

TEST_CASE("nested scrambling maps to independent uniform numbers") {
  Rng rng(5);
  const std::vector<double> values{0, 0.5, 0.25, 0x1p-20, 0};
  const auto uniforms_of = [&](auto flips_of) {
    Uniforms numbers{"test", 4};
    for (int i = 0; i < 2000; ++i) {
      std::map<std::pair<int, std::uint64_t>, std::uint64_t> drawn;  // bits before -> flip
      const auto key = rng();
      std::vector<double> scrambled;
      for (const double value : values) {
        std::uint64_t word = 0;
        for (int k = 0; k < 53; ++k) {
          const std::uint64_t before = k == 0 ? 0 : bits_of(value) >> (53 - k);
          word = word << 1 | (flips_of(key, k, before, drawn) & 1);
        }
        scrambled.push_back(static_cast<double>(word ^ bits_of(value)) * 0x1p-53);
      }
      const auto more = uniforms_of_flips(values, scrambled, rng);
      numbers.values.insert(numbers.values.end(), more.begin(), more.end());
    }
    return numbers;
  };
  CHECK_FALSE(
      dependence_in(uniforms_of([&](std::uint64_t, int k, std::uint64_t before, auto& drawn) {
                      return drawn.try_emplace({k, before}, rng()).first->second;
                    }),
                    claim));
  CHECK(dependence_in(uniforms_of([](std::uint64_t key, int k, std::uint64_t, auto&) {
                        return key >> (k + 5);  // a digital shift
                      }),
                      claim));
}

}  // namespace
}  // namespace mc::checks
