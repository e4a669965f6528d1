// Gradescope: the zip, and what its image does with a submission.
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "checks/support/catch.hpp"
#include "tests/gradebook/course.hpp"
#include "tests/text.hpp"

namespace mc::tests::gradescope {

namespace fs = std::filesystem;
using namespace grader;

namespace {

/// /autograder, as Gradescope lays it out, somewhere else.
struct Container : Course {
  fs::path root = fs::canonical(path()) / "autograder", zip = path() / "autograder.zip";
  fs::path source = root / "source", handed = root / "submission",
           results = root / "results" / "results.json";
  sandbox::ProcessResult written;

  explicit Container(const std::vector<std::string>& more) {
    std::vector<std::string> words{"gradescope", "variance", "--out", zip.string()};
    words.insert(words.end(), more.begin(), more.end());
    written = run(words);
    for (const fs::path& place : {source, handed, results.parent_path()}) {
      fs::create_directories(place);
    }
    sandbox::run_process({"cmake", "-E", "tar", "xf", zip.string()}, {.directory = source});
    write_text(root / "submission_metadata.json", "{}");
  }
  sandbox::ProcessResult script(const std::string& name) const {
    return sandbox::run_process(
        {(source / name).string()},
        {.directory = root, .environment = {{"AUTOGRADER_ROOT", root.string()}, {"MC_BUILD", ""}}});
  }
  /// Hands in these files alone, and grades them.
  sandbox::ProcessResult grade(const std::vector<std::pair<fs::path, std::string>>& files) const {
    fs::remove_all(handed);
    fs::create_directories(handed);
    for (const auto& [file, text] : files) {
      fs::create_directories((handed / file).parent_path());
      write_text(handed / file, text);
    }
    return script("run_autograder");
  }
};

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

}  // namespace

TEST_CASE("Gradescope's zip has what it asks for at its top, the version, and no answer") {
  const Container plain({"--visibility", "after_due_date"});
  CAPTURE(plain.written.output, plain.written.errors);
  REQUIRE(plain.written.exit_code == 0);
  for (const char* script : {"setup.sh", "run_autograder"}) {
    const auto permissions = fs::status(plain.source / script).permissions();
    CHECK((permissions & fs::perms::owner_exec) != fs::perms::none);
  }
  CHECK(read_text(plain.source / "VERSION.txt") == plain.layout.version + '\n');
  for (const char* place : {"solutions", "autograder/submissions", "autograder/tests", ".git",
                            "build", "labs/2-independent"}) {
    CHECK_FALSE(fs::exists(plain.source / place));
  }
  const std::string script = read_text(plain.source / "run_autograder");
  CHECK(contains(script, "\nLAB=variance\nLEADERBOARD=\nVISIBILITY=after_due_date\n"));

  // A leaderboard compares with the reference, of these labs alone.
  const Container compared({"--leaderboard"});
  CHECK(contains(read_text(compared.source / "run_autograder"), "\nLEADERBOARD=1\n"));
  CHECK(fs::exists(compared.source / "solutions" / "variance.cpp"));
  CHECK_FALSE(fs::exists(compared.source / "solutions" / "halton.cpp"));
}

TEST_CASE("a lab's zip has the labs that it stands on") {
  const Course course;
  const fs::path zip = course.path() / "6.zip";
  const auto run = course.run({"gradescope", "6", "1", "--out", zip.string()});
  CHECK(run.exit_code == 0);
  const auto listed = sandbox::run_process({"cmake", "-E", "tar", "tf", zip.string()});
  for (const char* file :
       {"labs/3-stratification/stratification.hpp", "autograder/checks/sampler/"}) {
    CHECK(contains(listed.output, file));
  }
  CHECK_FALSE(contains(listed.output, "solutions/"));
  CHECK(course.run({"gradescope", "--out", zip.string()}).exit_code == 2);
  CHECK(course.run({"gradescope", "1"}).exit_code == 2);
  CHECK(course.run({"gradescope", "1", "--out", "/no/such/place/a.zip"}).exit_code == 2);
  CHECK(course.run({"gradescope", "1", "--out", zip.string(), "--visibility", "never"}).exit_code ==
        2);
}

// Built from nothing, as Gradescope does: not in --quick.
TEST_CASE("Gradescope grades what is handed in, and invents no score", "[.gradescope]") {
  const Container container({"--visibility", "hidden"});
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

  // For ever in one task: the others count. What failed, the student can repeat at home.
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

  // With a leaderboard: what such a zip has more, in the same container.
  const Container compared({"--leaderboard"});
  fs::copy(compared.source / "solutions", container.source / "solutions",
           fs::copy_options::recursive);
  fs::copy_file(compared.source / "run_autograder", container.source / "run_autograder",
                fs::copy_options::overwrite_existing);
  const auto told = container.grade({{"variance.cpp", solution}});
  CAPTURE(told.output, told.errors);
  REQUIRE(told.exit_code == 0);
  const auto ranked = nlohmann::json::parse(read_text(container.results));
  CHECK(ranked["score"] == 100);
  CHECK(ranked["visibility"] == "visible");
  REQUIRE(ranked["leaderboard"].size() == 1);
  CHECK(ranked["leaderboard"][0]["name"] == "lab 1: speed, times the reference's");
  CHECK(ranked["leaderboard"][0]["value"] > 0.1);  // of itself, on any machine: about 1
  CHECK(container.grade({{"variance.cpp", starter}}).exit_code == 0);
  CHECK_FALSE(nlohmann::json::parse(read_text(container.results)).contains("leaderboard"));

  // A grader that cannot be built is nobody's zero: no results.json, not even the last one.
  write_text(container.source / "autograder" / "grader" / "main.cpp", "no grader\n");
  const auto fails = container.grade({{"variance.cpp", solution}});
  CHECK(fails.exit_code == 3);
  CHECK_FALSE(fs::exists(container.results));
}

}  // namespace mc::tests::gradescope
