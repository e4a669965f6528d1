#pragma once
// The speed tasks of a submission beside the reference: reported with a grade, no part of it.

#include "grader/judging/verdict.hpp"
#include "sandbox/jail.hpp"

namespace mc::grader {

/// Measures the speed tasks of which all checks passed, on a program of the variant for speed, and
/// the reference's right after them.
std::vector<Speed> measure_speed(const Layout& layout, const LabVerdict& verdict,
                                 const sandbox::Program& program);

}  // namespace mc::grader
