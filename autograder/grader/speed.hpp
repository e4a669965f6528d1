#pragma once
// The speed tasks of a submission beside the reference: reported with a grade, no part of it.

#include "grader/build.hpp"
#include "grader/verdict.hpp"

namespace mc::grader {

/// Measures the speed tasks of which all checks passed, on a program of the variant for speed. The
/// reference's figures are measured once for each build of it and kept.
std::vector<Speed> measure_speed(const Layout& layout, const LabVerdict& verdict,
                                 const Program& program);

}  // namespace mc::grader
