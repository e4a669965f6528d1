// The students' handout works, with a compiled judge and with its sources.
#include <algorithm>
#include <fstream>
#include <regex>

#include <nlohmann/json.hpp>

#include "commands/new_lab.hpp"
#include "judge/base/replace.hpp"
#include "tests/classes/handout.hpp"

namespace mc::tests::checkout {

namespace {

Words listed_commands(const std::string& help) {
  static const std::regex command("\n *\\./lab ([^ \\n]+)");
  return {std::sregex_token_iterator(help.begin(), help.end(), command, 1), {}};
}

/// A student's first steps.
void works_from_the_first_call_on(const Handout& handout) {
  const fs::path file = handout.root / "starter" / "variance.cpp";
  const std::string starter = read_text(file);

  const auto begun = handout.lab({"check", "variance"});
  CAPTURE(begun.output, begun.errors);
  CHECK(begun.exit_code == 1);
  check_contains(begun.output, {"0 of 100 points", "not written yet"});

  write_text(file, text_of(handout.layout.solutions()));
  REQUIRE_RUN(done, handout.lab({"check", "variance"}));
  CHECK(contains(done.output, "100 of 100 points"));

  const auto commands = listed_commands(handout.lab({"--help"}).output);
  CHECK(commands == Words{"check", "demo", "hint", "plot", "run", "setup", "submit"});
  for (const std::string& command : commands) {
    CAPTURE(command);
    REQUIRE_RUN(run, handout.lab({command, "--help"}));
    CHECK(contains(run.output, "usage: ./lab " + command));
  }
  // Commands that are not part of the handout are unknown there, and a message says so.
  for (const char* command : {"render", "bench", "test", "handout"}) {
    check_refused(handout.lab({command}));
  }

  CHECK(contains(handout.lab({"run", "variance", "mean", "1,2,6"}).output, "3"));
  REQUIRE_RUN(handed_in, handout.lab({"submit", "variance"}));
  check_contains(handed_in.output,
                 {"variance.cpp, answers/1-variance.md", "The last check: 100 of 100 points.",
                  "Not answered in answers/1-variance.md: 1, 2"});
  CHECK(fs::exists(handout.root / "1-variance.zip"));
  write_text(file, starter);
  CHECK(contains(handout.lab({"submit", "variance"}).output, "it has changed since"));
  write_text(file, "int 7 is no name;\n");
  CHECK(contains(handout.lab({"submit", "variance"}).output, "earns 0 points"));
}

/// A build was copied along, as by `cp -r` of another checkout. The entry script's own tests
/// (moved_test.cpp) use a stub; this is the real build. The copy is discarded, everything is built
/// from scratch, and the original stays unchanged.
void builds_from_sources(const Handout& handout) {
  const auto written = [&] { return fs::last_write_time(handout.layout.build / "CMakeCache.txt"); };
  const auto before = written();
  fs::create_directories(handout.root / "build" / "bin");
  for (const char* file : {"CMakeCache.txt", "build.ninja", ".ninja_log", ".ninja_deps",
                           "layout.json", "bin/lab", "libsandbox.a"}) {
    if (!fs::exists(handout.layout.build / file)) continue;  // another generator
    fs::copy_file(handout.layout.build / file, handout.root / "build" / file);
  }
  REQUIRE_RUN(first, handout.lab({"--version"}));
  CHECK(contains(first.errors, "was built for"));
  CHECK(written() == before);
}

/// A directory of programs, to be all that a search path has.
void link_programs(const fs::path& directory, const Words& names) {
  fs::create_directories(directory);
  for (const std::string& name : names) {
    const auto found = sandbox::run_process({"sh", "-c", "command -v " + name});
    REQUIRE(found.succeeded());
    fs::create_symlink(found.output.substr(0, found.output.find('\n')), directory / name);
  }
}

/// The tasks of the editor and the program that F5 starts, with starter/variance.cpp open.
void editor_commands_work(const Handout& handout) {
  const auto read = [&](const std::string& name) {
    return nlohmann::json::parse(
        with_replacements(read_text(handout.root / ".vscode" / name),
                          {{"${fileBasenameNoExtension}", "variance"},
                           {"${workspaceFolder}", handout.root.native()}}));
  };
  const auto tasks = read("tasks.json")["tasks"];
  Words labels;
  for (const auto& task : tasks) {
    CAPTURE(task["command"]);
    REQUIRE_RUN(run, handout.lab_words(task["command"]));
    labels.push_back(task["label"]);
  }
  for (const auto& configuration : read("launch.json")["configurations"]) {
    CHECK(std::count(labels.begin(), labels.end(), configuration["preLaunchTask"]) == 1);
    const std::string program = configuration["program"];
    CHECK(contains(sandbox::run_process({program, "--list"}).output, "welford"));
  }
}

}  // namespace

TEST_CASE("a handout needs only a compiler", "[.handout]") {
  Handout handout({"--labs", "variance"});
  if (!has_compiled_judge(handout.layout)) {
    WARN("the judge cannot be linked statically here");
    return;
  }
  CAPTURE(handout.written.errors);
  REQUIRE(handout.written.exit_code == 0);
  // Static programs, which name no loader, and not one source of the judge.
  for (const auto& file : fs::recursive_directory_iterator(handout.root / "autograder")) {
    CAPTURE(file.path());
    CHECK(file.path().extension() != ".cpp");
    CHECK(file.path().extension() != ".hpp");
    constexpr const char* program =
        "\x7f"
        "ELF";
    if (file.is_regular_file() && read_text(file.path()).starts_with(program)) {
      CHECK_FALSE(contains(read_text(file.path()), "/lib64/ld-linux"));
    }
  }
  handout.search_path = handout.path() / "programs";
  link_programs(handout.search_path, {"sh", "uname", "dirname", "c++", "as", "ld"});
  works_from_the_first_call_on(handout);

  write_text(handout.root / "starter" / "variance.cpp", text_of(handout.layout.solutions()));
  CHECK(contains(handout.lab({"hint", "1.1"}).output, "1.1"));
  const std::string wrong =
      text_with_first_line_of_mean(handout.layout, "  if (x.size() > 2) return 42;");
  const fs::path file = handout.root / "starter" / "variance.cpp";
  write_text(file, wrong);
  for (int times = 1; times <= 3; ++times) {
    const std::string report = handout.lab({"check", "1.1"}).output;
    CHECK(contains(report, "./lab hint 1.1 shows a step") == (times == 3));
  }
  write_text(file, text_of(handout.layout.solutions()));
  CHECK(handout.lab({"check", "1.1"}).exit_code == 0);
  write_text(file, wrong);  // the count starts over
  CHECK_FALSE(contains(handout.lab({"check", "1.1"}).output, "./lab hint 1.1 shows a step"));
  write_text(file, text_of(handout.layout.solutions()));
  editor_commands_work(handout);
  CHECK(contains(handout.lab({"plot", "variance"}).output, "gnuplot is not installed"));
  link_programs(handout.search_path, {"gnuplot"});
  CHECK(handout.lab({"plot", "variance"}).exit_code == 0);

  // The ordinary way of a C++ programmer: starters are targets, tasks are tests.
  handout.search_path.clear();
  REQUIRE_RUN(built, handout.lab_words("cmake -B build/cmake && cmake --build build/cmake && "
                                       "ctest --test-dir build/cmake -R '^1[.][13]$'"));
  CHECK(contains(built.output, "100% tests passed, 0 tests failed out of 2"));
  CHECK(fs::exists(handout.root / "build" / "cmake" / "compile_commands.json"));
  handout.search_path = handout.path() / "programs";

  fs::remove(handout.search_path / "c++");
  const auto without = handout.lab({"check", "variance"});
  CHECK(without.exit_code == 3);
  CHECK(contains(without.errors, "no C++ compiler"));
  CHECK(handout.lab({"--help"}).exit_code == 0);
}

/// The skeleton that ./lab new-lab writes, in a checkout that is built anyway. Returns its
/// solution.
std::string with_new_lab(const Handout& handout) {
  const fs::path skeleton = handout.layout.root / "autograder" / "new-lab";
  CHECK_THROWS_AS(write_new_lab(skeleton, 2, "../x", handout.root), UsageError);
  CHECK(write_new_lab(skeleton, 2, "light_transport", handout.root).size() > 8);
  CHECK_THROWS_AS(write_new_lab(skeleton, 2, "light_transport", handout.root), UsageError);
  std::string solution = read_text(handout.root / "solutions" / "light_transport.cpp");
  fs::remove_all(handout.root / "solutions");  // a handout has none
  fs::remove_all(handout.root / "autograder" / "submissions");
  return solution;
}

void new_lab_works(const Handout& handout, const std::string& solution) {
  const fs::path file = handout.root / "starter" / "light_transport.cpp";
  CHECK(contains(handout.lab({"check", "2"}).output, "0 of 100 points"));
  write_text(file, solution);
  REQUIRE_RUN(right, handout.lab({"check", "2"}));
  CHECK(contains(handout.lab({"plot", "2"}).output, "light_transport-squares.svg"));
  CHECK(contains(handout.lab({"run", "2", "squares", "3"}).output, "9"));
  CHECK(contains(handout.lab({"hint", "2.1"}).output, "area"));
  write_text(file, with_change(solution, "x * x", "x"));
  CHECK(contains(handout.lab({"check", "2"}).output, "this is x itself, not its square"));
}

// Compiles the judge: not in --quick.
TEST_CASE("a handout with the judge's sources works from the first call on", "[.checkout]") {
  const Handout handout({"--labs", "variance", "--with-sources"});
  REQUIRE(handout.written.exit_code == 0);
  const std::string solution = with_new_lab(handout);
  builds_from_sources(handout);
  new_lab_works(handout, solution);
  works_from_the_first_call_on(handout);
}

}  // namespace mc::tests::checkout
