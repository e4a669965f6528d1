#include "sandbox/process.hpp"

#include <fcntl.h>
#include <grp.h>
#include <linux/close_range.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <sstream>
#include <system_error>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "sandbox/child.hpp"
#include "sandbox/descriptor.hpp"

namespace mc::sandbox {
namespace {

std::vector<std::string> variables_of(const Environment& additions) {
  std::vector<std::string> all;
  for (const auto& [name, value] : fixed_environment()) {
    const bool is_replaced = std::ranges::any_of(
        additions, [&name = name](const auto& one) { return one.first == name; });
    if (!is_replaced) all.push_back(name + '=' + value);
  }
  for (const auto& [name, value] : additions) all.push_back(name + '=' + value);
  return all;
}

std::vector<char*> pointers(std::vector<std::string>& texts) {
  std::vector<char*> all;
  for (std::string& text : texts) all.push_back(text.data());
  all.push_back(nullptr);
  return all;
}

/// Everything the child needs, prepared before the fork.
struct Launch {
  const char* path;
  char* const* arguments;
  char* const* environment;
  const char* directory;
  int input, output, errors;
  pid_t parent;
  const Descriptor& ruleset;  ///< of a confined program
};

/// Runs in the child, between fork and exec: async-signal-safe calls only.
[[noreturn]] void become(const Launch& launch, const ProcessOptions& options) {
  // In its own session: it is killed with all processes it started, and never reads a terminal.
  setsid();
  if (dup2(launch.input, 0) < 0 || dup2(launch.output, 1) < 0 || dup2(launch.errors, 2) < 0) {
    _exit(exit_not_started);
  }
  // Also what we inherited ourselves. Before Linux 5.11 only our own, which close by themselves.
  syscall(SYS_close_range, 3, ~0u, CLOSE_RANGE_CLOEXEC);
  // Our descriptors are all above those given to a child (descriptor.hpp): none overlap.
  for (const auto& [ours, theirs] : options.descriptors) {
    if (dup2(ours, theirs) < 0) _exit(exit_not_started);
  }
  if (*launch.directory != '\0' && chdir(launch.directory) != 0) _exit(exit_not_started);
  bool limited = true;
  const auto both = [&](decltype(RLIMIT_CPU) resource, rlim_t value) {
    limited &= limit(resource, value, value);
  };
  if (options.cpu_seconds > 0) {
    both(RLIMIT_CPU, static_cast<rlim_t>(std::ceil(options.cpu_seconds)));
  }
  if (options.file_size > 0) both(RLIMIT_FSIZE, options.file_size);
  if (options.memory > 0) {
    both(RLIMIT_CORE, 0);
    both(RLIMIT_AS, options.memory);
  }
  if (!limited) _exit(exit_not_started);
  signal(SIGPIPE, SIG_DFL);
  if (options.user != 0 &&
      (setgroups(0, nullptr) != 0 || setgid(options.user) != 0 || setuid(options.user) != 0)) {
    _exit(exit_not_started);
  }
  // After the change of user, which resets it.
  if (prctl(PR_SET_PDEATHSIG, SIGKILL) != 0 || getppid() != launch.parent) _exit(exit_not_started);
  if (options.places != nullptr && !confine(launch.ruleset)) _exit(exit_not_started);
  execve(launch.path, launch.arguments, launch.environment);
  _exit(127);
}

/// For the output of a program. A pipe would let it wait: a text can make a compiler read its own
/// output (/proc/self/fd/1), and a file has an end.
Descriptor unnamed_file() {
  return Descriptor(memfd_create("output", MFD_CLOEXEC), "memfd_create");
}

std::string text_in(const Descriptor& file, std::size_t most) {
  const off_t end = lseek(file.get(), 0, SEEK_END);
  std::string text(std::min(most, static_cast<std::size_t>(std::max<off_t>(end, 0))), '\0');
  std::size_t length = 0;
  while (length < text.size()) {
    const ssize_t got =
        pread(file.get(), text.data() + length, text.size() - length, static_cast<off_t>(length));
    if (got <= 0) break;
    length += static_cast<std::size_t>(got);
  }
  text.resize(length);
  return text;
}

/// Waits for the end of a program without reaping it; kills it when its time is up or a stop is
/// requested.
void wait_for_end(pid_t pid, const ProcessOptions& options, ProcessResult& result) {
  const auto start = std::chrono::steady_clock::now();
  const Descriptor end = end_of(pid);
  bool killed = false;
  for (;;) {
    siginfo_t ended{};
    if (waitid(P_PID, static_cast<id_t>(pid), &ended, WEXITED | WNOHANG | WNOWAIT) == 0 &&
        ended.si_pid == pid) {
      return;
    }
    const double left =
        options.wall_seconds -
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    const bool late = options.wall_seconds > 0 && left <= 0;
    const bool stopped = options.stop != nullptr && *options.stop;
    if (!killed && (late || stopped)) {
      killed = true;
      result.out_of_time = !stopped;
      kill_group(pid);
    }
    double most = end ? 1000 : 2;  // milliseconds
    if (options.stop != nullptr) most = std::min(most, 200.0);
    if (options.wall_seconds > 0 && !killed) most = std::min(most, 1000 * left + 1);
    pollfd watched{end.get(), POLLIN, 0};
    poll(&watched, 1, std::max(1, static_cast<int>(most)));
  }
}

/// Reaps all that the program left, and adds what these processes used. They are our children
/// because we adopt orphans (below).
void reap_rest(pid_t leader, rusage& used) {
  rusage more{};
  for (;;) {
    const pid_t one = wait4(-leader, nullptr, 0, &more);
    if (one < 0 && errno == EINTR) continue;
    if (one < 0) return;
    timeradd(&used.ru_utime, &more.ru_utime, &used.ru_utime);
    timeradd(&used.ru_stime, &more.ru_stime, &used.ru_stime);
    used.ru_maxrss = std::max(used.ru_maxrss, more.ru_maxrss);
    used.ru_oublock += more.ru_oublock;
  }
}

}  // namespace

std::vector<std::string> places_in(const char* name) {
  std::vector<std::string> places;
  const char* const list = std::getenv(name);
  std::istringstream parts(list == nullptr ? "" : list);
  for (std::string place; std::getline(parts, place, ':');) {
    // An empty or relative place is the working directory: a submission's.
    if (place.starts_with('/')) places.push_back(place);
  }
  return places;
}

Environment fixed_environment() {
  const auto path = places_in("PATH"), libraries = places_in("LD_LIBRARY_PATH");
  const auto temporary = places_in("TMPDIR");
  Environment fixed{{"PATH", path.empty() ? "/usr/local/bin:/usr/bin:/bin"
                                          : fmt::format("{}", fmt::join(path, ":"))},
                    {"LC_ALL", "C"},
                    {"TMPDIR", temporary.empty() ? "/tmp" : temporary[0]},
                    {"HOME", "/nonexistent"},
                    {"CCACHE_DISABLE", "1"}};
  if (!libraries.empty()) {
    fixed.emplace_back("LD_LIBRARY_PATH", fmt::format("{}", fmt::join(libraries, ":")));
  }
  return fixed;
}

std::string found_in_path(const std::string& name) {
  if (name.empty() || name.find('/') != std::string::npos) return name;
  std::istringstream places(fixed_environment()[0].second);
  for (std::string place; std::getline(places, place, ':');) {
    std::string file = place + '/' + name;
    if (access(file.c_str(), X_OK) == 0) return file;
  }
  return name;
}

ProcessResult run_process(const std::vector<std::string>& command, const ProcessOptions& options) {
  // What a killed compiler leaves is adopted by us, not by init: so its CPU time is counted.
  if (options.places != nullptr) prctl(PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0);
  auto words = command;
  auto variables = variables_of(options.environment);
  const auto arguments = pointers(words), environment = pointers(variables);
  const std::string directory = options.directory.string(), path = found_in_path(command[0]);

  Descriptor ruleset;
  if (options.places != nullptr) ruleset = ruleset_for(*options.places);
  const Descriptor output = unnamed_file(), errors = unnamed_file();
  const Descriptor nothing(open("/dev/null", O_RDONLY | O_CLOEXEC), "/dev/null");
  const Launch launch{path.c_str(),      arguments.data(), environment.data(),
                      directory.c_str(), nothing.get(),    output.get(),
                      errors.get(),      getpid(),         ruleset};
  const pid_t pid = fork();
  if (pid < 0) fail("fork");
  if (pid == 0) become(launch, options);

  ProcessResult result;
  wait_for_end(pid, options, result);
  kill(-pid, SIGKILL);  // while its number cannot belong to another process
  int status = 0;
  rusage used{};
  while (wait4(pid, &status, 0, &used) < 0) {
    if (errno != EINTR) fail("wait4");
  }
  reap_rest(pid, used);
  result.output = text_in(output, options.output);
  result.errors = text_in(errors, options.output);
  if (WIFEXITED(status)) result.exit_code = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) result.signal = WTERMSIG(status);
  if (result.exit_code == exit_not_started) {
    throw std::system_error(EAGAIN, std::generic_category(), "cannot start " + command[0]);
  }
  result.cpu_seconds = cpu_seconds_of(used);
  result.peak_memory = peak_memory_of(used);
  result.written = static_cast<std::size_t>(used.ru_oublock) * 512;
  return result;
}

}  // namespace mc::sandbox
