// Experiments by hand, and the words that say which lab.
#include <filesystem>
#include <string>
#include <vector>

#include "checks/support/catch.hpp"
#include "grader/context/layout.hpp"
#include "sandbox/process.hpp"
#include "tests/door.hpp"
#include "tests/submissions.hpp"
#include "tests/text.hpp"

namespace mc::tests::run {

namespace fs = std::filesystem;
using namespace grader;

TEST_CASE("an experiment by hand") {
  const std::string solutions = read_layout().solutions().string();
  CHECK(lab({"run", "--dir", solutions, "variance", "mean", "1,2,6"}).output == "3\n");
  CHECK(lab({"run", "--dir", solutions, "variance", "mean", "-1,-2,-6"}).output == "-3\n");
  CHECK(contains(lab({"run", "--dir", solutions, "variance"}).output, "welford x"));
  CHECK(lab({"run", "--dir", solutions, "variance", "nothing"}).exit_code == 2);
  // As its help writes it, options behind the lab; behind the experiment, all is its own.
  CHECK(lab({"run", "variance", "--dir", solutions, "mean", "1,2,6"}).output == "3\n");
  CHECK(lab({"run", "variance", "--dir", solutions, "mean", "-1,-2,-6"}).output == "-3\n");
  CHECK(lab({"run", "variance", "mean", "--dir", solutions}).exit_code == 1);
  CHECK(contains(lab({"run", "variance", "mean", "1,2"}).output, "not written yet"));
}

TEST_CASE("an experiment under the sanitizers") {
  const Layout layout = read_layout();
  const fs::path directory = layout.build / "tests" / "sanitize";
  fs::create_directories(directory);
  const auto run = [&](const std::string& text) {
    write_text(directory / "variance.cpp", text);
    return lab({"run", "--sanitize", "variance", "--dir", directory.string(), "mean", "1,2,6"});
  };
  const std::string right = text_of(layout.solutions());
  const auto good = run(right);
  CHECK(good.output == "3\n");
  CHECK(good.exit_code == 0);
  const fs::path program = last_line(good.errors);
  CHECK(program.string().starts_with((layout.build / "sanitize" / "variance").string()));
  const auto built = fs::last_write_time(program);
  CHECK(run(right).output == "3\n");
  CHECK(fs::last_write_time(program) == built);  // nothing has changed

  const auto with_first_line_of_mean = [&](const std::string& line) {
    const std::string head = "double mean(std::span<const double> x) {";
    std::string text = right;
    REQUIRE(contains(text, head));
    return text.insert(text.find(head) + head.size(), line);
  };
  const auto stale = run(with_first_line_of_mean(
      "double* few = new double[3]{}; delete[] few; return few[int(x[0])];"));
  CHECK(stale.exit_code != 0);
  CHECK(contains(stale.errors, "AddressSanitizer: heap-use-after-free"));
  const auto overflow = run(with_first_line_of_mean("return int(x[0]) + 2147483647;"));
  CHECK(overflow.exit_code != 0);
  CHECK(contains(overflow.errors, "runtime error: signed integer overflow"));
  const auto unfinished = run(right + "int f() { return nothing; }\n");
  CHECK(unfinished.exit_code == 1);
  CHECK(contains(unfinished.errors, "variance.cpp"));
  CHECK(contains(unfinished.errors, "nothing"));
}

TEST_CASE("a lab and its task") {
  const std::string solutions = read_layout().solutions().string();
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"check", "1.3", solutions},
        {"check", "variance", "1.3", solutions},
        {"check", "1", "1.3", solutions},
        {"check", "1-variance", solutions, "--only", "1.3"}}) {
    const auto run = lab(words);
    CAPTURE(words);
    CHECK(run.exit_code == 0);
    CHECK(contains(run.output, "18 of 18 points"));
    CHECK(!contains(run.output, " 1.2 "));
  }
}

TEST_CASE("the door finds the lab among a verb's words") {
  const std::string root = read_layout().root.string();
  const auto found = [&](const std::string& words) {
    const auto run = sandbox::run_process(
        {"sh", "-euc", "root='" + root + "'; . \"$root/cmake/setup.sh\"; lab_among " + words});
    CHECK(run.exit_code == 0);
    return run.output;
  };
  for (const char* words :
       {"check 1", "check variance", "check 1-variance", "check 1.3", "check variance 2.3",
        "check --seed 3 variance", "check --seed=3 variance", "check --only 1.3 1",
        "check variance --seed 3", "run --dir 2 variance mean 3", "run --sanitize 1 mean 3"}) {
    CAPTURE(words);
    CHECK(found(words) == "variance\n");
  }
  CHECK(found("check 4-blue-noise") == "blue_noise\n");
  for (const char* words :
       {"", "check", "check --seed 3", "check 99", "check vari", "check 99.1"}) {
    CAPTURE(words);
    CHECK(found(words).empty());
  }
}

}  // namespace mc::tests::run
