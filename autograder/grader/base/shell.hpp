#pragma once
// Quoting of commands that users copy into a shell.

#include <algorithm>
#include <string>

#include "sandbox/printable.hpp"

namespace mc::grader {

/// `word` quoted as one word of a POSIX shell, whatever its content. Unprintable characters are
/// dropped, so the command may fail but does nothing else.
inline std::string shell_quoted_value(const std::string& word) {
  std::string shown = sandbox::printable_line(word);
  const bool plain = !shown.empty() && std::all_of(shown.begin(), shown.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
           std::string_view("/._-+=:,@%").find(c) != std::string_view::npos;
  });
  if (plain) return shown;
  std::string quoted = "'";
  for (const char c : shown) quoted += c == '\'' ? "'\\''" : std::string(1, c);
  return quoted + "'";
}

/// The same for a file: a name that begins with a dash does not become an option.
inline std::string shell_quoted(const std::string& file) {
  return shell_quoted_value(file.starts_with('-') ? "./" + file : file);
}

}  // namespace mc::grader
