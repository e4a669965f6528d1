// Submissions in the layouts that people and platforms produce.

#include <array>

#include "grader/base/replace.hpp"
#include "grader/base/shell.hpp"
#include "grader/submission/archive.hpp"
#include "grader/submission/exports.hpp"
#include "grader/submission/intake.hpp"
#include "tests/submissions.hpp"

namespace mc::tests::intake {

namespace {

struct Place : Scratch {
  Context context{read_layout(), find_labs(read_layout())};

  explicit Place(const Words& files = {}) {
    for (const std::string& name : files) file(name);
  }
  Place& file(const std::string& name, const std::string& text = "int x;\n") {
    write(name, text);
    return *this;
  }
  /// Zips the content of `directory`, with paths relative to it, and removes the directory.
  Place& zip(const std::string& directory, const fs::path& file) {
    zip_content({.directory = path() / directory, .zip = path() / file});
    fs::remove_all(path() / directory);
    return *this;
  }
  Intake take(const std::string& name = "class", Meaning meaning = Meaning::many) const {
    return take_in(context, {(path() / name).string()}, meaning);
  }
};

/// "alice: variance@x/y stratification; bob: !why"
std::string summary(const Intake& intake) {
  std::string all;
  for (const IntakeEntry& one : intake.entries) {
    all += (all.empty() ? "" : "; ") + one.submission.label + ":";
    if (!one.unreadable.empty()) all += " !" + one.unreadable;
    for (const auto& [lab, file] : one.submission.files) all += " " + lab;
    if (!one.submission.found_in.empty()) all += " @" + one.submission.found_in;
  }
  return all;
}

/// The zip of what is in z.
std::string zipped(Place& place) {
  place.zip("z", "a.zip");
  return read_whole_text(place.path() / "a.zip");
}

}  // namespace

TEST_CASE("one person's files are found wherever they are") {
  const struct {
    Words files;
    std::string found;
  } cases[] = {
      {{"a/variance.cpp"}, "a: variance"},
      {{"a/variance.cpp", "a/x/variance.cpp"}, "a: variance"},
      {{"a/starter/variance.cpp", "a/old/variance.cpp"}, "a: variance @starter"},
      {{"a/x/y/variance.cpp", "a/x/notes.txt"}, "a: variance @x/y"},
      // A checkout in a directory: its other files do not count.
      {{"a/mc/README.md", "a/mc/starter/variance.cpp", "a/mc/solutions/variance.cpp"},
       "a: variance @mc/starter"},
      {{"a/README.md", "a/1/variance.cpp", "a/2/independent.cpp"}, "a: independent variance @1, 2"},
      {{"a/README.md", "a/__MACOSX/variance.cpp", "a/.git/variance.cpp", "a/build/variance.cpp"},
       "a:"}};
  for (const auto& one : cases) CHECK(summary(Place(one.files).take("a")) == one.found);
  CHECK(summary(Place({"a/1/variance.cpp", "a/2/variance.cpp"}).take("a", Meaning::one)) ==
        "a: !variance.cpp is in 1 and in 2: which one counts?");
  CHECK(summary(Place({"a/variance.cpp"}).take("a/")) == "a: variance");
}

TEST_CASE("a parent directory means its children") {
  Place place({"class/bob/variance.cpp", "class/anna/starter/variance.cpp",
               "class/nothing/notes.txt", "class/two/1/variance.cpp", "class/two/2/variance.cpp",
               "class/grades.csv", "z/sub/variance.cpp", "z/._variance.cpp"});
  place.zip("z", "class/zoe.zip").file("class/broken.zip", "no zip at all");
  fs::create_directory_symlink(place.context.layout.solutions(),
                               place.path() / "class" / "mallory");
  CHECK(summary(place.take()) ==
        "anna: variance @starter; bob: variance; broken: !it is not a zip file; mallory: !it is a "
        "link; "
        "nothing:; two: !variance.cpp is in 1 and in 2: which one counts?; zoe: variance @sub");
}

TEST_CASE("ids are unique, printable, and valid file names") {
  Place place({"x/anna/variance.cpp", "x/Anna/variance.cpp", "z/variance.cpp",
               "x/\x1b[31m\n\xe2\x80\xae/variance.cpp"});
  place.zip("z", "x/anna.zip");
  CHECK(summary(place.take("x")) ==
        "?[31m ???: variance; Anna: variance; anna (2): variance; anna (3): variance");
}

TEST_CASE("several words are one submission each, for any directory names") {
  const Place place({"class/mallory/zoe/variance.cpp", "class/mallory/yann/variance.cpp",
                     "class/zoe/variance.cpp", "class/two/1/variance.cpp",
                     "class/two/2/independent.cpp", "a/Jo_12_assignsubmission_file_variance.cpp",
                     "b/doejane_4711_992_variance.cpp"});
  const auto at = [&](const char* name) { return (place.path() / name).string(); };
  const Intake intake = take_in(
      place.context, {at("class/mallory"), at("class/two"), at("class/zoe")}, Meaning::many);
  CHECK(summary(intake) ==
        "mallory: !variance.cpp is in yann and in zoe: which one counts?; "
        "two: independent variance @1, 2; zoe: variance");
  CHECK(intake.each_word_is_one);
  const Intake exports = take_in(place.context, {at("a"), at("b")}, Meaning::many);
  CHECK(summary(exports) == "Jo_12: variance; doejane_4711: variance");
}

TEST_CASE("the exports of learning platforms") {
  Place gradescope({"z/assignment_7_export/submission_11/variance.cpp",
                    "z/assignment_7_export/submission_12/lab/starter/variance.cpp",
                    "z/assignment_7_export/submission_13/notes.txt",
                    "z/assignment_7_export/submission_metadata.yml"});
  gradescope.zip("z", "class.zip");
  CHECK(summary(gradescope.take("class.zip")) ==
        "submission_11: variance; submission_12: variance @lab/starter; submission_13:");

  Place canvas({"z/doejane_4711_991_variance-2.cpp", "z/doejane_4711_992_independent.cpp",
                "z/roe_LATE_4712_993_variance.cpp", "in/x/variance.cpp"});
  canvas.zip("in", "z/müller_4713_994_submission.zip").zip("z", "submissions.zip");
  CHECK(summary(canvas.take("submissions.zip")) ==
        "doejane_4711: independent variance; müller_4713: variance @x; roe_4712: variance");

  Place moodle({"in/variance.cpp", "z/Jane Doe_123_assignsubmission_file_/variance.cpp",
                "z/Rob Roe_124_assignsubmission_file_/notes.txt"});
  moodle.zip("in", "z/Rob Roe_124_assignsubmission_file_/my work.zip").zip("z", "class.zip");
  CHECK(summary(moodle.take("class.zip")) == "Jane Doe_123: variance; Rob Roe_124: variance");

  // An online text next to files, in either form, is not another person; alone it is not a file.
  for (const Words& files :
       {Words{"class/Jane Doe_123_assignsubmission_file_/variance.cpp",
              "class/Jane Doe_123_assignsubmission_onlinetext_/onlinetext.html",
              "class/Rob Roe_124_assignsubmission_onlinetext_/onlinetext.html"},
        {"class/Jane Doe_123_assignsubmission_file_variance.cpp",
         "class/Jane Doe_123_assignsubmission_onlinetext.html",
         "class/Rob Roe_124_assignsubmission_onlinetext.html"}}) {
    CHECK(summary(Place(files).take()) == "Jane Doe_123: variance; Rob Roe_124:");
  }

  // Canvas keeps earlier attempts: the latest counts.
  Place attempts({"class/doejane_4711_991_variance.cpp", "class/doejane_4711_993_variance-1.cpp"});
  attempts.file("class/doejane_LATE_4711_995_variance-2.cpp", "int latest;\n");
  const Intake latest = attempts.take();
  CHECK(summary(latest) == "doejane_4711: variance");
  CHECK(read_text(latest.entries.at(0).submission.files.at("variance")) == "int latest;\n");

  // Gradescope's names and addresses.
  Place people({"class/submission_11/variance.cpp", "class/submission_12/variance.cpp",
                "class/submission_13/variance.cpp"});
  people.file(
      "class/submission_metadata.yml",
      "---\nsubmission_11:\n  :submitters:\n  - :name: Jane Doe\n    :sid: '7'\n"
      "    :email: jane@example.edu\n  :created_at: 2026-01-02 03:04:05 Z\n"
      "submission_12:\n  :submitters:\n  - :name: \"Rob Roe\"\n    :email: rob@example.edu\n"
      "  - :name: Ann Poe\n    :email: ann@example.edu\n");
  CHECK(summary(people.take()) ==
        "Jane Doe (jane@example.edu): variance; "
        "Rob Roe (rob@example.edu) & Ann Poe (ann@example.edu): variance; submission_13: variance");

  // GitHub Classroom: clones side by side.
  const Place clones({"class/lab-anna/.git/HEAD", "class/lab-anna/starter/variance.cpp",
                      "class/lab-bob/.git/HEAD", "class/lab-bob/starter/independent.cpp"});
  CHECK(summary(clones.take()) == "lab-anna: variance @starter; lab-bob: independent @starter");

  CHECK(!named_by_platform("lab_1_2_alice.zip"));
  CHECK(named_by_platform("Jo_12_assignsubmission_file_variance.cpp")->file == "variance.cpp");
}

TEST_CASE("a zip never unpacks outside of its own directory") {
  Place place;
  const auto taken = [&](const std::string& zip) {
    place.file("a.zip", zip);
    return summary(place.take("a.zip"));
  };
  // An entry's name, in which `to` replaces `from`: as no program packs it.
  const auto renamed = [&](const std::string& name, std::string_view from, std::string_view to) {
    place.file("z/" + name, "int x;\n");
    return taken(with_replacements(zipped(place), {{from, to}}));
  };
  place.file("z/variance.cpp");
  CHECK(taken(zipped(place)) == "a: variance");
  for (const auto& [name, from, to] : {std::array{"AA/variance.cpp", "AA", ".."},
                                       {"Atmp/variance.cpp", "Atmp", "/tmp"},
                                       {"x/AA/AA/variance.cpp", "AA", ".."}}) {
    CHECK(renamed(name, from, to).starts_with("a: !the zip file has a path outside"));
  }
  fs::create_directories(place.path() / "z");
  fs::create_symlink("/etc/passwd", place.path() / "z" / "variance.cpp");
  CHECK(taken(zipped(place)) == "a:");
  place.file("z/variance.cpp");
  CHECK(renamed("variance.cpA/x", "cpA", "cpp") == "a:");
  place.file("z/variance.cpp");
  CHECK(renamed("variance.cpA", "cpA", "cpp") == "a: variance");                       // twice
  CHECK(renamed("y/" + std::string(254, 'x') + "/variance.cpp", "y/", "yy") == "a:");  // too long
  place.file("z/variance.cpp", std::string(5000, 'x'));
  const std::string whole = zipped(place);
  CHECK(taken(whole.substr(0, whole.size() / 2)).starts_with("a: !"));
  CHECK(taken("").starts_with("a: !the zip file is empty"));

  place.file("z/1").file("z/2").file("z/3").zip("z", "many.zip");
  const Scratch to;
  CHECK_THROWS_AS(unpack({.zip = place.path() / "many.zip", .to = to.path()}, {.entries = 2}),
                  UnreadableSubmission);
  place
      .file("z/variance.cpp", std::string(std::size_t{3} << 20, ' '))  // 3 MB of blanks
      .file("z/independent.cpp", std::string(std::size_t{3} << 20, ' '))
      .zip("z", "large.zip");
  CHECK_THROWS_AS(
      unpack({.zip = place.path() / "large.zip", .to = to.path()}, {.bytes = 1'500'000}),
      UnreadableSubmission);
  // A text is unpacked up to the length at which the compiler rejects it.
  CHECK(fs::file_size(to.path() / "variance.cpp") <= (std::size_t{1} << 20) + 1);
}

TEST_CASE("an unreadable word does not affect the others") {
  const Place place({"a/variance.cpp", "b.cpp"});
  const auto at = [&](const char* name) { return (place.path() / name).string(); };
  const Intake intake = take_in(place.context, {at("a"), at("gone"), at("b.cpp")}, Meaning::many);
  REQUIRE(intake.entries.size() == 3);
  CHECK(intake.entries[0].unreadable == "");
  CHECK(intake.entries[1].unreadable.starts_with("no such directory"));
  CHECK(contains(intake.entries[2].unreadable, "is a file"));
  CHECK_THROWS_AS(take_in_one(place.context, at("gone")), UsageError);
}

TEST_CASE("a path in a command is one word, for any name") {
  CHECK(shell_quoted("class/anna") == "class/anna");
  CHECK(shell_quoted("übung 1") == "'übung 1'");
  CHECK(shell_quoted("$(rm x)`'\"") == "'$(rm x)`'\\''\"'");
  CHECK(shell_quoted("-rf") == "./-rf");
  CHECK(shell_quoted("a\nb") == "'a b'");
  CHECK(shell_quoted("") == "''");
}

}  // namespace mc::tests::intake
