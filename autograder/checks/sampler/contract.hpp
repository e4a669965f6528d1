#pragma once
// What the contract of 6.4 says of any calls of a sampler.

#include <algorithm>
#include <array>
#include <optional>
#include <span>

#include "checks/sampler/samplers.hpp"

namespace mc::checks {

using experiments::Answer;
using experiments::Step;

enum Called : unsigned { generate_call, next_call, next2_call, advance_call };

inline const Step next{next_call}, next2{next2_call}, advance{advance_call};
inline Step generate(std::uint64_t samples, std::uint64_t seed) {
  return {generate_call, samples, seed};
}

/// One generate() and, for every sample, its list of uses.
inline std::vector<Step> walk(std::size_t samples, std::uint64_t seed,
                              const std::vector<Uses>& uses) {
  std::vector<Step> steps{generate(samples, seed)};
  for (const Uses& of_sample : uses) {
    for (const unsigned use : of_sample) steps.push_back({use, 0, 0});
    steps.push_back({advance_call, 0, 0});
  }
  return steps;
}

/// The calls of one sampler.
struct Calls {
  std::string kind, which;  ///< "sobol", ", the other of two"
  std::vector<Step> steps;

  /// "sobol: generate(2, 7); next()": up to step i, without most of many.
  std::string until(std::size_t i) const {
    constexpr std::size_t most = 24;
    std::string words = kind + which + ": ";
    for (std::size_t k = 0; k <= i; ++k) {
      if (i >= most && k == most / 2) {
        words += fmt::format("… {} more …; ", i + 1 - most);
        k += i + 1 - most;
      }
      words += experiments::spelled(steps[k]) + (k < i ? "; " : "");
    }
    return words;
  }
};

/// The calls of one integration, or those before the first: what each asks for.
struct Integration {
  struct Number {
    std::size_t sample, coordinate;
  };
  Uses uses = {};                                   ///< in the order in which they come first
  std::vector<std::optional<Number>> numbers = {};  ///< of each call; none where there is none

  Integration(std::span<const Step> calls, std::uint64_t samples) {
    std::array<std::vector<std::size_t>, 3> coordinates;  // of the k-th next() and next2()
    std::array<std::size_t, 3> count{};                   // those that this sample has asked for
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

/// The answers are what 6.4 says: next() and next2() throw std::out_of_range where there is no
/// sample, and else have the numbers of a new sampler, whose samples all ask for all the sample
/// dimensions, in the order in which these calls do first.
inline void expect_answers(const Calls& calls, std::span<const Answer> answers,
                           const Claim& claim) {
  const std::vector<Step>& steps = calls.steps;
  const auto fail_at = [&](std::size_t i, const std::string& gave, const std::string& expected) {
    expect_that(false, calls.until(i) + ' ' + gave, expected, claim.because, claim.likely);
  };
  for (std::size_t first = 0, end = 0; first < steps.size(); first = end) {
    for (++end; end < steps.size() && steps[end].call != generate_call;) ++end;
    const auto [_, samples, seed] = steps[first];
    const Integration all(std::span<const Step>(steps).subspan(first, end - first), samples);
    std::optional<SampleSets> columns;
    if (!all.uses.empty()) columns = columns_of(calls.kind, samples, {seed}, all.uses);
    for (std::size_t i = first; i < end; ++i) {
      const auto& [thrown, x, y] = answers[i];
      const auto& number = all.numbers[i - first];
      const unsigned call = steps[i].call;
      const bool must_throw = !number && (call == next_call || call == next2_call);
      if (thrown != (must_throw ? 1 : 0)) {
        constexpr const char* words[] = {"threw nothing", "threw std::out_of_range",
                                         "threw std::invalid_argument", "threw another exception"};
        fail_at(i, words[std::min(thrown, 3u)],
                must_throw ? "std::out_of_range: there is no sample" : "no exception");
      }
      if (!number) continue;
      const double due_x = columns->column(0, number->coordinate)[number->sample];
      const double due_y =
          call == next2_call ? columns->column(0, number->coordinate + 1)[number->sample] : y;
      if (x == due_x && y == due_y) continue;
      const auto words = [&](double a, double b) {
        return call == next_call ? fmt::format("{:.17g}", a)
                                 : fmt::format("({:.17g}, {:.17g})", a, b);
      };
      fail_at(i, "gave " + words(x, y),
              fmt::format("{} for this sample dimension of sample {}, as in {}",
                          words(due_x, due_y), number->sample, columns->call));
    }
  }
  pass();
}

inline void expect_contract(const std::string& kind, const std::vector<Step>& steps,
                            const Claim& claim) {
  expect_answers({kind, "", steps}, MEASURE(play, kind, steps).exactly(steps.size(), any_number),
                 claim);
}

}  // namespace mc::checks
