#pragma once
// What a handout says of itself: its version, its labs, and the files that the course wrote.

#include <map>
#include <set>

#include "grader/commands/command.hpp"

namespace mc::grader {

inline constexpr const char* manifest_file = "autograder/handout.txt";

struct Manifest {
  std::string version;
  std::string form;   ///< "compiled" or "sources"
  std::string hints;  ///< the number of steps; empty: all
  std::set<std::string> labs;
  std::map<std::string, std::string> checks;  ///< lab -> a hash of its checks
  std::map<std::string, std::string> files;   ///< path -> a hash of its text
};

/// Empty where there is no manifest: not a handout.
Manifest read_manifest(const fs::path& handout);
void write_manifest(const fs::path& handout, const Manifest& manifest);

/// Of a file's text, for comparing versions of it.
std::string hash_of_file(const fs::path& file);

}  // namespace mc::grader
