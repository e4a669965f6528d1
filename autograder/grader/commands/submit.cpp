// submit: writes the zip to hand in, and reports the state of what is in it.

#include <sys/stat.h>

#include <ctime>
#include <filesystem>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "grader/base/errors.hpp"
#include "grader/base/text_file.hpp"
#include "grader/commands/command.hpp"
#include "grader/commands/manifest.hpp"
#include "grader/commands/progress.hpp"
#include "grader/submission/build.hpp"
#include "grader/submission/hours.hpp"
#include "grader/submission/intake.hpp"
#include "grader/submission/zip.hpp"

namespace mc::grader {
namespace {

namespace fs = std::filesystem;

/// "It compiles. The last check: 84 of 100 points.", or why it earns nothing.
std::string state_of(const Context& context, const Lab& lab, const Submission& submission) {
  const BuildResult built = build_program(context.layout, lab, submission);
  if (!built.program) return built.failure + "\nAs it is, it earns 0 points.";
  const auto progress = recall(context.layout, lab);
  if (!progress) return fmt::format("It compiles. It was never checked: ./lab check {}", lab.name);
  return fmt::format(
      "It compiles. The last check: {:g} of {:g} points{}.", progress->earned, progress->points,
      progress->is_current ? ""
                           : fmt::format(", but it has changed since (./lab check {})", lab.name));
}

int submit(const Context& context, const Arguments& arguments) {
  if (arguments.words.size() != 1) throw UsageError("usage: ./lab submit LAB");
  const Lab& lab = find_lab(context.labs, arguments.words[0]);
  std::vector<std::string> names = lab.depends_on;
  names.push_back(lab.name);
  std::vector<ZipEntry> entries;
  const auto add = [&](const fs::path& file, const std::string& as) {
    struct stat found {};
    stat(file.c_str(), &found);
    entries.push_back({as, read_whole_text(file), found.st_mtime});
  };
  for (const std::string& name : names) {
    const fs::path file = context.layout.starter() / (name + ".cpp");
    if (!fs::exists(file)) {
      throw UsageError(fmt::format("there is no starter/{}.cpp to hand in", name));
    }
    add(file, name + ".cpp");
  }
  const std::string answers = fmt::format("answers/{}.md", lab.folder);
  const bool has_answers = fs::exists(context.layout.root / answers);
  if (has_answers) add(context.layout.root / answers, answers);

  // The version that the student saw: grade says where it judges by another one.
  entries.push_back(
      {manifest_file, fmt::format("version={}\n", context.layout.version), std::time(nullptr)});

  const fs::path zip = fs::absolute("submission.zip");
  write_text(zip, zip_of(entries));
  names.clear();
  for (const ZipEntry& entry : entries) names.push_back(entry.name);
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
    {"submit",
     "submit LAB",
     {},
     "Writes submission.zip here: your file of that lab and of the labs it depends on, and\n"
     "answers/LAB.md if it exists, and the version of the checks. Prints whether the file "
     "compiles,\n"
     "its last points, and a question for the hours if answers/LAB.md does not say them.\n",
     submit}};

}  // namespace
}  // namespace mc::grader
