#pragma once
// The compiler's and the linker's words, made fit for a student.

#include <map>
#include <string>

#include "grader/checkout/labs.hpp"

namespace mc::grader {

/// The first errors of a compilation and the lines that belong to them. The compiler is not asked
/// to quote source lines (see build.cpp); those of `file`, whose text is given, are put back in.
std::string first_errors(const std::string& diagnostics, const std::string& file,
                         const std::string& text);

/// "your variance.cpp does not define `mc::covariance` (declared in variance.hpp)", and the like.
std::string explain_link_errors(const std::string& diagnostics, const Lab& lab,
                                const std::map<std::string, std::string>& headers_below = {});

}  // namespace mc::grader
