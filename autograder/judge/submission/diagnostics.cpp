#include "judge/submission/diagnostics.hpp"

#include <algorithm>
#include <charconv>
#include <optional>
#include <set>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "runner/text.hpp"
#include "sandbox/printable.hpp"

namespace mc::grader {
namespace {

constexpr std::size_t most_lines = 24;
constexpr std::size_t longest_line = 400;

/// Headers that every compilation includes, and names that a file needs them for.
constexpr struct {
  std::string_view header, names;
} included_anyway[] = {
    {"algorithm", " max max_element min min_element nth_element shuffle sort stable_sort "},
    {"array", " array "},
    {"cmath", " abs cos exp floor fma hypot isfinite isinf isnan log pow sin sqrt "},
    {"functional", " function greater hash less plus "},
    {"limits", " numeric_limits "},
    {"numeric", " accumulate inner_product iota partial_sum reduce transform_reduce "},
};

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::string line;
  for (const char c : sandbox::printable(text)) {
    if (c != '\n') {
      if (line.size() < longest_line) line += c;
    } else {
      lines.push_back(std::move(line));
      line.clear();
    }
  }
  if (!line.empty()) lines.push_back(line);
  return lines;
}

/// Lines of a message from the text. They are marked, except for positions in the file `name`:
/// these are what editors look for.
std::string joined(const std::vector<std::string>& lines, const std::string& name) {
  std::string all;
  for (std::size_t i = 0; i < lines.size() && i < most_lines; ++i) {
    const bool is_safe = lines[i].starts_with(name + ':') || lines[i].starts_with("| ");
    all += (is_safe ? "" : "| ") + lines[i] + '\n';
  }
  if (lines.size() > most_lines)
    all += fmt::format("… and {} more lines\n", lines.size() - most_lines);
  if (!all.empty()) all.pop_back();
  return all;
}

/// The word after "file:12:5: ": error, warning, note, fatal; empty for any other line.
std::string_view severity(std::string_view line) {
  const auto parts = text::split(line.substr(0, line.find_first_of("`'\"")), ':');
  const auto is_number = [](std::string_view part) {
    return !part.empty() && part.find_first_not_of("0123456789") == std::string_view::npos;
  };
  for (std::size_t i = 1; i + 2 < parts.size(); ++i) {
    if (is_number(parts[i]) && is_number(parts[i + 1])) {
      return parts[i + 2].substr(0, parts[i + 2].find(' '));
    }
  }
  return {};
}

/// Adds the source line of "file:12:5: error: …", with a caret under the column.
void quote(const std::string& line, const std::vector<std::string>& source,
           std::vector<std::string>& to) {
  const auto parts = text::split(line, ':');
  const auto number = [&](std::size_t i) {
    std::size_t value = 0;
    if (i < parts.size())
      std::from_chars(parts[i].data(), parts[i].data() + parts[i].size(), value);
    return value;
  };
  const std::size_t row = number(1), column = number(2);
  if (row == 0 || row > source.size() || column == 0 || column > source[row - 1].size() + 1) return;
  // Blanks up to the caret; tabs stay, so that it is below the right character.
  std::string blanks = source[row - 1].substr(0, column - 1);
  for (char& c : blanks) c = c == '\t' ? '\t' : ' ';
  to.push_back("| " + source[row - 1]);
  to.push_back("| " + blanks + '^');
}

/// What follows `words` in a linker's line, up to the closing quote.
std::optional<std::string> quoted_after(std::string_view line, std::string_view words) {
  const auto at = line.find(words);
  if (at == std::string_view::npos) return {};
  line.remove_prefix(at + words.size());
  while (!line.empty() && (line.front() == '`' || line.front() == '\'' || line.front() == ' ')) {
    line.remove_prefix(1);
  }
  return std::string(line.substr(0, line.find_first_of("`';")));
}

}  // namespace

bool is_error(std::string_view line) {
  return severity(line) == "error" || severity(line) == "fatal";
}

std::string first_errors(const std::string& diagnostics, const NamedText& file) {
  const std::vector<std::string> source = lines_of(file.text);
  // Warnings come first but matter less: drop each with its continuation lines.
  std::vector<std::string> kept;
  bool keep = true;
  for (const std::string& line : lines_of(diagnostics)) {
    if (const auto kind = severity(line); !kind.empty()) {
      keep = kind == "error" || kind == "fatal" || (kind == "note" && keep);
    } else if (line.find(": In ") != std::string::npos || line.starts_with("In file included")) {
      keep = true;
    }
    if (!keep || line.find("compilation terminated") != std::string::npos) continue;
    kept.push_back(line);
    if (line.starts_with(file.name + ':')) quote(line, source, kept);
  }
  return joined(kept, file.name);
}

std::string missing_include(const NamedText& file) {
  const std::string& text = file.text;
  for (auto at = text.find("std::"); at != text.npos; at = text.find("std::", at + 1)) {
    if (text.find("//", text.rfind('\n', at) + 1) < at) continue;  // in a comment
    const auto end = text.find_first_not_of("abcdefghijklmnopqrstuvwxyz_0123456789", at + 5);
    const std::string name = text.substr(at + 5, std::min(end, text.size()) - at - 5);
    for (const auto& [header, names] : included_anyway) {
      if (names.find(' ' + name + ' ') == names.npos ||
          text.find(fmt::format("<{}>", header)) != text.npos) {
        continue;
      }
      return fmt::format(
          "{} uses std::{} without #include <{}>. It compiles here, but may not elsewhere.",
          file.name, name, header);
    }
  }
  return {};
}

std::string explain_link_errors(const std::string& diagnostics, const Lab& lab,
                                const std::map<std::string, std::string>& headers) {
  // The lab whose header declares it, if one does; this lab's header comes first.
  const auto owner_of = [&](const std::string& plain) -> std::string {
    const std::string declared = ' ' + plain.substr(plain.rfind(':') + 1) + '(';
    const auto declares = [&](const auto& header) {
      return header.second.find(declared) != std::string::npos;
    };
    const auto own = headers.find(lab.name);
    if (own != headers.end() && declares(*own)) return lab.name;
    const auto other = std::ranges::find_if(headers, declares);
    return other == headers.end() ? "" : other->first;
  };
  const auto is_linked = [&](const std::string& name) {
    return name == lab.name || std::ranges::find(lab.depends_on, name) != lab.depends_on.end();
  };
  std::set<std::string> missing, doubled;
  const std::pair<const char*, std::set<std::string>&> messages[] = {
      // of bfd, of lld
      {"undefined reference to", missing},
      {"undefined symbol:", missing},
      {"multiple definition of", doubled},
      {"duplicate symbol:", doubled}};
  for (const std::string& line : lines_of(diagnostics)) {
    for (const auto& [words, names] : messages) {
      if (const auto name = quoted_after(line, words)) names.insert(*name);
    }
  }
  std::vector<std::string> lines;
  for (const std::string& name : missing) {
    const std::string plain = name.substr(0, name.find('('));
    const std::string owner = owner_of(plain);
    if (owner.empty() || !plain.starts_with("mc::")) {
      lines.push_back(
          fmt::format("Your {} uses `{}`, which is not defined anywhere.", lab.file(), name));
    } else if (is_linked(owner)) {
      lines.push_back(fmt::format(
          "Your {0}.cpp does not define `{1}` with the parameters that {0}.hpp declares.", owner,
          plain));
    } else {
      lines.push_back(fmt::format(
          "Your {0} uses `{1}`, which {2}.cpp defines; lab {3} is linked with {4}. Copy the "
          "function into {0}, in an unnamed namespace.",
          lab.file(), plain, owner, lab.number,
          lab.depends_on.empty() ? "no other lab"
                                 : fmt::format("{} only", fmt::join(lab.depends_on, ", "))));
    }
  }
  for (const std::string& name : doubled) {
    lines.push_back(
        name == "main"
            ? fmt::format("Your {} defines `main`, but the labs have their own.", lab.file())
            : fmt::format("`{}` is defined twice.", name));
  }
  if (lines.empty()) {
    return fmt::format("{} does not link:\n{}", lab.file(),
                       joined(lines_of(diagnostics), lab.file()));
  }
  if (lines.size() > most_lines) {
    lines[most_lines] = fmt::format("… and {} more lines", lines.size() - most_lines);
    lines.resize(most_lines + 1);
  }
  return fmt::format("{}", fmt::join(lines, "\n"));
}

}  // namespace mc::grader
