#pragma once
// Replaces parts of a text.

#include <string>
#include <string_view>

namespace mc::grader {

/// Replaces each `from` by `to`, from left to right; does not look into what it inserted.
inline void replace_all(std::string& text, std::string_view from, std::string_view to) {
  std::string all;
  std::size_t done = 0;
  for (auto at = text.find(from); at != std::string::npos; at = text.find(from, done)) {
    all.append(text, done, at - done) += to;
    done = at + from.size();
  }
  text = all.append(text, done);
}

}  // namespace mc::grader
