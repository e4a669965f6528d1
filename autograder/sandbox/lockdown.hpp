#pragma once
// The part of the jail between fork and exec: the new process gives up its rights before any
// untrusted code runs in it.

#include <sys/types.h>

#include "sandbox/jail.hpp"

namespace mc::sandbox {

/// Descriptors of the child: these, in this order, and no others.
struct Ends {
  int request, printed, response;
};

/// Why a launch failed. Shared with the child until its exec, so that the program cannot fake a
/// failed launch afterwards.
struct LaunchFailure {
  volatile int error;           ///< errno; 0 unless something failed
  const char* volatile action;  ///< a string literal
};

/// Prepared once, in the parent, where allocating is safe.
void prepare_lockdown();

/// Runs in the child, which may share its memory with the parent until the exec (vfork): only
/// async-signal-safe calls, and no writes except to its own stack and `failure`. Drops all rights
/// and executes the open `program`; returns only if that failed, with the reason in `failure`.
void lock_down_and_exec(int program, const Ends& ends, const Limits& limits, pid_t parent,
                        LaunchFailure& failure);

/// The user `nobody`, which runs programs when the judge is root.
constexpr uid_t jailed_user = 65534;

}  // namespace mc::sandbox
