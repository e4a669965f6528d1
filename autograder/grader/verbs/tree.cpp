#include "grader/verbs/tree.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "grader/context/errors.hpp"
#include "runner/text.hpp"
#include "sandbox/printable.hpp"
#include "sandbox/process.hpp"

namespace mc::grader {
namespace fs = std::filesystem;
namespace {

/// What holds answers, or is of use to instructors only.
constexpr const char* kept_back[] = {"solutions/",
                                     "docs/",
                                     "autograder/submissions/",
                                     "autograder/tests/",
                                     "autograder/bench/",
                                     "autograder/gradescope/",
                                     ".ci/",
                                     ".github/",
                                     "README.md",
                                     "CONTRIBUTING.md",
                                     "CHANGELOG.md",
                                     "CITATION.cff"};

bool is_kept_back(const std::string& file) {
  return std::any_of(std::begin(kept_back), std::end(kept_back),
                     [&](const char* place) { return file.starts_with(place); });
}

/// Is this file of a lab that is not handed out?
bool is_left_out(const Context& context, const std::set<std::string>& chosen,
                 const std::string& file) {
  for (const Lab& lab : context.labs) {
    if (chosen.contains(lab.name)) continue;
    for (const std::string& place :
         {"labs/" + lab.folder + '/', "starter/" + lab.file(),
          "autograder/checks/" + lab.name + '/', "autograder/measurements/" + lab.name + '/'}) {
      if (file.starts_with(place)) return true;
    }
  }
  return false;
}

/// Throws UsageError, naming the files, where a file that would be handed out is not committed as it
/// is: what git does not know would be missing, and nobody would see it.
void require_committed(const Context& context, const std::set<std::string>& chosen) {
  const std::string listed = git(context.layout.root, {"status", "--porcelain", "-z",
                                                       "--untracked-files=all", "--no-renames"});
  std::string changed;
  std::size_t count = 0;
  for (const std::string_view entry : text::split(listed, '\0')) {
    if (entry.size() < 4) continue;
    const std::string file(entry.substr(3));  // "?? name", " M name"
    if (is_kept_back(file) || is_left_out(context, chosen, file)) continue;
    if (++count <= 10) changed += "\n  " + sandbox::printable_line(file);
  }
  if (count == 0) return;
  throw UsageError(fmt::format("{} {} not committed; commit or remove first:{}{}", count,
                               count == 1 ? "file is" : "files are", changed,
                               count > 10 ? "\n  …" : ""));
}

}  // namespace

std::string git(const fs::path& directory, std::vector<std::string> words) {
  words.insert(words.begin(), {"git", "-C", directory.string()});
  const auto run = sandbox::run_process(words);
  if (!run.succeeded()) {
    throw MachineError(fmt::format("{}: {}", fmt::join(words, " "),
                                   sandbox::printable_line(run.errors.substr(0, 200))));
  }
  return run.output;
}

std::set<std::string> labs_and_those_below(const Context& context,
                                           const std::optional<std::string>& list) {
  std::set<std::string> chosen;
  if (!list) {
    for (const Lab& lab : context.labs) chosen.insert(lab.name);
    return chosen;
  }
  for (const std::string_view word : text::split(*list, ',')) {
    const Lab& lab = find_lab(context.labs, std::string(word));
    chosen.insert(lab.name);
    chosen.insert(lab.stands_on.begin(), lab.stands_on.end());
  }
  return chosen;
}

std::vector<std::string> files_without_answers(const Context& context,
                                               const std::set<std::string>& labs) {
  std::vector<std::string> files;
  require_committed(context, labs);
  const std::string listed = git(context.layout.root, {"ls-files", "-z"});
  for (const std::string_view name : text::split(listed, '\0')) {
    const std::string file(name);
    if (!file.empty() && !is_kept_back(file) && !is_left_out(context, labs, file)) {
      files.push_back(file);
    }
  }
  return files;
}

void copy_into(const fs::path& from, const fs::path& to) {
  fs::create_directories(to.parent_path());
  fs::copy_file(from, to);
}

}  // namespace mc::grader
