#pragma once
// Text queries for tests.

#include <cstddef>
#include <string>
#include <vector>

#include "checks/support/catch.hpp"

namespace mc::tests {

inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// The text has each of these parts.
inline void check_contains(const std::string& text, const std::vector<std::string>& parts) {
  for (const std::string& part : parts) {
    CAPTURE(part, text);
    CHECK(contains(text, part));
  }
}

/// The text has none of these parts.
inline void check_lacks(const std::string& text, const std::vector<std::string>& parts) {
  for (const std::string& part : parts) {
    CAPTURE(part, text);
    CHECK_FALSE(contains(text, part));
  }
}

/// How often the text has this part.
inline std::size_t times(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (auto at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++found;
  return found;
}

inline std::size_t lines(const std::string& text) {
  return times(text, "\n");
}

inline std::vector<std::string> joined(std::vector<std::string> words,
                                       const std::vector<std::string>& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

/// The text with `from`, which is in it, replaced by `to`.
inline std::string with_change(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);  // throws if it is not there
}

/// Without the line end. Progress output may come before the line.
inline std::string last_line(std::string text) {
  if (text.ends_with('\n')) text.pop_back();
  return text.substr(text.rfind('\n') + 1);
}

}  // namespace mc::tests
