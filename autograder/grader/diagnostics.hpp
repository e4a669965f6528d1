#pragma once
// The compiler's and the linker's words, made fit for a student.

#include <string>

#include "grader/labs.hpp"

namespace mc::grader {

/// The first errors of a compilation and the lines that belong to them.
std::string first_errors(const std::string& diagnostics);

/// Only the lines that speak about `file` itself: for a text that could not even be preprocessed,
/// where other lines might quote a file that it should not see.
std::string own_lines_only(const std::string& diagnostics, const std::string& file);

/// "your variance.cpp does not define `mc::covariance` (declared in variance.hpp)", and the like.
std::string explain_link_errors(const std::string& diagnostics, const Lab& lab);

}  // namespace mc::grader
