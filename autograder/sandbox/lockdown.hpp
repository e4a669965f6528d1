#pragma once
// The part of the jail between fork and exec: what the new process gives up before a line of
// foreign code runs in it.

#include <sys/types.h>

#include "sandbox/jail.hpp"

namespace mc::sandbox {

/// The program: an open descriptor, or its path where there is no execveat.
struct Executable {
  int descriptor;
  const char* path;
};

/// Descriptors of the child: these, in this order, and no others.
struct Ends {
  int request, printed, response;
};

/// Why a launch failed. Shared with the child until its exec, so that nothing the program does
/// afterwards can be taken for a failed launch.
struct LaunchFailure {
  volatile int error;           ///< errno; 0 as long as nothing failed
  const char* volatile action;  ///< a string literal
};

/// Made ready once, in the parent, where memory may still be allocated.
void prepare_lockdown();

/// In the child, which may have its memory in common with the parent until the exec (vfork): only
/// async-signal-safe calls, and nothing written but its own stack and `failure`. Gives everything
/// up and becomes the program; returns only if that failed, having said why in `failure`.
void lock_down_and_exec(const Executable& program, const Ends& ends, const Limits& limits,
                        pid_t parent, LaunchFailure& failure);

/// The user `nobody`, which runs programs when the judge is root.
constexpr uid_t jailed_user = 65534;

}  // namespace mc::sandbox
