#include "sandbox/child.hpp"

#include <signal.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include <fmt/format.h>

namespace mc::sandbox {
Descriptor end_of(pid_t pid) {
  const int raw = static_cast<int>(syscall(SYS_pidfd_open, pid, 0));
  return raw < 0 ? Descriptor() : Descriptor(raw, "pidfd");
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
  return static_cast<std::size_t>(used.ru_maxrss) * 1024;
}

bool limit(decltype(RLIMIT_CPU) resource, rlim_t soft, rlim_t hard) {
  rlimit value{soft, hard};
  if (setrlimit(resource, &value) == 0) return true;
  rlimit now{};
  if (getrlimit(resource, &now) != 0) return false;
  value = {std::min(soft, now.rlim_max), std::min(hard, now.rlim_max)};
  return setrlimit(resource, &value) == 0;
}

std::string lowered_limit(double cpu_seconds, std::size_t memory, std::size_t file_size) {
  const struct {
    decltype(RLIMIT_CPU) resource;
    rlim_t needed, unit;
    const char *name, *option, *in;
  } limits[] = {
      {RLIMIT_CPU, static_cast<rlim_t>(std::ceil(cpu_seconds)), 1, "CPU time", "-Ht", "s"},
      {RLIMIT_AS, memory, 1 << 20, "memory", "-Hv", "MB"},
      {RLIMIT_FSIZE, file_size, 1 << 20, "file size", "-Hf", "MB"}};
  for (const auto& one : limits) {
    rlimit now{};
    if (getrlimit(one.resource, &now) != 0 || now.rlim_max >= one.needed) continue;
    return fmt::format("the limit on {} here is {} {} (ulimit {}), and {} {} are needed: raise it",
                       one.name, now.rlim_max / one.unit, one.in, one.option, one.needed / one.unit,
                       one.in);
  }
  return {};
}

bool may_become(uid_t user) {
  if (geteuid() != 0) return false;
  for (const char* map : {"/proc/self/uid_map", "/proc/self/gid_map"}) {
    std::ifstream lines(map);
    unsigned long first = 0, outside = 0, count = 0;
    bool has_user = !lines;  // without /proc: as everywhere
    while (lines >> first >> outside >> count) has_user |= user >= first && user - first < count;
    if (!has_user) return false;
  }
  return true;
}

}  // namespace mc::sandbox
