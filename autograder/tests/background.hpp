#pragma once
// A program that runs while a test goes on.

#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <string>
#include <thread>
#include <vector>

#include "sandbox/descriptor.hpp"
#include "tests/submissions.hpp"

namespace mc::tests {

/// Long enough for any machine: stops a hanging test, and does not measure speed.
constexpr auto patience = std::chrono::minutes(2);

/// Ended with this object.
class BackgroundProcess {
 public:
  /// Its descriptors `from` are read by until(); write() reaches its descriptor `to`.
  explicit BackgroundProcess(Words command,
                             const std::vector<int>& from = {STDOUT_FILENO, STDERR_FILENO},
                             int to = STDIN_FILENO)
      : output_(sandbox::make_pipe()), input_(sandbox::make_pipe()) {
    pid_ = fork();
    if (pid_ == 0) {
      setenv("MC_NO_BUILD", "1", 1);
      for (const int number : from) dup2(output_.write.get(), number);
      dup2(input_.read.get(), to);
      std::vector<char*> words;
      for (std::string& word : command) words.push_back(word.data());
      words.push_back(nullptr);
      execvp(words[0], words.data());
      _exit(127);
    }
    output_.write.reset();
    input_.read.reset();
    sandbox::make_nonblocking(output_.read);
  }
  ~BackgroundProcess() {
    if (pid_ > 0) kill(pid_, SIGKILL);
    if (pid_ > 0) waitpid(pid_, nullptr, 0);
  }
  BackgroundProcess(const BackgroundProcess&) = delete;

  /// Reads until `text` arrives; returns all output so far. Fails if it never arrives.
  std::string until(const std::string& text) {
    const auto end = std::chrono::steady_clock::now() + patience;
    for (;;) {
      if (const auto at = unread_.find(text); at != std::string::npos) {
        std::string all = unread_.substr(0, at + text.size());
        unread_.erase(0, at + text.size());
        return all;
      }
      const bool is_open = sandbox::read_available(output_.read, unread_, std::size_t{1} << 22);
      if (!is_open || std::chrono::steady_clock::now() > end) {
        FAIL("no '" << text << "' in:\n" << unread_);
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
  }

  void write(const std::string& text) const {
    REQUIRE(::write(input_.write.get(), text.data(), text.size()) ==
            static_cast<ssize_t>(text.size()));
  }

  /// The exit status after an interrupt; -1 if a signal ended it.
  int interrupt() {
    kill(pid_, SIGINT);
    int status = 0;
    waitpid(pid_, &status, 0);
    pid_ = -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

  pid_t pid() const { return pid_; }

 private:
  sandbox::Pipe output_, input_;
  pid_t pid_ = -1;
  std::string unread_;
};

}  // namespace mc::tests
