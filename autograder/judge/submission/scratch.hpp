#pragma once
// Temporary directories, removed with their owner.

#include <filesystem>
#include <functional>
#include <set>

#include "judge/checkout/layout.hpp"

namespace mc::grader {

/// A fresh directory below build/tmp. Throws MachineError if it cannot be created.
class ScratchDirectory {
 public:
  explicit ScratchDirectory(const Layout& layout);
  ~ScratchDirectory();
  ScratchDirectory(const ScratchDirectory&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// Calls `write`. If it may not write, throws MachineError that names the owner of `place` (another
/// user, after a run as root) and the remedy; other exceptions pass.
void write_or_explain(const std::filesystem::path& place, const std::function<void()>& write);

/// Removes the least recently used programs until at most `most_bytes` are left, but none that a
/// build may be about to link, except those of files in `done_with`.
void sweep_programs(const Layout& layout, std::size_t most_bytes,
                    const std::set<std::filesystem::path>& done_with);

/// Removes what dead processes left in build/tmp.
void sweep_scratch(const Layout& layout);

}  // namespace mc::grader
