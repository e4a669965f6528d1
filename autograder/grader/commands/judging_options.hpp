#pragma once
// Options that check and grade have in common.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <random>
#include <string>

#include <fmt/format.h>

#include "grader/base/errors.hpp"
#include "grader/commands/arguments.hpp"

namespace mc::grader {

/// New in every run, so that no answer can be fitted to it; short enough to type.
inline std::uint64_t seed_of(const Arguments& arguments) {
  return arguments.number("seed").value_or(std::random_device()() % 1'000'000'000);
}

/// Checked before any work is done, so that a mistyped name costs no grading time.
inline void require_writable(const std::optional<std::string>& file) {
  if (!file) return;
  const auto directory = std::filesystem::absolute(*file).parent_path();
  if (!std::filesystem::is_directory(directory)) {
    throw UsageError(fmt::format("no such directory: {}", directory.string()));
  }
}

/// When Gradescope shows the checks to students; throws UsageError for an unknown value.
inline std::optional<std::string> visibility_of(const Arguments& arguments) {
  auto given = arguments.get("visibility");
  for (const char* known : {"visible", "hidden", "after_due_date", "after_published"}) {
    if (!given || *given == known) return given;
  }
  throw UsageError("--visibility takes visible, hidden, after_due_date or after_published");
}

}  // namespace mc::grader
