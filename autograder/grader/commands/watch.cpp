#include "grader/commands/watch.hpp"

#include <poll.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <sstream>
#include <system_error>
#include <thread>
#include <utility>

#include "sandbox/descriptor.hpp"
#include "sandbox/process.hpp"

namespace mc::grader {
namespace {

/// Tells the programs that `watch` starts the width of the terminal, and whether it has colors:
/// "100", or "100c".
constexpr const char* terminal_variable = "MC_WATCHED";

/// The writing end of a pipe that is polled for signals and for the end of a run.
int wake_up = -1;
std::atomic<bool> interrupted{false};

void on_signal(int) {
  const int before = errno;
  interrupted = true;
  (void)!write(wake_up, "", 1);
  errno = before;
}

/// From here on, an interrupt ends the watching cleanly.
void catch_signals() {
  struct sigaction action {};
  action.sa_handler = on_signal;
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) sigaction(signal, &action, nullptr);
}

std::string clock_time() {
  const std::time_t now = std::time(nullptr);
  char text[sizeof "00:00:00"];
  std::strftime(text, sizeof text, "%H:%M:%S", std::localtime(&now));
  return text;
}

/// Files and their state at the last look. A save is a change of time, size or inode, so editors
/// may write into a file, replace it, or remove it and write it anew.
class WatchedFiles {
 public:
  explicit WatchedFiles(const std::vector<fs::path>& files) : files_(files) { changed(); }

  /// Has a file been saved or removed since the last call?
  bool changed() {
    std::vector<State> now;
    for (const fs::path& file : files_) now.push_back(state_of(file));
    return std::exchange(states_, now) != now;
  }
  /// The name of the first missing file; empty if none is missing.
  std::string missing() const {
    const auto found = std::ranges::find(states_, State{});
    if (found == states_.end()) return {};
    return files_[static_cast<std::size_t>(found - states_.begin())].filename().string();
  }

 private:
  struct State {
    fs::file_time_type time{};
    off_t size = 0;
    ino_t inode = 0;
    bool operator==(const State&) const = default;
  };
  static State state_of(const fs::path& file) {
    struct stat found {};
    std::error_code vanished;
    const auto time = fs::last_write_time(file, vanished);
    if (vanished || stat(file.c_str(), &found) != 0 || !S_ISREG(found.st_mode)) return {};
    return {time, found.st_size, found.st_ino};
  }

  const std::vector<fs::path>& files_;
  std::vector<State> states_;
};

/// One run of the judge, concurrent with the watching.
class Run {
 public:
  Run(const std::vector<std::string>& command, const std::string& terminal)
      : thread_([this, command, terminal] {
          try {
            result_ = sandbox::run_process(
                command, {.environment = {{terminal_variable, terminal}}, .stop = &stop_});
          } catch (const std::system_error& error) {  // no process or descriptor is left
            result_.errors = fmt::format("lab: {}\n", error.what());
          }
          has_ended_ = true;
          (void)!write(wake_up, "", 1);
        }) {}
  ~Run() {
    stop_ = true;
    thread_.join();
  }
  Run(const Run&) = delete;

  bool has_ended() const { return has_ended_; }
  /// Call after it has ended.
  std::string text() const {
    const bool is_verdict = result_.exit_code == 0 || result_.exit_code == 1;
    return result_.output + (is_verdict ? std::string() : result_.errors);
  }

 private:
  std::atomic<bool> stop_{false}, has_ended_{false};
  sandbox::ProcessResult result_;
  std::thread thread_;
};

/// Shows verdicts: on one screen of a terminal, or one after the other.
class Screen {
 public:
  Screen() : terminal_(this_terminal()) {}

  std::string terminal() const {
    return fmt::format("{}{}", terminal_.width, terminal_.color ? "c" : "");
  }
  /// Adds a line below the verdict that is still shown.
  void say(const std::string& line) const {
    if (terminal_.interactive) {
      fmt::print("\r\x1b[K{}", line);
    } else {
      fmt::print("{}\n", line);
    }
    std::fflush(stdout);
  }
  void show(const std::string& text) const {
    if (terminal_.interactive) {
      fmt::print("\x1b[H\x1b[2J{}", first_rows(text, rows() - 1, columns()));
      say(fmt::format("judged {}; Ctrl-C ends", clock_time()));
    } else {
      fmt::print("{}", text);
      say(fmt::format("judged {}", clock_time()));
    }
  }
  void end() const {
    if (terminal_.interactive) fmt::print("\n");
  }

 private:
  static winsize size() {
    winsize found{};
    if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &found) != 0) found = {};
    return found;
  }
  static std::size_t rows() { return std::max<std::size_t>(size().ws_row, 10); }
  static std::size_t columns() { return std::max<std::size_t>(size().ws_col, 40); }
  Terminal terminal_;
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

/// Waits until a signal arrives, a run ends, or the time is over.
void wait_for_wake_up(int wakes, int milliseconds) {
  pollfd watched{wakes, POLLIN, 0};
  poll(&watched, 1, milliseconds);
  char some[64];
  while (read(wakes, some, sizeof some) > 0) {
  }
}

}  // namespace

int watch(const Context& context, const std::vector<std::string>& words,
          const std::vector<fs::path>& files) {
  sandbox::Pipe wakes = sandbox::make_pipe();
  sandbox::make_nonblocking(wakes.read);
  sandbox::make_nonblocking(wakes.write);
  wake_up = wakes.write.get();
  catch_signals();
  std::vector<std::string> command{(context.layout.bin / "lab").string()};
  command.insert(command.end(), words.begin(), words.end());

  const Screen screen;
  WatchedFiles watched(files);
  std::optional<Run> run;
  bool is_unjudged = true;  // the present text
  std::string reported;     // the missing file
  while (!interrupted) {
    if (watched.changed()) {
      if (run) screen.say("saved again: judging starts over");
      run.reset();
      is_unjudged = true;
      // An editor may save in several steps: start after a moment without changes.
      wait_for_wake_up(wakes.read.get(), 50);
      continue;
    }
    const std::string missing = watched.missing();
    if (is_unjudged && missing.empty()) {
      screen.say(fmt::format("judging {}", files[0].filename().string()));
      run.emplace(command, screen.terminal());
      is_unjudged = false;
    } else if (is_unjudged && missing != reported) {
      screen.say(fmt::format("{} does not exist: waiting for it", missing));
    }
    reported = missing;
    wait_for_wake_up(wakes.read.get(), 100);
    if (run && run->has_ended() && !interrupted) {
      screen.show(run->text());
      run.reset();
    }
  }
  run.reset();
  screen.end();
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
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  std::size_t all_rows = 0;
  for (const std::string& line : lines) all_rows += rows_of(line, columns);
  if (all_rows <= rows) return text;
  std::string shown;
  std::size_t used = 0, count = 0;
  for (; count < lines.size(); ++count) {
    const std::size_t takes = rows_of(lines[count], columns);
    if (used + takes >= rows) break;
    used += takes;
    shown += lines[count] + '\n';
  }
  return shown + fmt::format("… {} more lines\n", lines.size() - count);
}

}  // namespace mc::grader
