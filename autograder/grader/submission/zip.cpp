#include "grader/submission/zip.hpp"

#include <cstddef>
#include <cstdint>
#include <initializer_list>

namespace mc::grader {
namespace {

std::uint32_t crc32(const std::string& bytes) {
  std::uint32_t crc = 0xffffffff;
  for (const char byte : bytes) {
    crc ^= static_cast<unsigned char>(byte);
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ ((crc & 1u) != 0 ? 0xedb88320u : 0u);
  }
  return ~crc;
}

/// Appends the low `bytes` bytes of a value, the lowest first.
void add(std::string& to, std::size_t value, int bytes) {
  for (int i = 0; i < bytes; ++i) to += static_cast<char>(value >> (8 * i) & 0xff);
}
void add16(std::string& to, std::initializer_list<std::size_t> values) {
  for (const std::size_t value : values) add(to, value, 2);
}
void add32(std::string& to, std::initializer_list<std::size_t> values) {
  for (const std::size_t value : values) add(to, value, 4);
}

/// What a file's own header and its entry in the directory share.
void add_description(std::string& to, const ZipEntry& entry) {
  constexpr std::size_t version = 10, utf8_names = 1 << 11, stored = 0;
  constexpr std::size_t midnight = 0, first_of_1980 = (1 << 5) + 1;
  add16(to, {version, utf8_names, stored, midnight, first_of_1980});
  add32(to, {crc32(entry.content), entry.content.size(), entry.content.size()});
  add16(to, {entry.name.size(), 9});  // the size of time_of()
}

/// "UT", 5 bytes, of which the first says that there is one time: that of the last change.
std::string time_of(const ZipEntry& entry) {
  std::string field;
  add16(field, {0x5455, 5});
  add(field, 1, 1);
  add32(field, {static_cast<std::size_t>(entry.modified)});
  return field;
}

}  // namespace

std::string zip_of(const std::vector<ZipEntry>& entries) {
  constexpr std::size_t made_on_unix = (3 << 8) + 10, readable = std::size_t{0100644} << 16;
  std::string files, directory;
  for (const ZipEntry& entry : entries) {
    const std::size_t start = files.size();
    add32(files, {0x04034b50});
    add_description(files, entry);
    files += entry.name + time_of(entry) + entry.content;

    add32(directory, {0x02014b50});
    add16(directory, {made_on_unix});
    add_description(directory, entry);
    add16(directory, {0, 0, 0});
    add32(directory, {readable, start});
    directory += entry.name + time_of(entry);
  }
  std::string end;
  add32(end, {0x06054b50});
  add16(end, {0, 0, entries.size(), entries.size()});
  add32(end, {directory.size(), files.size()});
  add16(end, {0});
  return files + directory + end;
}

}  // namespace mc::grader
