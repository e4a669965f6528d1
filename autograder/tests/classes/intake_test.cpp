// Submissions in the layouts that people and platforms produce.

#include <array>

#include "judge/base/replace.hpp"
#include "judge/base/shell.hpp"
#include "judge/submission/archive.hpp"
#include "judge/submission/intake.hpp"
#include "judge/submission/platform_names.hpp"
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
  std::string at(const std::string& name) const { return (path() / name).string(); }
  Intake take(const std::string& name) const { return take_in(context, {at(name)}); }
  Intake take_class(const std::string& name = "class") const {
    return take_in_class(context, at(name));
  }
};

/// "alice: variance@x/y stratification; bob: !why; left out: …"
std::string summary(const Intake& intake) {
  std::string all;
  for (const IntakeEntry& one : intake.entries) {
    all += (all.empty() ? "" : "; ") + one.submission.label + ":";
    if (!one.unreadable.empty()) all += " !" + one.unreadable;
    for (const auto& [lab, file] : one.submission.files) all += " " + lab;
    if (!one.submission.found_in.empty()) all += " @" + one.submission.found_in;
    for (const std::string& other : one.submission.others) all += " ?" + other;
  }
  for (const std::string& file : intake.left_out) {
    all += "; left out: " + file.substr(0, file.find(':'));
  }
  return all;
}

/// The zip of what is in z.
std::string zipped(Place& place) {
  place.zip("z", "a.zip");
  return read_whole_text(place.path() / "a.zip");
}

}  // namespace

TEST_CASE("one person's files are found wherever they are, and what was meant is named") {
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
      {{"a/1/variance.cpp", "a/2/variance.cpp"},
       "a: !variance.cpp is in 1 and in 2: which one counts?"},
      {{"a/README.md", "a/__MACOSX/variance.cpp", "a/.git/variance.cpp", "a/build/variance.cpp"},
       "a:"},
      {{"a/variance (1).cpp"}, "a: ?variance (1).cpp"},
      {{"a/Variance.cpp", "a/variance.cpp.txt"}, "a: ?Variance.cpp ?variance.cpp.txt"}};
  for (const auto& one : cases) CHECK(summary(Place(one.files).take("a")) == one.found);
  CHECK(summary(Place({"a/variance.cpp"}).take("a/")) == "a: variance");
}

TEST_CASE("each word is one submission, whatever is in it") {
  const Place place({"class/anna/variance.cpp", "class/bob/variance.cpp", "one/variance.cpp"});
  const Intake intake =
      take_in(place.context, {place.at("class"), place.at("one"), place.at("gone")});
  CHECK(summary(intake) ==
        "class: !variance.cpp is in anna and in bob: which one counts?; one: variance; gone: !no "
        "such directory: " +
            place.at("gone"));
  CHECK_THROWS_AS(take_in_one(place.context, place.at("gone")), UsageError);
}

TEST_CASE("every entry of a class is one student, whatever it is called") {
  Place place;
  std::string expected;
  for (const char* name : {".bob", "CMakeLists.txt", "README", "build", "lab", "starter"}) {
    place.file(fmt::format("class/{}/variance.cpp", name));
    expected += fmt::format("{}{}: variance", expected.empty() ? "" : "; ", name);
  }
  CHECK(summary(place.take_class()) == expected);
  // Alone, such a directory is still a class of one.
  CHECK(summary(Place({"class/starter/variance.cpp"}).take_class()) == "starter: variance");
  // So it is in an archive, also in one that holds the class's directory.
  place.zip("class", "class.zip");
  CHECK(summary(place.take_class("class.zip")) == expected);
  Place wrapped({"z/export/anna/variance.cpp", "z/export/.bob/starter/variance.cpp"});
  CHECK(summary(wrapped.zip("z", "class.zip").take_class("class.zip")) ==
        ".bob: variance @starter; anna: variance");
}

TEST_CASE("what is in a class is a row, or is named as left out") {
  Place place({"class/two/1/variance.cpp", "class/two/2/variance.cpp", "class/grades.csv",
               "class/hugo.cpp", "class/nothing/notes.txt", "z/sub/variance.cpp"});
  place.zip("z", "class/ZOE.ZIP").file("class/broken.zip", "no zip at all");
  place.file("class/fred.rar", "Rar!").file("in/variance.cpp");
  REQUIRE_RUN(tar, sandbox::run_process({"tar", "czf", place.at("class/carl.tar.gz"), "-C",
                                         place.at("in"), "variance.cpp"}));
  fs::create_directory_symlink(place.context.layout.solutions(), place.path() / "class/mallory");
  CHECK(summary(place.take_class()) ==
        "ZOE: variance @sub; broken: !it is not a zip, tar or 7z archive; carl: variance; fred: "
        "!it is not a zip, tar or 7z archive; mallory: !it is a link or a device, not a directory; "
        "nothing:; two: !variance.cpp is in 1 and in 2: which one counts?; left out: grades.csv; "
        "left out: hugo.cpp");
  // A zip in a zip, and no further than anyone packs on purpose.
  Place nested({"z/variance.cpp"});
  for (const char* name : {"y/a.zip", "x/b.zip", "class/c.zip"}) {
    fs::create_directories((nested.path() / name).parent_path());
    nested.zip(name[0] == 'y' ? "z" : name[0] == 'x' ? "y" : "x", name);
  }
  CHECK(summary(nested.take_class()) == "c: variance");
}

TEST_CASE("ids are unique after cutting, printable, and valid file names") {
  const std::string longer(70, 'x');
  Place place({"x/anna/variance.cpp", "x/Anna/variance.cpp", "z/variance.cpp",
               "x/\x1b[31m\n\xe2\x80\xae/variance.cpp", "x/" + longer + "1/variance.cpp",
               "x/" + longer + "2/variance.cpp"});
  place.zip("z", "x/anna.zip");
  CHECK(summary(place.take_class("x")) ==
        fmt::format("?[31m ???: variance; Anna: variance; anna (2): variance; anna (3): variance; "
                    "{}: variance; {} (2): variance",
                    longer.substr(0, 60), longer.substr(0, 56)));
}

TEST_CASE("in a flat export, the form of the platform's file names is the rule") {
  Place canvas({"z/doejane_4711_991_variance-2.cpp", "z/doejane_4711_992_independent.cpp",
                "z/roe_LATE_4712_993_variance.cpp", "z/anon_Ab12C_995_variance.cpp",
                "in/x/variance.cpp"});
  canvas.zip("in", "z/müller_4713_994_submission.zip").zip("z", "submissions.zip");
  CHECK(summary(canvas.take_class("submissions.zip")) ==
        "anon_Ab12C: variance; doejane_4711: independent variance; müller_4713: variance @x; "
        "roe_4712: variance");

  const Place moodle({"class/Jane Doe_123_assignsubmission_file_variance.cpp",
                      "class/Rob Roe_124_assignsubmission_file_notes.txt",
                      "class/Rob Roe_124_assignsubmission_onlinetext.html"});
  CHECK(summary(moodle.take_class()) ==
        "Jane Doe_123: variance; Rob Roe_124: ?notes.txt; left out: Rob "
        "Roe_124_assignsubmission_onlinetext.html");

  const Place blackboard({"class/Lab 1_jdoe_attempt_2026-01-02-03-04-05.txt",
                          "class/Lab 1_jdoe_attempt_2026-01-02-03-04-05_variance.cpp"});
  CHECK(summary(blackboard.take_class()) == "Lab 1_jdoe: variance");

  // Canvas keeps earlier attempts: the latest counts.
  Place attempts({"class/doejane_4711_991_variance.cpp", "class/doejane_4711_993_variance-1.cpp"});
  attempts.file("class/doejane_LATE_4711_995_variance-2.cpp", "int latest;\n");
  const Intake latest = attempts.take_class();
  CHECK(summary(latest) == "doejane_4711: variance");
  CHECK(read_text(latest.entries.at(0).submission.files.at("variance")) == "int latest;\n");

  // A student's own name for a file never makes it another student's.
  CHECK(named_by_platform("eve_4714_996_doejane_4711_997_variance.cpp")->person == "eve_4714");
  CHECK(named_by_platform("Eve_9_assignsubmission_file_Jo_12_assignsubmission_file_variance.cpp")
            ->person == "Eve_9");
  CHECK(!named_by_platform("lab_1_2_alice.zip"));
  // No platform gives two files one number: these are names like any other.
  Place named({"y/variance.cpp", "z/variance.cpp"});
  fs::create_directories(named.path() / "class");
  named.zip("y", "class/lab_12_34_ann.zip").zip("z", "class/lab_12_34_bob.zip");
  CHECK(summary(named.take_class()) == "lab_12_34_ann: variance; lab_12_34_bob: variance");

  // Directories: Gradescope, Moodle, GitHub Classroom. The id is the directory's name.
  const Place directories({"class/submission_11/variance.cpp", "class/submission_metadata.yml",
                           "class/Jane Doe_123_assignsubmission_file_/variance.cpp",
                           "class/lab-anna/.git/HEAD", "class/lab-anna/starter/variance.cpp"});
  CHECK(summary(directories.take_class()) ==
        "Jane Doe_123_assignsubmission_file_: variance; lab-anna: variance @starter; "
        "submission_11: variance; left out: submission_metadata.yml");
}

TEST_CASE("an archive never unpacks outside of its own directory") {
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
    CHECK(renamed(name, from, to).starts_with("a: !the archive has a path outside"));
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
  CHECK(taken("").starts_with("a: !it is not a zip"));

  place.file("z/1").file("z/2").file("z/3").zip("z", "many.zip");
  const Scratch to;
  CHECK_THROWS_AS(unpack({.archive = place.path() / "many.zip", .to = to.path()}, {.entries = 2}),
                  UnreadableSubmission);
  place
      .file("z/variance.cpp", std::string(std::size_t{3} << 20, ' '))  // 3 MB of blanks
      .file("z/independent.cpp", std::string(std::size_t{3} << 20, ' '))
      .zip("z", "large.zip");
  CHECK_THROWS_AS(
      unpack({.archive = place.path() / "large.zip", .to = to.path()}, {.bytes = 1'500'000}),
      UnreadableSubmission);
  // A text is unpacked up to the length at which the compiler rejects it.
  CHECK(fs::file_size(to.path() / "variance.cpp") <= (std::size_t{1} << 20) + 1);
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
