#include "grader/submission/segments.hpp"

#include <cstdint>
#include <string>

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

}  // namespace mc::grader
