// ./lab reset, in a repository with its own history.

#include "tests/submissions.hpp"

namespace mc::tests::reset {

namespace {

/// A repository, with the grader apparently built in it.
struct Checkout : Scratch {
  fs::path root = path() / "checkout", file = root / "starter" / "variance.cpp";
  fs::path program = built_for(root, path() / "build", "grader");

  Checkout() {
    fs::create_directories(root / "starter");
    fs::create_directory_symlink(read_layout().labs(), root / "labs");
    git(root, {"init", "-q"});
  }
  void commit(const std::string& text) const {
    write_text(file, text);
    git(root, {"add", "starter"});
    git(root, {"commit", "-q", "-m", "a step"});
  }
  std::string backup(int number) const {
    return read_text(fmt::format("{}.{}.bak", file.string(), number));
  }
  /// Independent of any repository above the scratch directory.
  sandbox::ProcessResult reset() const {
    return sandbox::run_process({program, "reset", "variance"},
                                {.environment = {{"GIT_CEILING_DIRECTORIES", path()}}});
  }
};

}  // namespace

TEST_CASE("reset restores the starter and keeps a backup of what was written", "[script]") {
  const Checkout checkout;
  const std::string given = text_of(read_layout().starter());
  checkout.commit("// an older handout\n" + given);
  checkout.commit(given);
  checkout.commit(with_change(given, "throw todo(\"1.1\");", "return 0;"));  // a task is begun
  write_text(checkout.file, "mine\n");

  REQUIRE_RUN(first, checkout.reset());
  CHECK(read_text(checkout.file) == given);  // the newest version without a begun task
  CHECK(checkout.backup(1) == "mine\n");
  CHECK(contains(first.output, "variance.cpp.1.bak"));

  const auto again = checkout.reset();  // nothing to back up
  CHECK(again.exit_code == 0);
  CHECK(contains(again.output, "is the original again"));
  CHECK(checkout.backup(2).empty());

  write_text(checkout.file, "mine too\n");
  CHECK(checkout.reset().exit_code == 0);
  CHECK(checkout.backup(1) == "mine\n");
  CHECK(checkout.backup(2) == "mine too\n");

  fs::remove(checkout.file);
  CHECK(checkout.reset().exit_code == 0);
  CHECK(read_text(checkout.file) == given);
  CHECK(checkout.backup(3).empty());
}

TEST_CASE("without a history there is no starter, and the file stays unchanged", "[script]") {
  const Checkout checkout;
  write_text(checkout.file, "mine\n");
  const auto run = checkout.reset();
  CHECK(run.exit_code == 3);
  CHECK(lines(run.errors) == 1);
  CHECK(contains(run.errors, "git has no starter/variance.cpp here"));
  CHECK(read_text(checkout.file) == "mine\n");
}

}  // namespace mc::tests::reset
