// ./lab reset, in a repository with its own history.
#include <filesystem>
#include <string>
#include <vector>

#include "checks/support/catch.hpp"
#include "grader/base/text_file.hpp"
#include "grader/checkout/layout.hpp"
#include "sandbox/process.hpp"
#include "tests/submissions.hpp"
#include "tests/text.hpp"

namespace mc::tests::reset {

namespace fs = std::filesystem;
using namespace grader;

namespace {

/// A checkout with the grader apparently built in it: the grader finds its folder by its own path,
/// and the checkout by the layout file next to it.
class Checkout {
 public:
  Checkout() {
    const Layout real = read_layout();
    fs::create_directories(place_.path() / "build" / "bin");
    fs::copy_file(real.build / "bin" / "grader", place_.path() / "build" / "bin" / "grader");
    std::string layout = read_text(real.build / "layout.txt");
    layout.replace(0, layout.find('\n'), "root=" + root().string());
    write_text(place_.path() / "build" / "layout.txt", layout);
    fs::create_directories(root() / "starter");
    fs::create_directory_symlink(real.labs(), root() / "labs");
    git({"init", "-q"});
  }

  fs::path root() const { return place_.path() / "checkout"; }
  fs::path file() const { return root() / "starter" / "variance.cpp"; }

  void commit(const std::string& text) const {
    write_text(file(), text);
    git({"add", "starter"});
    git({"-c", "user.name=anna", "-c", "user.email=anna@example.org", "commit", "-q", "-m",
         "a step"});
  }
  sandbox::ProcessResult reset() const {
    const fs::path grader = place_.path() / "build" / "bin" / "grader";
    return sandbox::run_process({grader.string(), "reset", "variance"}, {.environment = alone()});
  }

 private:
  /// Independent of the user's git configuration, and of any repository above the scratch
  /// directory.
  std::vector<std::pair<std::string, std::string>> alone() const {
    return {{"GIT_CONFIG_GLOBAL", "/dev/null"},
            {"GIT_CONFIG_NOSYSTEM", "1"},
            {"GIT_CEILING_DIRECTORIES", place_.path().string()}};
  }
  void git(const std::vector<std::string>& words) const {
    REQUIRE_RUN(run, sandbox::run_process(joined({"git", "-C", root().string()}, words),
                                          {.environment = alone()}));
  }

  Scratch place_{"reset"};
};

/// The starter with its first task begun.
std::string begun(const std::string& text) {
  return with_change(text, "throw todo(\"1.1\");", "return 0;");
}

}  // namespace

TEST_CASE("reset restores the starter and keeps a backup of what was written", "[script]") {
  const Checkout checkout;
  const std::string given = text_of(read_layout().starter());
  checkout.commit("// an older handout\n" + given);
  checkout.commit(given);
  checkout.commit(begun(given));
  write_text(checkout.file(), "mine\n");

  REQUIRE_RUN(first, checkout.reset());
  CHECK(read_text(checkout.file()) == given);  // the newest version without a begun task
  CHECK(read_text(checkout.file().string() + ".1.bak") == "mine\n");
  CHECK(contains(first.output, "variance.cpp.1.bak"));

  const auto again = checkout.reset();  // nothing to back up
  CHECK(again.exit_code == 0);
  CHECK(contains(again.output, "is the original again"));
  CHECK_FALSE(fs::exists(checkout.file().string() + ".2.bak"));

  write_text(checkout.file(), "mine too\n");
  CHECK(checkout.reset().exit_code == 0);
  CHECK(read_text(checkout.file().string() + ".1.bak") == "mine\n");
  CHECK(read_text(checkout.file().string() + ".2.bak") == "mine too\n");

  fs::remove(checkout.file());
  CHECK(checkout.reset().exit_code == 0);
  CHECK(read_text(checkout.file()) == given);
  CHECK_FALSE(fs::exists(checkout.file().string() + ".3.bak"));
}

TEST_CASE("without a history there is no starter, and the file stays unchanged", "[script]") {
  const Checkout checkout;
  write_text(checkout.file(), "mine\n");
  const auto run = checkout.reset();
  CHECK(run.exit_code == 3);
  CHECK(lines(run.errors) == 1);
  CHECK(contains(run.errors, "git has no starter/variance.cpp here"));
  CHECK(read_text(checkout.file()) == "mine\n");
}

}  // namespace mc::tests::reset
