#pragma once
// Writes a full verdict as JSON and reads it back, so that it need not be judged again.

#include <string>

#include "grader/judging/verdict.hpp"

namespace mc::grader {

/// Without the arguments of calls, which can take megabytes; the commands that repeat them are
/// included.
std::string verdict_to_json(const Verdict& verdict);

/// Throws std::exception if the text is not a complete verdict.
Verdict verdict_from_json(const std::string& text);

}  // namespace mc::grader
