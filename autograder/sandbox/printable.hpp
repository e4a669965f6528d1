#pragma once
// Makes untrusted text safe to show.

#include <cstddef>
#include <string>
#include <string_view>

namespace mc::sandbox {

/// `text` with everything that is not printable ASCII or well-formed UTF-8 replaced by '?', so that
/// it is valid in a terminal, in JSON and in XML; line ends and tabs stay. Also replaces characters
/// that change the writing direction or are invisible, and the '[' of "##[", a command to GitHub's
/// runners: readers see the text as it really is.
std::string printable(std::string_view text);

/// The same on one line: line ends and tabs become blanks. For names.
std::string printable_line(std::string_view text);

/// Each line of `text` after "| ": none can pass for a line of a report, or for a command to a
/// runner ("::notice …").
std::string marked(std::string_view text);

/// The beginning of `text`, at most `most` bytes, without splitting a UTF-8 sequence; with " …" if
/// something is missing.
std::string shortened(std::string_view text, std::size_t most);

}  // namespace mc::sandbox
