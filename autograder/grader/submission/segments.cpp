#include "grader/submission/segments.hpp"

#include <cstdint>
#include <string>

#include "grader/base/text_file.hpp"

namespace mc::grader {

Segments segments_of(const std::filesystem::path& program) {
  const std::string bytes = read_whole_text(program);
  // A little-endian number; 0 past the end of the file.
  const auto at = [&](std::uint64_t offset, std::size_t size) {
    std::uint64_t value = 0;
    if (offset < bytes.size() && size <= bytes.size() - offset) {
      bytes.copy(reinterpret_cast<char*>(&value), size, offset);
    }
    return value;
  };
  constexpr char elf_64_little_endian[] = {0x7f, 'E', 'L', 'F', 2, 1, 0};
  Segments segments;
  if (!bytes.starts_with(elf_64_little_endian)) return segments;
  for (std::size_t i = 0; i < at(0x38, 2); ++i) {
    const std::uint64_t header = at(0x20, 8) + i * at(0x36, 2);
    const auto type = at(header, 4);
    constexpr unsigned load = 1, interpreter = 3, thread_local_storage = 7;
    if (type == load || type == thread_local_storage) segments.memory += at(header + 0x28, 8);
    if (type == interpreter) segments.loader = true;
  }
  return segments;
}

}  // namespace mc::grader
