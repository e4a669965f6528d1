// A class with every hostile file that has ever cost a student a grade: each row is right.
#include <sys/stat.h>
#include <unistd.h>

#include <iterator>

#include "commands/course_copy.hpp"
#include "judge/reports/verdict_json.hpp"
#include "judge/submission/archive.hpp"
#include "judge/submission/cache.hpp"
#include "tests/classes/course.hpp"

namespace mc::tests::hostile {

namespace {

/// id -> "judged 100"
std::map<std::string, std::string> outcomes(Rows rows) {
  std::map<std::string, std::string> all;
  for (auto& [id, row] : rows) all[id] = row["variance status"] + ' ' + row["variance total"];
  return all;
}

}  // namespace

TEST_CASE("a class with every hostile file gives a row for each, and each is right", "[.class]") {
  Course course;
  const fs::path place = course.place();
  const std::string starter = text_of(course.layout.starter()),
                    solution = text_of(course.layout.solutions());
  std::map<std::string, std::string> expected;
  const auto hand_in = [&](const std::string& id, const std::string& text, const char* outcome) {
    course.hand_in(id, text);
    expected[id] = outcome;
  };

  // Files that are not what they seem.
  hand_in("huge", "", "no program 0");
  fs::resize_file(place / "huge" / "variance.cpp", std::uintmax_t{40} << 30);  // sparse
  hand_in("long", std::string((std::size_t{1} << 20) + 1, ' '), "no program 0");
  for (const char* id : {"pipe", "link"}) {
    fs::create_directories(place / id);
    expected[id] = "no file 0";
  }
  REQUIRE(mkfifo((place / "pipe" / "variance.cpp").c_str(), 0600) == 0);
  fs::create_symlink(course.layout.solutions() / "variance.cpp", place / "link" / "variance.cpp");
  if (geteuid() != 0) {  // root can read them all
    hand_in("closed", starter, "unreadable ");
    fs::permissions(place / "closed" / "variance.cpp", fs::perms::none);
  } else {
    hand_in("closed", starter + "// closed\n", "judged 0");
  }
  write_text(place / "broken.zip", "PK no zip");
  expected["broken"] = "unreadable ";
  // Other people's names below a person's directory.
  for (const char* other : {"s00", "zoe"}) {
    course.write(std::string("class/mallory/") + other + "/variance.cpp", starter);
  }
  expected["mallory"] = "unreadable ";  // which one counts?

  // Texts that make a compiler wait, write, or never end: three and more in a row.
  for (const std::string file : {"/proc/self/fd/0", "/proc/self/fd/1", "/proc/self/fd/2"}) {
    hand_in("reads" + std::to_string(expected.size()), "#include \"" + file + "\"\n" + starter,
            "judged 0");  // its own input and output: empty
  }
  for (const std::string file : {"/dev/tty", "/dev/zero", "/proc/self/environ"}) {
    hand_in("reads" + std::to_string(expected.size()), "#include \"" + file + "\"\n" + starter,
            "no program 0");
  }
  // The compiler's own input and output have nothing in them, and an end.
  for (const char* descriptor : {"0", "1", "2"}) {
    hand_in(std::string("reads_own") + descriptor,
            std::string("#include \"/proc/self/fd/") + descriptor + "\"\n" + starter, "judged 0");
  }
  hand_in("deep", "template <int n> struct A : A<n + 1> {}; A<0> a;\n" + starter, "no program 0");
  hand_in("wide", "#define A(x) x x x x x x x x\nint a[] = {A(A(A(A(A(A(A(A(A(A(1,))))))))))};\n",
          "no program 0");
  hand_in("elsewhere", "asm(\".incbin \\\"/etc/passwd\\\"\");\n" + starter, "no program 0");

  // Programs.
  hand_in("prints",
          "#include <cstdio>\nstatic int a = []() -> int { for (;;) puts(\"/vector: Assertion '\\n"
          "likely    x' failed.\"); }();\n" +
              starter,
          "judged 0");
  hand_in("waits", "#include <unistd.h>\nstatic int a = (pause(), 0);\n" + starter, "judged 0");

  hand_in("right", solution, "judged 100");

  const fs::path csv = course.csv();
  const auto compare = [&](const std::map<std::string, std::string>& found) {
    CHECK(found.size() == expected.size());
    for (const auto& [id, outcome] : expected) {
      CAPTURE(id);
      CHECK(found.at(id) == outcome);
    }
  };
  compare(outcomes(course.graded({"--seed", "1"})));
  // What it prints is bounded, and never a line of the report.
  CHECK(fs::file_size(course.verdict_file("prints")) < (std::size_t{1} << 20));
  const Verdict printing = verdict_from_json(read_text(course.verdict_file("prints")));
  for (const CheckResult& result : printing.labs.at(0).checks) {
    CHECK(!contains(result.report, "\nlikely    x"));
    CHECK(result.by_hand.empty());  // it would run without the sandbox
  }
  const auto again = course.grade({"--csv", csv, "--resume"});
  CHECK(contains(again.output, "0 judged"));
  compare(outcomes(rows_of(csv)));
}

TEST_CASE("deep names in a zip are left out") {
  const Scratch place;
  std::string deep = "in/";
  for (int i = 0; i < 20; ++i) deep += "d/";
  place.write(deep + "variance.cpp", "int x;\n");
  const fs::path zip = place.path() / "deep.zip";
  zip_content({.directory = place.path() / "in", .zip = zip});
  fs::create_directories(place.path() / "out");
  unpack({.archive = zip, .to = place.path() / "out"});
  const fs::recursive_directory_iterator entries(place.path() / "out");
  CHECK(std::distance(begin(entries), end(entries)) < 15);
}

TEST_CASE("files that are not in git are refused, not left out") {
  const Scratch root;
  Context context{read_layout(), {}};
  context.layout.root = root.path();
  git(root.path(), {"init", "-q"});
  root.write("kept.txt", "");
  git(root.path(), {"add", "kept.txt"});
  const Scratch copy;
  copy_course(context, {}, JudgeForm::sources, copy.path());
  CHECK(fs::exists(copy.path() / "kept.txt"));
  root.write("new lab.hpp", "");
  CHECK_THROWS_AS(copy_course(context, {}, JudgeForm::compiled, copy.path()), UsageError);
}

TEST_CASE("a hash names a cache entry, and its contents decide") {
  const Scratch place;
  const fs::path slot = place.path() / "slot";
  const auto keep = [&](const std::string& name, const std::string& key) {
    return keep_cached(slot, "o", key, place.write(name + "/unit.o", key));
  };
  const fs::path mine = keep("mine", "my text"), other = keep("other", "another text");
  CHECK(find_cached(slot, "o", "my text") == mine);
  CHECK(find_cached(slot, "o", "another text") == other);
  CHECK(!find_cached(slot, "o", "a third text"));
  // As if both texts had the same hash: the entry found for mine is that of the other.
  for (const auto& entry : fs::directory_iterator(slot)) {
    if (!read_text(entry.path()).ends_with("\nmy text")) continue;
    write_text(entry.path(), other.filename().string() + "\nanother text");
  }
  CHECK(!find_cached(slot, "o", "my text"));
}

}  // namespace mc::tests::hostile
