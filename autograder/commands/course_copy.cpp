#include "commands/course_copy.hpp"

#include <sys/utsname.h>

#include <algorithm>

#include <nlohmann/json.hpp>

#include "commands/git.hpp"
#include "judge/judging/points.hpp"
#include "runner/text.hpp"

namespace mc::grader {
namespace {

/// Files that hold answers or are for instructors only.
constexpr const char* kept_back[] = {"solutions/",
                                     "docs/",
                                     "autograder/submissions/",
                                     "autograder/tests/",
                                     "autograder/bench/",
                                     "autograder/gradescope/",
                                     "autograder/new-lab/",
                                     ".ci/",
                                     ".github/",
                                     "README.md",
                                     "SECURITY.md",
                                     "REUSE.toml",
                                     "CONTRIBUTING.md",
                                     "CHANGELOG.md",
                                     "CITATION.cff",
                                     "points.csv"};  // the last is copied where it belongs

/// What only a judge with sources needs.
constexpr const char* sources_of_the_judge[] = {"autograder/", "cmake/", "CMakeLists.txt",
                                                "CMakePresets.json", "lab"};

bool is_kept_back(const std::string& file, JudgeForm form) {
  const auto is_below = [&](const char* place) {
    return std::string_view(place).ends_with('/') ? file.starts_with(place) : file == place;
  };
  return std::ranges::any_of(kept_back, is_below) ||
         (form == JudgeForm::compiled && std::ranges::any_of(sources_of_the_judge, is_below));
}

/// Does this file belong to a lab that is left out?
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

/// "a, b and 3 more", printable.
std::string some_of(const std::vector<std::string>& names) {
  constexpr std::size_t most = 12;
  const std::vector<std::string> some(
      names.begin(), names.begin() + static_cast<std::ptrdiff_t>(std::min(most, names.size())));
  std::string text = fmt::format("{}", fmt::join(some, ", "));
  if (names.size() > most) text += fmt::format(" and {} more", names.size() - most);
  return sandbox::printable_line(text);
}

/// Untracked files would be missing from the copy, and modified ones would be in it without a
/// version: refuses the first, and lists the second.
void compare_with_git(const Context& context, const std::set<std::string>& chosen) {
  const JudgeForm form = JudgeForm::sources;  // the programs are made from them
  const std::string listed = git(context.layout.root, {"status", "--porcelain", "-z",
                                                       "--untracked-files=all", "--no-renames"});
  std::vector<std::string> unknown, changed;
  for (const std::string_view entry : text::split(listed, '\0')) {
    if (entry.empty()) continue;
    const std::string file(entry.substr(entry.find(' ') + 1));  // "?? name", "M name"
    if (is_kept_back(file, form) || is_left_out(context, chosen, file)) continue;
    (entry.starts_with("??") ? unknown : changed).push_back(file);
  }
  if (!unknown.empty()) {
    throw UsageError("these files are not in git; add or remove them first: " + some_of(unknown));
  }
  if (!changed.empty()) {
    fmt::print(stderr, "lab: the handout has changes that are not committed: {}\n",
               some_of(changed));
  }
}

/// Copies the files that git tracks, so no builds and no private files.
void copy_tracked(const Context& context, const std::set<std::string>& labs, JudgeForm form,
                  const fs::path& to) {
  const fs::path root = context.layout.root;
  compare_with_git(context, labs);
  const std::string listed = git(root, {"ls-files", "-z"});
  for (const std::string_view name : text::split(listed, '\0')) {
    const std::string file(name);
    if (file.empty() || is_kept_back(file, form) || is_left_out(context, labs, file)) continue;
    if (fs::exists(root / file)) copy_into(root / file, to / file);
  }
}

/// Into autograder/bin, with the script that starts it.
void copy_compiled_judge(const Context& context, const std::set<std::string>& labs,
                         const fs::path& to) {
  const Layout& layout = context.layout;
  const fs::path programs = layout.build / "handout", all = to / "autograder" / "bin";
  utsname system{};
  uname(&system);
  const fs::path bin = all / fmt::format("linux-{}", system.machine);
  if (!has_compiled_judge(layout)) {
    throw MachineError(
        "the judge cannot be compiled for a handout: this needs Linux, GCC and a static libseccomp "
        "(Debian's libseccomp-dev has it); use --with-sources");
  }
  copy_into(programs / "lab", bin / "lab");
  for (const std::string& lab : labs) {
    for (const char* kind : {"checks_", "measure_"}) {
      const fs::path program = programs / (kind + lab);
      if (fs::exists(program)) copy_into(program, bin / program.filename());
    }
  }
  write_text(all / "layout.json", nlohmann::json{{"judge_is_compiled", true},
                                                 {"version", layout.version},
                                                 {"link_flags", {"-static"}}}
                                          .dump(1) +
                                      '\n');
  const fs::path form = layout.root / "docs" / "compiled-handout";
  copy_into(form / "lab", to / "lab");
  copy_into(form / "CMakeLists.txt", to / "CMakeLists.txt");
  copy_into(layout.root / "cmake" / "tasks.cmake", to / "cmake" / "tasks.cmake");
  for (const char* name : {"demo.html", "demo.js", "demo_labs.js", "demo_watch.js"}) {
    const fs::path part = fs::path("autograder") / "judge" / "pictures" / name;
    copy_into(layout.root / part, to / part);
  }
}

}  // namespace

std::set<std::string> labs_with_dependencies(const Context& context,
                                             const std::optional<std::string>& list) {
  std::set<std::string> chosen;
  if (!list) {
    for (const Lab& lab : context.labs) chosen.insert(lab.name);
    return chosen;
  }
  for (const std::string_view word : text::split(*list, ',')) {
    const Lab& lab = find_lab(context.labs, std::string(word));
    chosen.insert(lab.name);
    chosen.insert(lab.depends_on.begin(), lab.depends_on.end());
  }
  return chosen;
}

void copy_course(const Context& context, const std::set<std::string>& labs, JudgeForm form,
                 const fs::path& to) {
  copy_tracked(context, labs, form, to);
  if (form == JudgeForm::compiled) copy_compiled_judge(context, labs, to);
  const fs::path points = context.layout.root / points_file;
  if (fs::exists(points)) copy_into(points, to / points_file);
}

bool has_compiled_judge(const Layout& layout) {
  return fs::exists(layout.build / "handout" / "lab");
}

void copy_into(const fs::path& from, const fs::path& to) {
  fs::create_directories(to.parent_path());
  fs::remove(to);
  fs::copy_file(from, to);
}

}  // namespace mc::grader
