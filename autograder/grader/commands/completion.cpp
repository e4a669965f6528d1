// completion: a script that completes commands, labs, tasks, experiments and options on TAB.

#include "grader/base/replace.hpp"
#include "grader/checkout/labs.hpp"
#include "grader/commands/command.hpp"
#include "grader/commands/list.hpp"
#include "runner/text.hpp"

namespace mc::grader {
namespace {

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

std::string script(const Context& context) {
  Words commands, labs, tasks;
  std::string options, experiments;
  for (const CommandEntry& entry : command_list) {
    if (entry.name.empty() || !fs::exists(context.layout.root / entry.about)) continue;
    commands.emplace_back(entry.name);
  }
  for (const Command& command : registered_commands()) {
    Words names{"--help"};
    for (const CommandOption& option : command.options) {
      names.push_back(option.shown.substr(0, option.shown.find_first_of(" ,")));
    }
    const std::string name = command.name.empty() ? "''" : command.name;
    options += fmt::format("      {}) words='{}' ;;\n", name, fmt::join(names, " "));
  }
  for (const Lab& lab : context.labs) {
    labs.push_back(lab.name);
    for (std::string& task : tasks_of(context.layout, lab)) tasks.push_back(std::move(task));
    Words names;
    for (const Experiment& one : experiments_of(context.layout, lab)) names.push_back(one.name);
    experiments += fmt::format("      {}|{}|{}) words='{}' ;;\n", lab.number, lab.name, lab.folder,
                               fmt::join(names, " "));
  }
  constexpr std::string_view text =
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
      run|plot|report|reset|submit|release|gradescope) words='@LABS@' ;;
      completion) words='bash zsh' ;;
    esac
  elif [[ $COMP_CWORD == 3 && $command == run ]]; then
    case ${COMP_WORDS[2]} in
@EXPERIMENTS@    esac
  fi
  COMPREPLY=($(compgen -W "$words" -- "$word"))
}
complete -o default -F _monte_carlo_labs ./lab lab
)sh";
  const auto words = [](const auto& list) { return fmt::format("{}", fmt::join(list, " ")); };
  return with_replacements(text, {{"@OPTIONS@", options},
                                  {"@EXPERIMENTS@", experiments},
                                  {"@COMMANDS@", words(commands)},
                                  {"@LABS@", words(labs)},
                                  {"@TASKS@", words(tasks)}});
}

int completion(const Context& context, const Arguments& arguments) {
  const std::string& shell = arguments.words[0];
  if (shell != "bash" && shell != "zsh") throw WrongUsage();
  if (shell == "zsh") fmt::print("autoload -U +X bashcompinit && bashcompinit\n");
  fmt::print("{}", script(context));
  return 0;
}

const RegisterCommand completion_command{
    {.usage = "completion bash|zsh",
     .details = "Prints a script: eval \"$(./lab completion bash)\" completes commands, labs, "
                "tasks, experiments and options on TAB in this shell; put it into ~/.bashrc for "
                "every shell.",
     .run = completion,
     .least_words = 1,
     .most_words = 1}};

}  // namespace
}  // namespace mc::grader
