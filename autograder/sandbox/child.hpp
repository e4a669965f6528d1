#pragma once
// Child processes: their end, what they used, and that none outlives the judge.

#include <sys/resource.h>
#include <sys/types.h>

#include <cstddef>

#include "sandbox/descriptor.hpp"

namespace mc::sandbox {

/// A descriptor that becomes readable when the process ends; none where the system has no pidfd.
Descriptor end_of(pid_t pid);

/// Kills a process that leads its session, with all that it started, or that is about to lead one.
void kill_group(pid_t leader);

double cpu_seconds_of(const rusage& used);
std::size_t peak_memory_of(const rusage& used);  ///< in bytes

/// Started processes lead their own groups. A watchman process, forked once, learns of each group
/// and kills those that remain when this process has ended in any way, with all grandchildren.
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
