#pragma once
// The progress of a command, on standard error: at a terminal, one line that is rewritten and
// finally removed; elsewhere, a line every ten seconds.

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace mc::grader {

class ProgressLine {
 public:
  /// `what` is the current activity: "checking variance".
  explicit ProgressLine(std::string what);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;

  /// Reports the finished part of the work, in any unit: equal parts, or expected seconds. Changes
  /// the current activity unless `what` is empty.
  void show(double done, double all, const std::string& what = {});
  /// Removes the line so that something else can be printed; it comes back by itself.
  void clear();

 private:
  void tick();
  void print();

  using Clock = std::chrono::steady_clock;
  const Clock::time_point start_ = Clock::now();
  const bool interactive_;
  Clock::time_point next_;  ///< when it is printed next
  std::mutex mutex_;
  std::condition_variable ended_;
  bool end_ = false, is_shown_ = false;
  std::string what_;
  double done_ = 0, all_ = 0;
  std::thread ticker_;
};

}  // namespace mc::grader
