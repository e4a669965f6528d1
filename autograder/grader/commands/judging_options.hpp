#pragma once
// What check and grade ask of their options alike.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <random>
#include <string>

#include <fmt/format.h>

#include "grader/base/errors.hpp"
#include "grader/commands/arguments.hpp"

namespace mc::grader {

/// Fresh for every run, so that nothing can be made to fit it; short, so that it can be typed.
inline std::uint64_t seed_of(const Arguments& arguments) {
  return arguments.number("seed").value_or(std::random_device()() % 1'000'000'000);
}

/// Looked at before any work is done: a mistyped name should not cost a grade.
inline void require_writable(const std::optional<std::string>& file) {
  if (!file) return;
  const auto directory = std::filesystem::absolute(*file).parent_path();
  if (!std::filesystem::is_directory(directory)) {
    throw UsageError(fmt::format("no such directory: {}", directory.string()));
  }
}

/// When Gradescope shows the checks to students; throws UsageError for what it does not know.
inline std::optional<std::string> visibility_of(const Arguments& arguments) {
  auto given = arguments.get("visibility");
  for (const char* known : {"visible", "hidden", "after_due_date", "after_published"}) {
    if (!given || *given == known) return given;
  }
  throw UsageError("--visibility takes visible, hidden, after_due_date or after_published");
}

}  // namespace mc::grader
