// run, plot, reset, submit, test: what one does beside being judged.

#include <unistd.h>

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "grader/build.hpp"
#include "grader/errors.hpp"
#include "grader/plots.hpp"
#include "grader/process.hpp"
#include "grader/text_file.hpp"
#include "grader/verbs.hpp"
#include "runner/text.hpp"

namespace mc::grader {
namespace fs = std::filesystem;
namespace {

/// Becomes another program. Returns only by an exception.
[[noreturn]] void become(std::vector<std::string> command) {
  std::vector<char*> pointers;
  for (std::string& word : command) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  std::fflush(nullptr);
  execvp(pointers[0], pointers.data());
  throw MachineError(fmt::format("cannot run {}", command[0]));
}

std::size_t count(const std::string& text, const std::string& what) {
  std::size_t found = 0;
  for (auto at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++found;
  return found;
}

/// The newest committed version of a file in which the most tasks are still to be done.
std::string pristine(const House& house, const std::string& file) {
  const std::string root = house.layout.root.string();
  const auto commits =
      run_process({"git", "-C", root, "log", "--format=%H", "--", "starter/" + file});
  std::string best;
  for (const std::string_view commit : text::split(commits.output, '\n')) {
    if (commit.empty()) continue;
    const auto version =
        run_process({"git", "-C", root, "show", fmt::format("{}:starter/{}", commit, file)});
    if (version.succeeded() && count(version.output, "todo(") > count(best, "todo(")) {
      best = version.output;
    }
  }
  if (best.empty()) {
    throw MachineError(
        fmt::format("git has no starter/{} here: take it from the course's page", file));
  }
  return best;
}

}  // namespace

int run(const House& house, const Arguments& arguments) {
  if (arguments.words.empty()) throw UsageError("usage: ./lab run LAB [EXPERIMENT ARGUMENT...]");
  const Lab& lab = find_lab(house.labs, arguments.words[0]);
  const fs::path directory = arguments.get("dir").value_or(house.layout.starter().string());
  const Submission submission = open_submission(house.layout, house.labs, directory);
  const Built built = build_program(house.layout, lab, submission);
  if (!built.program) {
    fmt::print("{}\n", built.failure);
    return 1;
  }
  if (arguments.words.size() == 1) {
    fmt::print("The experiments of {}; run one with ./lab run {} NAME ARGUMENT...\n\n", lab.title(),
               lab.name);
    become({built.program->path, "--list"});
  }
  std::vector<std::string> command{built.program->path};
  command.insert(command.end(), arguments.words.begin() + 1, arguments.words.end());
  become(std::move(command));
}

std::vector<Submission> submissions_beside(const House& house, const Lab& lab,
                                           const std::vector<std::string>& directories) {
  std::vector<Submission> submissions;
  for (const std::string& directory : directories) {
    submissions.push_back(open_submission(house.layout, house.labs, directory));
  }
  if (submissions.empty()) {
    submissions.push_back(open_submission(house.layout, house.labs, house.layout.starter()));
    submissions.back().label = "starter";
  }
  const bool has_solutions =
      std::any_of(submissions.begin(), submissions.end(), [](auto& one) { return one.trusted; });
  if (!has_solutions && fs::exists(house.layout.solutions() / lab.file())) {
    submissions.push_back(open_submission(house.layout, house.labs, house.layout.solutions()));
    submissions.back().label = "solutions";
  }
  return submissions;
}

int plot(const House& house, const Arguments& arguments) {
  if (arguments.words.empty()) throw UsageError("usage: ./lab plot LAB [DIR...]");
  const Lab& lab = find_lab(house.labs, arguments.words[0]);
  const std::vector<Submission> submissions =
      submissions_beside(house, lab, {arguments.words.begin() + 1, arguments.words.end()});
  const Plots plots = draw_plots(house.layout, lab, submissions, "side-by-side");
  for (const std::string& remark : plots.remarks) fmt::print("{}\n", remark);
  for (const fs::path& picture : plots.pictures) fmt::print("{}\n", picture.string());
  return plots.pictures.empty() ? 1 : 0;
}

int reset(const House& house, const Arguments& arguments) {
  if (arguments.words.size() != 1) throw UsageError("usage: ./lab reset LAB");
  const Lab& lab = find_lab(house.labs, arguments.words[0]);
  const std::string fresh = pristine(house, lab.file());
  const fs::path file = house.layout.starter() / lab.file();
  if (fs::exists(file)) {
    if (read_text(file) == fresh) {
      fmt::print("starter/{} is as it was given to you.\n", lab.file());
      return 0;
    }
    fs::path backup;
    for (int i = 1; backup.empty() || fs::exists(backup); ++i) {
      backup = file.string() + fmt::format(".{}.bak", i);
    }
    fs::copy_file(file, backup);
    fmt::print("Your file is kept as {}.\n", backup.string());
  }
  write_text(file, fresh);
  fmt::print("starter/{} is as it was given to you.\n", lab.file());
  return 0;
}

int submit(const House& house, const Arguments& arguments) {
  if (arguments.words.size() != 1) throw UsageError("usage: ./lab submit LAB");
  const Lab& lab = find_lab(house.labs, arguments.words[0]);
  std::vector<std::string> files;
  for (const std::string& name : lab.stands_on) files.push_back(name + ".cpp");
  files.push_back(lab.file());
  for (const std::string& file : files) {
    if (!fs::exists(house.layout.starter() / file)) {
      throw UsageError(fmt::format("there is no starter/{} to hand in", file));
    }
  }
  const fs::path zip = fs::absolute("submission.zip");
  const fs::path aside = zip.string() + ".new";
  std::vector<std::string> command{"cmake", "-E", "tar", "cf", aside.string(), "--format=zip"};
  command.insert(command.end(), files.begin(), files.end());
  const auto made = run_process(command, {.directory = house.layout.starter()});
  if (!made.succeeded()) {
    std::error_code ignored;
    fs::remove(aside, ignored);
    throw MachineError(fmt::format("cannot write {}: {}", zip.string(), made.errors));
  }
  fs::rename(aside, zip);
  fmt::print("{}: {}\nHand it in as it is.\n", zip.string(), fmt::join(files, ", "));
  return 0;
}

int test(const House& house, const Arguments& arguments) {
  if (!arguments.words.empty()) throw UsageError("usage: ./lab test [--full]");
  if (arguments.has("full")) setenv("MC_SEEDS", "1000", 1);
  become({"cmake", "-D", "BUILD=" + house.layout.build.string(), "-P",
          (house.layout.root / "cmake" / "test.cmake").string()});
}

}  // namespace mc::grader
