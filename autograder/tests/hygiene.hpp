#pragma once
// Few descriptors, many signals: adverse conditions that last as long as an object.

#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/time.h>

#include <atomic>
#include <cstddef>

namespace mc::tests {

/// The number of descriptors that this process has open.
inline std::size_t open_descriptors() {
  std::size_t count = 0;
  for (int i = 0; i < 1024; ++i) count += fcntl(i, F_GETFD) >= 0;
  return count;
}

/// `ulimit -n most` for the lifetime of the object, also for processes started meanwhile.
class FewDescriptors {
 public:
  explicit FewDescriptors(std::size_t most) {
    getrlimit(RLIMIT_NOFILE, &before_);
    const rlimit few{most, before_.rlim_max};
    setrlimit(RLIMIT_NOFILE, &few);
  }
  ~FewDescriptors() { setrlimit(RLIMIT_NOFILE, &before_); }
  FewDescriptors(const FewDescriptors&) = delete;

 private:
  rlimit before_{};
};

/// A signal every millisecond, whose handler interrupts system calls.
class SignalTimer {
 public:
  SignalTimer() {
    count = 0;
    struct sigaction action {};
    action.sa_handler = [](int) { ++count; };
    sigaction(SIGALRM, &action, &before_);
    const itimerval often{{0, 1000}, {0, 1000}};
    setitimer(ITIMER_REAL, &often, nullptr);
  }
  ~SignalTimer() {
    const itimerval never{};
    setitimer(ITIMER_REAL, &never, nullptr);
    sigaction(SIGALRM, &before_, nullptr);
  }
  SignalTimer(const SignalTimer&) = delete;
  int times() const { return count; }

 private:
  static inline std::atomic<int> count = 0;
  struct sigaction before_ {};
};

}  // namespace mc::tests
