// The student handout and the Gradescope package work. Both have the same labs, judge and starters,
// byte by byte: one replaces the other in place, so the minute-long build happens once.
#include <algorithm>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "checks/support/catch.hpp"
#include "runner/text.hpp"
#include "tests/gradebook/container.hpp"
#include "tests/gradebook/handout.hpp"
#include "tests/text.hpp"

namespace mc::tests::checkout {

namespace fs = std::filesystem;
using namespace grader;

namespace {

/// Files of a build that was copied with a checkout, and their modification times. The original
/// checkout must stay unchanged.
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

std::vector<std::string> listed_verbs(const std::string& help) {
  std::vector<std::string> commands;
  for (std::string_view line : text::split(help, '\n')) {
    constexpr std::string_view start = "./lab ";
    line.remove_prefix(std::min(line.find_first_not_of(' '), line.size()));
    if (!line.starts_with(start) || line[start.size()] == ' ') continue;
    line.remove_prefix(start.size());
    commands.emplace_back(line.substr(0, line.find(' ')));
  }
  return commands;
}

/// A build was copied along, as by `cp -r` of another checkout. The entry script's own tests
/// (moved_test.cpp) use a stub; this is the real build. The copy is discarded and everything is
/// built from scratch.
void works_from_the_first_call_on(const Handout& handout) {
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
  const auto commands = listed_verbs(help.output);
  CHECK(commands == std::vector<std::string>{"setup", "check", "run", "hint", "plot", "report",
                                             "reset", "submit"});
  for (const std::string& command : commands) {
    const auto run = handout.lab({command, "--help"});
    CAPTURE(command, run.errors);
    CHECK(run.exit_code == 0);
    CHECK(contains(run.output, "usage: ./lab " + command));
  }
  // Commands that are not part of the handout are unknown there, and a message says so.
  for (const char* command : {"render", "bench", "test", "handout"}) {
    const auto run = handout.lab({command});
    CAPTURE(command, run.errors);
    CHECK(run.exit_code == 2);
    CHECK(contains(last_line(run.errors), "is not here"));
  }

  CHECK(contains(handout.lab({"run", "variance", "mean", "1,2,6"}).output, "3"));
  CHECK(handout.lab({"submit", "variance"}).exit_code == 0);
  CHECK(fs::exists(handout.root / "submission.zip"));
  CHECK(handout.lab({"reset", "variance"}).exit_code == 0);
  CHECK(read_text(file) == starter);
}

/// Makes the checkout equal to the tree. Common files stay untouched, and so do their builds.
void put_in_place_of(const fs::path& checkout, const fs::path& tree) {
  for (auto file = fs::recursive_directory_iterator(checkout);
       file != fs::recursive_directory_iterator(); ++file) {
    const fs::path name = fs::relative(file->path(), checkout);
    if (name == "build" || name == ".git") file.disable_recursion_pending();
    if (file->is_regular_file() && !fs::exists(tree / name)) fs::remove(file->path());
  }
  fs::remove_all(checkout / ".git");
  for (const auto& file : fs::recursive_directory_iterator(tree)) {
    if (!file.is_regular_file()) continue;
    const fs::path name = fs::relative(file.path(), tree);
    CAPTURE(name);
    if (fs::exists(checkout / name)) {
      CHECK(read_text(checkout / name) == read_text(file.path()));
    } else {
      fs::create_directories((checkout / name).parent_path());
      fs::copy_file(file.path(), checkout / name);
    }
  }
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

void grades_what_is_handed_in(const Container& container) {
  const auto built = container.script("setup.sh");
  CAPTURE(built.output, built.errors);
  REQUIRE(built.exit_code == 0);
  const std::string starter = text_of(container.layout.starter());
  const std::string solution = text_of(container.layout.solutions());
  const auto results = [&](const std::vector<std::pair<fs::path, std::string>>& files) {
    const auto run = container.grade(files);
    CAPTURE(run.output, run.errors);
    CHECK(run.exit_code == 0);
    const std::string text = read_text(container.results);
    CHECK_FALSE(contains(text, container.path().string()));  // no path of the container
    auto json = nlohmann::json::parse(text, nullptr, false);
    REQUIRE_FALSE(json.is_discarded());
    CHECK(json["visibility"] == "hidden");
    CHECK(json["tests"].size() > 20);
    CHECK(json["extra_data"]["version"] == container.layout.version);
    return json;
  };

  const auto all = results({{"variance.cpp", solution}});
  CHECK(all["score"] == 100);
  CHECK_FALSE(all.contains("leaderboard"));

  const auto none = results({{"variance.cpp", starter}});
  CHECK(none["score"] == 0);
  CHECK(count(none.dump(), "not written yet") > 20);

  const auto empty = results({{"readme.txt", "I wrote nothing"}});
  CHECK(empty["score"] == 0);
  CHECK(contains(empty["output"], "variance.cpp"));

  const auto broken = results({{"variance.cpp", "int 7 is no name;\n"}});
  CHECK(broken["score"] == 0);
  CHECK(contains(broken["output"], "variance.cpp:1:5: error"));
  CHECK(count(broken.dump(), "does not compile") == 1);

  const auto curious = results(
      {{"variance.cpp", "#include \"../autograder/checks/support/exact.hpp\"\n" + starter}});
  CHECK(curious["score"] == 0);

  // One endless task: the others count. The student can repeat the failures at home.
  std::string loops = solution;
  const std::string begin = "double mean(std::span<const double> x) {";
  REQUIRE(contains(loops, begin));
  loops.insert(loops.find(begin) + begin.size(), "\n  for (volatile bool on = true; on;) {\n  }\n");
  const auto late = results({{"variance.cpp", loops}});
  CHECK(late["score"] < 100);
  std::size_t failed = 0;
  for (const auto& test : late["tests"]) {
    const std::string output = test["output"];
    failed += contains(output, "again");
    if (contains(output, "again")) CHECK(contains(output, "./lab check variance --only "));
  }
  CHECK(failed > 0);

  const auto deeper = results({{"my lab/variance.cpp", solution}, {"my lab/notes.txt", ""}});
  CHECK(deeper["score"] == 100);
  CHECK(contains(deeper["output"], "found in my lab"));

  const auto repository = results({{".git/HEAD", ""},
                                   {"README.md", ""},
                                   {"starter/variance.cpp", solution},
                                   {"build/variance.cpp", starter}});
  CHECK(repository["score"] == 100);

  // With a leaderboard: adds what such a zip has in addition, in the same container.
  const Container compared({"--leaderboard"});
  fs::copy(compared.source / "solutions", container.source / "solutions",
           fs::copy_options::recursive);
  fs::copy_file(compared.source / "run_autograder", container.source / "run_autograder",
                fs::copy_options::overwrite_existing);
  const auto graded = container.grade({{"variance.cpp", solution}});
  CAPTURE(graded.output, graded.errors);
  REQUIRE(graded.exit_code == 0);
  const auto ranked = nlohmann::json::parse(read_text(container.results));
  CHECK(ranked["score"] == 100);
  CHECK(ranked["visibility"] == "visible");
  REQUIRE(ranked["leaderboard"].size() == 1);
  CHECK(ranked["leaderboard"][0]["name"] == "lab 1: speed, times the reference's");
  CHECK(ranked["leaderboard"][0]["value"].is_number());
  CHECK(container.grade({{"variance.cpp", starter}}).exit_code == 0);
  CHECK_FALSE(nlohmann::json::parse(read_text(container.results)).contains("leaderboard"));

  // A grader that cannot be built gives no student a zero: no results.json, not even an old one.
  write_text(container.source / "autograder" / "grader" / "main.cpp", "no grader\n");
  const auto fails = container.grade({{"variance.cpp", solution}});
  CHECK(fails.exit_code == 3);
  CHECK_FALSE(fs::exists(container.results));
}

}  // namespace

// Takes 90 s of CPU time: not in --quick.
TEST_CASE("a handout works from the first call on, and Gradescope's zip never invents a score",
          "[.checkout]") {
  const Container container({"--visibility", "hidden"});
  const fs::path unzipped = container.path() / "unzipped";
  fs::rename(container.source, unzipped);
  const Handout handout({"--labs", "variance"}, container.source);
  works_from_the_first_call_on(handout);
  put_in_place_of(container.source, unzipped);
  grades_what_is_handed_in(container);
}

}  // namespace mc::tests::checkout
