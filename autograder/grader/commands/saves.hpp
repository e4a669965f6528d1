#pragma once
// Detects saved files, for any way an editor saves them.

#include <filesystem>
#include <string>
#include <vector>

#include "sandbox/descriptor.hpp"

namespace mc::grader {

/// A set of files and their state at the last look. A save is a change of time, size or inode, so
/// editors may write into a file, replace it, or remove it and write it anew.
class Saves {
 public:
  explicit Saves(std::vector<std::filesystem::path> files);

  /// Becomes readable when something happens near the files (inotify); -1 if the system does not
  /// report that. It only says to look now: looking every second misses nothing either.
  int hint() const { return notes_.get(); }

  /// Has a file been saved or removed since the last call?
  bool changed();

  /// The name of the first missing file; empty if none is missing.
  std::string missing() const;

 private:
  struct State {
    std::filesystem::file_time_type time{};
    std::uintmax_t size = 0, inode = 0;
    bool is_there = false;
    bool operator==(const State&) const = default;
  };
  static State look_at(const std::filesystem::path& file);
  void listen();

  std::vector<std::filesystem::path> files_;
  std::vector<State> states_;
  sandbox::Descriptor notes_;
};

}  // namespace mc::grader
