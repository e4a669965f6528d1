#include "sandbox/lockdown.hpp"

#include <fcntl.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <new>
#include <random>
#include <system_error>
#include <vector>

#ifdef MC_HAVE_SECCOMP
#include <seccomp.h>
#endif

#include "sandbox/child.hpp"

namespace mc::sandbox {
namespace {

constexpr int program_descriptor = 4;  // after request 0, printed 1 and 2, response 3

/// The arguments of execveat, on one page at an unpredictable address. The filter allows exec only
/// with pointers into this page; the page disappears with the exec, so no second one can follow. A
/// filter cannot read a path, and an address that is known could be a section of the program.
struct LaunchPage {
  char empty_path[8] = "", name[16] = "submission";
  char* arguments[2] = {name, nullptr};
  char* environment[1] = {};
};
LaunchPage* launch_page = nullptr;
bool can_become_nobody = false;

#ifdef MC_HAVE_SECCOMP

std::vector<sock_filter> filter;
constexpr std::size_t longest_filter = 512;
constexpr std::uint32_t pid_placeholder = 0x5eedc0deu;  // no pid: those end at 2^22

[[noreturn]] void fail_with(int error, const char* action) {
  throw std::system_error(error < 0 ? -error : error, std::generic_category(), action);
}

/// Allows `call` if all `conditions` on its arguments hold.
template <class... Conditions>
void allow(scmp_filter_ctx context, int call, Conditions... conditions) {
  const int error =
      seccomp_rule_add(context, SCMP_ACT_ALLOW, call, sizeof...(conditions), conditions...);
  if (error != 0) fail_with(error, "seccomp_rule_add");
}

scmp_datum_t datum(const void* pointer) {
  return reinterpret_cast<scmp_datum_t>(pointer);
}

/// Requires an argument of a call to have exactly this value.
scmp_arg_cmp equal(unsigned argument, scmp_datum_t value) {
  return {argument, SCMP_CMP_EQ, value, 0};
}

void add_rules(scmp_filter_ctx context) {
  // Computing, memory, clocks, exit.
  for (const int call : {SCMP_SYS(brk),           SCMP_SYS(mmap),         SCMP_SYS(munmap),
                         SCMP_SYS(mremap),        SCMP_SYS(mprotect),     SCMP_SYS(madvise),
                         SCMP_SYS(clock_gettime), SCMP_SYS(clock_getres), SCMP_SYS(gettimeofday),
                         SCMP_SYS(time),          SCMP_SYS(getrandom),    SCMP_SYS(getpid),
                         SCMP_SYS(gettid),        SCMP_SYS(rt_sigaction), SCMP_SYS(rt_sigprocmask),
                         SCMP_SYS(rt_sigreturn),  SCMP_SYS(sigaltstack),  SCMP_SYS(sched_yield),
                         SCMP_SYS(exit),          SCMP_SYS(exit_group)}) {
    allow(context, call);
  }
  // What a static C library does before main().
  for (const int call : {SCMP_SYS(arch_prctl), SCMP_SYS(set_tid_address), SCMP_SYS(set_robust_list),
                         SCMP_SYS(rseq), SCMP_SYS(uname)}) {
    allow(context, call);
  }
  // pthread_once, under std::call_once and the locales, always wakes; waiting is not allowed.
  for (const unsigned wake : {1u, 129u}) {  // FUTEX_WAKE, and private
    allow(context, SCMP_SYS(futex), equal(1, wake));
  }
  allow(context, SCMP_SYS(read), equal(0, 0));
  for (const unsigned descriptor : {1u, 2u, 3u}) {
    allow(context, SCMP_SYS(write), equal(0, descriptor));
    allow(context, SCMP_SYS(writev), equal(0, descriptor));
  }
  // abort(), for itself only; reading its own limits, setting none.
  allow(context, SCMP_SYS(tgkill), equal(0, pid_placeholder), equal(2, SIGABRT));
  allow(context, SCMP_SYS(prlimit64), equal(0, 0), equal(2, 0));
  // The single exec.
  allow(context, SCMP_SYS(execveat), equal(0, program_descriptor),
        equal(1, datum(launch_page->empty_path)), equal(2, datum(launch_page->arguments)),
        equal(3, datum(launch_page->environment)), equal(4, AT_EMPTY_PATH));
  // A static glibc tries these and handles a refusal.
  for (const int call : {SCMP_SYS(readlink), SCMP_SYS(readlinkat), SCMP_SYS(fstat),
                         SCMP_SYS(newfstatat), SCMP_SYS(statx), SCMP_SYS(ioctl), SCMP_SYS(lseek)}) {
    const int error = seccomp_rule_add(context, SCMP_ACT_ERRNO(EPERM), call, 0);
    if (error != 0) fail_with(error, "seccomp_rule_add");
  }
}

/// The filter as instructions, with a placeholder for the child's pid.
std::vector<sock_filter> export_filter() {
  const scmp_filter_ctx context = seccomp_init(SCMP_ACT_KILL_PROCESS);
  if (context == nullptr) fail_with(ENOSYS, "seccomp");  // refused, for example by a container
  add_rules(context);
  const int file = memfd_create("filter", MFD_CLOEXEC);
  if (file < 0) fail_with(errno, "memfd_create");
  if (const int error = seccomp_export_bpf(context, file); error != 0) {
    fail_with(error, "seccomp_export_bpf");
  }
  seccomp_release(context);
  const auto size = static_cast<std::size_t>(lseek(file, 0, SEEK_END));
  std::vector<sock_filter> instructions(size / sizeof(sock_filter));
  if (pread(file, instructions.data(), size, 0) != static_cast<ssize_t>(size)) {
    fail_with(errno, "reading the filter");
  }
  close(file);
  if (instructions.size() > longest_filter) fail_with(E2BIG, "the filter");
  return instructions;
}

#endif  // MC_HAVE_SECCOMP

/// Direct system calls: the C library's functions would involve the parent's threads.
bool become_nobody() {
  return syscall(SYS_setgroups, 0, nullptr) == 0 && syscall(SYS_setgid, jailed_user) == 0 &&
         syscall(SYS_setuid, jailed_user) == 0;
}

void close_from(int first) {
  if (syscall(SYS_close_range, first, ~0u, 0) == 0) return;  // Linux 5.9
  for (int descriptor = first; descriptor < 4096; ++descriptor) close(descriptor);
}

}  // namespace

bool jail_is_complete() {
#ifdef MC_HAVE_SECCOMP
  return true;
#else
  return false;
#endif
}

void prepare_lockdown() {
  can_become_nobody = may_become(jailed_user);
  std::random_device random;
  const std::uint64_t bits = std::uint64_t{random()} << 32 | random();
  const std::uint64_t address = (bits & 0x3fff'ffff'0000u) + 0x1000'0000'0000u;  // a wish
  void* const page = mmap(reinterpret_cast<void*>(address), sizeof(LaunchPage),
                          PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (page == MAP_FAILED) fail("mmap");
  launch_page = new (page) LaunchPage;
#ifdef MC_HAVE_SECCOMP
  filter = export_filter();
#endif
}

void lock_down_and_exec(int program, const Ends& ends, const Limits& limits, pid_t parent,
                        LaunchFailure& failure) {
  const auto failed = [&](const char* action) {
    failure.action = action;
    failure.error = errno;
  };

  if (setsid() < 0) return failed("setsid");
  if (dup2(ends.request, 0) < 0 || dup2(ends.printed, 1) < 0 || dup2(ends.printed, 2) < 0 ||
      dup2(ends.response, 3) < 0 || dup2(program, program_descriptor) < 0) {
    return failed("dup2");
  }
  if (fcntl(program_descriptor, F_SETFD, FD_CLOEXEC) != 0) return failed("fcntl");
  close_from(program_descriptor + 1);
  if (chdir("/") != 0) return failed("chdir");

  // No handler of the parent may run here once signals are unblocked.
  for (int one = 1; one < NSIG; ++one) signal(one, SIG_DFL);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);

  const auto cpu = static_cast<rlim_t>(std::ceil(limits.cpu_seconds));
  constexpr rlim_t stack = rlim_t{16} << 20;
  if (!limit(RLIMIT_CPU, cpu, cpu + 1) || !limit(RLIMIT_STACK, stack, stack) ||
      !limit(RLIMIT_FSIZE, 0, 0) || !limit(RLIMIT_CORE, 0, 0) ||
      !limit(RLIMIT_AS, limits.memory, limits.memory)) {
    return failed("setrlimit");
  }

  if (can_become_nobody && !become_nobody()) return failed("becoming nobody");
  // After the user change: a limit of 0 before it would forbid the exec that follows it.
  if (!limit(RLIMIT_NPROC, 0, 0)) return failed("setrlimit");

  // After the user change, which resets it.
  if (prctl(PR_SET_PDEATHSIG, SIGKILL) != 0) return failed("prctl");
  if (getppid() != parent) _exit(127);  // the parent died before prctl took effect
  if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) return failed("no_new_privs");

#ifdef MC_HAVE_SECCOMP
  sock_filter own[longest_filter];  // the parent's memory may be shared until the exec
  std::ranges::copy(filter, own);
  const auto self = static_cast<std::uint32_t>(getpid());
  for (std::size_t i = 0; i < filter.size(); ++i) {
    if (BPF_CLASS(own[i].code) == BPF_JMP && own[i].k == pid_placeholder) own[i].k = self;
  }
  const sock_fprog installed{static_cast<unsigned short>(filter.size()), own};
  if (prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &installed) != 0) return failed("seccomp");
#endif

  syscall(SYS_execveat, program_descriptor, launch_page->empty_path, launch_page->arguments,
          launch_page->environment, AT_EMPTY_PATH);
  failed("exec");
}

}  // namespace mc::sandbox
