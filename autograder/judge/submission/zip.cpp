#include "judge/submission/zip.hpp"

#include <cstddef>
#include <cstdint>

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

/// The low bytes of a value, the lowest first.
std::string number(std::size_t value, int bytes) {
  std::string all;
  for (int i = 0; i < bytes; ++i) all += static_cast<char>(value >> (8 * i) & 0xff);
  return all;
}
std::string two_bytes(std::size_t value) {
  return number(value, 2);
}
std::string four_bytes(std::size_t value) {
  return number(value, 4);
}

}  // namespace

std::string zip_of(const std::vector<ZipEntry>& entries) {
  constexpr std::size_t version = 10, made_on_unix = 3 << 8, utf8_names = 1 << 11, stored = 0;
  constexpr std::size_t midnight = 0, first_of_1980 = (1 << 5) + 1, readable = 0100644;
  std::string files, directory;
  for (const auto& [name, content, modified] : entries) {
    // "UT", 5 bytes, of which the first says that there is one time: that of the last change.
    const std::string time =
        "UT" + two_bytes(5) + number(1, 1) + four_bytes(static_cast<std::size_t>(modified));
    const std::string description =
        two_bytes(version) + two_bytes(utf8_names) + two_bytes(stored) + two_bytes(midnight) +
        two_bytes(first_of_1980) + four_bytes(crc32(content)) + four_bytes(content.size()) +
        four_bytes(content.size()) + two_bytes(name.size()) + two_bytes(time.size());
    constexpr std::size_t comment = 0, disk = 0, attributes = 0;
    directory += "PK\1\2" + two_bytes(made_on_unix + version) + description + two_bytes(comment) +
                 two_bytes(disk) + two_bytes(attributes) + four_bytes(readable << 16) +
                 four_bytes(files.size()) + name + time;
    files += "PK\3\4" + description + name + time + content;
  }
  const std::string count = two_bytes(entries.size());
  return files + directory + "PK\5\6" + four_bytes(0) + count + count +
         four_bytes(directory.size()) + four_bytes(files.size()) + two_bytes(0);
}

}  // namespace mc::grader
