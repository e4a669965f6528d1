#pragma once

#include <filesystem>
#include <fstream>
#include <map>
#include <mutex>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "grader/base/text_file.hpp"
#include "grader/reports/progress_line.hpp"

namespace mc::grader {

/// The progress in expected seconds. Stores the duration of each job, so that the next estimate is
/// good.
class BenchProgress {
 public:
  explicit BenchProgress(std::filesystem::path memory)
      : memory_(std::move(memory)), line_("bench") {
    std::ifstream file(memory_);
    double seconds = 0;
    for (std::string name; file >> seconds && std::getline(file >> std::ws, name);) {
      seconds_[name] = seconds;
    }
  }
  ~BenchProgress() {
    std::string all;
    for (const auto& [name, seconds] : seconds_) all += fmt::format("{:.2f} {}\n", seconds, name);
    write_text(memory_, all);
  }
  BenchProgress(const BenchProgress&) = delete;

  void expect(const std::string& name, double workers = 1) {
    total_ += expected_.try_emplace(name, estimate(name)).first->second / workers;
  }
  void begin(const std::string& name) {
    const std::lock_guard lock(mutex_);
    line_.show(done_, total_, name);
  }
  void end(const std::string& name, double seconds, double workers = 1) {
    const std::lock_guard lock(mutex_);
    done_ += expected_[name] / workers;
    seconds_[name] = seconds;
  }
  double expected() const { return total_; }

 private:
  double estimate(const std::string& name) const {
    const auto found = seconds_.find(name);
    return found == seconds_.end() ? 6 : found->second;
  }

  std::filesystem::path memory_;
  std::map<std::string, double> seconds_, expected_;
  double total_ = 0, done_ = 0;
  std::mutex mutex_;
  ProgressLine line_;
};

}  // namespace mc::grader
