#pragma once
// Nothing outlives the judge: not even what the programs that it starts have started.

#include <sys/types.h>

namespace mc::sandbox {

/// Processes that this one starts lead groups of their own. A watchman, forked once, learns of each
/// group and kills those that are left when this process has died, however it died.
class GroupGuard {
 public:
  /// From now until its destruction the group of `leader` is guarded.
  explicit GroupGuard(pid_t leader);
  ~GroupGuard();
  GroupGuard(const GroupGuard&) = delete;

 private:
  pid_t leader_;
};

}  // namespace mc::sandbox
