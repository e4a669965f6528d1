// Gradescope's zip, and what its container does with a submission.

#include <nlohmann/json.hpp>

#include "tests/classes/course.hpp"

namespace mc::tests::gradescope {

namespace {

using Files = std::map<std::string, std::string>;

/// Gradescope's /autograder, in a temporary directory.
struct Container : Course {
  fs::path root = fs::canonical(path()) / "autograder", source = root / "source",
           submitted = root / "submission", results = root / "results" / "results.json";

  Container() {
    const fs::path zip = path() / "autograder.zip";
    output_of({"gradescope", "variance", "--out", zip});
    fs::create_directories(source);
    fs::create_directories(results.parent_path());
    sandbox::run_process({"cmake", "-E", "tar", "xf", zip}, {.directory = source});
    write_text(root / "submission_metadata.json", "{}");
  }
  sandbox::ProcessResult script(const std::string& name) const {
    return sandbox::run_process(
        {(source / name).string()},
        {.directory = root, .environment = {{"AUTOGRADER_ROOT", root.string()}, {"MC_BUILD", ""}}});
  }
  /// Hands in only these files, and grades them.
  sandbox::ProcessResult grade(const Files& files) const {
    fs::remove_all(submitted);
    for (const auto& [file, text] : files) write("autograder/submission/" + file, text);
    return script("run_autograder");
  }
  nlohmann::json results_of(const Files& files) const {
    REQUIRE_RUN(run, grade(files));
    const std::string text = read_text(results);
    CHECK_FALSE(contains(text, path().string()));  // no path of the container
    auto json = nlohmann::json::parse(text, nullptr, false);
    REQUIRE_FALSE(json.is_discarded());
    CHECK(json["tests"].size() > 20);
    CHECK(json["extra_data"]["version"] == layout.version);
    for (const auto& test : json["tests"]) {  // shown with the next assertion, if that fails
      if (test["score"] != test["max_score"]) UNSCOPED_INFO(test.dump());
    }
    return json;
  }
};

}  // namespace

TEST_CASE("Gradescope's zip has the required files at its top, the version, and no answers") {
  const Container plain;
  for (const char* script : {"setup.sh", "run_autograder"}) {
    const auto permissions = fs::status(plain.source / script).permissions();
    CHECK((permissions & fs::perms::owner_exec) != fs::perms::none);
  }
  CHECK(contains(read_text(plain.source / "autograder" / "bin" / "layout.json"),
                 plain.layout.version));
  for (const char* place : {"solutions", "autograder/submissions", "autograder/tests",
                            "autograder/checks", ".git", "build", "labs/2-independent"}) {
    CHECK_FALSE(fs::exists(plain.source / place));
  }
  CHECK(contains(read_text(plain.source / "run_autograder"), "\nLAB=variance\n"));
}

TEST_CASE("a lab's zip has the labs that it depends on") {
  const Course course;
  const fs::path zip = course.path() / "6.zip";
  course.output_of({"gradescope", "6", "1", "--out", zip});
  const auto listed = sandbox::run_process({"cmake", "-E", "tar", "tf", zip});
  check_contains(listed.output, {"labs/3-stratification/stratification.hpp", "/checks_sampler",
                                 "/checks_variance"});
  check_lacks(listed.output, {"solutions/", "autograder/checks/"});
  for (const Words& wrong : {Words{"--out", zip}, {"1"}, {"1", "--out", "/no/such/place/a.zip"}}) {
    check_refused(lab(joined({"gradescope"}, wrong)));
  }
}

TEST_CASE("Gradescope's zip never invents a score", "[.gradescope]") {
  const Container container;
  REQUIRE_RUN(built, container.script("setup.sh"));
  const std::string starter = text_of(container.layout.starter());
  const std::string solution = text_of(container.layout.solutions());

  // A repository in which other files have the lab's name.
  const auto all = container.results_of({{".git/HEAD", ""},
                                         {"README.md", ""},
                                         {"starter/variance.cpp", solution},
                                         {"build/variance.cpp", starter}});
  CHECK(all["score"] == 100);

  const auto empty = container.results_of({{"readme.txt", "I wrote nothing"}});
  CHECK(empty["score"] == 0);
  CHECK(contains(empty["output"], "variance.cpp"));

  const auto broken = container.results_of({{"variance.cpp", "int 7 is no name;\n"}});
  CHECK(broken["score"] == 0);
  CHECK(contains(broken["output"], "variance.cpp:1:5: error"));
  CHECK(times(broken.dump(), "does not compile") == 1);

  // The judge's files are not there to include.
  const auto curious = container.results_of(
      {{"variance.cpp", "#include \"../autograder/checks/support/exact.hpp\"\n" + starter}});
  CHECK(curious["score"] == 0);

  // One task is endless for some arguments: the others count. The student can repeat the failures.
  const std::string head =
      "double covariance(std::span<const double> x, std::span<const double> y) {\n";
  const auto late = container.results_of(
      {{"my lab/variance.cpp",
        with_change(solution, head,
                    head + "  for (volatile bool on = x.size() == 1; on;) {\n  }\n")}});
  CHECK(contains(late["output"], "found in my lab"));
  CHECK(late["score"] < 100);
  CHECK(late["score"] > 0);
  std::size_t failed = 0;
  for (const auto& test : late["tests"]) {
    const std::string output = test["output"];
    failed += contains(output, "again");
    if (contains(output, "again")) CHECK(contains(output, "./lab check variance --only "));
  }
  CHECK(failed > 0);

  const auto none = container.results_of({{"variance.cpp", starter}});
  CHECK(none["score"] == 0);
  CHECK(times(none.dump(), "not written yet") > 20);

  // A grader that is missing gives no student a zero: no results.json, not even an old one.
  fs::remove_all(container.source / "autograder" / "bin");
  const auto fails = container.grade({{"variance.cpp", solution}});
  CHECK(fails.exit_code == 3);
  CHECK_FALSE(fs::exists(container.results));
}

}  // namespace mc::tests::gradescope
