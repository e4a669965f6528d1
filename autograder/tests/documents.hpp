#pragma once
// The documents of the repository, and the commands in them.

#include <algorithm>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "grader/checkout/labs.hpp"
#include "grader/checkout/layout.hpp"

namespace mc::tests {

using Words = std::vector<std::string>;

/// The prompt before a command whose output the document shows.
inline constexpr std::string_view prompt = "$ ";

/// Words as a shell splits them, up to a comment; documents may also separate a comment by blanks.
inline Words words_of(std::string_view line) {
  Words words;
  std::string word;
  bool in_word = false;
  char quote = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (quote != 0) {
      if (c == quote) {
        quote = 0;
      } else {
        word += c;
      }
    } else if (c == '"' || c == '\'') {
      quote = c;
      in_word = true;
    } else if (c == ' ' || c == '\n') {
      if (in_word) words.push_back(word);
      word.clear();
      in_word = false;
      if (line.substr(i).starts_with("  ") || line.substr(i).starts_with(" #")) return words;
    } else {
      word += c;
      in_word = true;
    }
  }
  if (in_word) words.push_back(word);
  return words;
}

/// A document as readers see it: without <!-- comments --> and the line ends after them.
inline std::string without_comments(std::string document) {
  constexpr std::string_view opening = "<!--", closing = "-->";
  for (auto at = document.find(opening); at != std::string::npos; at = document.find(opening, at)) {
    auto end = std::min(document.find(closing, at), document.size() - closing.size());
    end += closing.size();
    if (end < document.size() && document[end] == '\n') ++end;
    document.erase(at, end - at);
  }
  return document;
}

/// The documents that contain commands to type.
inline std::vector<std::filesystem::path> documents(const grader::Layout& layout) {
  std::vector<std::filesystem::path> all{layout.root / "README.md", layout.root / "CONTRIBUTING.md",
                                         layout.root / "docs" / "handout" / "README.md"};
  for (const auto& entry : std::filesystem::recursive_directory_iterator(layout.root / "docs")) {
    if (entry.path().extension() == ".md" && entry.path() != all[2]) all.push_back(entry.path());
  }
  for (const grader::Lab& lab : grader::find_labs(layout)) {
    all.push_back(layout.labs() / lab.folder / "README.md");
  }
  return all;
}

}  // namespace mc::tests
