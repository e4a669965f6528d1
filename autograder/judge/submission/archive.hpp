#pragma once
// Zips and other archives, as students and learning platforms make them.

#include <cstddef>
#include <filesystem>
#include <stdexcept>
#include <string>

namespace mc::grader {

/// A submission cannot be read, and why, in one line. Others are not affected.
struct UnreadableSubmission : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Limits for one archive: far above a handwritten submission, and above a whole class.
struct ArchiveLimits {
  std::size_t entries = 20'000;
  std::size_t bytes = std::size_t{512} << 20;  ///< in all
  std::size_t file = std::size_t{64} << 20;    ///< of each archive in it
  std::ptrdiff_t depth = 14;                   ///< parts of a name; deeper entries are left out
};

/// Does the name say so: .zip, .tar, .tar.gz, .tgz, .7z, …, in any case? (A .rar, too, which cannot
/// be unpacked: its row says so.)
bool is_archive(const std::filesystem::path& file);

/// "ann" for "ann.tar.gz".
std::string without_archive_extension(const std::string& name);

struct Unpacking {
  std::filesystem::path archive, to;
};
/// Unpacks directories, .cpp files and archives into `to`, which must be ours and hold no links.
/// Other files are created empty, so that pictures and builds cost nothing; links, .git and what
/// macOS adds are left out. Throws UnreadableSubmission for a file that is not an archive,
/// escapes `to`, is encrypted or exceeds the limits; std::system_error if the disk is full.
void unpack(const Unpacking& paths, const ArchiveLimits& limits = {});

/// Is this the name of something that is never submitted on purpose: .git, __MACOSX, build?
bool is_ignored(const std::filesystem::path& name);

}  // namespace mc::grader
