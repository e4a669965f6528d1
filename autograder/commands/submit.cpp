// submit: writes the zip to hand in, and reports the state of what is in it.

#include <sys/stat.h>

#include <charconv>
#include <sstream>

#include "commands/command.hpp"
#include "commands/progress.hpp"
#include "judge/submission/build.hpp"
#include "judge/submission/intake.hpp"
#include "judge/submission/zip.hpp"

namespace mc::grader {
namespace {

/// "It compiles. The last check: 84 of 100 points.", or why it earns nothing.
std::string state_of(const Context& context, const Lab& lab, const Submission& submission) {
  const BuildResult built = build_program(context.layout, lab, submission);
  if (!built.program) return built.failure + "\nAs it is, it earns 0 points.";
  const auto progress = read_progress(context.layout, lab);
  if (!progress) return fmt::format("It compiles. It was never checked: ./lab check {}", lab.name);
  return fmt::format(
      "It compiles. The last check: {:g} of {:g} points{}.", progress->earned, progress->points,
      progress->is_current ? ""
                           : fmt::format(", but it has changed since (./lab check {})", lab.name));
}

/// The numbers of the questions, "1. …", below which nothing is written.
std::vector<int> blank_answers(const std::string& text) {
  std::vector<int> blank;
  int question = 0;
  bool has_answer = true, is_in_question = false;
  std::istringstream lines(text);
  const auto end_question = [&] {
    if (!has_answer) blank.push_back(question);
  };
  for (std::string line; std::getline(lines, line);) {
    int number = 0;
    const auto dot = line.find(". ");
    const auto [end, error] = std::from_chars(line.data(), line.data() + line.size(), number);
    if (error == std::errc() && dot != std::string::npos && end == line.data() + dot) {
      end_question();
      question = number;
      has_answer = false;
      is_in_question = true;
    } else if (line.empty()) {
      is_in_question = false;  // its paragraph has ended
    } else if (!is_in_question && !line.starts_with("<!--")) {
      has_answer = true;
    }
  }
  end_question();
  return blank;
}

int submit(const Context& context, const Arguments& arguments) {
  const Lab& lab = find_lab(context.labs, arguments.words[0]);
  std::vector<ZipEntry> entries;
  std::vector<std::string> names;
  const auto add = [&](const fs::path& file, const std::string& name) {
    struct stat found {};
    stat(file.c_str(), &found);
    entries.push_back({name, read_whole_text(file), found.st_mtime});
    names.push_back(name);
  };
  std::vector<std::string> labs = lab.depends_on;
  labs.push_back(lab.name);
  for (const std::string& name : labs) {
    const fs::path file = context.layout.starter() / (name + ".cpp");
    if (!fs::exists(file)) {
      throw UsageError(fmt::format("there is no starter/{}.cpp to hand in", name));
    }
    add(file, name + ".cpp");
  }
  const std::string answers = fmt::format("answers/{}.md", lab.folder);
  const bool has_answers = fs::exists(context.layout.root / answers);
  if (has_answers) add(context.layout.root / answers, answers);

  const fs::path zip = fs::absolute(lab.folder + ".zip");
  write_text(zip, zip_of(entries));
  fmt::print("{}: {}\n", zip.string(), fmt::join(names, ", "));
  if (has_answers) {
    const auto blank = blank_answers(read_whole_text(context.layout.root / answers));
    if (!blank.empty()) {
      fmt::print("Not answered in {}: {}\n", answers, fmt::join(blank, ", "));
    }
  } else {
    fmt::print("Answers to the written questions go into {}.\n", answers);
  }
  const Submission submission = open_submission(context.labs, context.layout.starter());
  fmt::print("{}\n", state_of(context, lab, submission));
  return 0;
}

const RegisterCommand submit_command{
    {.usage = "submit LAB",
     .about = "write the zip file to hand in",
     .details =
         "Writes N-LAB.zip here: your file of that lab and of the labs it depends on, and "
         "answers/N-LAB.md if it exists. Prints whether the file compiles, its last points, and "
         "which questions are not answered.",
     .run = submit,
     .least_words = 1,
     .most_words = 1}};

}  // namespace
}  // namespace mc::grader
