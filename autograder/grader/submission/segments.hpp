#pragma once
// What a program's file says of it.

#include <cstddef>
#include <filesystem>

namespace mc::grader {

/// What a static ELF program asks of the machine before its first line.
struct Segments {
  std::size_t memory = 0;  ///< globals and code, those of a thread included
  bool loader = false;     ///< another program, to be started in its place
};

/// Of a 64-bit ELF file; nothing of any other.
Segments segments_of(const std::filesystem::path& program);

}  // namespace mc::grader
