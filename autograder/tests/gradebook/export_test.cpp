// A class, exported for a tool that finds similar submissions.
#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "checks/support/catch.hpp"
#include "tests/gradebook/course.hpp"
#include "tests/text.hpp"

namespace mc::tests::exports {

namespace fs = std::filesystem;
using namespace grader;

namespace {

std::vector<std::string> files_in(const fs::path& directory) {
  std::vector<std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(directory)) {
    if (!entry.is_directory()) files.push_back(entry.path().lexically_relative(directory).string());
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

TEST_CASE("export for JPlag: a folder for each submission, the starters as base code") {
  Course course;
  const fs::path handed = course.path() / "class", out = course.path() / "out";
  course.hand_in("ada", "// ada\n");
  write_text(handed / "ada" / "notes.txt", "mine");
  course.write("class/bob/a/starter/halton.cpp", "// bob\n");  // as deep as grade finds it
  course.hand_in("$(touch x) '\x1b[31m", "// eve\n");
  fs::create_directories(handed / "fay");
  fs::create_symlink(course.layout.solutions() / "variance.cpp", handed / "fay" / "variance.cpp");
  fs::create_directory_symlink(course.layout.solutions(), handed / "sly");
  write_text(handed / "broken.zip", "no zip");

  REQUIRE_RUN(run, course.run({"export", "jplag", handed.string(), "--out", out.string()}));
  CHECK(files_in(out / "submissions") == std::vector<std::string>{"$(touch x) '?[31m/variance.cpp",
                                                                  "ada/variance.cpp",
                                                                  "bob/halton.cpp"});
  CHECK(read_text(out / "submissions" / "bob" / "halton.cpp") == "// bob\n");
  CHECK(files_in(out / "base-code") == files_in(course.layout.starter()));
  CHECK(read_text(out / "base-code" / "variance.cpp") == text_of(course.layout.starter()));
  CHECK(contains(run.output, "left out: broken: it is not a zip file"));
  CHECK(contains(run.output, "left out: fay: it contains no lab files"));
  CHECK(contains(run.output, "left out: sly: it is a link"));
  CHECK(contains(run.output, "3 submissions: java -jar jplag.jar -l cpp -bc " + out.string()));
}

TEST_CASE("export overwrites nothing, and explains its usage") {
  Course course;
  course.hand_in("ada", "int x;\n");
  const std::string handed = (course.path() / "class").string();
  const fs::path full = course.path() / "full", empty = course.path() / "empty";
  course.write("full/mine", "");
  fs::create_directories(empty);
  const auto refused = course.run({"export", "jplag", handed, "--out", full.string()});
  CHECK(refused.exit_code == 2);
  CHECK(contains(refused.errors, "is not empty"));
  const std::vector<std::vector<std::string>> wrong{
      {"export"},
      {"export", "jplag", handed},
      {"export", "moss", handed, "--out", empty.string()},
      {"export", "jplag", "--out", empty.string()},
      {"export", "jplag", empty.string(), "--out", (course.path() / "new").string()}};
  for (const auto& words : wrong) {
    CAPTURE(words);
    CHECK(course.run(words).exit_code == 2);
  }
  CHECK(fs::is_empty(empty));
  CHECK(!fs::exists(course.path() / "new"));
  CHECK(files_in(full) == std::vector<std::string>{"mine"});
}

}  // namespace mc::tests::exports
