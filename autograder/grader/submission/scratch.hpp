#pragma once
// Directories that go away with their owner.

#include <filesystem>

#include "grader/context/layout.hpp"

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

/// Removes what processes left in build/tmp that are no more.
void sweep_scratch(const Layout& layout);

}  // namespace mc::grader
