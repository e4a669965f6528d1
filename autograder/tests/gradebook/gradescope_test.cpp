// Gradescope's zip. checkout_test.cpp tests what its image does with a submission.
#include <filesystem>
#include <string>

#include "checks/support/catch.hpp"
#include "tests/gradebook/container.hpp"
#include "tests/text.hpp"

namespace mc::tests::gradescope {

namespace fs = std::filesystem;
using namespace grader;

TEST_CASE("Gradescope's zip has the required files at its top, the version, and no answers") {
  const Container plain({"--visibility", "after_due_date"});
  CAPTURE(plain.written.output, plain.written.errors);
  REQUIRE(plain.written.exit_code == 0);
  for (const char* script : {"setup.sh", "run_autograder"}) {
    const auto permissions = fs::status(plain.source / script).permissions();
    CHECK((permissions & fs::perms::owner_exec) != fs::perms::none);
  }
  CHECK(contains(read_text(plain.source / "autograder" / "bin" / "layout.txt"),
                 "\nversion=" + plain.layout.version + '\n'));
  for (const char* place : {"solutions", "autograder/submissions", "autograder/tests",
                            "autograder/checks", ".git", "build", "labs/2-independent"}) {
    CHECK_FALSE(fs::exists(plain.source / place));
  }
  const std::string script = read_text(plain.source / "run_autograder");
  CHECK(contains(script, "\nLAB=variance\nLEADERBOARD=\nVISIBILITY=after_due_date\n"));

  // A leaderboard compares with the reference, for these labs only.
  const Container compared({"--leaderboard"});
  CHECK(contains(read_text(compared.source / "run_autograder"), "\nLEADERBOARD=1\n"));
  CHECK(fs::exists(compared.source / "solutions" / "variance.cpp"));
  CHECK_FALSE(fs::exists(compared.source / "solutions" / "halton.cpp"));
}

TEST_CASE("a lab's zip has the labs that it depends on") {
  const Course course;
  const fs::path zip = course.path() / "6.zip";
  REQUIRE_RUN(run, course.run({"gradescope", "6", "1", "--out", zip.string()}));
  const auto listed = sandbox::run_process({"cmake", "-E", "tar", "tf", zip.string()});
  for (const char* file :
       {"labs/3-stratification/stratification.hpp", "/checks_sampler", "/checks_variance"}) {
    CHECK(contains(listed.output, file));
  }
  CHECK_FALSE(contains(listed.output, "solutions/"));
  CHECK_FALSE(contains(listed.output, "autograder/checks/"));
  CHECK(course.run({"gradescope", "--out", zip.string()}).exit_code == 2);
  CHECK(course.run({"gradescope", "1"}).exit_code == 2);
  CHECK(course.run({"gradescope", "1", "--out", "/no/such/place/a.zip"}).exit_code == 2);
  CHECK(course.run({"gradescope", "1", "--out", zip.string(), "--visibility", "never"}).exit_code ==
        2);
}

}  // namespace mc::tests::gradescope
