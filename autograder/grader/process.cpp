#include "grader/process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <system_error>

#ifdef __linux__
#include <sys/prctl.h>
#endif

extern char** environ;

namespace mc::grader {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int above_all_targets = 64;

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

void limit(decltype(RLIMIT_CPU) resource, rlim_t value) {
  if (value == 0) return;
  const rlimit both{value, value};
  setrlimit(resource, &both);
}

/// In the child, between fork and exec: async-signal-safe calls only.
[[noreturn]] void become(char* const* command, char* const* environment,
                         const ProcessOptions& options, int input, int output, int errors,
                         const char* directory, pid_t parent) {
  // In a session of its own: it is killed with whatever it has started, and never reads a terminal.
  setsid();
#ifdef __linux__
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(127);
#else
  (void)parent;
#endif
  dup2(input, 0);
  dup2(output, 1);
  dup2(errors, 2);
  // By way of high numbers, so that no target lies on another one's source.
  int high[8];
  std::size_t count = 0;
  for (const auto& pair : options.descriptors) {
    high[count++] = fcntl(pair.first, F_DUPFD_CLOEXEC, above_all_targets);
  }
  count = 0;
  for (const auto& pair : options.descriptors) dup2(high[count++], pair.second);
  if (*directory != '\0' && chdir(directory) != 0) _exit(127);
  limit(RLIMIT_CPU, static_cast<rlim_t>(std::ceil(options.cpu_seconds)));
  limit(RLIMIT_FSIZE, options.file_size);
#ifdef __linux__
  limit(RLIMIT_AS, options.memory);
#endif
  if (options.memory != 0) {
    const rlimit none{0, 0};
    setrlimit(RLIMIT_CORE, &none);
  }
  signal(SIGPIPE, SIG_DFL);
  environ = const_cast<char**>(environment);
  execvp(command[0], command);
  _exit(127);
}

}  // namespace

std::pair<int, int> make_pipe() {
  int ends[2];
  if (pipe(ends) != 0) throw std::system_error(errno, std::generic_category(), "pipe");
  for (const int end : ends) fcntl(end, F_SETFD, FD_CLOEXEC);
  return {ends[0], ends[1]};
}

ProcessResult run_process(const std::vector<std::string>& command, const ProcessOptions& options) {
  auto words = command;
  auto variables = environment_with(options.environment);
  const auto arguments = pointers(words), environment = pointers(variables);
  const std::string directory = options.directory.string();

  const auto output = make_pipe(), errors = make_pipe();
  const int nothing = open("/dev/null", O_RDONLY | O_CLOEXEC);
  const pid_t parent = getpid();
  const pid_t pid = fork();
  if (pid < 0) throw std::system_error(errno, std::generic_category(), "fork");
  if (pid == 0) {
    become(arguments.data(), environment.data(), options, nothing, output.second, errors.second,
           directory.c_str(), parent);
  }
  close(nothing);
  close(output.second);
  close(errors.second);

  ProcessResult result;
  const auto start = Clock::now();
  pollfd watched[] = {{output.first, POLLIN, 0}, {errors.first, POLLIN, 0}};
  std::string* const texts[] = {&result.output, &result.errors};
  while (watched[0].fd >= 0 || watched[1].fd >= 0) {
    int patience = -1;
    if (options.wall_seconds > 0 && !result.out_of_time) {
      const double left =
          options.wall_seconds - std::chrono::duration<double>(Clock::now() - start).count();
      if (left <= 0) {
        result.out_of_time = true;
        kill(-pid, SIGKILL);
      }
      patience = left <= 0 ? -1 : static_cast<int>(left * 1000) + 1;
    }
    if (options.stop != nullptr) {
      if (*options.stop) kill(-pid, SIGKILL);
      patience = patience < 0 ? 200 : std::min(patience, 200);
    }
    if (poll(watched, 2, patience) < 0 && errno != EINTR) break;
    for (int i = 0; i < 2; ++i) {
      if (watched[i].fd < 0 || watched[i].revents == 0) continue;
      char buffer[1 << 14];
      const ssize_t got = read(watched[i].fd, buffer, sizeof buffer);
      if (got > 0) {
        if (texts[i]->size() < options.output) texts[i]->append(buffer, static_cast<size_t>(got));
      } else if (got == 0 || errno != EINTR) {
        close(watched[i].fd);
        watched[i].fd = -1;
      }
    }
  }
  int status = 0;
  rusage used{};
  while (wait4(pid, &status, 0, &used) < 0 && errno == EINTR) {
  }
  if (WIFEXITED(status)) result.exit_code = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) result.signal = WTERMSIG(status);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  result.cpu_seconds = seconds(used.ru_utime) + seconds(used.ru_stime);
  result.peak_memory = static_cast<std::size_t>(used.ru_maxrss) * 1024;
  return result;
}

}  // namespace mc::grader
