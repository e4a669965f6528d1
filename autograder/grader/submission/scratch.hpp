#pragma once
// Directories that go away with their owner.

#include <filesystem>
#include <set>

#include "grader/checkout/layout.hpp"

namespace mc::grader {

/// A fresh directory below build/tmp. Throws MachineError where none can be made.
class ScratchDirectory {
 public:
  explicit ScratchDirectory(const Layout& layout);
  ~ScratchDirectory();
  ScratchDirectory(const ScratchDirectory&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// Removes the programs that were not used for longest until `most_bytes` are left, but none that a
/// build may be about to link, except of files in `done_with`.
void sweep_programs(const Layout& layout, std::size_t most_bytes,
                    const std::set<std::filesystem::path>& done_with);

/// Removes what processes left in build/tmp that are no more.
void sweep_scratch(const Layout& layout);

}  // namespace mc::grader
