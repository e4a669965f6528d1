#include "commands/watch.hpp"

#include <sys/ioctl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <sstream>
#include <system_error>
#include <thread>
#include <utility>

#include "commands/progress.hpp"
#include "sandbox/process.hpp"

namespace mc::grader {
namespace {

using namespace std::chrono_literals;

/// Tells the programs that `watch` starts the width of the terminal, and whether it has colors:
/// "100", or "100c".
constexpr const char* terminal_variable = "MC_WATCHED";

std::atomic<bool> is_interrupted{false};

std::string clock_time() {
  const std::time_t now = std::time(nullptr);
  char text[sizeof "00:00:00"];
  std::strftime(text, sizeof text, "%H:%M:%S", std::localtime(&now));
  return text;
}

/// A save is a change of time, size or inode, so editors may write into a file, replace it, or
/// remove it and write it anew. A missing file is all zeros.
struct FileState {
  fs::file_time_type time{};
  off_t size = 0;
  ino_t inode = 0;
  bool operator==(const FileState&) const = default;
};

std::vector<FileState> states_of(const std::vector<fs::path>& files) {
  std::vector<FileState> states;
  for (const fs::path& file : files) {
    FileState& state = states.emplace_back();
    struct stat found {};
    std::error_code vanished;
    const auto time = fs::last_write_time(file, vanished);
    if (vanished || stat(file.c_str(), &found) != 0 || !S_ISREG(found.st_mode)) continue;
    state = {time, found.st_size, found.st_ino};
  }
  return states;
}

/// A job, concurrent with the watching; ended with this object.
class Run {
 public:
  explicit Run(Job job) {
    thread_ = std::thread([this, job = std::move(job)] {
      try {
        text_ = job(stop_);
      } catch (const std::exception& error) {  // the machine lacks something
        text_ = fmt::format("lab: {}\n", error.what());
      }
      has_ended_ = true;
    });
  }
  ~Run() {
    stop_ = true;
    thread_.join();
  }
  Run(const Run&) = delete;

  bool has_ended() const { return has_ended_; }
  /// Call after it has ended.
  const std::string& text() const { return text_; }

 private:
  std::atomic<bool> stop_{false}, has_ended_{false};
  std::string text_;
  std::thread thread_;
};

/// Shows verdicts: on one screen of a terminal, or one after the other.
class Screen {
 public:
  /// Adds a line below the verdict that is still shown.
  void say(const std::string& line) const {
    fmt::print("{}", terminal.interactive ? "\r\x1b[K" + line : line + '\n');
    std::fflush(stdout);
  }
  void show(const std::string& text, const std::string& done) const {
    if (!terminal.interactive) {
      fmt::print("{}", text);
      return say(fmt::format("{} {}", done, clock_time()));
    }
    winsize size{};
    if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0) size = {};
    fmt::print("\x1b[H\x1b[2J{}", first_rows(text, std::max<std::size_t>(size.ws_row, 10) - 1,
                                             std::max<std::size_t>(size.ws_col, 40)));
    say(fmt::format("{} {}; Ctrl-C ends", done, clock_time()));
  }

  const Terminal terminal = this_terminal();
};

/// The number of rows that a line takes in a window; color codes take no space.
std::size_t rows_of(std::string_view line, std::size_t columns) {
  std::string shown;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '\x1b') {
      i = std::min(line.find('m', i), line.size());
    } else {
      shown += line[i];
    }
  }
  return std::max<std::size_t>(1, (columns_of(shown) + columns - 1) / columns);
}

}  // namespace

Job job_of(std::vector<std::string> command) {
  const Terminal terminal = this_terminal();
  sandbox::ProcessOptions options;
  options.environment = {
      {terminal_variable, fmt::format("{}{}", terminal.width, terminal.color ? "c" : "")}};
  if (std::getenv("MC_NO_BUILD") != nullptr) options.environment.push_back({"MC_NO_BUILD", "1"});
  return [command = std::move(command), options](const std::atomic<bool>& stop) mutable {
    options.stop = &stop;
    const auto result = sandbox::run_process(command, options);
    const bool is_verdict = result.exit_code == 0 || result.exit_code == 1;
    return result.output + (is_verdict ? std::string() : result.errors);
  };
}

int watch(const WatchedWork& work) {
  struct sigaction action {};
  action.sa_handler = [](int) { is_interrupted = true; };
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) sigaction(signal, &action, nullptr);

  const Screen screen;
  auto states = states_of(work.files);
  std::vector<Job> jobs = work.jobs();  // still to be done
  std::optional<Run> run;
  bool is_waiting = false;  // for a missing file
  for (; !is_interrupted; std::this_thread::sleep_for(50ms)) {
    if (auto now = states_of(work.files); now != states) {
      // An editor may save in several steps: look again after a moment.
      if (run) screen.say(fmt::format("saved again: {} starts over", work.doing));
      run.reset();
      states = std::move(now);
      jobs = work.jobs();
      is_waiting = false;
      continue;
    }
    if (run && run->has_ended()) {
      screen.show(run->text(), work.done);
      run.reset();
    }
    if (run || jobs.empty()) continue;
    const auto missing = std::ranges::find(states, FileState{});
    if (missing == states.end()) {
      screen.say(fmt::format("{} {}", work.doing, work.subject));
      run.emplace(std::move(jobs.front()));
      jobs.erase(jobs.begin());
    } else if (!std::exchange(is_waiting, true)) {
      const auto at = static_cast<std::size_t>(missing - states.begin());
      screen.say(
          fmt::format("{} does not exist: waiting for it", work.files[at].filename().string()));
    }
  }
  run.reset();
  if (screen.terminal.interactive) fmt::print("\n");
  return 0;
}

std::optional<Terminal> watching_terminal() {
  const char* value = std::getenv(terminal_variable);
  if (value == nullptr) return {};
  Terminal terminal;
  char* end = nullptr;
  terminal.width = std::clamp<std::size_t>(std::strtoul(value, &end, 10), 40, 100);
  terminal.color = *end == 'c';
  return terminal;
}

std::string report_open_first(const LabVerdict& lab, const Verdict& verdict,
                              const Terminal& terminal) {
  const auto is_open = [](const CheckResult& result) { return result.is_open(); };
  LabVerdict sorted = lab;
  const auto open = std::ranges::find_if(lab.checks, is_open);
  if (open != lab.checks.end()) {
    std::stable_partition(sorted.checks.begin(), sorted.checks.end(), [&](const CheckResult& one) {
      return one.check.task == open->check.task;
    });
  }
  std::string all;
  if (lab.no_program.empty() && verdict.not_judged.empty()) {
    all = fmt::format(
        "{:g} of {:g} points; {}\n", lab.earned(), lab.points(),
        open == lab.checks.end() ? "nothing is open" : "first open: " + open->check.task);
  }
  return all + report_lab(sorted, verdict, terminal);
}

std::string first_rows(const std::string& text, std::size_t rows, std::size_t columns) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  std::size_t all_rows = 0;
  for (std::string line; std::getline(stream, line);) {
    all_rows += rows_of(line, columns);
    lines.push_back(line);
  }
  if (all_rows <= rows) return text;
  std::string shown;
  std::size_t used = 0, count = 0;
  for (; count < lines.size(); ++count) {
    used += rows_of(lines[count], columns);
    if (used >= rows) break;
    shown += lines[count] + '\n';
  }
  return shown + fmt::format("… {} more lines\n", lines.size() - count);
}

}  // namespace mc::grader
