#pragma once
// What tests ask of a text.

#include <algorithm>
#include <cstddef>
#include <string>

namespace mc::tests {

inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

inline std::size_t lines(const std::string& text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

}  // namespace mc::tests
