#pragma once
// The files that a compilation read, as the compiler lists them, and whether it may.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "grader/checkout/layout.hpp"

namespace mc::grader {

/// The output of a compiler run with -H: the files it opened, in order, and its messages.
struct CompilerOutput {
  std::vector<std::filesystem::path> opened;
  std::string messages;
};
CompilerOutput parse_compiler_output(const std::string& errors);

/// The files that a make rule ("a.o: b.cpp c.hpp \\") depends on.
std::vector<std::filesystem::path> dependencies(const std::string& rule);

/// Does the text have an #embed, which -H does not list? A false alarm is possible: a comment with
/// that word counts too.
bool may_embed(std::string_view text);

/// The first of `files` that a submission compiled in `directory` must not read. It may read that
/// directory, the labs, and the system's headers; a trusted one may read the whole repository.
std::optional<std::filesystem::path> forbidden(const Layout& layout, bool trusted,
                                               const std::filesystem::path& directory,
                                               const std::vector<std::filesystem::path>& files);

}  // namespace mc::grader
