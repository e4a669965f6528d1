// Processes and descriptors: no leaks and no leftovers, in spite of interruptions; an exception in
// a worker ends the grader with a message and a status.
#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <optional>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "judge/judging/judge.hpp"
#include "judge/pictures/plots.hpp"
#include "sandbox/descriptor.hpp"
#include "sandbox/programs.hpp"
#include "tests/submissions.hpp"

namespace mc::tests::hygiene {

using sandbox::Descriptor;
using sandbox::run_process;

namespace {

/// The number of descriptors that this process has open.
std::size_t open_descriptors() {
  std::size_t count = 0;
  for (int i = 0; i < 1024; ++i) count += fcntl(i, F_GETFD) >= 0;
  return count;
}

/// `ulimit -n most` for the lifetime of the object, also for processes started meanwhile.
class FewDescriptors {
 public:
  explicit FewDescriptors(std::size_t most) {
    getrlimit(RLIMIT_NOFILE, &before_);
    const rlimit few{most, before_.rlim_max};
    setrlimit(RLIMIT_NOFILE, &few);
  }
  ~FewDescriptors() { setrlimit(RLIMIT_NOFILE, &before_); }
  FewDescriptors(const FewDescriptors&) = delete;

 private:
  rlimit before_{};
};

/// A signal every millisecond, whose handler interrupts system calls.
class SignalTimer {
 public:
  SignalTimer() {
    count = 0;
    struct sigaction action {};
    action.sa_handler = [](int) { ++count; };
    sigaction(SIGALRM, &action, &before_);
    const itimerval often{{0, 1000}, {0, 1000}};
    setitimer(ITIMER_REAL, &often, nullptr);
  }
  ~SignalTimer() {
    const itimerval never{};
    setitimer(ITIMER_REAL, &never, nullptr);
    sigaction(SIGALRM, &before_, nullptr);
  }
  SignalTimer(const SignalTimer&) = delete;
  int times() const { return count; }

 private:
  static inline std::atomic<int> count = 0;
  struct sigaction before_ {};
};

/// A submission of lab 1, and its program.
struct Labs : FirstLab {
  Scratch place;

  /// The starter with a different comment.
  Submission submission(int number) const {
    place.write("variance.cpp", starter + fmt::format("// {}\n", number));
    return open_submission(labs, place.path());
  }
  BuildResult program() const {
    BuildResult built = build_program(layout, lab, submission(0));
    INFO(built.failure);
    REQUIRE(built.program);
    return built;
  }
};

/// Is every task of the untouched starter «not written yet»?
bool is_right(const LabVerdict& verdict) {
  return std::all_of(verdict.checks.begin(), verdict.checks.end(), [](const CheckResult& result) {
    return result.status == Status::not_written;
  });
}

}  // namespace

TEST_CASE("a descriptor has one owner, and a number that no child uses") {
  const std::size_t before = open_descriptors();
  {
    Descriptor first(open("/dev/null", O_RDONLY), "/dev/null");
    const int number = first.get();
    CHECK(number >= 16);
    Descriptor second = std::move(first);
    CHECK(second.get() == number);
    second = Descriptor(open("/dev/null", O_RDONLY), "/dev/null");
    CHECK(open_descriptors() == before + 1);
    second.reset();
    CHECK_FALSE(second);
    CHECK(open_descriptors() == before);
    CHECK_THROWS_AS(Descriptor(open("/no/such/file", O_RDONLY), "open"), std::system_error);
  }
  CHECK(open_descriptors() == before);
}

TEST_CASE("a child inherits only what it is given") {
  const auto seen_by_child = [](const sandbox::ProcessOptions& options = {}) {
    return run_process({"ls", "/proc/self/fd"}, options).output;
  };
  const std::string before = seen_by_child();
  const sandbox::Pipe pipe = sandbox::make_pipe();
  for (const auto* end : {&pipe.read, &pipe.write}) {
    CHECK((fcntl(end->get(), F_GETFD) & FD_CLOEXEC) != 0);
  }
  CHECK(seen_by_child() == before);
  const int inherited = dup(0);  // without FD_CLOEXEC, as those that a shell has open
  CHECK(seen_by_child() == before);
  close(inherited);
  const std::string with_one = seen_by_child({.descriptors = {{pipe.read.get(), 9}}});
  CHECK(contains(with_one, "\n9\n"));
  CHECK(lines(with_one) == lines(before) + 1);
}

TEST_CASE("no environment of the person who types reaches a program") {
  const std::pair<const char*, const char*> hostile[] = {{"LC_ALL", "fr_FR.UTF-8"},
                                                         {"LANG", "fr_FR.UTF-8"},
                                                         {"LANGUAGE", "fr"},
                                                         {"CPATH", ":/x"},
                                                         {"CPLUS_INCLUDE_PATH", ":/x"},
                                                         {"CXXFLAGS", "-flto"},
                                                         {"GCC_COLORS", "error=1"},
                                                         {"CCACHE_DIR", "/x"},
                                                         {"GIT_DIR", "/x"},
                                                         {"GIT_CONFIG_COUNT", "1"},
                                                         {"GNUPLOT_LIB", "/x"},
                                                         {"LD_PRELOAD", ""},
                                                         {"HOME", "/x"},
                                                         {"XDG_CONFIG_HOME", "/x"},
                                                         {"LD_LIBRARY_PATH", "/a::b:/c"}};
  std::vector<std::pair<const char*, std::optional<std::string>>> before;
  for (const auto& [name, value] : hostile) {
    const char* const old = std::getenv(name);
    before.emplace_back(name, old == nullptr ? std::nullopt : std::optional<std::string>(old));
    setenv(name, value, 1);
  }
  const std::string path = std::getenv("PATH");
  setenv("PATH", (":.:" + path).c_str(), 1);
  const auto run = run_process({"env"}, {.environment = {{"OWN", "1"}}});
  setenv("PATH", path.c_str(), 1);
  for (const auto& [name, value] : before) {
    value ? setenv(name, value->c_str(), 1) : unsetenv(name);
  }
  const char* const temporary = std::getenv("TMPDIR");
  CHECK(run.output == fmt::format("PATH={}\nLC_ALL=C\nTMPDIR={}\nHOME=/nonexistent\n"
                                  "CCACHE_DISABLE=1\nLD_LIBRARY_PATH=/a:/c\nOWN=1\n",
                                  path, temporary == nullptr ? "/tmp" : temporary));
}

TEST_CASE("git runs without anybody's configuration, and gnuplot without ~/.gnuplot") {
  const Scratch place;
  REQUIRE_RUN(made, sandbox::run_git(place.path(), {"init", "-q"}));
  place.write("bin/x", "");
  place.write(".git/hooks/pre-commit", "#!/bin/sh\nexit 1\n");
  std::filesystem::permissions(place.path() / ".git/hooks/pre-commit",
                               std::filesystem::perms(0755));
  REQUIRE_RUN(added, sandbox::run_git(place.path(), {"add", "."}));
  REQUIRE_RUN(commit, sandbox::run_git(place.path(), {"commit", "-q", "-m", "x"}));
  CHECK(sandbox::run_git(place.path(), {"ls-files"}).output == "bin/x\n");
}

TEST_CASE("the CPU time of a confined program is that of all that it started and left") {
  const sandbox::Places everywhere{{"/"}, "/tmp"};
  const std::string burn = "i=0; while [ $i -lt 300000 ]; do i=$((i + 1)); done";
  const auto left = run_process({"sh", "-c", "(" + burn + "; sleep 60) & sleep 60"},
                                {.wall_seconds = 3, .places = &everywhere});
  CHECK(left.out_of_time);
  CHECK(left.cpu_seconds > 0.05);
}

TEST_CASE("how a process ends") {
  CHECK(run_process({"true"}).succeeded());
  CHECK(run_process({"sh", "-c", "exit 7"}).exit_code == 7);
  CHECK(run_process({"sh", "-c", "kill -9 $$"}).signal == SIGKILL);
  CHECK(run_process({"/no/such/program"}).exit_code == 127);
  CHECK(run_process({"no-such-program"}).exit_code == 127);
  const auto late = run_process({"sleep", "60"}, {.wall_seconds = 0.2});
  CHECK(late.out_of_time);
  CHECK(late.signal == SIGKILL);
  const auto busy = run_process({"sh", "-c", "while :; do :; done"}, {.cpu_seconds = 1});
  CHECK_FALSE(busy.out_of_time);
  CHECK((busy.signal == SIGXCPU || busy.signal == SIGKILL));  // both come at the limit
  CHECK(busy.cpu_seconds > 0.5);
  CHECK(run_process({"sh", "-c", "yes | head -c 1000000"}, {.output = 1000}).output.size() == 1000);
}

TEST_CASE("the processes that a process started end with it") {
  const auto run = run_process({"sh", "-c", "sleep 60 & echo $!; wait"}, {.wall_seconds = 0.3});
  CHECK(run.out_of_time);
  const auto child = static_cast<pid_t>(std::stol(run.output));
  bool gone = false;
  for (int i = 0; i < 200 && !gone; ++i) {  // it may remain a zombie until init reaps it
    gone = kill(child, 0) != 0 ||
           contains(run_process({"ps", "-o", "stat=", "-p", std::to_string(child)}).output, "Z");
    if (!gone) usleep(10'000);
  }
  CHECK(gone);
}

TEST_CASE("signals interrupt no program") {
  const SignalTimer interrupted;
  const auto run = run_process(
      {"sh", "-c", "i=0; while [ $i -lt 3000 ]; do echo $i; echo $i >&2; i=$((i + 1)); done"});
  CHECK(run.succeeded());
  CHECK(lines(run.output) == 3000);
  CHECK(lines(run.errors) == 3000);
  const auto slow = run_process({"sh", "-c", "sleep 0.3; echo done"});
  CHECK(slow.output == "done\n");
  CHECK(interrupted.times() > 50);
}

TEST_CASE("without free descriptors no process starts, and no descriptor leaks") {
  const std::size_t before = open_descriptors();
  for (const std::size_t most : {17u, 18u}) {  // it takes three of them, from 16 on
    const FewDescriptors few(most);
    CHECK_THROWS_AS(run_process({"true"}), std::system_error);
  }
  CHECK(open_descriptors() == before);
  const FewDescriptors enough(32);
  CHECK(run_process({"true"}).succeeded());
}

TEST_CASE("plots under 64 descriptors") {
  const Labs labs;
  if (!std::filesystem::exists(labs.layout.measurements(labs.lab.name))) return;  // it is not built
  const FewDescriptors few(64);
  const std::size_t before = open_descriptors();
  for (int i = 0; i < 2; ++i) {
    draw_plots(labs.layout, labs.lab, {labs.submission(i)}, "tests");
  }
  CHECK(open_descriptors() == before);
}

TEST_CASE("a plot draws what there is, and states in place what is missing") {
  const Labs labs;
  if (!std::filesystem::exists(labs.layout.measurements(labs.lab.name))) return;  // it is not built
  const auto drawn = [&](const std::string& text, const char* label) {
    Submission submission = labs.submission(0);
    labs.place.write("variance.cpp", text);
    submission.label = label;
    return draw_plots(labs.layout, labs.lab, {submission}, "tests");
  };
  const auto picture = [&](const std::string& name) {
    return read_text(labs.layout.build / "plots" / "tests" / ("variance-" + name + ".svg"));
  };
  const Plots none = drawn(labs.starter, "starter");
  check_contains(picture("digits"), {"not drawn: ", "is not written yet"});
  CHECK(std::any_of(none.remarks.begin(), none.remarks.end(), [](const std::string& remark) {
    return remark.starts_with("starter, digits: 1.") && remark.ends_with(" is not written yet");
  }));

  const std::string text = with_change(labs.starter, "throw todo(\"1.2\");", "return 1.0 / 12;");
  const Plots some = drawn(text, "anna");
  CHECK(!contains(picture("digits"), "not drawn: "));
  CHECK_FALSE(some.remarks.empty());
}

TEST_CASE("an exception in a worker reaches the caller, and the other workers finish") {
  const Labs labs;
  const FewDescriptors few(64);
  const std::size_t before = open_descriptors();
  for (const unsigned workers : {1u, 2u, 4u}) {
    const BuildResult built = labs.program();
    JudgeOptions options;
    options.workers = workers;
    std::size_t calls = 0;
    options.progress = [&](std::size_t, std::size_t) {
      if (++calls == 3) throw std::runtime_error("no more of this");
    };
    CHECK_THROWS_WITH(judge_lab(labs.layout, labs.lab, built, options), "no more of this");
    options.progress = {};
    CHECK(is_right(judge_lab(labs.layout, labs.lab, built, options)));
  }
  CHECK(open_descriptors() == before);
}

TEST_CASE("signals change no verdict") {
  const Labs labs;
  const SignalTimer interrupted;
  CHECK(is_right(judge_lab(labs.layout, labs.lab, labs.program(), {})));
  CHECK(interrupted.times() > 50);
}

TEST_CASE("without descriptors the grader ends with a line and status 3, whenever they run out") {
  const Labs labs;
  labs.submission(0);
  std::size_t lacking = 0, judged = 0;
  for (int most = 17; most <= 40; ++most) {
    const auto run = run_process(
        {"sh", "-c",
         fmt::format("ulimit -n {} && exec '{}' check variance '{}' --only 1.1", most,
                     (labs.layout.build / "bin" / "lab").string(), labs.place.path().string())});
    CAPTURE(most, run.errors);
    CHECK(run.signal == 0);
    CHECK((run.exit_code == 1 || run.exit_code == 3));
    if (run.exit_code == 3) CHECK(last_line(run.errors).starts_with("lab: "));
    lacking += run.exit_code == 3;
    judged += run.exit_code == 1;
  }
  CHECK(lacking > 0);
  CHECK(judged > 0);
}

}  // namespace mc::tests::hygiene
