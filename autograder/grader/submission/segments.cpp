#include "grader/submission/segments.hpp"

#include <cstdint>
#include <string>
#include <string_view>

#include "grader/base/text_file.hpp"

namespace mc::grader {
namespace {

/// A 64-bit, little-endian ELF file. What lies past its end is read as 0.
class ElfFile {
 public:
  explicit ElfFile(const std::filesystem::path& path) : bytes_(read_whole_text(path)) {}
  bool is_valid() const {
    return bytes_.starts_with(
        "\x7f"
        "ELF\2\1");
  }
  std::uint64_t at(std::uint64_t offset, std::size_t size) const {
    std::uint64_t value = 0;
    if (offset < bytes_.size() && size <= bytes_.size() - offset) {
      bytes_.copy(reinterpret_cast<char*>(&value), size, offset);
    }
    return value;
  }
  bool has_text(std::uint64_t offset, std::string_view text) const {
    return offset < bytes_.size() && std::string_view(bytes_).substr(offset).starts_with(text);
  }

 private:
  std::string bytes_;
};

}  // namespace

Segments segments_of(const std::filesystem::path& program) {
  const ElfFile file(program);
  Segments segments;
  if (!file.is_valid()) return segments;
  for (std::size_t i = 0; i < file.at(0x38, 2); ++i) {
    const std::uint64_t header = file.at(0x20, 8) + i * file.at(0x36, 2);
    const auto type = file.at(header, 4);
    constexpr unsigned load = 1, interpreter = 3, thread_local_storage = 7;
    if (type == load || type == thread_local_storage) segments.memory += file.at(header + 0x28, 8);
    if (type == interpreter) segments.loader = true;
  }
  return segments;
}

bool has_variables(const std::filesystem::path& object) {
  const ElfFile file(object);
  const std::uint64_t headers = file.at(0x28, 8), size = file.at(0x3a, 2), count = file.at(0x3c, 2);
  if (!file.is_valid() || count == 0) return true;
  const std::uint64_t names = file.at(headers + file.at(0x3e, 2) * size + 0x18, 8);
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint64_t header = headers + i * size, name = names + file.at(header, 4);
    constexpr unsigned writable = 1, start_functions = 14;
    const bool is_written =
        (file.at(header + 8, 8) & writable) != 0 && file.at(header + 4, 4) != start_functions &&
        !file.has_text(name, ".data.rel.ro") && !file.has_text(name, ".data.rel.local.DW.ref.");
    if (is_written && file.at(header + 0x20, 8) > 0) return true;
  }
  return false;
}

}  // namespace mc::grader
