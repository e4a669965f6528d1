#include "sandbox/process.hpp"

#include <fcntl.h>
#include <grp.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <string_view>
#include <system_error>

#ifdef __linux__
#include <sys/prctl.h>
#endif

#include "sandbox/confinement.hpp"
#include "sandbox/descriptor.hpp"
#include "sandbox/reaper.hpp"

extern char** environ;

namespace mc::sandbox {
namespace {

using Clock = std::chrono::steady_clock;

std::vector<std::string> environment_with(
    const std::vector<std::pair<std::string, std::string>>& changes) {
  std::vector<std::string> all;
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const std::string text = *entry;
    bool replaced = false;
    for (const auto& [name, value] : changes) replaced |= text.starts_with(name + "=");
    if (!replaced) all.push_back(text);
  }
  for (const auto& [name, value] : changes) all.push_back(name + "=" + value);
  return all;
}

std::vector<char*> pointers(std::vector<std::string>& texts) {
  std::vector<char*> all;
  for (std::string& text : texts) all.push_back(text.data());
  all.push_back(nullptr);
  return all;
}

/// The program's path according to PATH; the name itself if it is not found, so that exec reports
/// the error. Called before the fork, because searching PATH may allocate.
std::string found_in_path(const std::string& name) {
  if (name.find('/') != std::string::npos) return name;
  const char* path = std::getenv("PATH");
  std::string_view left = path == nullptr ? "/usr/bin:/bin" : path;
  while (!left.empty()) {
    const auto colon = left.find(':');
    std::string candidate = std::string(left.substr(0, colon)) + '/' + name;
    if (candidate[0] == '/' && access(candidate.c_str(), X_OK) == 0) return candidate;
    if (colon == std::string_view::npos) break;
    left.remove_prefix(colon + 1);
  }
  return name;
}

/// Everything the child needs, prepared before the fork.
struct Launch {
  const char* path;
  char* const* arguments;
  char* const* environment;
  const char* directory;
  int input, output, errors;
  pid_t parent;
};

bool limit(decltype(RLIMIT_CPU) resource, rlim_t value) {
  const rlimit both{value, value};
  return setrlimit(resource, &both) == 0;
}

/// Runs in the child, between fork and exec: async-signal-safe calls only.
[[noreturn]] void become(const Launch& launch, const ProcessOptions& options) {
  // In its own session: it is killed with all processes it started, and never reads a terminal.
  setsid();
#ifdef __linux__
  if (prctl(PR_SET_PDEATHSIG, SIGKILL) != 0 || getppid() != launch.parent) _exit(exit_not_started);
#endif
  if (dup2(launch.input, 0) < 0 || dup2(launch.output, 1) < 0 || dup2(launch.errors, 2) < 0) {
    _exit(exit_not_started);
  }
  // Our descriptors are all above those given to a child (descriptor.hpp): none overlap.
  for (const auto& [ours, theirs] : options.descriptors) {
    if (dup2(ours, theirs) < 0) _exit(exit_not_started);
  }
  if (*launch.directory != '\0' && chdir(launch.directory) != 0) _exit(exit_not_started);
  bool limited = true;
  if (options.cpu_seconds > 0) {
    limited &= limit(RLIMIT_CPU, static_cast<rlim_t>(std::ceil(options.cpu_seconds)));
  }
  if (options.file_size > 0) limited &= limit(RLIMIT_FSIZE, options.file_size);
  if (options.memory > 0) limited &= limit(RLIMIT_CORE, 0);
#ifdef __linux__
  if (options.memory > 0) limited &= limit(RLIMIT_AS, options.memory);
#endif
  if (!limited) _exit(exit_not_started);
  signal(SIGPIPE, SIG_DFL);
  if (options.user != 0 &&
      (setgroups(0, nullptr) != 0 || setgid(options.user) != 0 || setuid(options.user) != 0)) {
    _exit(exit_not_started);
  }
#ifdef __linux__
  // Again, because the change of user resets it.
  if (prctl(PR_SET_PDEATHSIG, SIGKILL) != 0) _exit(exit_not_started);
#endif
  if (options.confinement != nullptr && !options.confinement->apply()) _exit(exit_not_started);
  execve(launch.path, launch.arguments, launch.environment);
  _exit(127);
}

/// Milliseconds until the deadline, rounded up; -1 for none.
int patience_of(const ProcessOptions& options, Clock::time_point start, bool killed) {
  int patience = -1;
  if (options.wall_seconds > 0 && !killed) {
    const double left =
        options.wall_seconds - std::chrono::duration<double>(Clock::now() - start).count();
    patience = std::max(0, static_cast<int>(left * 1000)) + 1;
  }
  if (options.stop != nullptr) patience = patience < 0 ? 200 : std::min(patience, 200);
  return patience;
}

/// An unnamed file in the working directory of a confined program.
Descriptor unnamed_file(const std::string& directory) {
  std::string name = directory + "/output-XXXXXX";
  const int raw = mkostemp(name.data(), O_CLOEXEC);
  Descriptor file(raw, "output");
  unlink(name.c_str());
  return file;
}

std::string text_in(const Descriptor& file, std::size_t most) {
  std::string text(most, '\0');
  std::size_t length = 0;
  while (length < most) {
    const ssize_t got =
        pread(file.get(), text.data() + length, most - length, static_cast<off_t>(length));
    if (got <= 0) break;
    length += static_cast<std::size_t>(got);
  }
  text.resize(length);
  return text;
}

/// The elapsed time of the program, and whether it must end now.
class Patience {
 public:
  explicit Patience(const ProcessOptions& options) : options_(options) {}

  /// Milliseconds to wait for the next event; -1: no limit.
  int milliseconds() const { return patience_of(options_, start_, killed_); }

  /// Kills the program's session when its time is up or a stop is requested.
  void enforce(pid_t pid, ProcessResult& result) {
    const bool late =
        options_.wall_seconds > 0 &&
        std::chrono::duration<double>(Clock::now() - start_).count() >= options_.wall_seconds;
    const bool stopped = options_.stop != nullptr && *options_.stop;
    if (killed_ || (!late && !stopped)) return;
    killed_ = true;
    result.out_of_time = late && !stopped;
    kill(-pid, SIGKILL);
    kill(pid, SIGKILL);  // in case it has no session yet
  }

 private:
  const ProcessOptions& options_;
  const Clock::time_point start_ = Clock::now();
  bool killed_ = false;
};

/// Reads both pipes to their end.
void read_pipes(pid_t pid, Pipe& output, Pipe& errors, const ProcessOptions& options,
                ProcessResult& result) {
  Patience patience(options);
  make_nonblocking(output.read);
  make_nonblocking(errors.read);
  Descriptor* const ends[] = {&output.read, &errors.read};
  std::string* const texts[] = {&result.output, &result.errors};
  while (*ends[0] || *ends[1]) {
    pollfd watched[] = {{ends[0]->get(), POLLIN, 0}, {ends[1]->get(), POLLIN, 0}};
    if (poll(watched, 2, patience.milliseconds()) < 0 && errno != EINTR) fail("poll");
    for (int i = 0; i < 2; ++i) {
      if (!*ends[i]) continue;
      std::string some;
      if (!read_available(*ends[i], some, std::size_t{1} << 16)) ends[i]->reset();
      if (texts[i]->size() < options.output) {
        texts[i]->append(some, 0, options.output - texts[i]->size());
      }
    }
    patience.enforce(pid, result);
  }
}

/// Waits for the end of a program whose output goes to files, without reaping it.
void wait_for_end(pid_t pid, const ProcessOptions& options, ProcessResult& result) {
  Patience patience(options);
#ifdef SYS_pidfd_open
  const int raw = static_cast<int>(syscall(SYS_pidfd_open, pid, 0));
  const Descriptor end = raw < 0 ? Descriptor() : Descriptor(raw, "pidfd");
#else
  const Descriptor end;
#endif
  for (;;) {
    siginfo_t ended{};
    if (waitid(P_PID, static_cast<id_t>(pid), &ended, WEXITED | WNOHANG | WNOWAIT) == 0 &&
        ended.si_pid == pid) {
      return;
    }
    pollfd watched{end.get(), POLLIN, 0};
    const int most = end ? 1000 : 2;
    const int left = patience.milliseconds();
    poll(&watched, 1, left < 0 ? most : std::min(left, most));
    patience.enforce(pid, result);
  }
}

}  // namespace

ProcessResult run_process(const std::vector<std::string>& command, const ProcessOptions& options) {
  auto words = command;
  auto variables = environment_with(options.environment);
  const auto arguments = pointers(words), environment = pointers(variables);
  const std::string directory = options.directory.string(), path = found_in_path(command[0]);

  const bool has_files = options.confinement != nullptr;
  Pipe output, errors;
  if (has_files) {
    output.write = unnamed_file(directory);
    errors.write = unnamed_file(directory);
  } else {
    output = make_pipe();
    errors = make_pipe();
  }
  const Descriptor nothing(open("/dev/null", O_RDONLY | O_CLOEXEC), "/dev/null");
  const Launch launch{path.c_str(),  arguments.data(),   environment.data(), directory.c_str(),
                      nothing.get(), output.write.get(), errors.write.get(), getpid()};
  const pid_t pid = fork();
  if (pid < 0) fail("fork");
  if (pid == 0) become(launch, options);
  const GroupGuard guard(pid);  // a compiler starts more programs

  ProcessResult result;
  if (has_files) {
    wait_for_end(pid, options, result);
    result.output = text_in(output.write, options.output);
    result.errors = text_in(errors.write, options.output);
  } else {
    output.write.reset();
    errors.write.reset();
    read_pipes(pid, output, errors, options, result);
  }
  int status = 0;
  rusage used{};
  while (wait4(pid, &status, 0, &used) < 0) {
    if (errno != EINTR) fail("wait4");
  }
  if (WIFEXITED(status)) result.exit_code = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) result.signal = WTERMSIG(status);
  if (result.exit_code == exit_not_started) {
    throw std::system_error(EAGAIN, std::generic_category(), "cannot start " + command[0]);
  }
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  result.cpu_seconds = seconds(used.ru_utime) + seconds(used.ru_stime);
  result.peak_memory = static_cast<std::size_t>(used.ru_maxrss) * rusage_memory_unit;
  result.written = static_cast<std::size_t>(used.ru_oublock) * 512;
  return result;
}

}  // namespace mc::sandbox
