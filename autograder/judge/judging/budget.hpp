#pragma once
// The total resources of one submission, so that a resource bomb cannot block grading.

#include <atomic>
#include <chrono>
#include <cstdint>
#include <string>

#include <fmt/format.h>

namespace mc::grader {

/// For all its labs, compilers and checks together. Right answers to all six labs take about 24 s.
constexpr double submission_cpu_seconds = 300;
/// Does not affect grades: a submission that reaches it was delayed by the machine.
constexpr double submission_wall_seconds = 3600;

class Budget {
 public:
  void use(double cpu_seconds) { used_ += static_cast<std::int64_t>(1e6 * cpu_seconds); }
  bool is_used_up() const { return 1e-6 * static_cast<double>(used_) >= submission_cpu_seconds; }
  static std::string why() {
    return fmt::format("the submission used up its {} s of CPU time", submission_cpu_seconds);
  }
  bool is_late() const {
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start_;
    return passed.count() >= submission_wall_seconds;
  }
  static std::string why_late() {
    return fmt::format("the machine is too busy: this submission could not be judged in {} s",
                       submission_wall_seconds);
  }

 private:
  std::atomic<std::int64_t> used_ = 0;  // microseconds
  const std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace mc::grader
