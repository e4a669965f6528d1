#pragma once
// Confines a trusted program that reads untrusted text (a compiler): it may read and write what a
// list of places says, and nothing else.

#include <filesystem>
#include <vector>

#include "sandbox/descriptor.hpp"

namespace mc::sandbox {

/// What a program may use of the file system: places with everything below them. Places that do not
/// exist are left out. /dev/null is always one.
struct Places {
  std::vector<std::filesystem::path> readable;
  std::filesystem::path writable;  ///< a directory, also readable
};

/// Can this kernel enforce a list of places (Landlock, Linux 5.13)? If not, grades must say so.
bool places_are_enforced();

/// A Landlock ruleset that allows these places; none if places_are_enforced() is false. Created in
/// the parent, where allocating is safe.
Descriptor ruleset_for(const Places& places);

/// Confines this process for good, between fork and exec: async-signal-safe. False if the kernel
/// refuses what it claimed to support.
bool confine(const Descriptor& ruleset);

}  // namespace mc::sandbox
