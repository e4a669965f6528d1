#include "grader/submission/include_policy.hpp"

#include <algorithm>
#include <map>
#include <mutex>
#include <system_error>

#include "grader/base/replace.hpp"
#include "runner/text.hpp"
#include "sandbox/process.hpp"

namespace mc::grader {
namespace fs = std::filesystem;
namespace {

/// Is `path` below `directory`? Both canonical.
bool is_below(const fs::path& path, const fs::path& directory) {
  return std::mismatch(directory.begin(), directory.end(), path.begin(), path.end()).first ==
         directory.end();
}

/// The compiler's search path for system headers.
std::vector<fs::path> system_directories(const Layout& layout) {
  static std::mutex mutex;
  static std::map<std::string, std::vector<fs::path>> known;
  const std::lock_guard lock(mutex);
  auto& directories = known[layout.compiler];
  if (!directories.empty()) return directories;
  const auto listed =
      sandbox::run_process({layout.compiler, "-E", "-x", "c++", "-v", "/dev/null"}).errors;
  bool inside = false;
  for (const std::string_view line : text::split(listed, '\n')) {
    if (line.starts_with("End of search list")) inside = false;
    if (inside) {
      std::error_code missing;
      auto directory = fs::canonical(line.substr(0, line.find(" (")), missing);
      if (!missing) directories.push_back(std::move(directory));
    }
    if (line.starts_with("#include <...>")) inside = true;
  }
  return directories;
}

}  // namespace

CompilerOutput parse_compiler_output(const std::string& errors) {
  CompilerOutput output;
  for (const std::string_view line : text::split(errors, '\n')) {
    const auto blank = line.find_first_not_of(".!");
    if (blank != std::string_view::npos && blank > 0 && line[blank] == ' ') {
      output.opened.emplace_back(line.substr(blank + 1));  // ".. file", "! file.gch"
    } else if (!line.empty() && line[0] != '/' &&
               line != "Multiple include guards may be useful for:") {
      // GCC's advice at the end is a list of paths, not a message. No line reliably ends the list
      // of opened files, because a submission can print any line.
      output.messages += std::string(line) + '\n';
    }
  }
  return output;
}

std::vector<fs::path> dependencies(const std::string& rule) {
  std::vector<fs::path> files;
  std::string word;
  const auto colon = rule.find(": ");
  if (colon == std::string::npos) return files;
  for (std::size_t i = colon + 2; i <= rule.size(); ++i) {
    const char c = i < rule.size() ? rule[i] : '\n';
    const char next = i + 1 < rule.size() ? rule[i + 1] : '\n';
    if (c == '\\' && (next == ' ' || next == '#' || next == '\\')) {
      word += rule[++i];
    } else if (c == '$' && next == '$') {
      word += rule[++i];
    } else if (c == ' ' || c == '\n' || (c == '\\' && next == '\n')) {
      if (!word.empty()) files.emplace_back(word);
      word.clear();
    } else {
      word += c;
    }
  }
  return files;
}

bool may_embed(std::string_view text) {
  const std::string joined = with_replacements(text, {{"\\\n", ""}, {"\\\r\n", ""}});
  return joined.find("embed") != std::string::npos;
}

std::optional<fs::path> forbidden(const Layout& layout, bool trusted, const fs::path& directory,
                                  const std::vector<fs::path>& files) {
  const std::vector<fs::path> system = system_directories(layout);
  std::vector<fs::path> allowed = system;
  allowed.push_back(fs::canonical(layout.labs()));
  allowed.push_back(fs::canonical(directory));
  allowed.push_back(fs::weakly_canonical(layout.build / "precompiled"));
  if (trusted) allowed.push_back(fs::canonical(layout.root));
  const auto is_below_one = [](const fs::path& path, const std::vector<fs::path>& places) {
    return std::ranges::any_of(places, [&](auto& place) { return is_below(path, place); });
  };
  for (const fs::path& file : files) {
    const fs::path path = file.is_absolute() ? file : directory / file;
    if (is_below_one(fs::weakly_canonical(path), allowed)) continue;
    // A system header may itself be a link to elsewhere: Debian 13 has the kernel's in /usr/lib.
    if (is_below_one(fs::weakly_canonical(path.parent_path()) / path.filename(), system)) continue;
    return file;
  }
  return {};
}

}  // namespace mc::grader
