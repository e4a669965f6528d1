// The handout holds no answers. checkout_test.cpp tests that it works.
#include <algorithm>
#include <set>

#include "runner/text.hpp"
#include "tests/classes/handout.hpp"

namespace mc::tests::handout {

namespace {

/// So many lines in a row, of more characters than this in all.
struct Passage {
  std::size_t lines, longer_than;
};
constexpr Passage line{1, 40};  // identifies an answer
// The judge computes the same things as the answers, so they share loops here and there, of at most
// three lines.
constexpr Passage four_lines{4, 100};

using Texts = std::set<std::string>;

/// Adds a text's passages, without blanks, braces, and git's markers of added lines.
void add_passages(const std::string& text, const Passage& kind, Texts& to) {
  Words lines;
  for (std::string_view one : text::split(text, '\n')) {
    if (one.starts_with('+')) one.remove_prefix(1);
    one.remove_prefix(std::min(one.find_first_not_of(" \t"), one.size()));
    if (one.size() >= 4) lines.emplace_back(one);
  }
  for (std::size_t i = 0; i + kind.lines <= lines.size(); ++i) {
    const auto first = lines.begin() + static_cast<std::ptrdiff_t>(i);
    const auto end = first + static_cast<std::ptrdiff_t>(kind.lines);
    std::string passage = fmt::format("{}", fmt::join(first, end, "\n"));
    if (passage.size() > kind.longer_than) to.insert(std::move(passage));
  }
}

Texts passages_in(const Layout& layout, const Words& places, const Passage& kind) {
  Texts all;
  for (const std::string& place : places) {
    for (const auto& entry : fs::recursive_directory_iterator(layout.root / place)) {
      if (entry.is_regular_file()) add_passages(read_text(entry.path()), kind, all);
    }
  }
  return all;
}

/// Passages of the answers that this text has and the students' files do not.
Texts answers_in(const Layout& layout, const std::string& text, const Passage& kind) {
  const std::string kinds = "autograder/submissions/";
  const Texts answers = passages_in(
      layout, {"solutions", kinds + "mistakes", kinds + "alternatives", kinds + "peers"}, kind);
  const Texts given = passages_in(layout, {"labs", "starter"}, kind);
  REQUIRE(answers.size() > 1000);
  Texts here, found;
  add_passages(text, kind, here);
  for (const std::string& one : here) {
    if (answers.contains(one) && !given.contains(one)) found.insert(one);
  }
  return found;
}

}  // namespace

TEST_CASE("neither a handout nor its history has an answer", "[.handout]") {
  const Handout handout({"--with-sources"});
  CAPTURE(handout.written.errors);
  REQUIRE(handout.written.exit_code == 0);
  CHECK(git(handout.root, {"status", "--porcelain"}).empty());  // its history has every file
  CHECK(lines(git(handout.root, {"rev-list", "--all"})) == 1);
  const std::string others = git(handout.root, {"log", "-p", "--all", "--", ".", ":!autograder"});
  const std::string judge = git(handout.root, {"log", "-p", "--all", "--", "autograder"});
  REQUIRE(contains(others, "TODO(6.1)"));
  REQUIRE(contains(judge, "TEST_CASE"));
  CHECK(answers_in(handout.layout, others, line) == Texts{});
  CHECK(answers_in(handout.layout, judge, four_lines) == Texts{});
  for (const char* place :
       {"solutions", "docs/answers", "autograder/submissions", "autograder/tests"}) {
    CHECK_FALSE(fs::exists(handout.root / place));
  }
}

TEST_CASE("a handout's README covers exactly the handout's content", "[.handout]") {
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

TEST_CASE("a new version is one commit on top, which git merges with a student's work",
          "[.handout]") {
  const Handout handout({"--labs", "1"});
  REQUIRE(handout.written.exit_code == 0);
  const fs::path clone = handout.path() / "student";
  git(handout.path(), {"clone", "-q", handout.root, clone});
  write_text(clone / "starter" / "variance.cpp", "// mine\n");
  git(clone, {"commit", "-q", "-a", "-m", "mine"});
  const auto again = [&](const Words& more = {}) {
    return lab(joined({"handout", handout.root.string()}, more));
  };
  CHECK(contains(again().output, "nothing to change"));
  // Files that are gone from the course go, others come; a lab is added, and none is dropped.
  handout.write("labs/labs/old.txt", "");
  git(handout.root, {"add", "-f", "labs/old.txt"});
  git(handout.root, {"commit", "-q", "-m", "old"});
  REQUIRE_RUN(more, again({"--labs", "4"}));
  CHECK(contains(more.output, "one commit on top"));
  CHECK(lines(git(handout.root, {"rev-list", "--all"})) == 3);
  CHECK_FALSE(fs::exists(handout.root / "labs" / "old.txt"));
  CHECK(fs::exists(handout.root / "starter" / "variance.cpp"));
  CHECK(fs::exists(handout.root / "starter" / "blue_noise.cpp"));
  git(clone, {"pull", "-q", "--no-rebase", "--no-edit"});
  CHECK(read_text(clone / "starter" / "variance.cpp") == "// mine\n");
  CHECK(fs::exists(clone / "starter" / "blue_noise.cpp"));
  write_text(handout.root / "README.md", "edited\n");
  check_refused(again(), "not committed");
}

}  // namespace mc::tests::handout
