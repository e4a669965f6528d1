// handout: writes the students' repository, with a fresh history.

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <sstream>

#include "grader/base/replace.hpp"
#include "grader/checkout/hints.hpp"
#include "grader/commands/git.hpp"
#include "grader/commands/list.hpp"
#include "grader/commands/tree.hpp"
#include "grader/commands/upgrade.hpp"
#include "grader/judging/points.hpp"
#include "grader/submission/scratch.hpp"

namespace mc::grader {
namespace {

/// Does a line mention a command for something that is not part of the handout?
bool names_absent_command(const std::string& line, const fs::path& handout) {
  return std::ranges::any_of(command_list, [&](const CommandEntry& command) {
    const bool is_named = line.find(fmt::format("`./lab {}`", command.name)) != std::string::npos;
    return is_named && !fs::exists(handout / command.about);
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
      "# {}: answers\n\nWrite below each question; `./lab submit {}` includes this file.\n{}\n"
      "Hours that I spent on this lab, as a number (helps to plan the next course; no points):\n",
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

int steps_in(const Manifest& manifest) {
  return manifest.hints.empty() ? 3 : std::clamp(std::atoi(manifest.hints.c_str()), 0, 3);
}

/// "has three steps", with the number of this handout.
void state_hints(const fs::path& readme, const Manifest& manifest) {
  constexpr const char* numbers[] = {"no steps", "one step", "two steps", "three steps"};
  const std::string steps = fmt::format("has {}", numbers[steps_in(manifest)]);
  write_text(readme, with_replacements(read_whole_text(readme), {{"has three steps", steps}}));
}

/// Writes the handout that this manifest describes into an empty directory.
void write_handout(const Context& context, const Manifest& manifest, const fs::path& to) {
  const fs::path root = context.layout.root;
  const JudgeForm form = manifest.form == "sources" ? JudgeForm::sources : JudgeForm::compiled;
  copy_course(context, manifest.labs, form, to);
  fs::copy(root / "docs" / "handout", to, fs::copy_options::recursive);
  fs::create_directories(to / "docs");  // what the labs' handouts link
  fs::copy_file(root / "docs" / "going-faster.md", to / "docs" / "going-faster.md");
  std::vector<Lab> labs = context.labs;
  std::erase_if(labs, [&](const Lab& lab) { return !manifest.labs.contains(lab.name); });
  for (const Lab& lab : labs) {
    const std::string questions =
        answers_template(lab, read_whole_text(root / "labs" / lab.folder / "README.md"));
    if (!questions.empty()) {
      fs::create_directories(to / "answers");
      write_text(to / "answers" / (lab.folder + ".md"), questions);
    }
    leave_tasks_out(root, lab, to);
    const fs::path hints = to / "labs" / lab.folder / "hints.md";
    if (manifest.hints.empty() || !fs::exists(hints)) continue;
    write_text(hints, with_fewer_hints(read_whole_text(hints), steps_in(manifest)));
    state_hints(to / "labs" / lab.folder / "README.md", manifest);
  }
  if (form == JudgeForm::compiled) write_text(to / "compile_flags.txt", compile_flags_for(labs));
  make_manifest(context, manifest, to);  // the README mentions commands for what exists
  for (const char* name : {"README.md", "Dockerfile", ".github/workflows/grade.yml"}) {
    std::string text = read_whole_text(to / name);
    keep_one_form(text, form);
    write_text(to / name, name == std::string("README.md") ? readme_for(text, labs, to) : text);
  }
  state_hints(to / "README.md", manifest);
  make_manifest(context, manifest, to);
}

int handout(const Context& context, const Arguments& arguments) {
  require_known_points(context.layout, context.labs);
  const fs::path to = fs::absolute(arguments.words[0]).lexically_normal();
  const std::string shown = sandbox::printable_line(to.string());
  Manifest manifest = read_manifest(to);
  const bool is_new = manifest.version.empty();
  if (is_new && fs::exists(to) && !fs::is_empty(to)) {
    throw UsageError(shown + " is not empty, and not a handout");
  }
  // An existing handout keeps its labs, form and hints, unless the options change them.
  if (is_new || arguments.has("labs")) {
    manifest.labs.merge(labs_with_dependencies(context, arguments.get("labs")));
  }
  if (is_new) manifest.form = arguments.has("with-sources") ? "sources" : "compiled";
  if (const auto most = arguments.number("hints")) manifest.hints = std::to_string(*most);
  if (is_new) {
    write_handout(context, manifest, to);
    git(to, {"init", "-q", "-b", "main"});
    commit_files(to, {"."}, "Monte Carlo labs " + context.layout.version);
    fmt::print("{}: {} files, one commit, labs {}\n", shown, read_manifest(to).files.size(),
               fmt::join(manifest.labs, ", "));
    return 0;
  }
  const ScratchDirectory scratch(context.layout);
  const fs::path tree = scratch.path() / "tree";
  write_handout(context, manifest, tree);
  const std::string message = upgrade(to, tree);
  fmt::print("{}: {}\n", shown, message.empty() ? "nothing to change" : "one commit on top");
  fmt::print("{}", message);
  return 0;
}

const RegisterCommand handout_command{
    {.usage = "handout DIR [--labs 1,2,…] [--hints N] [--with-sources]",
     .details =
         "Writes a git repository with one commit: the labs, the starters, the autograder as "
         "programs, a README for students, an editor's tasks, a dev container, and a workflow that "
         "grades each push. It has no solutions, checks or tests. Students need Linux on this "
         "machine's architecture, and a compiler. If DIR is a handout already, adds a commit with "
         "the changes; starter/, answers/ and edited files stay as they are.",
     .options = {{"--labs LIST", "only these labs and those that they depend on"},
                 {"--hints N", "only the first N steps of each task's hints, 0 to 3"},
                 {"--with-sources",
                  "the autograder's sources in place of its programs, for other systems and for "
                  "those who want to read them; the checks contain working algorithms"}},
     .run = handout,
     .least_words = 1,
     .most_words = 1}};

}  // namespace
}  // namespace mc::grader
