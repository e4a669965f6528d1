#pragma once
// The documents of the repository, and the commands in them.

#include <algorithm>
#include <regex>
#include <string_view>

#include "tests/submissions.hpp"

namespace mc::tests {

/// The prompt before a command whose output the document shows.
inline constexpr std::string_view prompt = "$ ";

/// Words as a shell splits them, up to a comment; documents may also separate a comment by blanks.
inline Words words_of(const std::string& line) {
  static const std::regex word(R"re((?:"[^"]*"|'[^']*'|[^\s"'])+)re");
  Words words;
  for (std::sregex_iterator found(line.begin(), line.end(), word), end; found != end; ++found) {
    std::string text = found->str();
    const bool ends = found->prefix().str().starts_with("  ") || text.starts_with('#');
    if (ends && !words.empty()) break;
    std::erase_if(text, [](char c) { return c == '"' || c == '\''; });
    words.push_back(text);
  }
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
inline std::vector<fs::path> documents(const Layout& layout) {
  std::vector<fs::path> all{layout.root / "README.md", layout.root / "CONTRIBUTING.md",
                            layout.root / "docs" / "handout" / "README.md"};
  for (const auto& entry : fs::recursive_directory_iterator(layout.root / "docs")) {
    if (entry.path().extension() == ".md" && entry.path() != all[2]) all.push_back(entry.path());
  }
  for (const Lab& lab : find_labs(layout)) {
    all.push_back(layout.labs() / lab.folder / "README.md");
  }
  return all;
}

}  // namespace mc::tests
