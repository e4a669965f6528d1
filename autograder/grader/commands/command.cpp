#include "grader/commands/command.hpp"

#include <algorithm>
#include <utility>

namespace mc::grader {
namespace {

std::vector<Command>& registry() {
  static std::vector<Command> commands;
  return commands;
}

}  // namespace

RegisterCommand::RegisterCommand(Command command) {
  registry().push_back(std::move(command));
}

const std::vector<Command>& registered_commands() {
  return registry();
}

std::vector<Submission> submissions_with_solutions(const Context& context, const Lab& lab,
                                                   const std::vector<std::string>& directories) {
  const Layout& layout = context.layout;
  std::vector<Submission> submissions;
  for (const std::string& directory : directories) {
    submissions.push_back(open_submission(context.labs, directory));
  }
  if (submissions.empty()) {
    submissions.push_back(open_submission(context.labs, layout.starter()));
    submissions.back().label = "starter";
  }
  const bool has_solutions = std::any_of(submissions.begin(), submissions.end(),
                                         [&](auto& one) { return is_reference(layout, one); });
  if (!has_solutions && std::filesystem::exists(layout.solutions() / lab.file())) {
    submissions.push_back(open_submission(context.labs, layout.solutions()));
    submissions.back().label = "solutions";
  }
  return submissions;
}

}  // namespace mc::grader
