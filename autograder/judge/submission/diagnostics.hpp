#pragma once
// Compiler and linker messages, edited for students.

#include <map>
#include <string>
#include <string_view>

#include "judge/checkout/labs.hpp"

namespace mc::grader {

struct NamedText {
  std::string name, text;  ///< of a source file
};

/// Is this a compiler's line about an error at a place: "file:12:5: error: …"?
bool is_error(std::string_view line);

/// The first errors of a compilation with their lines. The compiler is run without quoting source
/// lines (see compile.cpp); this inserts those of `file`.
std::string first_errors(const std::string& diagnostics, const NamedText& file);

/// The first standard header that a file needs but does not include, as a sentence; empty if there
/// is none. Every compilation includes a few headers, precompiled, so the compiler does not notice.
std::string missing_include(const NamedText& file);

/// "Your variance.cpp does not define `mc::covariance` …" and the like. `headers` has the text of
/// each lab's header, by the lab's name.
std::string explain_link_errors(const std::string& diagnostics, const Lab& lab,
                                const std::map<std::string, std::string>& headers);

}  // namespace mc::grader
