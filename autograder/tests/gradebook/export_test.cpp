// A class, exported for a tool that finds similar submissions.
#include <algorithm>

#include "tests/gradebook/course.hpp"

namespace mc::tests::exports {

namespace {

Words files_in(const fs::path& directory) {
  Words files;
  for (const auto& entry : fs::recursive_directory_iterator(directory)) {
    if (!entry.is_directory()) files.push_back(entry.path().lexically_relative(directory).string());
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

TEST_CASE("export for JPlag: a folder for each submission, the starters as base code") {
  Course course;
  const fs::path submitted = course.path() / "class", out = course.path() / "out";
  course.hand_in("ada", "// ada\n");
  write_text(submitted / "ada" / "notes.txt", "mine");
  course.write("class/bob/a/starter/halton.cpp", "// bob\n");  // as deep as grade finds it
  course.hand_in("$(touch x) '\x1b[31m", "// eve\n");
  fs::create_directories(submitted / "fay");
  fs::create_symlink(course.layout.solutions() / "variance.cpp",
                     submitted / "fay" / "variance.cpp");
  fs::create_directory_symlink(course.layout.solutions(), submitted / "sly");
  write_text(submitted / "broken.zip", "no zip");

  REQUIRE_RUN(run, course.run({"export", "jplag", submitted, "--out", out}));
  CHECK(files_in(out / "submissions") ==
        Words{"$(touch x) '?[31m/variance.cpp", "ada/variance.cpp", "bob/halton.cpp"});
  CHECK(read_text(out / "submissions" / "bob" / "halton.cpp") == "// bob\n");
  CHECK(files_in(out / "base-code") == files_in(course.layout.starter()));
  CHECK(read_text(out / "base-code" / "variance.cpp") == text_of(course.layout.starter()));
  check_contains(run.output,
                 {"left out: broken: it is not a zip file",
                  "left out: fay: it contains no lab files", "left out: sly: it is a link",
                  "3 submissions: java -jar jplag.jar -l cpp -bc " + out.string()});
}

TEST_CASE("export overwrites nothing, and explains its usage") {
  Course course;
  course.hand_in("ada", "int x;\n");
  const fs::path submitted = course.path() / "class", full = course.path() / "full",
                 empty = course.path() / "empty";
  course.write("full/mine", "");
  fs::create_directories(empty);
  check_refused(course.run({"export", "jplag", submitted, "--out", full}), "is not empty");
  for (const Words& wrong : {Words{"export"},
                             {"export", "jplag", submitted},
                             {"export", "moss", submitted, "--out", empty},
                             {"export", "jplag", "--out", empty},
                             {"export", "jplag", empty, "--out", course.path() / "new"}}) {
    CAPTURE(wrong);
    check_refused(course.run(wrong));
  }
  CHECK(fs::is_empty(empty));
  CHECK(!fs::exists(course.path() / "new"));
  CHECK(files_in(full) == Words{"mine"});
}

}  // namespace mc::tests::exports
