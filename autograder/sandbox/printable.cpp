#include "sandbox/printable.hpp"

#include <algorithm>
#include <cstdint>

namespace mc::sandbox {
namespace {

/// Characters that change the writing direction, end lines, or are invisible (Unicode's Cf and the
/// separators): with them a text can look like another one.
bool is_deceptive(std::uint32_t point) {
  return point == 0xad || point == 0x61c || point == 0x180e ||  // soft hyphen, Arabic mark
         (point >= 0x200b && point <= 0x200f) || (point >= 0x2028 && point <= 0x202e) ||
         (point >= 0x2060 && point <= 0x206f) || point == 0xfeff ||
         (point >= 0xfff9 && point <= 0xfffb) || (point >= 0xe0000 && point <= 0xe007f);
}

}  // namespace

std::string printable(std::string_view text) {
  std::string clean;
  clean.reserve(text.size());
  for (std::size_t i = 0; i < text.size();) {
    const auto byte = static_cast<unsigned char>(text[i]);
    // The length that a UTF-8 sequence claims, and the smallest code point of that length.
    const std::size_t length = byte < 0x80       ? 1
                               : byte >> 5 == 6  ? 2
                               : byte >> 4 == 14 ? 3
                               : byte >> 3 == 30 ? 4
                                                 : 0;
    std::uint32_t point = length == 1 ? byte : length == 0 ? 0 : byte & (0x7fu >> length);
    bool whole = length > 0 && i + length <= text.size();
    for (std::size_t j = 1; whole && j < length; ++j) {
      const auto next = static_cast<unsigned char>(text[i + j]);
      whole = next >> 6 == 2;
      point = point << 6 | (next & 0x3fu);
    }
    constexpr std::uint32_t smallest[] = {0, 0, 0x80, 0x800, 0x10000};
    const bool allowed =
        whole && point >= smallest[length] && point <= 0x10ffff &&
        !(point >= 0xd800 && point <= 0xdfff) && (point & 0xfffe) != 0xfffe &&
        !is_deceptive(point) &&
        (point >= 0xa0 || (point >= 0x20 && point < 0x7f) || point == '\n' || point == '\t') &&
        !(byte == '[' && clean.ends_with("##"));  // ##[ is a command to GitHub, anywhere in a line
    if (allowed) {
      clean.append(text.substr(i, length));
      i += length;
    } else {
      clean += '?';
      ++i;
    }
  }
  return clean;
}

std::string printable_line(std::string_view text) {
  std::string line = printable(text);
  std::replace_if(
      line.begin(), line.end(), [](char c) { return c == '\n' || c == '\t'; }, ' ');
  return line;
}

std::string marked(std::string_view text) {
  std::string all;
  while (!text.empty()) {
    const auto end = text.find('\n');
    all += "| " + std::string(text.substr(0, end)) + '\n';
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
  return all;
}

std::string shortened(std::string_view text, std::size_t most) {
  if (text.size() <= most) return std::string(text);
  while (most > 0 && (static_cast<unsigned char>(text[most]) & 0xc0) == 0x80) --most;
  return std::string(text.substr(0, most)) + " …";
}

}  // namespace mc::sandbox
