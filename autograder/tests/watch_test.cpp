// ./lab check --watch: started as by a user, with files saved as editors save them.
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <sstream>
#include <thread>

#include "commands/watch.hpp"
#include "sandbox/descriptor.hpp"
#include "tests/submissions.hpp"

namespace mc::tests::watching {

namespace {

/// Long enough for any machine: stops a hanging test, and does not measure speed.
constexpr auto patience = std::chrono::minutes(2);

constexpr const char* begun = "judging variance.cpp";

/// A variance.cpp, and `check variance DIR --only 1.1 --watch` that runs and watches it.
class WatchProcess {
 public:
  explicit WatchProcess(const std::string& text) : output_(sandbox::make_pipe()) {
    save(text);
    const fs::path grader = read_layout().build / "bin" / "lab", place = place_.path();
    pid_ = fork();
    if (pid_ == 0) {
      setenv("MC_NO_BUILD", "1", 1);
      dup2(output_.write.get(), STDOUT_FILENO);
      dup2(output_.write.get(), STDERR_FILENO);
      execl(grader.c_str(), grader.c_str(), "check", "variance", place.c_str(), "--only", "1.1",
            "--watch", "--seed", "1", nullptr);
      _exit(127);
    }
    output_.write.reset();
    sandbox::make_nonblocking(output_.read);
  }
  ~WatchProcess() {
    if (pid_ > 0) kill(pid_, SIGKILL);
    if (pid_ > 0) waitpid(pid_, nullptr, 0);
  }
  WatchProcess(const WatchProcess&) = delete;

  /// As most editors do: writes a temporary file, and renames it.
  void save(const std::string& text) const { place_.write("variance.cpp", text); }
  fs::path file() const { return place_.path() / "variance.cpp"; }

  /// Reads until `text` arrives; returns all output so far. Fails if it never arrives.
  std::string until(const std::string& text) {
    const auto end = std::chrono::steady_clock::now() + patience;
    for (;;) {
      if (const auto at = unread_.find(text); at != std::string::npos) {
        std::string all = unread_.substr(0, at + text.size());
        unread_.erase(0, at + text.size());
        return all;
      }
      const bool is_open = sandbox::read_available(output_.read, unread_, std::size_t{1} << 22);
      if (!is_open || std::chrono::steady_clock::now() > end) {
        FAIL("no '" << text << "' in:\n" << unread_);
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
  }

  std::string until_judged() { return until("\njudged "); }

  /// The exit status after an interrupt; -1 if a signal ended it.
  int interrupt() {
    kill(pid_, SIGINT);
    int status = 0;
    waitpid(pid_, &status, 0);
    pid_ = -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

  /// Its child processes that still run, as names in /proc.
  std::vector<fs::path> children() const {
    std::vector<fs::path> all;
    std::istringstream found(sandbox::run_process({"pgrep", "-P", std::to_string(pid_)}).output);
    for (std::string child; found >> child;) all.push_back(fs::path("/proc") / child);
    return all;
  }

 private:
  Scratch place_;
  sandbox::Pipe output_;
  pid_t pid_ = -1;
  std::string unread_;
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
