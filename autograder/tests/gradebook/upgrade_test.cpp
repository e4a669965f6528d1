// A handout grows on top of what students have, and reaches them by ./lab update.

#include "grader/commands/upgrade.hpp"
#include "grader/commands/manifest.hpp"
#include "tests/gradebook/handout.hpp"

namespace mc::tests::upgrade {

namespace {

/// A handout of lab 1, and a student's clone of it. Programs need no building for git.
struct Semester : Handout {
  fs::path clone = path() / "student";
  Semester() : Handout({"--labs", "1", "--with-sources"}) {
    CAPTURE(written.errors);
    REQUIRE(written.exit_code == 0);
    git(path(), {"clone", "-q", root, clone});
  }
  /// As if the handout had been written by an older version of this repository: another text in a
  /// file, with its hash.
  void make_older(const std::string& file, const std::string& text) const {
    write_text(root / file, text);
    Manifest manifest = read_manifest(root);
    manifest.version = "1.0.0";
    manifest.files[file] = hash_of_file(root / file);
    manifest.checks["variance"] = "0";
    write_manifest(root, manifest);
    commit_files(root, {file, manifest_file}, "older");
  }
  sandbox::ProcessResult again(const Words& more = {}) const {
    return run(joined({"handout", root}, more));
  }
  /// `./lab update` in the clone, with the program of this build.
  sandbox::ProcessResult update() const {
    const fs::path program = built_for(clone, path() / "program", "grader");
    write("program/layout.txt", "root=" + clone.string() + "\nversion=1.0.0\ncompiler=c++\n");
    return sandbox::run_process({program, "update"}, {.directory = clone});
  }
};

}  // namespace

TEST_CASE("a handout grows by one commit, and leaves alone what others own", "[.update]") {
  const Semester semester;
  semester.make_older("labs/1-variance/README.md", "An older text.\n");
  // What a teaching assistant or a student has there.
  write_text(semester.root / "starter" / "variance.cpp", "my work\n");
  write_text(semester.root / "notes.md", "mine\n");
  const fs::path header = semester.root / "labs" / "1-variance" / "variance.hpp";
  write_text(header, read_text(header) + "// edited\n");
  REQUIRE_RUN(run, semester.again({"--labs", "2"}));
  CHECK(contains(run.output, "one commit on top"));
  CHECK(lines(git(semester.root, {"rev-list", "HEAD"})) == 3);
  const std::string message = git(semester.root, {"log", "-1", "--format=%B"});
  check_contains(message, {", was 1.0.0", "New labs: independent", "Checks changed: variance",
                           "labs/1-variance/README.md"});
  CHECK(read_text(semester.root / "starter" / "variance.cpp") == "my work\n");
  CHECK(read_text(semester.root / "notes.md") == "mine\n");
  CHECK(contains(read_text(header), "// edited"));
  CHECK(fs::exists(semester.root / "starter" / "independent.cpp"));
  CHECK(fs::exists(semester.root / "answers" / "2-independent.md"));
  CHECK(contains(read_text(semester.root / "README.md"), "Lab 2"));
  CHECK(!contains(read_text(semester.root / "labs" / "1-variance" / "README.md"), "An older"));
  // Only what the course wrote is in the commit.
  const std::string left = git(semester.root, {"status", "--porcelain"});
  check_contains(left, {"starter/variance.cpp", "notes.md", "variance.hpp"});
  CHECK(lines(left) == 3);
  CHECK(contains(semester.again().output, "nothing to change"));
  // A directory that is not a handout is refused.
  check_refused(semester.run({"handout", semester.write("other/x", "").parent_path()}));
}

TEST_CASE("a student's update keeps uncommitted work, and both versions of an edited header",
          "[.update]") {
  const Semester semester;
  const std::string work = "// my work\n", header = "labs/1-variance/variance.hpp";
  const std::string given = read_text(semester.root / header);
  semester.make_older(header, "// older\n");
  write_text(semester.clone / "README.md", "mine\n");
  git(semester.clone, {"stash", "-q"});
  CHECK(contains(semester.update().output, "Now version 1.0.0"));
  CHECK(lines(git(semester.clone, {"stash", "list"})) == 1);  // the student's
  git(semester.clone, {"stash", "drop", "-q"});
  write_text(semester.clone / "starter" / "variance.cpp", work);
  CHECK(contains(semester.update().output, "Already the latest: 1.0.0"));
  write_text(semester.clone / header, "// mine\n");
  REQUIRE(semester.again({"--labs", "2"}).exit_code == 0);
  REQUIRE_RUN(run, semester.update());
  check_contains(run.output,
                 {"New labs: independent", header + ": you changed it, and so did the course"});
  CHECK(read_text(semester.clone / "starter" / "variance.cpp") == work);
  CHECK(read_text(semester.clone / header) == given);
  CHECK(read_text(semester.clone / (header + ".mine")) == "// mine\n");
  CHECK(fs::exists(semester.clone / "starter" / "independent.cpp"));
  CHECK(read_manifest(semester.clone).version == semester.layout.version);
  CHECK(git(semester.clone, {"stash", "list"}).empty());
  // One more lab each week; a student who missed a week reads about both.
  REQUIRE(semester.again({"--labs", "3"}).exit_code == 0);
  REQUIRE(semester.again({"--labs", "4"}).exit_code == 0);
  const std::string later = semester.update().output;
  check_contains(later, {"New labs: stratification", "New labs: blue_noise"});
  CHECK(!contains(later, "New labs: independent"));
  CHECK(read_text(semester.clone / "starter" / "variance.cpp") == work);
  CHECK(fs::exists(semester.clone / "starter" / "blue_noise.cpp"));
}

TEST_CASE("an update that cannot be merged changes nothing", "[.update]") {
  const Semester semester;
  const std::string header = "labs/1-variance/variance.hpp";
  semester.make_older(header, "// older\n");
  REQUIRE(semester.update().exit_code == 0);
  write_text(semester.clone / header, "// mine\n");
  git(semester.clone, {"commit", "-q", "-a", "-m", "my header"});
  write_text(semester.clone / "starter" / "variance.cpp", "// uncommitted\n");
  REQUIRE(semester.again().exit_code == 0);
  check_refused(semester.update(), "nothing was updated: you committed changes to " + header);
  CHECK(read_text(semester.clone / header) == "// mine\n");
  CHECK(read_text(semester.clone / "starter" / "variance.cpp") == "// uncommitted\n");
  // What the message says to do, does it.
  git(semester.clone, {"commit", "-q", "-a", "-m", "work"});
  git(semester.clone, {"pull", "-q", "--no-rebase", "-X", "theirs"});
  CHECK(!contains(read_text(semester.clone / header), "mine"));
  // Without a remote, the message says what is missing.
  git(semester.clone, {"remote", "remove", "origin"});
  CHECK(contains(semester.update().errors, "git remote add origin"));
}

TEST_CASE("a released lab is one commit, and the next handout keeps it", "[.update]") {
  const Semester semester;
  semester.output_of({"release", "1", semester.root});
  CHECK(contains(git(semester.root, {"log", "-1", "--format=%s"}), "solution of lab variance"));
  CHECK(read_text(semester.root / "released" / "variance.cpp") ==
        text_of(semester.layout.solutions()));
  CHECK(fs::exists(semester.root / "released" / "1-variance.md"));
  CHECK(contains(semester.output_of({"release", "1", semester.root}), "already"));
  CHECK(contains(semester.update().output, "Release the solution of lab variance"));
  CHECK(fs::exists(semester.clone / "released" / "variance.cpp"));
  REQUIRE(semester.again({"--labs", "2"}).exit_code == 0);
  CHECK(fs::exists(semester.root / "released" / "variance.cpp"));
  CHECK(git(semester.root, {"status", "--porcelain"}).empty());
  check_refused(semester.run({"release", "3", semester.root}));
  check_refused(semester.run({"release", "1", semester.path()}));
}

// A submission or a handout may have any text there; listed files may be removed by an upgrade.
TEST_CASE("a manifest names files below its handout only") {
  const Scratch place;
  place.write(manifest_file,
              "version=1\nfile=a labs/x\nfile=b ../x\nfile=c /etc/x\nfile=d labs/../../x\n");
  const Manifest manifest = read_manifest(place.path());
  CHECK(manifest.version == "1");
  CHECK(manifest.files == std::map<std::string, std::string>{{"labs/x", "a"}});
  const std::string longer_than_a_path_may_be(10000, 'x');
  CHECK(read_manifest(place.path() / longer_than_a_path_may_be).version.empty());
}

}  // namespace mc::tests::upgrade
