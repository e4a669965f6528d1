#include "grader/submission/segments.hpp"

#include <cstdint>

#include "grader/base/text_file.hpp"

namespace mc::grader {

Segments segments_of(const std::filesystem::path& program) {
  const std::string bytes = read_whole_text(program);
  const auto at = [&](std::size_t offset, std::size_t size) {
    std::uint64_t value = 0;
    if (offset + size <= bytes.size()) bytes.copy(reinterpret_cast<char*>(&value), size, offset);
    return value;
  };
  Segments segments;
  if (!bytes.starts_with("\x7f"
                         "ELF\2\1"))
    return segments;  // 64 bits, little endian
  for (std::size_t i = 0; i < at(0x38, 2); ++i) {
    const std::size_t header = at(0x20, 8) + i * at(0x36, 2);
    const auto type = at(header, 4);
    constexpr unsigned load = 1, interpreter = 3, thread_local_storage = 7;
    if (type == load || type == thread_local_storage) segments.memory += at(header + 0x28, 8);
    if (type == interpreter) segments.loader = true;
  }
  return segments;
}

}  // namespace mc::grader
