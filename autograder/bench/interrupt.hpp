#pragma once
// Ctrl-C ends the measuring, and what was measured is still written.

#include <atomic>
#include <csignal>

namespace mc::grader {

inline std::atomic<bool> is_interrupted{false};

/// During its lifetime, an interrupt sets `is_interrupted`; a second one ends the program.
class StopOnInterrupt {
 public:
  StopOnInterrupt() {
    struct sigaction action {};
    action.sa_handler = [](int) { is_interrupted = true; };
    action.sa_flags = static_cast<int>(SA_RESETHAND);
    sigaction(SIGINT, &action, &before_);
    sigaction(SIGTERM, &action, nullptr);
  }
  ~StopOnInterrupt() { sigaction(SIGINT, &before_, nullptr); }
  StopOnInterrupt(const StopOnInterrupt&) = delete;

 private:
  struct sigaction before_ {};
};

}  // namespace mc::grader
