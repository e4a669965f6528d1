#pragma once
// A new version of a handout on top of an old one.

#include "grader/commands/manifest.hpp"

namespace mc::grader {

/// The manifest of a tree that was just written for these labs; written into it as well.
Manifest make_manifest(const Context& context, Manifest manifest, const fs::path& tree);

/// Adds one commit to `handout` with what differs in `tree`; returns its message, empty if nothing
/// does. Never touches what its owner has: starter/ and answers/ (new labs' are added), files
/// that the course did not write, and files that were edited.
std::string upgrade(const fs::path& handout, const fs::path& tree);

/// Commits these files, and nothing else that is changed or staged there.
void commit_files(const fs::path& handout, const std::vector<std::string>& files,
                  const std::string& message);

}  // namespace mc::grader
