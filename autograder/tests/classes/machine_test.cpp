// Failing machines: no disk, no processes, no descriptors, no jail. They give no submission points,
// and none a zero. Not in --quick: an answer is judged dozens of times.
#include <unistd.h>

#include <algorithm>

#include "tests/classes/course.hpp"

namespace mc::tests::machine {

namespace {

/// A class that wrote task 1.1 and no other, and a separate build directory to grade it with.
struct Course : tests::Course {
  fs::path build = path() / "build";

  explicit Course(int count) {
    const std::string first = with_change(
        text_of(layout.starter()), "throw todo(\"1.1\");",
        "long double sum = 0;\n  for (double value : x) sum += value;\n  return sum / x.size();");
    for (int i = 0; i < count; ++i) {
      // New text, so that nothing of it is cached.
      hand_in(fmt::format("s{}", i), first + fmt::format("// {} {}\n", getpid(), i));
    }
    fs::create_directories(build / "bin");
    for (const char* name : {"bin/lab", "bin/checks_variance", "layout.json"}) {
      fs::copy_file(layout.build / name, build / name);
    }
    if (fs::exists(layout.build / "precompiled")) {  // else the first submission would wait for it
      fs::create_directory_symlink(layout.build / "precompiled", build / "precompiled");
    }
    fs::permissions(path(), fs::perms::all);
  }

  fs::path json() const { return path() / "results.json"; }

  Words grade(const fs::path& where, const std::string& what, const Words& more) const {
    Words words{where / "bin" / "lab", "grade", "--lab", "variance", "--seed", "1", "--no-plots"};
    if (what == "class") words.emplace_back("--class");
    return joined(joined(std::move(words), {(path() / what).string()}), more);
  }
  sandbox::ProcessResult with(const Words& faults, const Words& words) const {
    const fs::path program = layout.build / "bin" / "faulty_machine";
    return sandbox::run_process(joined(joined({program}, faults), words),
                                {.environment = {{"MC_NO_BUILD", "1"}}});
  }
};

/// The results of a class and of one submission on such a machine. False if it cannot be simulated.
bool is_no_grade(const Course& course, const Words& faults, const std::string& reason,
                 const fs::path& build) {
  const auto run =
      course.with(faults, course.grade(build, "class", {"--csv", course.csv(), "-j", "1"}));
  if (run.exit_code == 77) {
    WARN("skipped: " << run.errors);
    return false;
  }
  CAPTURE(faults, run.output, run.errors);
  CHECK(run.exit_code == 3);
  CHECK(!contains(run.output, "/100"));
  CHECK(contains(run.output, "not judged"));
  CHECK(contains(run.output + run.errors, reason));
  const auto rows = csv_rows(read_text(course.csv()));
  CHECK(rows.size() == std::min<std::size_t>(course.ids.size(), 3) + 1);  // the rest is not tried
  for (std::size_t i = 1; i < rows.size(); ++i) {
    CHECK(rows[i][4].starts_with("not judged: "));
    CHECK(contains(rows[i][4], reason));
    CHECK(rows[i][5] == "not judged");
    for (std::size_t cell = 6; cell < rows[i].size(); ++cell) CHECK(rows[i][cell].empty());
  }
  // A single submission, for Gradescope: no file that could pass for a grade.
  const auto single =
      course.with(faults, course.grade(build, "class/" + course.ids[0], {"--json", course.json()}));
  CAPTURE(single.output, single.errors);
  CHECK(single.exit_code == 3);
  CHECK(contains(single.errors, "not judged: "));
  CHECK(!fs::exists(course.json()));
  return true;
}

/// Once the machine works again, --resume judges them all.
void is_made_good(const Course& course) {
  REQUIRE_RUN(run, sandbox::run_process(
                       course.grade(course.build, "class", {"--csv", course.csv(), "--resume"}),
                       {.environment = {{"MC_NO_BUILD", "1"}}}));
  const auto rows = csv_rows(read_text(course.csv()));
  REQUIRE(rows.size() == course.ids.size() + 1);
  for (std::size_t i = 1; i < rows.size(); ++i) {
    CHECK(rows[i][5] == "judged");
    CHECK(rows[i][6] == "12");
  }
}

}  // namespace

TEST_CASE("a full disk gives no grade, and after four in a row the rest is not tried",
          "[.machine]") {
  const Course course(4);
  fs::create_directories(course.path() / "disk");
  std::uintmax_t bytes = 0;
  for (const auto& entry : fs::recursive_directory_iterator(course.build)) {
    if (entry.is_regular_file()) bytes += entry.file_size();
  }
  const auto disk = [&](std::uintmax_t more) {
    return Words{"--disk", course.build, course.path() / "disk",
                 std::to_string((bytes >> 10) + 512 + more)};
  };
  if (is_no_grade(course, disk(0), "full", course.path() / "disk")) is_made_good(course);
  // A disk that is full after the first few: those are kept.
  fs::remove_all(course.path() / "grades-verdicts");
  const auto some = course.with(
      disk(3000), course.grade(course.path() / "disk", "class", {"--csv", course.csv()}));
  if (some.exit_code == 77) return;
  CAPTURE(some.output, some.errors);
  CHECK(some.exit_code == 3);
  const auto rows = csv_rows(read_text(course.csv()));
  for (std::size_t i = 1; i < rows.size(); ++i) {
    CHECK((rows[i][6] == "12" || (rows[i][6].empty() && rows[i][4].starts_with("not judged: "))));
  }
}

TEST_CASE("a table that cannot be written ends the batch with a message, and its old text stays",
          "[.machine]") {
  const Course course(2);
  fs::create_directories(course.path() / "empty");
  fs::create_directories(course.path() / "full");
  const auto run = course.with(
      {"--disk", course.path() / "empty", course.path() / "full", "16"},
      course.grade(course.build, "class", {"--csv", course.path() / "full" / "grades.csv"}));
  if (run.exit_code == 77) return;
  CAPTURE(run.output, run.errors);
  CHECK(run.exit_code == 3);
  CHECK(contains(run.errors, "No space left on device"));
}

TEST_CASE("where seccomp, execveat or setgroups is refused, nothing is judged", "[.machine]") {
  const Course course(1);
  const std::string refused = "Operation not permitted";
  is_no_grade(course, {"--refuse", "execveat"}, refused, course.build);
  if (geteuid() == 0) {  // otherwise the jail does not change the user
    fs::remove_all(course.path() / "grades-verdicts");
    is_no_grade(course, {"--refuse", "setgroups"}, refused, course.build);
  }
  fs::remove_all(course.path() / "grades-verdicts");
  if (is_no_grade(course, {"--refuse", "seccomp"}, "seccomp: Function not implemented",
                  course.build)) {
    is_made_good(course);
  }
}

TEST_CASE("without Landlock there is a grade, which says so, and no other file is included",
          "[.machine]") {
  Course course(1);
  course.hand_in("thief", "#include \"common/../../solutions/variance.cpp\"\n");
  for (const std::string& id : course.ids) {
    const auto run = course.with({"--refuse", "landlock_create_ruleset"},
                                 course.grade(course.build, "class/" + id, {}));
    if (run.exit_code == 77) return;
    CAPTURE(id, run.output, run.errors);
    CHECK(contains(run.output, "no Landlock on this machine"));
    CHECK(contains(run.output, id == "thief" ? "reads " : "12 of 100"));
    if (id == "thief") CHECK(contains(run.output, "0 of 100 points"));
  }
}

TEST_CASE("what was compiled without Landlock is compiled again with it", "[.machine]") {
  Course course(0);
  course.hand_in("thief",
                 "asm(\".incbin \\\"/etc/passwd\\\"\");\n" + text_of(course.layout.starter()));
  const auto words = course.grade(course.build, "class/thief", {});
  const auto before = course.with({"--refuse", "landlock_create_ruleset"}, words);
  if (before.exit_code == 77 || contains(course.with({}, words).output, "no Landlock")) return;
  CHECK(contains(before.output, "not written yet"));
  CHECK(contains(course.with({}, words).output, "The assembler rejects an asm statement"));
}

TEST_CASE("where files cannot be locked, it judges and says so", "[.machine]") {
  const Course course(1);
  const auto run = course.with({"--refuse", "flock"},
                               course.grade(course.build, "class", {"--csv", course.csv()}));
  if (run.exit_code == 77) return;
  CAPTURE(run.output, run.errors);
  CHECK(run.exit_code == 0);
  CHECK(contains(run.errors, "no locks on this file system"));
  CHECK(rows_of(course.csv()).begin()->second["variance total"] == "12");
}

TEST_CASE("the files of another user in the build directory are named", "[.machine]") {
  const Course course(1);
  const auto own = sandbox::run_process({"chown", "-R", "12345", course.path().string()});
  if (!own.succeeded()) return;  // only root can
  fs::create_directories(course.build / "programs" / "another-user's");
  const auto run =
      sandbox::run_process(joined({"setpriv", "--reuid=12345", "--regid=12345", "--clear-groups"},
                                  course.grade(course.build, "class", {})),
                           {.environment = {{"MC_NO_BUILD", "1"}}});
  CHECK(run.exit_code == 3);
  CHECK(contains(run.errors, "belongs to root, after a run as another user: remove"));
}

TEST_CASE("as the only user of a user namespace, and with a lower stack, it judges", "[.machine]") {
  const Course course(1);
  for (const Words& how : {Words{"unshare", "--user", "--map-root-user"},
                           Words{"prlimit", "--stack=8388608:8388608"}}) {
    const auto run =
        sandbox::run_process(joined(how, course.grade(course.build, "class/" + course.ids[0], {})),
                             {.environment = {{"MC_NO_BUILD", "1"}}});
    if (contains(run.errors, "unshare")) continue;  // not allowed here
    CAPTURE(how, run.output, run.errors);
    CHECK(contains(run.output, "12 of 100"));
  }
  const auto low =
      sandbox::run_process(joined({"prlimit", "--as=1000000000:1000000000"},
                                  course.grade(course.build, "class/" + course.ids[0], {})),
                           {.environment = {{"MC_NO_BUILD", "1"}}});
  CAPTURE(low.output, low.errors);
  CHECK((contains(low.output, "12 of 100") || contains(low.errors, "ulimit -Hv")));
}

TEST_CASE("without processes or descriptors there is a full grade or none", "[.machine]") {
  const Course course(1);
  const std::string user = std::to_string(700'000 + getpid());
  const auto own = sandbox::run_process({"chown", "-R", "-h", user, course.path().string()});
  std::vector<Words> faults;
  for (const char* most : {"17", "28", "256"}) {
    faults.push_back({"--descriptors", most});
  }
  if (own.succeeded()) {
    for (const char* most : {"1", "5", "64"}) {
      faults.push_back({"--processes", user, most});
    }
  }
  int graded = 0, not_graded = 0;
  for (const Words& fault : faults) {
    fs::remove(course.csv());
    fs::remove_all(course.path() / "grades-verdicts");
    fs::remove_all(course.build / "programs");
    const auto run =
        course.with(fault, course.grade(course.build, "class", {"--csv", course.csv()}));
    if (run.exit_code == 77) continue;
    CAPTURE(fault, run.output, run.errors);
    CHECK((run.exit_code == 0 || run.exit_code == 3));
    (run.exit_code == 0 ? graded : not_graded) += 1;
    if (!fs::exists(course.csv())) continue;
    const auto rows = csv_rows(read_text(course.csv()));
    for (std::size_t i = 1; i < rows.size(); ++i) {
      CHECK(rows[i][6] == (run.exit_code == 0 ? "12" : ""));
      CHECK(rows[i][4].empty() == (run.exit_code == 0));
    }
  }
  CHECK(not_graded > 0);
  CHECK(graded > 0);
}

}  // namespace mc::tests::machine
