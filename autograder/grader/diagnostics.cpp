#include "grader/diagnostics.hpp"

#include <regex>
#include <set>

#include <fmt/format.h>

#include "grader/jail.hpp"
#include "runner/text.hpp"

namespace mc::grader {
namespace {

constexpr std::size_t most_lines = 24;
constexpr std::size_t longest_line = 400;  // std::regex recurses once a character

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::string line;
  for (const char c : printable(text)) {
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

std::string joined(const std::vector<std::string>& lines) {
  std::string all;
  for (std::size_t i = 0; i < lines.size() && i < most_lines; ++i) all += lines[i] + '\n';
  if (lines.size() > most_lines) all += fmt::format("… and {} more lines\n", lines.size() - most_lines);
  if (!all.empty()) all.pop_back();
  return all;
}

}  // namespace

std::string first_errors(const std::string& diagnostics) {
  // Warnings come first in time but not in importance: drop each with the lines that follow it.
  static const std::regex location("^[^ ].*?:[0-9]+:[0-9]+: (\\w+).*");
  std::vector<std::string> kept;
  bool keep = true;
  for (const std::string& line : lines_of(diagnostics)) {
    std::smatch found;
    if (std::regex_match(line, found, location)) {
      keep = found[1] == "error" || found[1] == "fatal" || (found[1] == "note" && keep);
    } else if (line.find(": In ") != std::string::npos || line.starts_with("In file included")) {
      keep = true;
    }
    if (keep && line.find("compilation terminated") == std::string::npos) kept.push_back(line);
  }
  return joined(kept);
}

std::string own_lines_only(const std::string& diagnostics, const std::string& file) {
  std::vector<std::string> kept;
  for (const std::string& line : lines_of(diagnostics)) {
    if (line.starts_with(file + ":")) kept.push_back(line);
  }
  if (kept.empty()) return fmt::format("{} does not compile: something it includes does not.", file);
  return fmt::format("{} does not compile:\n{}", file, joined(kept));
}

std::string explain_link_errors(const std::string& diagnostics, const Lab& lab) {
  static const std::regex undefined("undefined (?:reference to|symbol:) [`']?([^`']+)'?");
  static const std::regex twice("multiple definition of [`']?([^`';]+)'?");
  std::set<std::string> missing, doubled;
  for (const std::string& line : lines_of(diagnostics)) {
    std::smatch found;
    if (std::regex_search(line, found, undefined)) missing.insert(found[1]);
    if (std::regex_search(line, found, twice)) doubled.insert(found[1]);
  }
  std::vector<std::string> lines;
  for (const std::string& name : missing) {
    const std::string plain = name.substr(0, name.find('('));
    lines.push_back(plain.starts_with("mc::")
                        ? fmt::format("Your {} does not define `{}` with the parameters that {} "
                                      "declares.",
                                      lab.file(), plain, lab.header())
                        : fmt::format("Your {} uses `{}`, which nothing defines.", lab.file(), name));
  }
  for (const std::string& name : doubled) {
    lines.push_back(name == "main"
                        ? fmt::format("Your {} defines `main`; the labs bring their own.", lab.file())
                        : fmt::format("`{}` is defined twice.", name));
  }
  if (lines.empty()) {
    lines = lines_of(diagnostics);
    lines.insert(lines.begin(), fmt::format("{} does not link:", lab.file()));
  }
  return printable(joined(lines));
}

}  // namespace mc::grader
