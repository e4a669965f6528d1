// The handout holds no answers. checkout_test.cpp tests that it works.
#include <set>

#include "runner/text.hpp"
#include "tests/gradebook/handout.hpp"

namespace mc::tests::handout {

namespace {

/// Lines without blanks and without git's markers of added lines.
Words lines_of(const std::string& text) {
  Words lines;
  for (std::string_view line : text::split(text, '\n')) {
    if (line.starts_with('+')) line.remove_prefix(1);
    const auto first = line.find_first_not_of(" \t");
    if (first == std::string_view::npos) continue;
    lines.emplace_back(line.substr(first));
  }
  return lines;
}

using Texts = std::set<std::string>;

/// Lines that identify an answer: long ones.
void add_lines(const std::string& text, Texts& to) {
  constexpr std::size_t long_enough = 40;
  for (std::string& line : lines_of(text)) {
    if (line.size() > long_enough) to.insert(std::move(line));
  }
}

/// Four lines in a row. The judge computes the same things as the answers, so they share loops here
/// and there, of at most three lines.
void add_passages(const std::string& text, Texts& to) {
  constexpr std::size_t long_enough = 100;
  Words lines = lines_of(text);
  std::erase_if(lines, [](const std::string& line) { return line.size() < 4; });  // braces
  for (std::size_t i = 0; i + 4 <= lines.size(); ++i) {
    const std::string four =
        lines[i] + '\n' + lines[i + 1] + '\n' + lines[i + 2] + '\n' + lines[i + 3];
    if (four.size() > long_enough) to.insert(four);
  }
}

using Add = void(const std::string& text, Texts& to);

Texts texts_in(const Layout& layout, const Words& places, Add* add) {
  Texts all;
  for (const std::string& place : places) {
    for (const auto& entry : fs::recursive_directory_iterator(layout.root / place)) {
      if (entry.is_regular_file()) add(read_text(entry.path()), all);
    }
  }
  return all;
}

/// Lines or passages of the answers that this text has and the students' files do not.
Texts answers_in(const Layout& layout, const std::string& text, Add* add) {
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

}  // namespace

TEST_CASE("neither a handout nor its history has an answer", "[.update]") {
  const Handout handout({"--with-sources"});
  CAPTURE(handout.written.errors);
  REQUIRE(handout.written.exit_code == 0);
  CHECK(git(handout.root, {"status", "--porcelain"}).empty());  // its history has every file
  CHECK(lines(git(handout.root, {"rev-list", "--all"})) == 1);
  const std::string others = git(handout.root, {"log", "-p", "--all", "--", ".", ":!autograder"});
  const std::string judge = git(handout.root, {"log", "-p", "--all", "--", "autograder"});
  REQUIRE(contains(others, "TODO(6.1)"));
  REQUIRE(contains(judge, "TEST_CASE"));
  CHECK(answers_in(handout.layout, others, add_lines) == Texts{});
  CHECK(answers_in(handout.layout, judge, add_passages) == Texts{});
  for (const char* place : {"solutions", "docs", "autograder/submissions", "autograder/tests"}) {
    CHECK_FALSE(fs::exists(handout.root / place));
  }
}

TEST_CASE("a handout's README covers exactly the handout's content", "[.update]") {
  const auto readme = [](const Handout& handout) {
    REQUIRE(handout.written.exit_code == 0);
    std::string text = read_text(handout.root / "README.md");
    for (auto at = text.find("]("); at != std::string::npos; at = text.find("](", at + 1)) {
      const std::string link = text.substr(at + 2, text.find(')', at) - at - 2);
      CAPTURE(link);
      CHECK(fs::exists(handout.root / link));
    }
    CHECK(!contains(text, "<!--"));
    return text;
  };
  const Handout first({"--labs", "1", "--hints", "1"});
  const std::string all = readme(Handout()), one = readme(first),
                    fourth = readme(Handout({"--labs", "blue_noise"}));
  check_contains(all, {"`./lab render`", "- [Lab 6 · sampler](labs/6-sampler/README.md)",
                       "a task has three steps"});
  check_contains(one, {"`./lab check 1.3`", "a task has one step"});
  check_lacks(one, {"./lab render", "Lab 2"});
  CHECK(
      contains(read_text(first.root / "labs/1-variance/README.md"), "has one step for each task"));
  check_contains(fourth, {"`./lab check 4.3`", "`starter/blue_noise.cpp`"});
  CHECK(!contains(fourth, "variance"));
}

TEST_CASE("a handout's containers have everything that ./lab requires") {
  const fs::path root = Course().layout.root;
  const auto packages = sandbox::run_process(
      {"sh", "-c",
       "set -e; . cmake/setup.sh; for thing in $(CXX=no-such-compiler missing_things) gnuplot; do "
       "package_of $thing apt; done"},
      {.directory = root});
  CAPTURE(packages.output, packages.errors);
  REQUIRE(contains(packages.output, "libseccomp-dev"));
  for (const char* file : {"Dockerfile", ".github/workflows/grade.yml"}) {
    const auto names = text::split(packages.output, '\n');
    check_contains(read_text(root / "docs" / "handout" / file), {names.begin(), names.end()});
  }
}

}  // namespace mc::tests::handout
