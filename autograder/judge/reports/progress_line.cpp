#include "judge/reports/progress_line.hpp"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "judge/reports/report.hpp"
#include "sandbox/printable.hpp"

namespace mc::grader {
namespace {

using namespace std::chrono_literals;

std::string rounded(double seconds) {
  return seconds < 90     ? fmt::format("{:.0f} s", 10 * std::round(seconds / 10))
         : seconds < 5400 ? fmt::format("{:.0f} min", seconds / 60)
                          : fmt::format("{:.1f} h", seconds / 3600);
}

}  // namespace

ProgressLine::ProgressLine(std::string what)
    : interactive_(is_interactive(STDERR_FILENO)),
      next_(start_ + (interactive_ ? 500ms : 10s)),
      what_(std::move(what)) {
  try {
    ticker_ = std::thread([this] { tick(); });
  } catch (const std::system_error&) {  // no more threads: show no progress
  }
}

ProgressLine::~ProgressLine() {
  {
    const std::lock_guard lock(mutex_);
    end_ = true;
  }
  ended_.notify_all();
  if (ticker_.joinable()) ticker_.join();
  clear();
}

void ProgressLine::show(double done, double all, const std::string& what) {
  const std::lock_guard lock(mutex_);
  done_ = done;
  all_ = all;
  if (!what.empty()) what_ = what;
}

void ProgressLine::clear() {
  const std::lock_guard lock(mutex_);
  if (is_shown_) fmt::print(stderr, "\r\x1b[K");
  is_shown_ = false;
}

void ProgressLine::tick() {
  std::unique_lock lock(mutex_);
  while (!ended_.wait_until(lock, next_, [this] { return end_; })) {
    print();
    next_ = Clock::now() + (interactive_ ? 250ms : 10s);
  }
}

void ProgressLine::print() {
  const double passed = std::chrono::duration<double>(Clock::now() - start_).count();
  std::string line = what_;
  if (all_ > 0) line = fmt::format("{:.0f} of {:.0f}  {}", done_, all_, what_);
  line += fmt::format(", {:.0f} s", passed);
  // Steps take different times: an early estimate would be far off, and one of seconds is useless.
  const double left = done_ > 0 ? passed * (all_ - done_) / done_ : 0;
  if (done_ >= all_ / 4 && left >= 10) line += fmt::format(", about {} left", rounded(left));
  if (!interactive_) {
    fmt::print(stderr, "{}\n", line);
    return;
  }
  const std::size_t columns = window_columns(STDERR_FILENO), width = columns > 0 ? columns : 80;
  constexpr std::size_t ellipsis = 2;  // columns of " …"
  const std::size_t most = width - std::min(width, ellipsis + 1);
  fmt::print(stderr, "\r\x1b[K{}", line.size() < width ? line : sandbox::shortened(line, most));
  is_shown_ = true;
}

}  // namespace mc::grader
