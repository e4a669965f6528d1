// handout: writes the students' repository, or a new version of it on top.

#include <algorithm>
#include <cstdlib>
#include <set>
#include <sstream>

#include <nlohmann/json.hpp>

#include "commands/course_copy.hpp"
#include "commands/git.hpp"
#include "judge/base/replace.hpp"
#include "judge/checkout/hints.hpp"
#include "judge/judging/points.hpp"
#include "judge/submission/scratch.hpp"
#include "runner/text.hpp"

namespace mc::grader {
namespace {

constexpr const char* settings_file = "autograder/handout.json";

/// How a handout was made, so that the next version is made in the same way.
struct Settings {
  std::string form;  ///< "compiled" or "sources"
  int hints = 3;     ///< steps of each task
  std::set<std::string> labs;
};
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Settings, form, hints, labs)

/// Does a line mention a command for something that is not part of the handout?
bool names_absent_command(const std::string& line, const fs::path& handout) {
  return std::ranges::any_of(all_commands(), [&](const Command& command) {
    const bool is_named = line.find(fmt::format("`./lab {}`", command.name)) != std::string::npos;
    return is_named && !fs::exists(handout / command.place);
  });
}

/// The README of docs/handout covers lab 1 and all labs; this adapts it to the labs of this
/// handout.
std::string readme_for(const std::string& given, const std::vector<Lab>& labs,
                       const fs::path& handout) {
  std::string all, list;
  std::istringstream lines(given);
  for (std::string line; std::getline(lines, line);) {
    if (!names_absent_command(line, handout)) all += line + '\n';
  }
  const Lab& first = labs.front();
  if (first.number != 1) {
    all = with_replacements(all, {{"1-variance", first.folder},
                                  {"variance", first.name},
                                  {"check 1.", fmt::format("check {}.", first.number)}});
  }
  for (const Lab& lab : labs) {
    list += fmt::format("{}- [{}](labs/{}/README.md)", list.empty() ? "" : "\n", lab.title(),
                        lab.folder);
  }
  return with_replacements(all, {{"<!-- labs -->", list}});
}

/// Replaces "<!-- if FORM -->…<!-- end -->" by its content for this form of the judge, and removes
/// it for the other.
void keep_one_form(std::string& text, JudgeForm form) {
  const std::string kept = form == JudgeForm::compiled ? "compiled" : "sources",
                    end = "<!-- end -->\n";
  for (const std::string name : {"compiled", "sources"}) {
    const std::string start = fmt::format("<!-- if {} -->\n", name);
    for (auto at = text.find(start); at != std::string::npos; at = text.find(start, at)) {
      const auto to = text.find(end, at);
      if (to == std::string::npos) throw MachineError(start + " has no end");
      const auto body = at + start.size();
      text.replace(at, to + end.size() - at, name == kept ? text.substr(body, to - body) : "");
    }
  }
}

/// A file for the answers to a lab's written questions: the section "Questions to hand in" of its
/// README. Empty if there is none.
std::string answers_template(const Lab& lab, const std::string& readme) {
  const std::string heading = "\n## Questions to hand in\n";
  const auto at = readme.find(heading);
  if (at == std::string::npos) return {};
  const auto from = at + heading.size(), to = readme.find("\n## ", from);
  return fmt::format(
      "# {}: answers\n\nWrite below each question; `./lab submit {}` includes this file.\n{}",
      lab.title(), lab.name, readme.substr(from, to == std::string::npos ? to : to - from));
}

/// For clangd: a handout without CMake has no compile_commands.json.
std::string compile_flags_for(const std::vector<Lab>& labs) {
  std::string flags = "-std=c++20\n-Ilabs\n-Ilabs/common\n";
  for (const Lab& lab : labs) flags += fmt::format("-Ilabs/{}\n", lab.folder);
  return flags;
}

/// Leaves out the tasks that points.csv leaves out: their sections and hints; the starter says so.
void leave_tasks_out(const fs::path& root, const Lab& lab, const fs::path& to) {
  const fs::path folder = to / "labs" / lab.folder;
  for (const std::string& task : tasks_left_out(root)) {
    if (std::atoi(task.c_str()) != lab.number) continue;
    for (const auto& [file, heading] :
         {std::pair{folder / "README.md", "### "}, std::pair{folder / "hints.md", "## "}}) {
      if (fs::exists(file)) write_text(file, without_section(read_text(file), heading + task));
    }
    const fs::path starter = to / "starter" / lab.file();
    write_text(starter,
               with_replacements(read_whole_text(starter),
                                 {{fmt::format("TODO({}):", task), "not part of this course:"}}));
  }
}

/// "has three steps", with the number of this handout.
void state_hints(const fs::path& readme, int steps) {
  constexpr const char* numbers[] = {"no steps", "one step", "two steps", "three steps"};
  write_text(readme,
             with_replacements(read_whole_text(readme),
                               {{"has three steps", fmt::format("has {}", numbers[steps])}}));
}

/// The pages of docs/ that a lab's README links to: "](../../docs/NAME.md)".
void copy_linked_pages(const fs::path& root, const std::string& readme, const fs::path& to) {
  constexpr std::string_view start = "](../../docs/";
  for (auto at = readme.find(start); at != std::string::npos; at = readme.find(start, at + 1)) {
    const auto from = at + start.size();
    const std::string page = readme.substr(from, readme.find_first_of("#)", from) - from);
    fs::create_directories((to / "docs" / page).parent_path());
    fs::copy_file(root / "docs" / page, to / "docs" / page, fs::copy_options::overwrite_existing);
  }
}

/// Writes the handout into an empty directory.
void write_handout(const Context& context, const Settings& settings, const fs::path& to) {
  const fs::path root = context.layout.root;
  const JudgeForm form = settings.form == "sources" ? JudgeForm::sources : JudgeForm::compiled;
  copy_course(context, settings.labs, form, to);
  fs::copy(root / "docs" / "handout", to, fs::copy_options::recursive);
  fs::create_directories(to / "docs");  // what the labs' handouts link
  fs::copy_file(root / "docs" / "going-faster.md", to / "docs" / "going-faster.md");
  std::vector<Lab> labs = context.labs;
  std::erase_if(labs, [&](const Lab& lab) { return !settings.labs.contains(lab.name); });
  for (const Lab& lab : labs) {
    const std::string readme = read_whole_text(root / "labs" / lab.folder / "README.md");
    copy_linked_pages(root, readme, to);
    const std::string questions = answers_template(lab, readme);
    if (!questions.empty()) {
      fs::create_directories(to / "answers");
      write_text(to / "answers" / (lab.folder + ".md"), questions);
    }
    leave_tasks_out(root, lab, to);
    const fs::path hints = to / "labs" / lab.folder / "hints.md";
    if (!fs::exists(hints)) continue;
    write_text(hints, with_fewer_hints(read_whole_text(hints), settings.hints));
    state_hints(to / "labs" / lab.folder / "README.md", settings.hints);
  }
  if (form == JudgeForm::compiled) write_text(to / "compile_flags.txt", compile_flags_for(labs));
  nlohmann::json made = settings;
  made["version"] = context.layout.version;
  write_text(to / settings_file, made.dump(1) + '\n');
  for (const char* name : {"README.md", "Dockerfile", ".github/workflows/grade.yml"}) {
    std::string text = read_whole_text(to / name);
    keep_one_form(text, form);
    write_text(to / name, name == std::string("README.md") ? readme_for(text, labs, to) : text);
  }
  state_hints(to / "README.md", settings.hints);
}

std::vector<std::string> files_below(const fs::path& directory) {
  std::vector<std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(directory)) {
    const std::string file = entry.path().lexically_relative(directory).string();
    if (entry.is_regular_file() && !file.starts_with(".git/")) files.push_back(file);
  }
  return files;
}

bool is_students_own(const std::string& file) {
  return file.starts_with("starter/") || file.starts_with("answers/");
}

/// Commits these files, whatever an ignore list says; false if nothing has changed.
bool commit_files(const fs::path& handout, const std::vector<std::string>& files,
                  const std::string& message) {
  std::vector<std::string> add{"add", "-f", "--"};
  add.insert(add.end(), files.begin(), files.end());
  git(handout, add);
  if (git(handout, {"status", "--porcelain", "--untracked-files=no"}).empty()) return false;
  git(handout, {"commit", "-q", "-m", message});
  return true;
}

/// Replaces everything that is tracked but starter/ and answers/ by the new version; files of new
/// labs are added there. Students merge it with `git pull`.
bool commit_on_top(const fs::path& handout, const fs::path& tree, const std::string& message) {
  if (!git(handout, {"status", "--porcelain", "--untracked-files=no"}).empty()) {
    throw UsageError(handout.string() + " has changes that are not committed: commit them first");
  }
  const std::string tracked = git(handout, {"ls-files", "-z"});
  std::vector<std::string> remove{"rm", "-q", "--"};
  for (const std::string_view name : text::split(tracked, '\0')) {
    const std::string file(name);
    if (!file.empty() && !is_students_own(file)) remove.push_back(file);
  }
  if (remove.size() > 3) git(handout, remove);
  std::vector<std::string> files = files_below(tree);
  std::erase_if(files, [&](const std::string& file) {
    return is_students_own(file) && fs::exists(handout / file);
  });
  for (const std::string& file : files) copy_into(tree / file, handout / file);
  return commit_files(handout, files, message);
}

int handout(const Context& context, const Arguments& arguments) {
  require_known_points(context.layout, context.labs);
  const fs::path to = fs::absolute(arguments.words[0]).lexically_normal();
  const std::string shown = sandbox::printable_line(to.string());
  const bool is_new = !fs::exists(to / settings_file);
  if (is_new && fs::exists(to) && !fs::is_empty(to)) {
    throw UsageError(shown + " is not empty, and not a handout of version 2");
  }
  Settings settings;
  settings.form = arguments.has("with-sources") ? "sources" : "compiled";
  if (!is_new)
    settings = nlohmann::json::parse(read_whole_text(to / settings_file)).get<Settings>();
  if (is_new || arguments.has("labs")) {
    settings.labs.merge(labs_with_dependencies(context, arguments.get("labs")));
  }
  settings.hints = static_cast<int>(
      std::min<std::uint64_t>(arguments.number("hints").value_or(settings.hints), 3));
  const std::string message = "Monte Carlo labs " + context.layout.version;
  if (is_new) {
    write_handout(context, settings, to);
    git(to, {"init", "-q", "-b", "main"});
    const auto files = files_below(to);
    commit_files(to, files, message);
    fmt::print("{}: {} files, one commit, labs {}\n", shown, files.size(),
               fmt::join(settings.labs, ", "));
    return 0;
  }
  const ScratchDirectory scratch(context.layout);
  const fs::path tree = scratch.path() / "tree";
  write_handout(context, settings, tree);
  const bool has_changed = commit_on_top(to, tree, message);
  fmt::print("{}: {}\n", shown, has_changed ? "one commit on top" : "nothing to change");
  return 0;
}

const RegisterCommand handout_command{
    {.usage = "handout DIR [--labs 1,2,…] [--hints N] [--with-sources]",
     .about = "write the repository for students, or a new version on top of it",
     .details =
         "Writes a git repository with one commit: the labs, the starters, the autograder as "
         "programs, a README for students, an editor's tasks, a dev container, and a workflow that "
         "grades each push. It has no solutions, checks or tests. Students need Linux on this "
         "machine's architecture, and a compiler. If DIR is a handout already, adds one commit "
         "that "
         "replaces everything but starter/ and answers/; students get it with git pull.",
     .options = {{"--labs LIST", "only these labs and those that they depend on"},
                 {"--hints N", "only the first N steps of each task's hints, 0 to 3"},
                 {"--with-sources",
                  "the autograder's sources in place of its programs, for other systems and for "
                  "those who want to read them; the checks contain working algorithms"}},
     .run = handout,
     .least_words = 1,
     .most_words = 1,
     .for_instructors = true,
     .place = "docs/handout",
     .targets = [](const Context&, const Arguments& arguments) {
       return arguments.has("with-sources") ? std::vector<std::string>()
                                            : std::vector<std::string>{"handout_judge"};
     }}};

}  // namespace
}  // namespace mc::grader
