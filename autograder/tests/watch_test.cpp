// ./lab check --watch: started as by a user, with files saved as editors save them.

#include <chrono>
#include <fstream>
#include <sstream>

#include "commands/watch.hpp"
#include "tests/background.hpp"

namespace mc::tests::watching {

namespace {

constexpr const char* begun = "judging variance.cpp";

/// A variance.cpp, and `check variance DIR --only 1.1 --watch` that runs and watches it.
class WatchProcess {
 public:
  explicit WatchProcess(const std::string& text) : file_(place_.write("variance.cpp", text)) {}

  /// As most editors do: writes a temporary file, and renames it.
  void save(const std::string& text) const { place_.write("variance.cpp", text); }
  fs::path file() const { return file_; }

  std::string until(const std::string& text) { return process_.until(text); }
  std::string until_judged() { return until("\njudged "); }
  int interrupt() { return process_.interrupt(); }

  /// Its child processes that still run, as names in /proc.
  std::vector<fs::path> children() const {
    std::vector<fs::path> all;
    std::istringstream found(
        sandbox::run_process({"pgrep", "-P", std::to_string(process_.pid())}).output);
    for (std::string child; found >> child;) all.push_back(fs::path("/proc") / child);
    return all;
  }

 private:
  Scratch place_;
  fs::path file_;
  BackgroundProcess process_{{(read_layout().bin / "lab").string(), "check", "variance",
                              place_.path(), "--only", "1.1", "--watch", "--seed", "1"}};
};

/// The solution with an endless 1.1.
std::string endless() {
  return text_with_first_line_of_mean(read_layout(), "for (volatile int i = 0;; i = i + 1) {}");
}

}  // namespace

TEST_CASE("watch judges at once and after each save, for any way of saving", "[script]") {
  const std::string solution = text_of(read_layout().solutions());
  WatchProcess watching(text_of(read_layout().starter()));
  CHECK(contains(watching.until_judged(), "\n0 of 12 points; first open: 1.1"));

  {  // into the file
    std::ofstream(watching.file()) << solution;
  }
  CHECK(contains(watching.until_judged(), "\n12 of 12 points; nothing is open"));

  watching.save("not C++\n");
  CHECK(contains(watching.until_judged(), "does not compile"));

  fs::remove(watching.file());  // removed and written anew
  CHECK(contains(watching.until("waiting for it"), "variance.cpp does not exist"));
  watching.save(solution);
  CHECK(contains(watching.until_judged(), "\n12 of 12 points"));

  CHECK_FALSE(contains(watching.until(""), "\x1b["));
  CHECK(watching.interrupt() == 0);
}

TEST_CASE("a save stops the run in progress, whose verdict is never shown", "[script]") {
  WatchProcess watching(endless());
  watching.until(begun);
  watching.save(text_of(read_layout().solutions()));
  const std::string shown = watching.until_judged();
  check_contains(shown, {"judging starts over", "\n12 of 12 points"});
  CHECK_FALSE(contains(shown, "\n0 of 12 points"));
  CHECK(watching.children().empty());
  CHECK(watching.interrupt() == 0);
}

TEST_CASE("an interrupt ends watch and the run in progress", "[script]") {
  WatchProcess watching(endless());
  watching.until(begun);
  const auto end = std::chrono::steady_clock::now() + patience;
  std::vector<fs::path> judges;  // started right after that line
  while (judges.empty() && std::chrono::steady_clock::now() < end) judges = watching.children();
  REQUIRE_FALSE(judges.empty());
  CHECK(watching.interrupt() == 0);
  for (const fs::path& judge : judges) CHECK_FALSE(fs::exists(judge));
}

TEST_CASE("a screen has the first rows, and says how many are left out") {
  CHECK(first_rows("a\nb\n", 2, 40) == "a\nb\n");
  CHECK(first_rows("  a\nb\nc\n", 2, 40) == "  a\n… 2 more lines\n");
  const std::string wide(41, 'x');  // two rows of 40 columns
  CHECK(first_rows(wide + "\nb\nc\n", 3, 40) == wide + "\n… 2 more lines\n");
  CHECK(first_rows("\x1b[31m" + std::string(40, 'x') + "\x1b[0m\nb\n", 2, 40).ends_with("b\n"));
}

TEST_CASE("watch shows the first open task on top of the report") {
  const LabVerdict lab =
      verdict_of({result_of("1.1 a", Status::passed), result_of("1.2 b", Status::failed),
                  result_of("1.3 c", Status::passed), result_of("1.2 d", Status::passed)});
  const std::string report = report_open_first(lab, {}, {});
  CHECK(report.starts_with("15 of 20 points; first open: 1.2\n"));
  CHECK(report.find("1.2 b") < report.find("1.2 d"));
  CHECK(report.find("1.2 d") < report.find("1.1 a"));
}

}  // namespace mc::tests::watching
