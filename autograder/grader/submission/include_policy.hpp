#pragma once
// What a compilation read, by its own account, and whether it may.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "grader/checkout/layout.hpp"

namespace mc::grader {

/// What a compiler run with -H has to say: the files it opened, in order, and its messages.
struct CompilerOutput {
  std::vector<std::filesystem::path> opened;
  std::string messages;
};
CompilerOutput parse_compiler_output(const std::string& errors);

/// The files that a make rule ("a.o: b.cpp c.hpp \\") depends on.
std::vector<std::filesystem::path> dependencies(const std::string& rule);

/// Does the text have an #embed, of which -H does not know? Not exactly: a comment with that word
/// has one too.
bool may_embed(std::string text);

/// The first of `files` that a submission must not read, compiled in `directory`: it may read that,
/// the labs, and the system's headers; if it is trusted, all of the repository.
std::optional<std::filesystem::path> forbidden(const Layout& layout, bool trusted,
                                               const std::filesystem::path& directory,
                                               const std::vector<std::filesystem::path>& files);

}  // namespace mc::grader
