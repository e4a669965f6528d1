#pragma once
// What a trusted program that reads untrusted text (a compiler) may do: write below one directory
// only, and use no network. It reads what it likes; the grader judges that afterwards.

#include <filesystem>

#include "sandbox/descriptor.hpp"

namespace mc::sandbox {

/// Made in the parent, where memory may be allocated; applied between fork and exec.
class Confinement {
 public:
  /// Files are created, written and removed below `writable` only, where the kernel has Landlock.
  explicit Confinement(const std::filesystem::path& writable);

  /// Async-signal-safe. False where the kernel refuses what it said it could do.
  bool apply() const;

 private:
  Descriptor ruleset_;  ///< none without Landlock
};

}  // namespace mc::sandbox
