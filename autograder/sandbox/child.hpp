#pragma once
// Child processes: their end, their limits, what they used.

#include <sys/resource.h>
#include <sys/types.h>

#include <cstddef>
#include <string>

#include "sandbox/descriptor.hpp"

namespace mc::sandbox {

/// A descriptor that becomes readable when the process ends; none where the system has no pidfd.
Descriptor end_of(pid_t pid);

/// Kills a process that leads its session, with all that it started, or that is about to lead one.
void kill_group(pid_t leader);

double cpu_seconds_of(const rusage& used);
std::size_t peak_memory_of(const rusage& used);  ///< in bytes

/// Lowers a limit for good; a lower hard limit stays. Async-signal-safe.
bool limit(decltype(RLIMIT_CPU) resource, rlim_t soft, rlim_t hard);

/// The first limit of this process (`ulimit -H`) that is below what a child needs, as a sentence
/// with the remedy; empty if there is none. What a child exceeds is then not its fault.
std::string lowered_limit(double cpu_seconds, std::size_t memory, std::size_t file_size);

/// May this process become that user? Only root may, and only in a user namespace that has the
/// user.
bool may_become(uid_t user);

}  // namespace mc::sandbox
