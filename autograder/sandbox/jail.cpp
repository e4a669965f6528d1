#include "sandbox/jail.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstring>
#include <new>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "sandbox/child.hpp"
#include "sandbox/lockdown.hpp"
#include "sandbox/printable.hpp"

namespace mc::sandbox {
namespace {

using Clock = std::chrono::steady_clock;

/// A page that parent and child both see until the child's exec.
class SharedFailure {
 public:
  SharedFailure() {
    void* page = mmap(nullptr, sizeof(LaunchFailure), PROT_READ | PROT_WRITE,
                      MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (page == MAP_FAILED) fail("mmap");
    value_ = new (page) LaunchFailure{0, nullptr};
  }
  ~SharedFailure() { munmap(value_, sizeof(LaunchFailure)); }
  LaunchFailure& operator*() const { return *value_; }

 private:
  LaunchFailure* value_;
};

struct Start {
  int program;
  Ends ends;
  const Limits& limits;
  LaunchFailure& failure;
};

/// Starts a process that locks itself down and becomes the program. Returns its pid; -1 if there is
/// none. Without a copy of the parent's memory: after a fork, each page that the parent writes is a
/// fault, and one check starts dozens of programs. No signal handler of ours may run in the child.
[[gnu::noinline]] pid_t start(const Start& start) {
  const pid_t parent = getpid();
  sigset_t all, before;
  sigfillset(&all);
  sigprocmask(SIG_BLOCK, &all, &before);
  const pid_t pid = vfork();
  if (pid == 0) {
    lock_down_and_exec(start.program, start.ends, start.limits, parent, start.failure);
    _exit(127);
  }
  const int error = errno;
  sigprocmask(SIG_SETMASK, &before, nullptr);
  errno = error;
  return pid;
}

constexpr std::size_t most_of_response = sizeof(wire::Header) + wire::longest_result;

/// Everything that the parent receives from and does to one child.
struct Watch {
  pid_t pid;
  Descriptor request, printed, response;
  std::string printed_text{}, response_bytes{};
  bool out_of_time = false, gone = false;
  int status = 0;
  rusage used{};

  void kill_now() const {
    if (!gone) kill_group(pid);  // once it is reaped, the pid may be reused
  }

  /// Sends the request and reads the output until the child has ended and all output is read.
  void until_gone(std::string_view to_send, const Limits& limits);
};

void Watch::until_gone(std::string_view to_send, const Limits& limits) {
  const auto deadline = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                           std::chrono::duration<double>(limits.wall_seconds));
  const Descriptor end = end_of(pid);
  while (!gone || printed || response) {
    if (to_send.empty()) request.reset();
    pollfd watched[] = {{request.get(), POLLOUT, 0},
                        {printed.get(), POLLIN, 0},
                        {response.get(), POLLIN, 0},
                        {gone ? -1 : end.get(), POLLIN, 0}};
    const auto left =
        std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now()).count();
    if (left <= 0 && !gone && !out_of_time) {
      out_of_time = true;
      kill_now();
    }
    // Without a descriptor for the child's end, poll for it.
    const int patience = end ? std::clamp<int>(static_cast<int>(left), 1, 1000) : 2;
    poll(watched, 4, patience);

    if (watched[0].revents != 0) {
      const ssize_t sent = write(request.get(), to_send.data(), to_send.size());
      if (sent > 0) to_send.remove_prefix(static_cast<std::size_t>(sent));
      if (sent < 0 && errno != EAGAIN && errno != EINTR) to_send = {};  // it does not read
    }
    const auto receive = [&](Descriptor& from, std::string& to, std::size_t limit) {
      if (from && !read_available(from, to, limit)) from.reset();
      if (to.size() <= limit) return;
      from.reset();
      kill_now();
    };
    receive(printed, printed_text, limits.printed);
    receive(response, response_bytes, most_of_response);
    if (!gone && wait4(pid, &status, WNOHANG, &used) == pid) gone = true;
  }
}

constexpr std::pair<int, const char*> crashes[] = {
    {SIGSEGV,
     "crashed: segmentation fault (outside an array, or out of stack by endless recursion?)"},
    {SIGBUS, "crashed: bus error"},
    {SIGFPE, "crashed: an integer divided by zero"},
    {SIGILL, "crashed: illegal instruction (a function that ends without returning its value?)"},
    {SIGABRT,
     "crashed: aborted (a failed assertion, a corrupted heap, or an exception in a noexcept)"},
    {SIGSYS,
     "made a system call a lab never needs (open a file, start a process, use the network)"},
    {SIGKILL, "was killed (by the machine: out of memory?)"},
};

std::string crash(int signal) {
  for (const auto& [one, text] : crashes) {
    if (one == signal) return text;
  }
  return fmt::format("crashed: signal {} ({})", signal, strsignal(signal));
}

/// Parses the response. False if it is malformed.
bool read_response(std::string_view bytes, Outcome& outcome) {
  wire::Header header;
  if (bytes.size() < sizeof header) return false;
  std::memcpy(&header, bytes.data(), sizeof header);
  bytes.remove_prefix(sizeof header);
  if (header.magic != wire::magic || header.reserved != 0 || header.length != bytes.size() ||
      header.status > wire::Status::other_exception) {
    return false;
  }
  outcome.answered = true;
  outcome.status = header.status;
  outcome.bytes = std::string(bytes);
  if (header.status != wire::Status::value) outcome.bytes = exception_text(bytes);
  return true;
}

Outcome interpret(const Watch& child, const Limits& limits) {
  Outcome outcome;
  outcome.printed = printable(child.printed_text.substr(0, limits.printed));
  outcome.cpu_seconds = cpu_seconds_of(child.used);
  outcome.peak_memory = peak_memory_of(child.used);

  // Which limit a runaway program reaches first depends on the machine; the report must not.
  const auto over_limit = [&] {
    const std::string low = lowered_limit(limits.cpu_seconds, limits.memory, 0);
    if (!low.empty()) throw std::system_error(EPERM, std::generic_category(), low);
    outcome.answered = false;
    outcome.failure = fmt::format("did not end within {} s of CPU time and {} MB of memory",
                                  limits.cpu_seconds, limits.memory >> 20);
    outcome.end = End::over_limit;
  };
  const bool signaled = WIFSIGNALED(child.status);
  const int signal = signaled ? WTERMSIG(child.status) : 0;
  if (child.printed_text.size() > limits.printed) {
    outcome.failure = fmt::format("printed more than {} KB", limits.printed >> 10);
  } else if (child.response_bytes.size() > most_of_response) {
    outcome.failure = fmt::format("sent a result of more than {} MB", wire::longest_result >> 20);
  } else if (signal == SIGXCPU || outcome.cpu_seconds > std::ceil(limits.cpu_seconds)) {
    // Also if it caught the signal and exited by itself in the second before SIGKILL.
    over_limit();
  } else if (child.out_of_time && jail_is_complete()) {
    // A jailed program can wait for nothing but the processor.
    throw std::system_error(ETIMEDOUT, std::generic_category(),
                            fmt::format("the machine is too busy: {:.1f} s of CPU time in {} s",
                                        outcome.cpu_seconds, limits.wall_seconds));
  } else if (child.out_of_time) {
    over_limit();
  } else if (signaled) {
    outcome.failure = crash(signal);
    outcome.end = signal == SIGSYS ? End::other : End::crashed;
  } else if (const int code = WEXITSTATUS(child.status); child.response_bytes.empty()) {
    outcome.failure = fmt::format("called exit({}) instead of returning", code);
  } else if (code != 0 || !read_response(child.response_bytes, outcome)) {
    outcome.failure = "sent something that is not a result";
  } else if (outcome.status == wire::Status::other_exception && outcome.bytes == "std::bad_alloc") {
    over_limit();
  }
  return outcome;
}

}  // namespace

std::string exception_text(std::string_view text) {
  constexpr std::size_t longest = 200;
  return printable_line(shortened(text, longest));
}

Program open_program(const std::string& path) {
  return {Descriptor(open(path.c_str(), O_PATH | O_CLOEXEC), path), path};
}

Outcome run_jailed(const Program& program, std::string_view request, const Limits& limits) {
  return run_jailed(program.descriptor.get(), program.path, request, limits);
}

Outcome run_jailed(int descriptor, const std::string& path, std::string_view request,
                   const Limits& limits) {
  static const bool prepared = [] {
    prepare_lockdown();
    std::signal(SIGPIPE, SIG_IGN);  // a program may exit without reading its request
    return true;
  }();
  (void)prepared;

  SharedFailure launch;
  Pipe to_child = make_pipe(), printed = make_pipe(), response = make_pipe();
  for (const Descriptor* ours : {&to_child.write, &printed.read, &response.read}) {
    make_nonblocking(*ours);
  }
  const pid_t pid = start({descriptor,
                           {to_child.read.get(), printed.write.get(), response.write.get()},
                           limits,
                           *launch});
  if (pid < 0) fail("fork");
  for (Descriptor* its : {&to_child.read, &printed.write, &response.write}) its->reset();

  Watch child{pid, std::move(to_child.write), std::move(printed.read), std::move(response.read)};
  child.until_gone(request, limits);
  if ((*launch).error != 0) {
    throw std::system_error((*launch).error, std::generic_category(),
                            fmt::format("starting {}: {}", path, (*launch).action));
  }
  return interpret(child, limits);
}

}  // namespace mc::sandbox
