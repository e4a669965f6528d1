// completion: a script that completes commands, labs, tasks, experiments and options on TAB.

#include <filesystem>
#include <map>
#include <set>
#include <string>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "grader/base/errors.hpp"
#include "grader/base/text_file.hpp"
#include "grader/commands/command.hpp"
#include "grader/commands/list.hpp"
#include "runner/text.hpp"

namespace mc::grader {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

/// The tasks of a lab, from its hints; "## 1.3" is a heading.
Words tasks_of(const Layout& layout, const Lab& lab) {
  Words tasks;
  const std::string text = read_text(layout.labs() / lab.folder / "hints.md");
  for (const std::string_view line : text::split(text, '\n')) {
    if (line.starts_with(fmt::format("## {}.", lab.number))) tasks.emplace_back(line.substr(3));
  }
  return tasks;
}

/// The experiments of a lab: those that its experiments.cpp lists.
Words experiments_of(const Layout& layout, const Lab& lab) {
  const std::string start = "MC_EXPERIMENT(";
  const std::string text = read_text(layout.labs() / lab.folder / "experiments.cpp");
  Words names;
  for (auto at = text.find(start); at != std::string::npos; at = text.find(start, at + 1)) {
    const auto from = at + start.size();
    names.push_back(text.substr(from, text.find(',', from) - from));
  }
  return names;
}

std::string script(const Context& context) {
  Words commands, labs, tasks;
  std::string options, experiments;
  for (const CommandEntry& entry : command_list) {
    if (entry.name.empty() || !fs::exists(context.layout.root / entry.about)) continue;
    commands.emplace_back(entry.name);
  }
  for (const Command& command : registered_commands()) {
    Words names{"--help"};
    for (const std::string& option : command.options) {
      names.push_back("--" + option.substr(0, option.find('=')));
    }
    const std::string name = command.name.empty() ? "''" : command.name;
    options += fmt::format("      {}) words='{}' ;;\n", name, fmt::join(names, " "));
  }
  for (const Lab& lab : context.labs) {
    labs.push_back(lab.name);
    for (std::string& task : tasks_of(context.layout, lab)) tasks.push_back(std::move(task));
    experiments += fmt::format("      {}|{}|{}) words='{}' ;;\n", lab.number, lab.name, lab.folder,
                               fmt::join(experiments_of(context.layout, lab), " "));
  }
  std::string all =
      R"sh(# Put this into ~/.bashrc or ~/.zshrc:  eval "$(./lab completion bash)"  (or zsh)
_monte_carlo_labs() {
  local word=${COMP_WORDS[COMP_CWORD]} command=${COMP_WORDS[1]} words=
  if [[ $word == -* ]]; then
    case $command in
@OPTIONS@    esac
  elif [[ $COMP_CWORD == 1 ]]; then
    words='@COMMANDS@'
  elif [[ $COMP_CWORD == 2 ]]; then
    case $command in
      check) words='@LABS@ @TASKS@' ;;
      hint) words='@TASKS@' ;;
      grade|handout|merge|stats|export|demo|setup|test|bench) ;;
      *) words='@LABS@' ;;
    esac
  elif [[ $COMP_CWORD == 3 && $command == run ]]; then
    case ${COMP_WORDS[2]} in
@EXPERIMENTS@    esac
  fi
  COMPREPLY=($(compgen -W "$words" -- "$word"))
}
complete -o default -F _monte_carlo_labs ./lab lab
)sh";
  const auto fill = [&](const std::string& name, const std::string& text) {
    for (auto at = all.find(name); at != std::string::npos; at = all.find(name, at + text.size())) {
      all.replace(at, name.size(), text);
    }
  };
  fill("@OPTIONS@", options);
  fill("@EXPERIMENTS@", experiments);
  fill("@COMMANDS@", fmt::format("{}", fmt::join(commands, " ")));
  fill("@LABS@", fmt::format("{}", fmt::join(labs, " ")));
  fill("@TASKS@", fmt::format("{}", fmt::join(tasks, " ")));
  return all;
}

int completion(const Context& context, const Arguments& arguments) {
  const std::string shell = arguments.words.empty() ? "" : arguments.words[0];
  if (arguments.words.size() != 1 || (shell != "bash" && shell != "zsh")) {
    throw UsageError("usage: ./lab completion bash (or zsh)");
  }
  if (shell == "zsh") fmt::print("autoload -U +X bashcompinit && bashcompinit\n");
  fmt::print("{}", script(context));
  return 0;
}

const RegisterCommand completion_command{
    {"completion",
     "completion bash|zsh",
     {},
     "Prints a script: eval \"$(./lab completion bash)\" completes commands, labs, tasks,\n"
     "experiments and options on TAB, in this shell; in ~/.bashrc, in each.\n",
     completion}};

}  // namespace
}  // namespace mc::grader
