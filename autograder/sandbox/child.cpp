#include "sandbox/child.hpp"

#include <signal.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <utility>

namespace mc::sandbox {
namespace {

/// In the watchman: positive numbers are groups to guard, negative ones to release; the end of the
/// pipe means that the judge has ended. Must not allocate: its parent has threads.
[[noreturn]] void watch(int notes) {
  setsid();
  // Do not keep the judge's streams open.
  for (int descriptor = 0; descriptor < 1024; ++descriptor) {
    if (descriptor != notes) close(descriptor);
  }
  for (const int ignored : {SIGINT, SIGTERM, SIGHUP, SIGPIPE}) signal(ignored, SIG_IGN);
  static std::array<pid_t, 4096> groups;
  std::size_t count = 0;
  pid_t note = 0;
  for (;;) {
    const ssize_t got = read(notes, &note, sizeof note);
    if (got < 0 && errno == EINTR) continue;
    if (got != static_cast<ssize_t>(sizeof note)) break;
    if (note > 0 && count < groups.size()) groups[count++] = note;
    if (note < 0) {
      const auto end = groups.begin() + static_cast<std::ptrdiff_t>(count);
      const auto found = std::find(groups.begin(), end, -note);
      if (found != end) *found = groups[--count];
    }
  }
  for (std::size_t i = 0; i < count; ++i) kill(-groups[i], SIGKILL);
  _exit(0);
}

/// The writing end of the watchman's pipe; -1 if there is no watchman.
int notes() {
  static const int descriptor = [] {
    Pipe pipe = make_pipe();
    const pid_t watchman = fork();
    if (watchman == 0) {
      // Forked twice, so that init adopts it and this process need not wait for it.
      const pid_t grandchild = fork();
      if (grandchild == 0) watch(pipe.read.get());
      _exit(grandchild < 0 ? 1 : 0);
    }
    int status = 1;
    if (watchman > 0) {
      while (waitpid(watchman, &status, 0) < 0 && errno == EINTR) {
      }
    }
    // No processes left: without a reader, a write would raise SIGPIPE.
    if (status != 0) return -1;
    static Descriptor kept;
    kept = std::move(pipe.write);
    return kept.get();
  }();
  return descriptor;
}

void send_note(pid_t note) {
  const int descriptor = notes();
  if (descriptor < 0) return;
  // Writes are shorter than PIPE_BUF, so they are atomic.
  while (write(descriptor, &note, sizeof note) < 0 && errno == EINTR) {
  }
}

}  // namespace

Descriptor end_of(pid_t pid) {
#ifdef SYS_pidfd_open
  const int raw = static_cast<int>(syscall(SYS_pidfd_open, pid, 0));
  if (raw >= 0) return Descriptor(raw, "pidfd");
#endif
  (void)pid;
  return {};
}

void kill_group(pid_t leader) {
  kill(-leader, SIGKILL);
  kill(leader, SIGKILL);  // in case it has no session yet
}

double cpu_seconds_of(const rusage& used) {
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(used.ru_utime) + seconds(used.ru_stime);
}

std::size_t peak_memory_of(const rusage& used) {
#ifdef __APPLE__
  constexpr std::size_t unit = 1;
#else
  constexpr std::size_t unit = 1024;
#endif
  return static_cast<std::size_t>(used.ru_maxrss) * unit;
}

GroupGuard::GroupGuard(pid_t leader) : leader_(leader) {
  send_note(leader_);
}

GroupGuard::~GroupGuard() {
  send_note(-leader_);
}

}  // namespace mc::sandbox
