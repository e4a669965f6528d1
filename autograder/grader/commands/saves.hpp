#pragma once
// Notices that files were saved, however an editor saves them.

#include <filesystem>
#include <string>
#include <vector>

#include "sandbox/descriptor.hpp"

namespace mc::grader {

/// Some files, and how they were when one looked last. A save is a file with another time, size or
/// inode: so it makes no difference whether an editor writes into a file, replaces it, or removes
/// it and writes it anew.
class Saves {
 public:
  explicit Saves(std::vector<std::filesystem::path> files);

  /// Becomes readable when something happens near the files (inotify); -1 if the system does not
  /// report that. It only says to look now: looking every second misses nothing either.
  int hint() const { return notes_.get(); }

  /// Was a file saved, or did it vanish, since this was asked last?
  bool changed();

  /// The name of the first file that is not there now; empty where all are.
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
