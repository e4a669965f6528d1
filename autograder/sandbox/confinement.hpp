#pragma once
// Confines a trusted program that reads untrusted text (a compiler): it may write only below one
// directory, and not use the network. It may read anything; the grader checks that afterwards.

#include <filesystem>

#include "sandbox/descriptor.hpp"

namespace mc::sandbox {

/// Created in the parent, where allocating is safe; applied between fork and exec.
class Confinement {
 public:
  /// Files can be created, written and removed only below `writable`, if the kernel has Landlock.
  explicit Confinement(const std::filesystem::path& writable);

  /// Async-signal-safe. False if the kernel refuses what it claimed to support.
  bool apply() const;

 private:
  Descriptor ruleset_;  ///< none without Landlock
};

}  // namespace mc::sandbox
