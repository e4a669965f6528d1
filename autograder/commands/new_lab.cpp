// new-lab: writes the skeleton of a lab.

#include "commands/new_lab.hpp"

#include <algorithm>
#include <map>

#include "judge/base/replace.hpp"

namespace mc::grader {
namespace {

int new_lab(const Context& context, const Arguments& arguments) {
  const std::string& lab = arguments.words[0];
  for (const Lab& other : context.labs) {
    if (other.name == lab) throw UsageError(fmt::format("lab {} is already {}", other.number, lab));
  }
  const int number = context.labs.back().number + 1;
  const fs::path root = context.layout.root;
  for (const fs::path& file : write_new_lab(root / "autograder" / "new-lab", number, lab, root)) {
    fmt::print("{}\n", file.string());
  }
  fmt::print(
      "\nLab {0} has one function, check, plot and mistake, and works:\n\n"
      "  ./lab check {0} solutions\n  ./lab plot {0}\n"
      "  git add .           a handout has the files in git\n  ./lab test\n\n"
      "CONTRIBUTING.md lists what else a lab can have.\n",
      number);
  return 0;
}

const RegisterCommand new_lab_command{
    {.usage = "new-lab NAME",
     .about = "write the skeleton of a new lab",
     .details = "NAME has lower-case letters, digits and _: light_transport. The lab gets the next "
                "number.",
     .run = new_lab,
     .least_words = 1,
     .most_words = 1,
     .for_instructors = true,
     .place = "autograder/new-lab"}};

}  // namespace

std::vector<fs::path> write_new_lab(const fs::path& skeleton, int number, const std::string& name,
                                    const fs::path& root) {
  if (name.empty() || name[0] < 'a' || name[0] > 'z' ||
      name.find_first_not_of("abcdefghijklmnopqrstuvwxyz_0123456789") != name.npos) {
    throw UsageError("a lab's name has lower-case letters, digits and _: light_transport");
  }
  std::string dashed = name, title = name;
  std::ranges::replace(dashed, '_', '-');
  std::ranges::replace(title, '_', ' ');
  const auto filled = [&](const std::string& text) {
    return with_replacements(text, {{"@lab@", name},
                                    {"@number@", std::to_string(number)},
                                    {"@title@", title},
                                    {"@folder@", fmt::format("{}-{}", number, dashed)}});
  };
  std::map<fs::path, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(skeleton)) {
    if (!entry.is_regular_file()) continue;
    files[filled(entry.path().lexically_relative(skeleton).string())] =
        filled(read_whole_text(entry.path()));
  }
  std::vector<fs::path> written;
  for (const auto& [file, contents] : files) {
    if (fs::exists(root / file)) throw UsageError(file.string() + " exists already");
    written.push_back(file);
  }
  for (const fs::path& file : written) {
    fs::create_directories((root / file).parent_path());
    write_text(root / file, files[file]);
  }
  return written;
}

}  // namespace mc::grader
