#pragma once
// Reads and writes whole files.

#include <cerrno>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <system_error>

#include <unistd.h>

namespace mc::grader {

/// The rest of a stream, read in blocks: character by character, this would take most of the time
/// of a run with a cached program.
inline std::string rest_of(std::istream& file) {
  std::string text;
  char piece[1 << 14];
  while (file.read(piece, sizeof piece), file.gcount() > 0) {
    text.append(piece, static_cast<std::size_t>(file.gcount()));
  }
  return text;
}

inline std::string read_text(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return rest_of(file);
}

/// The same, but throws std::system_error if the file does not exist or cannot be read: for texts
/// whose absence must not pass for an empty file.
inline std::string read_whole_text(const std::filesystem::path& path) {
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  std::string text = rest_of(file);
  if (!file.is_open() || file.bad() || errno == EIO) {
    throw std::system_error(errno == 0 ? EIO : errno, std::generic_category(),
                            "cannot read " + path.string());
  }
  return text;
}

/// Writes a temporary file and renames it, so readers see either the old text or the new one.
/// Throws std::system_error if that fails (full disk, no such directory); the old text stays.
inline void write_text(const std::filesystem::path& path, std::string_view text) {
  auto temporary = path;
  temporary += ".new-" + std::to_string(getpid());
  std::ofstream file(temporary, std::ios::binary);
  file << text;
  file.close();
  std::error_code error;
  if (!file) {
    error = std::error_code(errno, std::generic_category());
  } else {
    std::filesystem::rename(temporary, path, error);
  }
  if (error) {
    std::error_code ignored;
    std::filesystem::remove(temporary, ignored);
    throw std::system_error(error, "cannot write " + path.string());
  }
}

/// FNV-1a, to name files by the text they depend on. Not for security.
inline std::uint64_t hash_text(std::string_view text, std::uint64_t hash = 0xcbf29ce484222325u) {
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
  return hash;
}

}  // namespace mc::grader
