#pragma once
// Zips, as students and learning platforms make them.

#include <cstddef>
#include <filesystem>
#include <stdexcept>

namespace mc::grader {

/// What was handed in cannot be read, and why: one line. It is nobody's fault but its own.
struct Unreadable : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// What may come out of one zip. Nobody writes that much by hand; a whole class does not.
struct ArchiveLimits {
  std::size_t entries = 20'000;
  std::size_t bytes = std::size_t{512} << 20;  ///< in all
  std::size_t file = std::size_t{64} << 20;    ///< of each zip in it
  std::ptrdiff_t depth = 14;                   ///< parts of a name; deeper entries are left out
};

/// Unpacks below `directory`, which is ours and holds no link: directories, .cpp files and zips. Of
/// other files there is only the name, so that pictures and builds cost nothing; links, .git, build
/// and what macOS adds are left out. Throws Unreadable for what is no zip, leads out of itself, is
/// encrypted or above the limits; std::system_error where the disk is full.
void unpack(const std::filesystem::path& zip, const std::filesystem::path& directory,
            const ArchiveLimits& limits = {});

/// Is this a name that nobody hands in on purpose: .git, __MACOSX, build?
bool is_ignored(const std::filesystem::path& name);

}  // namespace mc::grader
