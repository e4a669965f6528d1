#include "sandbox/process.hpp"

#include <fcntl.h>
#include <grp.h>
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
#include <sstream>
#include <system_error>

#ifdef __linux__
#include <sys/prctl.h>
#endif

#include "sandbox/child.hpp"
#include "sandbox/confinement.hpp"
#include "sandbox/descriptor.hpp"

extern char** environ;

namespace mc::sandbox {
namespace {

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
  if (options.confined && !confine(launch.ruleset)) _exit(exit_not_started);
  execve(launch.path, launch.arguments, launch.environment);
  _exit(127);
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

/// How long the program may still run.
class Patience {
 public:
  explicit Patience(const ProcessOptions& options) : options_(options) {}

  /// Milliseconds to wait for the next event, at most `most`.
  int milliseconds(double most) const {
    if (options_.stop != nullptr) most = std::min(most, 200.0);
    if (options_.wall_seconds > 0 && !killed_) most = std::min(most, 1000 * seconds_left() + 1);
    return std::max(1, static_cast<int>(most));
  }

  /// Kills the program's session when its time is up or a stop is requested.
  void enforce(pid_t pid, ProcessResult& result) {
    const bool late = options_.wall_seconds > 0 && seconds_left() <= 0;
    const bool stopped = options_.stop != nullptr && *options_.stop;
    if (killed_ || (!late && !stopped)) return;
    killed_ = true;
    result.out_of_time = late && !stopped;
    kill_group(pid);
  }

 private:
  double seconds_left() const {
    return options_.wall_seconds -
           std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

  const ProcessOptions& options_;
  const std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
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
    constexpr double day = 86'400'000;
    if (poll(watched, 2, patience.milliseconds(day)) < 0 && errno != EINTR) fail("poll");
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
  const Descriptor end = end_of(pid);
  for (;;) {
    siginfo_t ended{};
    if (waitid(P_PID, static_cast<id_t>(pid), &ended, WEXITED | WNOHANG | WNOWAIT) == 0 &&
        ended.si_pid == pid) {
      return;
    }
    pollfd watched{end.get(), POLLIN, 0};
    poll(&watched, 1, patience.milliseconds(end ? 1000 : 2));
    patience.enforce(pid, result);
  }
}

}  // namespace

std::string found_in_path(const std::string& name) {
  if (name.find('/') != std::string::npos) return name;
  const char* const path = std::getenv("PATH");
  std::istringstream places(path == nullptr ? "/usr/bin:/bin" : path);
  for (std::string place; std::getline(places, place, ':');) {
    std::string file = place + '/' + name;
    if (file[0] == '/' && access(file.c_str(), X_OK) == 0) return file;
  }
  return name;
}

ProcessResult run_process(const std::vector<std::string>& command, const ProcessOptions& options) {
  auto words = command;
  auto variables = environment_with(options.environment);
  const auto arguments = pointers(words), environment = pointers(variables);
  const std::string directory = options.directory.string(), path = found_in_path(command[0]);

  Descriptor ruleset;
  Pipe output, errors;
  if (options.confined) {
    ruleset = ruleset_for(options.directory);
    output.write = unnamed_file(directory);
    errors.write = unnamed_file(directory);
  } else {
    output = make_pipe();
    errors = make_pipe();
  }
  const Descriptor nothing(open("/dev/null", O_RDONLY | O_CLOEXEC), "/dev/null");
  const Launch launch{path.c_str(),       arguments.data(), environment.data(),
                      directory.c_str(),  nothing.get(),    output.write.get(),
                      errors.write.get(), getpid(),         ruleset};
  const pid_t pid = fork();
  if (pid < 0) fail("fork");
  if (pid == 0) become(launch, options);
  const GroupGuard guard(pid);  // a compiler starts more programs

  ProcessResult result;
  if (options.confined) {
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
  result.cpu_seconds = cpu_seconds_of(used);
  result.peak_memory = peak_memory_of(used);
  result.written = static_cast<std::size_t>(used.ru_oublock) * 512;
  return result;
}

}  // namespace mc::sandbox
