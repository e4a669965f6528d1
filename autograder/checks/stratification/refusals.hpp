#pragma once
// Misuse that throws std::invalid_argument: that it does, and what it says, each judged by itself.

#include <algorithm>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "checks/support/expect.hpp"

namespace mc::checks {

/// A call with arguments that are out of order, and why they are.
struct Misuse {
  Call call;
  std::string because;
  std::string hint = "misuse throws std::invalid_argument, before anything is computed";
};

inline bool is_refused(const Call& call) {
  return call.outcome.answered && call.outcome.status == wire::Status::invalid_argument;
}

/// It throws std::invalid_argument, whatever that says.
inline void expect_refused(const Misuse& misuse) {
  const auto& outcome = misuse.call.outcome;
  if (is_refused(misuse.call)) return pass();
  if (outcome.answered && outcome.status == wire::Status::todo) require_value(misuse.call);
  const std::string what = !outcome.answered                       ? outcome.failure
                           : outcome.status == wire::Status::value ? "returned a value"
                           : outcome.status == wire::Status::out_of_range
                               ? "threw std::out_of_range: " + outcome.bytes
                               : "threw " + outcome.bytes;
  expect_that(false, fmt::format("{} {}", misuse.call.text, what), "std::invalid_argument",
              misuse.because, misuse.hint);
}

/// Those that are refused (one at least) are so in words that name the argument: one of `names`.
inline void expect_named(std::span<const Misuse> misuses,
                         std::initializer_list<std::string_view> names) {
  const Misuse* refused = nullptr;
  for (const Misuse& misuse : misuses) {
    if (!is_refused(misuse.call)) continue;
    refused = &misuse;
    const std::string& text = misuse.call.outcome.bytes;
    const bool named = std::any_of(names.begin(), names.end(), [&](std::string_view name) {
      return text.find(name) != std::string::npos;
    });
    std::string all;
    for (const std::string_view name : names)
      all += (all.empty() ? "" : " or ") + std::string(name);
    expect_that(named,
                fmt::format("{} threw std::invalid_argument(\"{}\")", misuse.call.text, text),
                "a text that names the argument: " + all, misuse.because,
                "say in the exception's text which argument is wrong");
  }
  if (refused == nullptr) expect_refused(misuses[0]);
}

}  // namespace mc::checks
