#pragma once
// A verdict as JSON: one file for each submission of a class, read again by --resume and for pages.

#include <string>

#include "judge/judging/verdict.hpp"

namespace mc::grader {

/// Everything but what is only measured (speed, p-values).
std::string verdict_to_json(const Verdict& verdict);

/// Throws std::exception if the text is not a whole verdict of this version's format.
Verdict verdict_from_json(const std::string& text);

}  // namespace mc::grader
