#pragma once
// Reads the headers of ELF programs.

#include <cstddef>
#include <filesystem>

namespace mc::grader {

/// What a static ELF program requires of the machine before it starts.
struct Segments {
  std::size_t memory = 0;  ///< globals and code, including those per thread
  bool loader = false;     ///< it needs another program (an interpreter) to start it
};

/// For a 64-bit ELF file; nothing for any other.
Segments segments_of(const std::filesystem::path& program);

}  // namespace mc::grader
