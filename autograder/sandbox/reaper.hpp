#pragma once
// Makes sure that no process outlives the judge, not even grandchildren.

#include <sys/types.h>

namespace mc::sandbox {

/// Started processes lead their own groups. A watchman process, forked once, learns of each group
/// and kills those that remain when this process has ended in any way.
class GroupGuard {
 public:
  /// Guards the group of `leader` until destruction.
  explicit GroupGuard(pid_t leader);
  ~GroupGuard();
  GroupGuard(const GroupGuard&) = delete;

 private:
  pid_t leader_;
};

}  // namespace mc::sandbox
