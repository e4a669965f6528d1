#pragma once
// A whole verdict as JSON, and back: what was judged is on disk and need not be judged again.

#include <string>

#include "grader/judging/verdict.hpp"

namespace mc::grader {

/// Without the arguments of calls, which can take megabytes: the commands that repeat them are in
/// it.
std::string verdict_to_json(const Verdict& verdict);

/// Throws std::exception for a text that is no verdict, or one cut short.
Verdict verdict_from_json(const std::string& text);

}  // namespace mc::grader
