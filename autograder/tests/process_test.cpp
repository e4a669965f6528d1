// Processes and descriptors: no leaks and no leftovers, in spite of interruptions.
#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include <string>
#include <system_error>
#include <utility>

#include "checks/support/catch.hpp"
#include "sandbox/descriptor.hpp"
#include "sandbox/process.hpp"
#include "tests/hygiene.hpp"
#include "tests/text.hpp"

namespace mc::tests::process {

using sandbox::Descriptor;
using sandbox::run_process;

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
#ifdef __linux__
  const auto seen_by_child = [](const sandbox::ProcessOptions& options = {}) {
    return run_process({"ls", "/proc/self/fd"}, options).output;
  };
  const std::string before = seen_by_child();  // includes descriptors inherited by the tests
#endif
  const sandbox::Pipe pipe = sandbox::make_pipe();
  for (const auto* end : {&pipe.read, &pipe.write}) {
    CHECK((fcntl(end->get(), F_GETFD) & FD_CLOEXEC) != 0);
  }
#ifdef __linux__
  CHECK(seen_by_child() == before);
  const std::string with_one = seen_by_child({.descriptors = {{pipe.read.get(), 9}}});
  CHECK(contains(with_one, "\n9\n"));
  CHECK(lines(with_one) == lines(before) + 1);
#endif
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

TEST_CASE("a signal is not the end of a pipe") {
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
  for (const std::size_t most : {17u, 18u, 19u, 20u}) {  // it takes five of them, from 16 on
    const FewDescriptors few(most);
    CHECK_THROWS_AS(run_process({"true"}), std::system_error);
  }
  CHECK(open_descriptors() == before);
  const FewDescriptors enough(32);
  CHECK(run_process({"true"}).succeeded());
}

}  // namespace mc::tests::process
