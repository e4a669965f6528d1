#pragma once
// Quoting of commands that users copy into a shell.

#include <string>

#include "judge/base/replace.hpp"
#include "sandbox/printable.hpp"

namespace mc::grader {

/// `word` quoted as one word of a POSIX shell, whatever its content. Unprintable characters are
/// dropped, so the command may fail but does nothing else.
inline std::string shell_quoted_value(const std::string& word) {
  std::string shown = sandbox::printable_line(word);
  constexpr const char* plain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789/._-+=:,@%";
  if (!shown.empty() && shown.find_first_not_of(plain) == std::string::npos) return shown;
  return '\'' + with_replacements(shown, {{"'", "'\\''"}}) + '\'';
}

/// The same for a file: a name that begins with a dash does not become an option.
inline std::string shell_quoted(const std::string& file) {
  return shell_quoted_value(file.starts_with('-') ? "./" + file : file);
}

}  // namespace mc::grader
