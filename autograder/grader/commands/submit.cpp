// submit: writes the zip to hand in, and reports the state of what is in it.

#include <sys/stat.h>

#include <ctime>

#include "grader/commands/command.hpp"
#include "grader/commands/manifest.hpp"
#include "grader/commands/progress.hpp"
#include "grader/submission/build.hpp"
#include "grader/submission/hours.hpp"
#include "grader/submission/intake.hpp"
#include "grader/submission/zip.hpp"

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

  // The version that the student saw: ./lab grade reports it if it judges by another one.
  entries.push_back(
      {manifest_file, fmt::format("version={}\n", context.layout.version), std::time(nullptr)});
  names.emplace_back(manifest_file);

  const fs::path zip = fs::absolute("submission.zip");
  write_text(zip, zip_of(entries));
  fmt::print("{}: {}\n", zip.string(), fmt::join(names, ", "));
  if (!has_answers) fmt::print("Answers to the written questions go into {}.\n", answers);
  Intake intake = take_in_one(context, context.layout.starter());
  Submission& submission = intake.entries[0].submission;
  read_hours(context.labs, submission);
  if (has_answers && !submission.delivery.hours.contains(lab.name)) {
    fmt::print(
        "How many hours did this lab take you? A last line \"Hours: 7.5\" in {} tells your "
        "instructor.\n",
        answers);
  }
  fmt::print("{}\n", state_of(context, lab, submission));
  return 0;
}

const RegisterCommand submit_command{
    {.usage = "submit LAB",
     .details = "Writes submission.zip here: your file of that lab and of the labs it depends on, "
                "answers/N-LAB.md if it exists, and the version of the checks. Prints whether the "
                "file compiles, its last points, and a question for the hours if the answers do "
                "not say them.",
     .run = submit,
     .least_words = 1,
     .most_words = 1}};

}  // namespace
}  // namespace mc::grader
