#include "grader/jail.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/syscall.h>
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

#include "grader/lockdown.hpp"

namespace mc::grader {
namespace {

using Clock = std::chrono::steady_clock;

[[noreturn]] void fail(const char* action) {
  throw std::system_error(errno, std::generic_category(), action);
}

/// The few below are given to a child, by number: none of the judge's own may be among them.
constexpr int lowest_own_descriptor = 16;

/// A descriptor that closes itself.
class Descriptor {
 public:
  explicit Descriptor(int raw = -1) {
    if (raw < 0) return;
    value_ = fcntl(raw, F_DUPFD_CLOEXEC, lowest_own_descriptor);
    close(raw);
    if (value_ < 0) fail("dup");
  }
  Descriptor(Descriptor&& other) noexcept : value_(std::exchange(other.value_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(value_, other.value_);
    return *this;
  }
  ~Descriptor() { reset(); }
  void reset() {
    if (value_ >= 0) close(std::exchange(value_, -1));
  }
  int get() const { return value_; }

 private:
  int value_ = -1;
};

struct Pipe {
  Descriptor read, write;
};

Pipe make_pipe() {
  int ends[2];
  if (pipe(ends) != 0) fail("pipe");
  return {Descriptor(ends[0]), Descriptor(ends[1])};
}

void make_nonblocking(const Descriptor& descriptor) {
  fcntl(descriptor.get(), F_SETFL, fcntl(descriptor.get(), F_GETFL) | O_NONBLOCK);
}

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

/// Appends what can be read now. False at the end of the stream.
bool drain(const Descriptor& from, std::string& to, std::size_t most) {
  char buffer[1 << 16];
  while (to.size() <= most) {
    const ssize_t got = read(from.get(), buffer, sizeof buffer);
    if (got > 0) {
      to.append(buffer, static_cast<std::size_t>(got));
    } else if (got == 0) {
      return false;
    } else if (errno != EINTR) {
      return true;  // nothing more for now
    }
  }
  return true;
}

/// Everything the parent hears and sees of one child.
struct Watch {
  pid_t pid;
  Descriptor request, printed, response;
  std::string printed_text{}, response_bytes{};
  bool out_of_time = false, printed_too_much = false, answered_too_much = false;
  int status = 0;
  rusage used{};

  void kill_now() const {
    kill(-pid, SIGKILL);  // its session, once it has one
    kill(pid, SIGKILL);
  }

  /// Feeds, drains and waits until the child is gone and everything it said is here.
  void until_gone(std::string_view to_send, const Limits& limits);
};

void Watch::until_gone(std::string_view to_send, const Limits& limits) {
  const auto deadline = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                           std::chrono::duration<double>(limits.wall_seconds));
#ifdef SYS_pidfd_open
  const Descriptor end(static_cast<int>(syscall(SYS_pidfd_open, pid, 0)));
#else
  const Descriptor end;
#endif
  constexpr std::size_t most = sizeof(wire::Header) + wire::longest_result;
  bool gone = false;
  while (!gone || printed.get() >= 0 || response.get() >= 0) {
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
    // Without a descriptor for the child's end, look for it now and then.
    const int patience = end.get() >= 0 ? std::clamp<int>(static_cast<int>(left), 1, 1000) : 2;
    poll(watched, 4, patience);

    if (watched[0].revents != 0) {
      const ssize_t sent = write(request.get(), to_send.data(), to_send.size());
      if (sent > 0) to_send.remove_prefix(static_cast<std::size_t>(sent));
      if (sent < 0 && errno != EAGAIN && errno != EINTR) to_send = {};  // it does not listen
    }
    if (printed.get() >= 0 && !drain(printed, printed_text, limits.printed)) printed.reset();
    if (response.get() >= 0 && !drain(response, response_bytes, most)) response.reset();
    if (printed_text.size() > limits.printed) {
      printed_too_much = true;
      printed.reset();
      kill_now();
    }
    if (response_bytes.size() > most) {
      answered_too_much = true;
      response.reset();
      kill_now();
    }
    if (!gone && wait4(pid, &status, WNOHANG, &used) == pid) gone = true;
  }
}

std::string crash(int signal) {
  switch (signal) {
    case SIGSEGV:
      return "crashed: segmentation fault (outside an array, or out of stack by endless "
             "recursion?)";
    case SIGBUS:
      return "crashed: bus error";
    case SIGFPE:
      return "crashed: an integer divided by zero";
    case SIGILL:
      return "crashed: illegal instruction (a function that ends without returning its value?)";
    case SIGABRT:
      return "crashed: aborted (a failed assertion, a corrupted heap, or an exception in a "
             "noexcept)";
    case SIGSYS:
      return "made a system call a lab never needs (open a file, start a process, use the network)";
    case SIGKILL:
      return "was killed (by the machine: out of memory?)";
    default:
      return fmt::format("crashed: signal {} ({})", signal, strsignal(signal));
  }
}

/// Takes the response apart. False if it is none.
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
  if (header.status != wire::Status::value) {
    // One line of a story: 16 MB of it would drown the check's report, lines could pass for ours.
    constexpr std::size_t longest_text = 200;
    outcome.bytes = printable(shortened(bytes, longest_text));
    std::replace_if(
        outcome.bytes.begin(), outcome.bytes.end(), [](char c) { return c == '\n' || c == '\t'; },
        ' ');
  }
  return true;
}

Outcome interpret(const Watch& child, const Limits& limits) {
  Outcome outcome;
  outcome.printed = printable(child.printed_text.substr(0, limits.printed));
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  outcome.cpu_seconds = seconds(child.used.ru_utime) + seconds(child.used.ru_stime);
#ifdef __APPLE__
  constexpr std::size_t unit = 1;
#else
  constexpr std::size_t unit = 1024;
#endif
  outcome.peak_memory = static_cast<std::size_t>(child.used.ru_maxrss) * unit;

  const std::string too_much_memory =
      fmt::format("wanted more than {} MB of memory", limits.memory >> 20);
  const bool signaled = WIFSIGNALED(child.status);
  const int signal = signaled ? WTERMSIG(child.status) : 0;
  if (child.printed_too_much) {
    outcome.failure = fmt::format("printed more than {} KB", limits.printed >> 10);
  } else if (child.answered_too_much) {
    outcome.failure = fmt::format("sent a result of more than {} MB", wire::longest_result >> 20);
  } else if (signal == SIGXCPU || outcome.cpu_seconds > std::ceil(limits.cpu_seconds)) {
    // Also where it caught the signal and came to an end by itself in the second until SIGKILL.
    outcome.failure = fmt::format("stopped after {} s of CPU time", limits.cpu_seconds);
    outcome.timed_out = true;
  } else if (child.out_of_time) {
    outcome.failure = fmt::format("stopped after {} s", limits.wall_seconds);
    outcome.timed_out = true;
  } else if (signaled) {
    outcome.failure = crash(signal);
  } else if (const int code = WEXITSTATUS(child.status); child.response_bytes.empty()) {
    outcome.failure = fmt::format("called exit({}) instead of returning", code);
  } else if (code != 0 || !read_response(child.response_bytes, outcome)) {
    outcome.failure = "sent something that is not a result";
  } else if (outcome.status == wire::Status::other_exception && outcome.bytes == "std::bad_alloc") {
    outcome.answered = false;
    outcome.failure = too_much_memory;
  }
  return outcome;
}

}  // namespace

Program open_program(const std::string& path) {
#ifdef O_PATH
  const int low = open(path.c_str(), O_PATH | O_CLOEXEC);
#else
  const int low = open(path.c_str(), O_RDONLY | O_CLOEXEC);
#endif
  if (low < 0) throw std::system_error(errno, std::generic_category(), path);
  const int descriptor = fcntl(low, F_DUPFD_CLOEXEC, lowest_own_descriptor);
  close(low);
  if (descriptor < 0) throw std::system_error(errno, std::generic_category(), path);
  return {descriptor, path};
}

Outcome run_jailed(const Program& program, std::string_view request, const Limits& limits) {
  static const bool prepared = [] {
    prepare_lockdown();
    std::signal(SIGPIPE, SIG_IGN);  // a program that does not read its request is no reason to die
    return true;
  }();
  (void)prepared;

  SharedFailure launch;
  Pipe asked = make_pipe(), said = make_pipe(), answered = make_pipe();
  const pid_t parent = getpid();
  const pid_t pid = fork();
  if (pid < 0) fail("fork");
  if (pid == 0) {
    lock_down_and_exec(program, {asked.read.get(), said.write.get(), answered.write.get()}, limits,
                       parent, *launch);
    _exit(127);
  }
  asked.read.reset();
  said.write.reset();
  answered.write.reset();
  make_nonblocking(asked.write);
  make_nonblocking(said.read);
  make_nonblocking(answered.read);

  Watch child{pid, std::move(asked.write), std::move(said.read), std::move(answered.read)};
  child.until_gone(request, limits);
  if ((*launch).error != 0) {
    throw std::system_error((*launch).error, std::generic_category(),
                            fmt::format("starting {}: {}", program.path, (*launch).action));
  }
  return interpret(child, limits);
}

std::string printable(std::string_view text) {
  std::string clean;
  clean.reserve(text.size());
  for (std::size_t i = 0; i < text.size();) {
    const auto byte = static_cast<unsigned char>(text[i]);
    // How long a UTF-8 sequence claims to be here, and the smallest code point of that length.
    const std::size_t length = byte < 0x80       ? 1
                               : byte >> 5 == 6  ? 2
                               : byte >> 4 == 14 ? 3
                               : byte >> 3 == 30 ? 4
                                                 : 0;
    std::uint32_t point = length == 1 ? byte : length == 0 ? 0 : byte & (0x7fu >> length);
    bool whole = length > 0 && i + length <= text.size();
    for (std::size_t j = 1; whole && j < length; ++j) {
      const auto next = static_cast<unsigned char>(text[i + j]);
      whole = next >> 6 == 2;
      point = point << 6 | (next & 0x3fu);
    }
    constexpr std::uint32_t smallest[] = {0, 0, 0x80, 0x800, 0x10000};
    const bool turns = (point >= 0x2028 && point <= 0x202e) || (point >= 0x2066 && point <= 0x2069);
    const bool allowed =
        whole && point >= smallest[length] && point <= 0x10ffff &&
        !(point >= 0xd800 && point <= 0xdfff) && (point & 0xfffe) != 0xfffe && !turns &&
        (point >= 0xa0 || (point >= 0x20 && point < 0x7f) || point == '\n' || point == '\t');
    if (allowed) {
      clean.append(text.substr(i, length));
      i += length;
    } else {
      clean += '?';
      ++i;
    }
  }
  return clean;
}

std::string shortened(std::string_view text, std::size_t most) {
  if (text.size() <= most) return std::string(text);
  while (most > 0 && (static_cast<unsigned char>(text[most]) & 0xc0) == 0x80) --most;
  return std::string(text.substr(0, most)) + " …";
}

}  // namespace mc::grader
