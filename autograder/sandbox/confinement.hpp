#pragma once
// Confines a trusted program that reads untrusted text (a compiler): it may write only below one
// directory, and not use the network. It may read anything; the grader checks that afterwards.

#include <filesystem>

#include "sandbox/descriptor.hpp"

namespace mc::sandbox {

/// A Landlock ruleset: files can be created, written and removed only below `writable`. None if the
/// kernel has no Landlock or it is disabled. Created in the parent, where allocating is safe.
Descriptor ruleset_for(const std::filesystem::path& writable);

/// Confines this process, between fork and exec: async-signal-safe. False if the kernel refuses
/// what it claimed to support.
bool confine(const Descriptor& ruleset);

}  // namespace mc::sandbox
