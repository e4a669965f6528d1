// What students get works, and holds no answer.
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "checks/support/catch.hpp"
#include "grader/verbs/list.hpp"
#include "runner/text.hpp"
#include "tests/gradebook/course.hpp"
#include "tests/text.hpp"

namespace mc::tests::handout {

namespace fs = std::filesystem;
using namespace grader;

namespace {

/// A handout, as somebody has it who has just cloned it.
struct Handout : Course {
  fs::path root = path() / "labs";
  sandbox::ProcessResult written;

  explicit Handout(const std::vector<std::string>& more = {}) {
    std::vector<std::string> words{"handout", root.string()};
    words.insert(words.end(), more.begin(), more.end());
    written = run(words);
  }
  sandbox::ProcessResult git(std::vector<std::string> words) const {
    words.insert(words.begin(), {"git", "-C", root.string()});
    return sandbox::run_process(words, {.output = std::size_t{64} << 20});
  }
  sandbox::ProcessResult lab(std::vector<std::string> words) const {
    words.insert(words.begin(), (root / "lab").string());
    return sandbox::run_process(
        words, {.directory = root, .environment = {{"MC_BUILD", ""}, {"CI", "true"}}});
  }
};

/// Lines without their blanks and without git's sign of what was added.
std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  for (std::string_view line : text::split(text, '\n')) {
    if (line.starts_with('+')) line.remove_prefix(1);
    const auto first = line.find_first_not_of(" \t");
    if (first == std::string_view::npos) continue;
    lines.emplace_back(line.substr(first));
  }
  return lines;
}

using Texts = std::set<std::string>;

/// Lines by which one would know an answer: long ones.
void add_lines(const std::string& text, Texts& to) {
  constexpr std::size_t long_enough = 40;
  for (std::string& line : lines_of(text)) {
    if (line.size() > long_enough) to.insert(std::move(line));
  }
}

/// Four lines in a row. The judge computes what the answers do: they share a loop here and there,
/// three lines at most.
void add_passages(const std::string& text, Texts& to) {
  constexpr std::size_t long_enough = 100;
  std::vector<std::string> lines = lines_of(text);
  std::erase_if(lines, [](const std::string& line) { return line.size() < 4; });  // braces
  for (std::size_t i = 0; i + 4 <= lines.size(); ++i) {
    const std::string four =
        lines[i] + '\n' + lines[i + 1] + '\n' + lines[i + 2] + '\n' + lines[i + 3];
    if (four.size() > long_enough) to.insert(four);
  }
}

Texts texts_in(const Layout& layout, const std::vector<std::string>& places,
               void (*add)(const std::string& text, Texts& to)) {
  Texts all;
  for (const std::string& place : places) {
    for (const auto& entry : fs::recursive_directory_iterator(layout.root / place)) {
      if (entry.is_regular_file()) add(read_text(entry.path()), all);
    }
  }
  return all;
}

/// The answers' lines, or passages, that this text has and students were not given.
Texts answers_in(const Layout& layout, const std::string& text,
                 void (*add)(const std::string& text, Texts& to)) {
  const std::string kinds = "autograder/submissions/";
  const Texts answers = texts_in(
      layout, {"solutions", kinds + "mistakes", kinds + "alternatives", kinds + "peers"}, add);
  const Texts given = texts_in(layout, {"labs", "starter"}, add);
  REQUIRE(answers.size() > 1000);
  Texts here, found;
  add(text, here);
  for (const std::string& one : here) {
    if (answers.contains(one) && !given.contains(one)) found.insert(one);
  }
  return found;
}

std::vector<std::string> listed_verbs(const std::string& help) {
  std::vector<std::string> verbs;
  for (const std::string& line : lines_of(help)) {
    const std::string start = "./lab ";
    if (!line.starts_with(start) || line[start.size()] == ' ') continue;
    verbs.push_back(line.substr(start.size(), line.find(' ', start.size()) - start.size()));
  }
  return verbs;
}

}  // namespace

TEST_CASE("no answer is in a handout, nor in its history") {
  const Handout handout;
  CAPTURE(handout.written.errors);
  REQUIRE(handout.written.exit_code == 0);
  CHECK(handout.git({"status", "--porcelain"}).output.empty());  // so its history has every file
  CHECK(lines(handout.git({"rev-list", "--all"}).output) == 1);
  const std::string others = handout.git({"log", "-p", "--all", "--", ".", ":!autograder"}).output;
  const std::string judge = handout.git({"log", "-p", "--all", "--", "autograder"}).output;
  REQUIRE(contains(others, "TODO(6.1)"));
  REQUIRE(contains(judge, "TEST_CASE"));
  CHECK(answers_in(handout.layout, others, add_lines) == Texts{});
  CHECK(answers_in(handout.layout, judge, add_passages) == Texts{});
  for (const char* place : {"solutions", "docs", "autograder/submissions", "autograder/tests"}) {
    CHECK_FALSE(fs::exists(handout.root / place));
  }
}

TEST_CASE("a handout's README speaks of what is handed out, and of nothing else") {
  const auto readme = [](const Handout& handout) {
    REQUIRE(handout.written.exit_code == 0);
    const std::string text = read_text(handout.root / "README.md");
    for (auto at = text.find("]("); at != std::string::npos; at = text.find("](", at + 1)) {
      const std::string link = text.substr(at + 2, text.find(')', at) - at - 2);
      CAPTURE(link);
      CHECK(fs::exists(handout.root / link));
    }
    CHECK(!contains(text, "<!--"));
    return text;
  };
  const std::string all = readme(Handout()), one = readme(Handout({"--labs", "1"})),
                    fourth = readme(Handout({"--labs", "blue_noise"}));
  CHECK(contains(all, "`./lab render`"));
  CHECK(contains(all, "- [Lab 6 · sampler](labs/6-sampler/README.md)"));
  CHECK(!contains(one, "./lab render"));
  CHECK(contains(one, "`./lab check 1.3`"));
  CHECK(!contains(one, "Lab 2"));
  CHECK(contains(fourth, "`./lab check 4.3`"));
  CHECK(contains(fourth, "`starter/blue_noise.cpp`"));
  CHECK(!contains(fourth, "variance"));
}

TEST_CASE("a handout's containers bring everything that ./lab looks for") {
  const fs::path root = Course().layout.root;
  const auto packages = sandbox::run_process(
      {"sh", "-c",
       "set -e; . cmake/setup.sh; for thing in $(CXX=no-such-compiler missing_things) gnuplot; do "
       "package_of $thing apt; done"},
      {.directory = root});
  CAPTURE(packages.output, packages.errors);
  REQUIRE(contains(packages.output, "libseccomp-dev"));
  for (const char* file : {"Dockerfile", ".github/workflows/grade.yml"}) {
    const std::string text = read_text(root / "docs" / "handout" / file);
    for (const std::string_view package : text::split(packages.output, '\n')) {
      CAPTURE(file, package);
      CHECK(contains(text, std::string(package)));
    }
  }
}

/// Files of a build that was copied with a checkout, and when they were written. That checkout must
/// stay as it is.
struct CopiedBuild {
  fs::path original;
  std::vector<fs::path> files;
  std::vector<fs::file_time_type> times;

  CopiedBuild(const fs::path& from, const fs::path& to) : original(from) {
    fs::create_directories(to / "bin");
    for (const char* file : {"CMakeCache.txt", "build.ninja", ".ninja_log", ".ninja_deps",
                             "layout.txt", "bin/grader", "libsandbox.a"}) {
      if (!fs::exists(from / file)) continue;  // another generator
      fs::copy_file(from / file, to / file);
      files.emplace_back(file);
    }
    times = written();
    REQUIRE(times.size() > 3);
  }
  std::vector<fs::file_time_type> written() const {
    std::vector<fs::file_time_type> now;
    for (const fs::path& file : files) now.push_back(fs::last_write_time(original / file));
    return now;
  }
};

// Some forty seconds of CPU time: not in --quick. A build was copied along, as by `cp -r` of
// another checkout: the door's own tests (moved_test.cpp) have a stub behind it, this is the whole.
// That it builds from nothing is Gradescope's test.
TEST_CASE("a handout works from the first call on", "[.handout]") {
  const Handout handout({"--labs", "variance"});
  REQUIRE(handout.written.exit_code == 0);
  const CopiedBuild copied(handout.layout.build, handout.root / "build");
  const fs::path file = handout.root / "starter" / "variance.cpp";
  const std::string starter = read_text(file);

  const auto begun = handout.lab({"check", "variance"});
  CAPTURE(begun.output, begun.errors);
  CHECK(begun.exit_code == 1);
  CHECK(contains(begun.output, "0 of 100 points"));
  CHECK(contains(begun.output, "not written yet"));
  CHECK(contains(begun.errors, "was built for"));
  CHECK(copied.written() == copied.times);

  write_text(file, text_of(handout.layout.solutions()));
  const auto done = handout.lab({"check", "variance"});
  CAPTURE(done.output, done.errors);
  CHECK(done.exit_code == 0);
  CHECK(contains(done.output, "100 of 100 points"));

  const auto help = handout.lab({"--help"});
  const auto verbs = listed_verbs(help.output);
  CHECK(verbs ==
        std::vector<std::string>{"setup", "check", "run", "plot", "report", "reset", "submit"});
  for (const std::string& verb : verbs) {
    const auto run = handout.lab({verb, "--help"});
    CAPTURE(verb, run.errors);
    CHECK(run.exit_code == 0);
    CHECK(contains(run.output, "usage: ./lab " + verb));
  }
  // What is not handed out is no verb there, and a line says so.
  for (const char* verb : {"render", "bench", "test", "handout"}) {
    const auto run = handout.lab({verb});
    CAPTURE(verb, run.errors);
    CHECK(run.exit_code == 2);
    CHECK(contains(last_line(run.errors), "is not here"));
  }

  CHECK(contains(handout.lab({"run", "variance", "mean", "1,2,6"}).output, "3"));
  CHECK(handout.lab({"submit", "variance"}).exit_code == 0);
  CHECK(fs::exists(handout.root / "submission.zip"));
  CHECK(handout.lab({"reset", "variance"}).exit_code == 0);
  CHECK(read_text(file) == starter);
}

}  // namespace mc::tests::handout
