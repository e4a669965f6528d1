// Submissions in the layouts that people and platforms produce.

#include <string>
#include <utility>
#include <vector>

#include "checks/support/catch.hpp"
#include "grader/base/errors.hpp"
#include "grader/base/shell.hpp"
#include "grader/submission/archive.hpp"
#include "grader/submission/exports.hpp"
#include "grader/submission/intake.hpp"
#include "sandbox/process.hpp"
#include "tests/submissions.hpp"

using namespace mc::grader;
using mc::tests::Scratch;
namespace fs = std::filesystem;

namespace {

struct Place : Scratch {
  Context context = [] {
    Context made{read_layout(), {}};
    made.labs = find_labs(made.layout);
    return made;
  }();

  Place& file(const std::string& name, const std::string& text = "int x;\n") {
    write(name, text);
    return *this;
  }
  /// Zips the content of `directory`, with paths relative to it, and removes the directory.
  Place& zip(const std::string& directory, const fs::path& file) {
    mc::tests::zip_content({.directory = path() / directory, .zip = path() / file});
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

/// A zip of stored entries with these names, texts and mode.
std::string raw_zip(const std::vector<std::pair<std::string, std::string>>& entries,
                    unsigned mode = 0100644) {
  std::string local, central;
  const auto number = [](std::string& to, std::uint64_t value, int bytes) {
    for (int i = 0; i < bytes; ++i) to += static_cast<char>(value >> (8 * i) & 0xff);
  };
  for (const auto& [name, text] : entries) {
    std::uint32_t crc = ~0u;
    for (const char c : text) {
      crc ^= static_cast<unsigned char>(c);
      for (int i = 0; i < 8; ++i) crc = (crc >> 1) ^ (0xedb88320u & (0u - (crc & 1u)));
    }
    std::string common;
    number(common, 20, 2);  // version needed, flags, method, time and date
    number(common, 0, 2);
    number(common, 0, 2);
    number(common, 0x21'0000, 4);
    number(common, ~crc & 0xffffffffu, 4);
    number(common, text.size(), 4);
    number(common, text.size(), 4);
    number(common, name.size(), 2);
    number(common, 0, 2);
    const std::size_t at = local.size();
    local += "PK\3\4" + common + name + text;
    central += std::string("PK\1\2") + "\x14\x03" + common;
    number(central, 0, 2);  // comment, disk, attributes
    number(central, 0, 2);
    number(central, 0, 2);
    number(central, std::uint64_t{mode} << 16, 4);
    number(central, at, 4);
    central += name;
  }
  std::string end = "PK\5\6";
  number(end, 0, 4);
  number(end, entries.size(), 2);
  number(end, entries.size(), 2);
  number(end, central.size(), 4);
  number(end, local.size(), 4);
  number(end, 0, 2);
  return local + central + end;
}

}  // namespace

TEST_CASE("one person's files are found wherever they are") {
  CHECK(summary(Place().file("a/variance.cpp").take("a")) == "a: variance");
  CHECK(summary(Place().file("a/variance.cpp").file("a/x/variance.cpp").take("a/")) ==
        "a: variance");
  CHECK(summary(Place().file("a/starter/variance.cpp").file("a/old/variance.cpp").take("a")) ==
        "a: variance @starter");
  CHECK(summary(Place().file("a/x/y/variance.cpp").file("a/x/notes.txt").take("a")) ==
        "a: variance @x/y");
  // A checkout in a directory: its other files do not count.
  CHECK(summary(Place()
                    .file("a/mc/README.md")
                    .file("a/mc/starter/variance.cpp")
                    .file("a/mc/solutions/variance.cpp")
                    .take("a")) == "a: variance @mc/starter");
  CHECK(summary(Place()
                    .file("a/README.md")
                    .file("a/1/variance.cpp")
                    .file("a/2/independent.cpp")
                    .take("a")) == "a: independent variance @1, 2");
  CHECK(summary(Place()
                    .file("a/README.md")
                    .file("a/__MACOSX/variance.cpp")
                    .file("a/.git/variance.cpp")
                    .file("a/build/variance.cpp")
                    .take("a")) == "a:");
  CHECK(
      summary(Place().file("a/1/variance.cpp").file("a/2/variance.cpp").take("a", Meaning::one)) ==
      "a: !variance.cpp is in 1 and in 2: which one counts?");
}

TEST_CASE("a parent directory means its children") {
  Place place;
  place.file("class/bob/variance.cpp")
      .file("class/anna/starter/variance.cpp")
      .file("class/nothing/notes.txt")
      .file("class/two/1/variance.cpp")
      .file("class/two/2/variance.cpp")
      .file("class/grades.csv")
      .file("z/sub/variance.cpp")
      .file("z/._variance.cpp")
      .zip("z", "class/zoe.zip")
      .file("class/broken.zip", "no zip at all");
  fs::create_directory_symlink(place.context.layout.solutions(),
                               place.path() / "class" / "mallory");
  CHECK(summary(place.take()) ==
        "anna: variance @starter; bob: variance; broken: !it is not a zip file; mallory: !it is a "
        "link; "
        "nothing:; two: !variance.cpp is in 1 and in 2: which one counts?; zoe: variance @sub");
}

TEST_CASE("ids are unique, printable, and valid file names") {
  Place place;
  place.file("x/anna/variance.cpp").file("x/Anna/variance.cpp");
  place.file("z/variance.cpp").zip("z", "x/anna.zip");
  place.file("x/\x1b[31m\n\xe2\x80\xae/variance.cpp");
  CHECK(summary(place.take("x")) ==
        "?[31m ???: variance; Anna: variance; anna (2): variance; anna (3): variance");
}

TEST_CASE("several words are one submission each, for any directory names") {
  Place place;
  place.file("class/mallory/zoe/variance.cpp").file("class/mallory/yann/variance.cpp");
  place.file("class/zoe/variance.cpp").file("class/two/1/variance.cpp");
  place.file("class/two/2/independent.cpp");
  const auto at = [&](const char* name) { return (place.path() / name).string(); };
  const Intake intake = take_in(
      place.context, {at("class/mallory"), at("class/two"), at("class/zoe")}, Meaning::many);
  CHECK(summary(intake) ==
        "mallory: !variance.cpp is in yann and in zoe: which one counts?; "
        "two: independent variance @1, 2; zoe: variance");
  CHECK(intake.each_word_is_one);
  place.file("a/Jo_12_assignsubmission_file_variance.cpp");
  place.file("b/doejane_4711_992_variance.cpp");
  const Intake exports = take_in(place.context, {at("a"), at("b")}, Meaning::many);
  CHECK(summary(exports) == "Jo_12: variance; doejane_4711: variance");
}

TEST_CASE("the exports of learning platforms") {
  Place gradescope;
  gradescope.file("z/assignment_7_export/submission_11/variance.cpp")
      .file("z/assignment_7_export/submission_12/lab/starter/variance.cpp")
      .file("z/assignment_7_export/submission_13/notes.txt")
      .file("z/assignment_7_export/submission_metadata.yml")
      .zip("z", "class.zip");
  CHECK(summary(gradescope.take("class.zip")) ==
        "submission_11: variance; submission_12: variance @lab/starter; submission_13:");

  Place canvas;
  canvas.file("z/doejane_4711_991_variance-2.cpp")
      .file("z/doejane_4711_992_independent.cpp")
      .file("z/roe_LATE_4712_993_variance.cpp")
      .file("in/x/variance.cpp")
      .zip("in", "z/müller_4713_994_submission.zip")
      .zip("z", "submissions.zip");
  CHECK(summary(canvas.take("submissions.zip")) ==
        "doejane_4711: independent variance; müller_4713: variance @x; roe_4712: variance");

  Place moodle;
  moodle.file("in/variance.cpp")
      .zip("in", "z.zip")
      .file("z/Jane Doe_123_assignsubmission_file_/variance.cpp")
      .file("z/Rob Roe_124_assignsubmission_file_/notes.txt");
  fs::rename(moodle.path() / "z.zip",
             moodle.path() / "z" / "Rob Roe_124_assignsubmission_file_" / "my work.zip");
  moodle.zip("z", "class.zip");
  CHECK(summary(moodle.take("class.zip")) == "Jane Doe_123: variance; Rob Roe_124: variance");

  // An online text next to files, in either form, is not another person; alone it is not a file.
  Place texts;
  texts.file("class/Jane Doe_123_assignsubmission_file_/variance.cpp")
      .file("class/Jane Doe_123_assignsubmission_onlinetext_/onlinetext.html")
      .file("class/Rob Roe_124_assignsubmission_onlinetext_/onlinetext.html");
  CHECK(summary(texts.take()) == "Jane Doe_123: variance; Rob Roe_124:");
  Place flat;
  flat.file("class/Jane Doe_123_assignsubmission_file_variance.cpp")
      .file("class/Jane Doe_123_assignsubmission_onlinetext.html")
      .file("class/Rob Roe_124_assignsubmission_onlinetext.html");
  CHECK(summary(flat.take()) == "Jane Doe_123: variance; Rob Roe_124:");

  // Canvas keeps earlier attempts: the latest counts.
  Place attempts;
  attempts.file("class/doejane_4711_991_variance.cpp")
      .file("class/doejane_LATE_4711_995_variance-2.cpp", "int latest;\n")
      .file("class/doejane_4711_993_variance-1.cpp");
  const Intake latest = attempts.take();
  CHECK(summary(latest) == "doejane_4711: variance");
  CHECK(read_text(latest.entries.at(0).submission.files.at("variance")) == "int latest;\n");

  // Gradescope's names and addresses.
  Place people;
  people.file("class/submission_11/variance.cpp")
      .file("class/submission_12/variance.cpp")
      .file("class/submission_13/variance.cpp")
      .file("class/submission_metadata.yml",
            "---\nsubmission_11:\n  :submitters:\n  - :name: Jane Doe\n    :sid: '7'\n"
            "    :email: jane@example.edu\n  :created_at: 2026-01-02 03:04:05 Z\n"
            "submission_12:\n  :submitters:\n  - :name: \"Rob Roe\"\n    :email: rob@example.edu\n"
            "  - :name: Ann Poe\n    :email: ann@example.edu\n");
  CHECK(summary(people.take()) ==
        "Jane Doe (jane@example.edu): variance; "
        "Rob Roe (rob@example.edu) & Ann Poe (ann@example.edu): variance; submission_13: variance");

  // GitHub Classroom: clones side by side.
  Place clones;
  clones.file("class/lab-anna/.git/HEAD").file("class/lab-anna/starter/variance.cpp");
  clones.file("class/lab-bob/.git/HEAD").file("class/lab-bob/starter/independent.cpp");
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
  CHECK(taken(raw_zip({{"variance.cpp", "int x;\n"}})) == "a: variance");
  for (const char* name : {"../variance.cpp", "/tmp/variance.cpp", "x/../../variance.cpp"}) {
    CHECK(taken(raw_zip({{name, "int x;\n"}})).starts_with("a: !the zip file has a path outside"));
  }
  CHECK(taken(raw_zip({{"variance.cpp", "/etc/passwd"}}, 0120777)) == "a:");  // a link
  CHECK(taken(raw_zip({{"variance.cpp/x", "1"}, {"variance.cpp", "2"}})) == "a:");
  CHECK(taken(raw_zip({{"variance.cpp", "old"}, {"variance.cpp", "new"}})) == "a: variance");
  CHECK(taken(raw_zip({{std::string(300, 'x') + "/variance.cpp", "1"}})) == "a:");
  const std::string whole = raw_zip({{"variance.cpp", std::string(5000, 'x')}});
  CHECK(taken(whole.substr(0, 3000)).starts_with("a: !"));
  CHECK(taken("").starts_with("a: !the zip file is empty"));

  place.file("many.zip", raw_zip({{"1", ""}, {"2", ""}, {"3", ""}}));
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
  Place place;
  place.file("a/variance.cpp").file("b.cpp");
  const auto at = [&](const char* name) { return (place.path() / name).string(); };
  const Intake intake = take_in(place.context, {at("a"), at("gone"), at("b.cpp")}, Meaning::many);
  REQUIRE(intake.entries.size() == 3);
  CHECK(intake.entries[0].unreadable == "");
  CHECK(intake.entries[1].unreadable.starts_with("no such directory"));
  CHECK(mc::tests::contains(intake.entries[2].unreadable, "is a file"));
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
