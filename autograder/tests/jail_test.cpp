// Each restriction of the jail, seen from inside: one submission whose mean() does what the first
// of its values says, with the others as arguments.
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <set>
#include <system_error>
#include <utility>

#include "runner/wire.hpp"
#include "sandbox/jail.hpp"
#include "sandbox/lockdown.hpp"
#include "tests/submissions.hpp"

namespace mc::tests::jail {

namespace {

// make_call is system call x[1] with arguments x[2], x[3], …: its result or -errno. Those that
// report throw what they find, as text.
#define DEEDS                                                                                  \
  return_second, loop, take_memory, segfault, abort_it, exit_3, print_100_kb, print_strangely, \
      send_garbage, send_20_mb, send_then_fail, throw_much, throw_lines, divide, make_call,    \
      report_environment, report_descriptors, report_limits, report_user
#define TEXT(...) #__VA_ARGS__
#define TEXT_OF(...) TEXT(__VA_ARGS__)
enum Deed { DEEDS };

const std::string source = "enum Deed { " TEXT_OF(DEEDS) " };\n" R"(
#include <sys/auxv.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <string>

#include "common/todo.hpp"
#include "runner/wire.hpp"
#include "variance.hpp"

extern char** environ;

namespace mc {
namespace {

volatile int zero = 0;

long call(std::span<const double> x) {
  long a[7] = {};
  for (std::size_t i = 1; i < x.size() && i < 8; ++i) a[i - 1] = static_cast<long>(x[i]);
  const long result = syscall(a[0], a[1], a[2], a[3], a[4], a[5], a[6]);
  return result == -1 ? -errno : result;
}

[[noreturn]] void report(const std::string& text) { throw std::runtime_error(text); }

}  // namespace

double deed_of(std::span<const double> x) {
  const std::string much(100 << 10, 'x');
  switch (static_cast<Deed>(x[0])) {
    case return_second: return x[1];
    case loop: for (volatile int i = 0;; i = i + 1) {}
    case take_memory:
      for (;;) {
        volatile char* const block = new char[1 << 20];
        block[0] = 1;
      }
    case segfault: return *reinterpret_cast<volatile double*>(zero + 8);
    case abort_it: std::abort();
    case exit_3: std::exit(3);
    case print_100_kb: std::puts(much.c_str()); return 1;
    case print_strangely: std::puts("\x1b[31mred\xff\n\ttabbed"); return 1;
    case send_garbage: (void)!write(3, "hello", 5); _exit(0);
    case send_20_mb: for (int i = 0; i < 200; ++i) (void)!write(3, much.data(), much.size());
      _exit(0);
    case send_then_fail: {
      const wire::Header header{wire::magic, wire::Status::value, 0, 8};
      (void)!write(3, &header, sizeof header);
      (void)!write(3, &header, 8);
      _exit(1);
    }
    case throw_much: report(much);
    case throw_lines: report("one\ntwo\tthree\x1b");
    case divide: return 7 / zero;
    case make_call: return static_cast<double>(call(x));
    case report_environment: {
      std::string all;
      for (char** one = environ; *one != nullptr; ++one) all += *one;
      report("[" + all + "] " + program_invocation_name);
    }
    case report_descriptors: {
      std::string open;
      for (int i = 0; i < 1100; ++i) {  // mmap says what a descriptor is without touching it
        errno = 0;
        mmap(nullptr, 4096, PROT_READ, MAP_PRIVATE, i, 0);
        if (errno != EBADF) open += std::to_string(i) + ' ';
      }
      report(open);
    }
    case report_limits: {
      std::string all;
      for (const auto which : {RLIMIT_CPU, RLIMIT_AS, RLIMIT_STACK, RLIMIT_FSIZE, RLIMIT_CORE,
                               RLIMIT_NPROC}) {
        rlimit limit{};
        getrlimit(which, &limit);
        all += std::to_string(limit.rlim_cur) + '/' + std::to_string(limit.rlim_max) + ' ';
      }
      report(all);
    }
    case report_user:
      report(std::to_string(getauxval(AT_UID)) + ' ' + std::to_string(getauxval(AT_EUID)) + ' ' +
           std::to_string(getauxval(AT_GID)) + ' ' + std::to_string(getauxval(AT_EGID)));
  }
  throw todo("no such deed");
}

}  // namespace mc
)";

/// The starter with this for mean().
std::string whole_source() {
  return source + with_change(FirstLab().starter, "throw todo(\"1.1\")", "return deed_of(x)");
}

const sandbox::Program& program() {
  static const BuildResult built = FirstLab().build_text("jail", whole_source());
  INFO(built.failure);
  REQUIRE(built.program);
  return *built.program;
}

sandbox::Outcome run(Deed deed, std::vector<double> arguments = {},
                     const sandbox::Limits& limits = {}) {
  arguments.insert(arguments.begin(), deed);
  mc::wire::Writer request;
  request.put(std::string("mean"));
  request.put(arguments);
  return sandbox::run_jailed(program(), request.bytes, limits);
}

double value_of(const sandbox::Outcome& outcome) {
  INFO(outcome.failure);
  REQUIRE(outcome.answered);
  REQUIRE(outcome.status == mc::wire::Status::value);
  return mc::wire::Reader(outcome.bytes).get<double>();
}

std::string text_of(const sandbox::Outcome& outcome) {
  INFO(outcome.failure);
  REQUIRE(outcome.answered);
  REQUIRE(outcome.status == mc::wire::Status::other_exception);
  return outcome.bytes;
}

}  // namespace

TEST_CASE("every way to end has its message") {
  CHECK(std::isnan(value_of(run(return_second, {NAN}))));
  const sandbox::Limits short_time{.cpu_seconds = 1};
  const auto timed = run(loop, {}, short_time);
  CHECK(timed.failure == "did not end within 1 s of CPU time and 512 MB of memory");
  CHECK(timed.over_limit());
  CHECK(run(take_memory).failure == "did not end within 2 s of CPU time and 512 MB of memory");
  CHECK(run(take_memory, {}, {.memory = std::size_t{64} << 20}).over_limit());
  CHECK(run(segfault).failure ==
        "crashed: segmentation fault (outside an array, or out of stack by endless recursion?)");
  CHECK(run(abort_it).failure ==
        "crashed: aborted (a failed assertion, a corrupted heap, or an exception in a noexcept)");
  CHECK(run(exit_3).failure == "called exit(3) instead of returning");
  CHECK(run(print_100_kb).failure == "printed more than 64 KB");
  CHECK(run(send_garbage).failure == "sent something that is not a result");
  CHECK(run(send_then_fail).failure == "sent something that is not a result");
  CHECK(run(send_20_mb).failure == "sent a result of more than 16 MB");
#ifdef __x86_64__  // elsewhere, integer division by zero gives zero
  CHECK(run(divide).failure == "crashed: an integer divided by zero");
#endif
  for (const Deed deed : {segfault, exit_3, send_garbage}) {
    const auto outcome = run(deed);
    CHECK_FALSE(outcome.answered);
    CHECK_FALSE(outcome.over_limit());
  }
}

TEST_CASE("running out of wall time is the machine's fault, because nothing in the jail can wait") {
  const sandbox::Limits impatient{.cpu_seconds = 9, .wall_seconds = 0.2};
  if (sandbox::jail_is_complete()) {
    CHECK_THROWS_AS(run(loop, {}, impatient), std::system_error);
  } else {
    const auto waited = run(loop, {}, impatient);
    CHECK(waited.over_limit());
  }
}

TEST_CASE("its output and exception texts are made safe") {
  const auto printed = run(print_strangely);
  CHECK(value_of(printed) == 1);
  CHECK(printed.printed == "?[31mred?\n\ttabbed\n");
  CHECK(text_of(run(throw_lines)) == "one two three?");
  const auto much = text_of(run(throw_much));
  CHECK(much.size() < 250);
  CHECK(much.ends_with("x …"));
}

TEST_CASE("it inherits nothing, has the documented limits, and is nobody if the judge is root") {
  CHECK(text_of(run(report_environment)) == "[] submission");
  CHECK(text_of(run(report_descriptors)) == "0 1 2 3 ");
  CHECK(text_of(run(report_limits)) == "2/3 536870912/536870912 16777216/16777216 0/0 0/0 0/0 ");
  const std::string id =
      geteuid() == 0 ? std::to_string(sandbox::jailed_user) : std::to_string(geteuid());
  const auto ids = text_of(run(report_user));
  CHECK(ids.starts_with(id + ' ' + id + ' '));
  if (geteuid() == 0) CHECK(ids == id + ' ' + id + ' ' + id + ' ' + id);
}

#ifdef __x86_64__

TEST_CASE("exactly these system calls are allowed") {
  if (!sandbox::jail_is_complete()) return;
  // clang-format off
  const std::set<long> allowed{
      SYS_read, SYS_brk, SYS_mmap, SYS_munmap, SYS_mremap, SYS_mprotect, SYS_madvise,
      SYS_clock_gettime, SYS_clock_getres, SYS_gettimeofday, SYS_time, SYS_getrandom, SYS_getpid,
      SYS_gettid, SYS_rt_sigaction, SYS_rt_sigprocmask, SYS_rt_sigreturn, SYS_sigaltstack,
      SYS_sched_yield, SYS_exit, SYS_exit_group, SYS_arch_prctl, SYS_set_tid_address,
      SYS_set_robust_list, SYS_rseq, SYS_uname, SYS_prlimit64};
  // clang-format on
  const std::set<long> refused{SYS_readlink, SYS_readlinkat, SYS_fstat, SYS_newfstatat,
                               SYS_statx,    SYS_ioctl,      SYS_lseek};
  const std::string killed =
      "made a system call a lab never needs (open a file, start a process, use the network)";
  for (long number = 0; number < 520; ++number) {  // all arguments zero
    // uretprobe and uprobe: Linux 6.14 and later do not filter them. They do nothing outside of a
    // probe, which only root can set.
    if (number == 335 || number == 336) continue;
    const auto outcome = run(make_call, {static_cast<double>(number)});
    INFO("system call " << number << ": " << outcome.failure);
    if (refused.contains(number)) {
      CHECK(value_of(outcome) == -EPERM);
    } else {
      CHECK((outcome.failure == killed) != allowed.contains(number));
    }
  }
}

TEST_CASE("system calls with allowed arguments, and with others") {
  if (!sandbox::jail_is_complete()) return;
  const auto survives = [](std::vector<double> arguments) {
    return run(make_call, std::move(arguments)).failure.find("made a system call") ==
           std::string::npos;
  };
  for (const double descriptor : {1., 2., 3.}) {
    CHECK(survives({SYS_write, descriptor, 0, 0}));
    CHECK(survives({SYS_writev, descriptor, 0, 0}));
  }
  for (const double descriptor : {0., 4., 10., 16., -1.}) {
    CHECK_FALSE(survives({SYS_write, descriptor, 0, 0}));
    CHECK_FALSE(survives({SYS_writev, descriptor, 0, 0}));
  }
  for (const double descriptor : {1., 3., 4., -1.}) {
    CHECK_FALSE(survives({SYS_read, descriptor, 0, 0}));
  }
  CHECK(survives({SYS_futex, 0, 1}));
  CHECK(survives({SYS_futex, 0, 129}));
  for (const double wait : {0., 128., 9., 137., 11., 5.}) {
    CHECK_FALSE(survives({SYS_futex, 0, wait}));
  }
  CHECK_FALSE(survives({SYS_prlimit64, 0, RLIMIT_CPU, 4096}));
  CHECK_FALSE(survives({SYS_prlimit64, 1, RLIMIT_CPU, 0}));
  CHECK_FALSE(survives({SYS_tgkill, 1, 1, 6}));
  CHECK_FALSE(survives({SYS_tgkill, -1, -1, 6}));
  CHECK_FALSE(survives({SYS_execveat, 4, 0, 0, 0, 0x1000}));
  // The same calls under their x32 numbers, and those that only x32 has.
  for (const double number : {0., 1., 2., 9., 59., 60., 231., 512., 520., 545.}) {
    CHECK_FALSE(survives({0x40000000 + number}));
  }
}

#endif

TEST_CASE("a long request to a program that does not read it") {
  const FirstLab first;
  const BuildResult built = first.build_text(
      "deaf", "#include <unistd.h>\nconst int early = (_exit(7), 0);\n" + first.starter);
  INFO(built.failure);
  REQUIRE(built.program);
  const auto outcome = sandbox::run_jailed(*built.program, std::string(10 << 20, 'x'));
  CHECK(outcome.failure == "called exit(7) instead of returning");
}

}  // namespace mc::tests::jail
