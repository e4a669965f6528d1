#pragma once
// Walks through the samples of a sampler, call by call, and what each call brought.

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "checks/sampler/samplers.hpp"

namespace mc::checks {

using experiments::Answer;
using experiments::Step;

enum Called : unsigned { generate_call, next_call, next2_call, advance_call };

inline Step generate(std::uint64_t samples, std::uint64_t seed) {
  return {generate_call, samples, seed};
}

/// "generate(9, 7); next(); advance()": the first few steps, up to the last that counts.
inline std::string told(const std::vector<Step>& steps, std::size_t count) {
  constexpr std::size_t most = 24;
  std::string calls;
  for (std::size_t i = 0; i < count; ++i) {
    if (count > most && i == most / 2) {
      calls += fmt::format("… {} more …; ", count - most);
      i += count - most;
    }
    calls += experiments::spelled(steps[i]) + "; ";
  }
  if (!calls.empty()) calls.resize(calls.size() - 2);
  return calls;
}

/// The calls of one sampler and their answers: whatever was not thrown is a number in [0,1).
struct Played {
  std::string kind, also;  ///< "sobol", ", the other of two"
  std::vector<Step> steps;
  std::vector<Answer> answers;

  /// What has been called up to step i: "sobol: generate(2, 7); next()".
  std::string until(std::size_t i) const {
    return fmt::format("{}{}: {}", kind, also, told(steps, i + 1));
  }
};

/// Looks at the answers to steps: each a number in [0,1) or an exception.
inline Played admitted(const std::string& kind, const std::vector<Step>& steps,
                       std::span<const Answer> answers, const std::string& also = "") {
  Played got{kind, also, steps, {answers.begin(), answers.end()}};
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const Answer& answer = answers[i];
    if (answer.thrown != 0) continue;
    const bool is_inside = lies_in(answer.x, unit) && lies_in(answer.y, unit);
    if (is_inside || steps[i].call == generate_call || steps[i].call == advance_call) continue;
    expect_that(false,
                steps[i].call == next_call
                    ? fmt::format("{} gave {}", got.until(i), answer.x)
                    : fmt::format("{} gave ({}, {})", got.until(i), answer.x, answer.y),
                "numbers in [0, 1)", "", "");
  }
  return got;
}

inline Played played(const std::string& kind, const std::vector<Step>& steps) {
  const auto got = MEASURE(play, kind, steps);
  return admitted(kind, steps, got.exactly(steps.size(), any_number));
}

/// 0 is no exception, 1 std::out_of_range, 2 std::invalid_argument.
inline void check_thrown(const Played& got, std::size_t i, unsigned thrown, const std::string& when,
                         const std::string& because, const std::string& hint = "") {
  if (got.answers[i].thrown == thrown) return;
  const char* const words[] = {"no exception", "std::out_of_range", "std::invalid_argument",
                               "another exception"};
  expect_that(
      false,
      fmt::format("{}, {}: {}", got.until(i), when, words[std::min(got.answers[i].thrown, 3u)]),
      words[thrown], because, hint);
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

/// A use of a sample: next() or next2(), which of its sort, of which sample; and the step it was.
struct Asked {
  unsigned call;
  std::size_t number, sample;
  auto operator<=>(const Asked&) const = default;
};
struct Told {
  Point2 point;
  std::size_t step;
};
using ByUse = std::map<Asked, Told>;

/// What each use had for each sample in the walk that begins with step `first`. Throws end it: a
/// use must have something.
inline ByUse by_use(const Played& got, std::size_t first, std::size_t end,
                    const std::string& hint) {
  ByUse values;
  std::size_t sample = 0;
  std::array<std::size_t, 4> count{};
  for (std::size_t i = first; i < end; ++i) {
    check_thrown(got, i, 0, "within the samples", "there are samples, and this is one of them",
                 hint);
    const unsigned call = got.steps[i].call;
    if (call == advance_call) {
      ++sample;
      count = {};
    } else if (call != generate_call) {
      values[{call, count[call]++, sample}] = {{got.answers[i].x, got.answers[i].y}, i};
    }
  }
  return values;
}
inline ByUse by_use(const Played& got) {
  return by_use(
      got, 0, got.steps.size(),
      "a sample dimension may first be asked for by a later sample: make its whole column then");
}

/// Whatever both walks asked for, both were told.
inline void check_same(const Played& got, const ByUse& known, const ByUse& values,
                       const std::string& because, const std::string& hint) {
  for (const auto& [asked, here] : values) {
    const auto other = known.find(asked);
    if (other == known.end()) continue;
    const Point2 due = other->second.point;
    if (due.x == here.point.x && due.y == here.point.y) continue;
    const bool is_one = asked.call == next_call;
    const auto words = [&](Point2 p) {
      return is_one ? fmt::format("{:.17g}", p.x) : fmt::format("({:.17g}, {:.17g})", p.x, p.y);
    };
    expect_that(
        false,
        fmt::format("{} gave {} for the {}-th {}() of sample {}", got.until(here.step),
                    words(here.point), asked.number, is_one ? "next" : "next2", asked.sample),
        words(due), because, hint);
  }
  pass();
}

/// Nothing can be said of numbers that are all the same, or of none. A sequence that is not
/// randomised has many twice, but that is the business of 6.3.
inline void check_different(const Played& got, const ByUse& values) {
  if (is_sequence(got.kind)) return;
  std::set<double> different;
  for (const auto& [asked, here] : values) different.insert(here.point.x);
  expect_that(
      different.size() == values.size(),
      fmt::format("{}: {} different numbers", got.until(got.steps.size() - 1), different.size()),
      fmt::format("{}: one for each sample dimension of each sample", values.size()),
      "two numbers of 53 random bits are the same once in 1e16: here once in 1e12 runs",
      "does advance() move on, and next() to another sample dimension?");
}

}  // namespace mc::checks
