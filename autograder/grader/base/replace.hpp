#pragma once
// Replaces parts of a text.

#include <string>

namespace mc::grader {

/// Replaces each `from` by `to`, from left to right; does not look into what it inserted.
inline void replace_all(std::string& text, const std::string& from, const std::string& to) {
  for (auto at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
}

}  // namespace mc::grader
