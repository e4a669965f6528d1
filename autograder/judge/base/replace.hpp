#pragma once
// Replaces parts of a text.

#include <initializer_list>
#include <string>
#include <string_view>

namespace mc::grader {

struct Replacement {
  std::string_view from, to;
};

/// Makes the replacements one after another. Each replaces `from` by `to` wherever it is, from left
/// to right, but not in what it inserted.
inline std::string with_replacements(std::string_view text,
                                     std::initializer_list<Replacement> replacements) {
  std::string all(text);
  for (const auto& [from, to] : replacements) {
    for (auto at = all.find(from); at != std::string::npos; at = all.find(from, at + to.size())) {
      all.replace(at, from.size(), to);
    }
  }
  return all;
}

}  // namespace mc::grader
