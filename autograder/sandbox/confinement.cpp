#include "sandbox/confinement.hpp"

#include <fcntl.h>
#include <linux/landlock.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>

namespace mc::sandbox {
namespace {

/// The version of Landlock; below 1 if the kernel has none, or if it is disabled.
long landlock_version() {
  return syscall(SYS_landlock_create_ruleset, nullptr, 0, LANDLOCK_CREATE_RULESET_VERSION);
}

constexpr std::uint64_t on_files =
    LANDLOCK_ACCESS_FS_EXECUTE | LANDLOCK_ACCESS_FS_WRITE_FILE | LANDLOCK_ACCESS_FS_READ_FILE;
constexpr std::uint64_t reading =
    LANDLOCK_ACCESS_FS_EXECUTE | LANDLOCK_ACCESS_FS_READ_FILE | LANDLOCK_ACCESS_FS_READ_DIR;

/// Every kind of access that this version can forbid: 13 in the first, then REFER, then TRUNCATE.
std::uint64_t all_access(long version) {
  return (std::uint64_t{1} << (version >= 3 ? 15 : version == 2 ? 14 : 13)) - 1;
}

}  // namespace

bool places_are_enforced() {
  static const bool are = landlock_version() >= 1;
  return are;
}

Descriptor ruleset_for(const Places& places) {
  if (!places_are_enforced()) return {};
  const std::uint64_t all = all_access(landlock_version());
  const landlock_ruleset_attr handled{.handled_access_fs = all};
  Descriptor ruleset(
      static_cast<int>(syscall(SYS_landlock_create_ruleset, &handled, sizeof handled, 0)),
      "landlock");
  const auto allow = [&](const std::filesystem::path& place, std::uint64_t access) {
    const int raw = open(place.c_str(), O_PATH | O_CLOEXEC);
    if (raw < 0 && (errno == ENOENT || errno == ENOTDIR || errno == EACCES)) return;
    const Descriptor opened(raw, place.native());
    struct stat status {};
    if (fstat(opened.get(), &status) != 0) fail(place.native());
    const landlock_path_beneath_attr rule{S_ISDIR(status.st_mode) ? access : access & on_files,
                                          opened.get()};
    if (syscall(SYS_landlock_add_rule, ruleset.get(), LANDLOCK_RULE_PATH_BENEATH, &rule, 0) != 0) {
      fail("landlock: " + place.native());
    }
  };
  for (const std::filesystem::path& place : places.readable) allow(place, reading);
  allow(places.writable, all & ~std::uint64_t{LANDLOCK_ACCESS_FS_EXECUTE});
  allow("/dev/null", LANDLOCK_ACCESS_FS_READ_FILE | LANDLOCK_ACCESS_FS_WRITE_FILE);
  return ruleset;
}

bool confine(const Descriptor& ruleset) {
  return prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
         (!ruleset || syscall(SYS_landlock_restrict_self, ruleset.get(), 0) == 0);
}

}  // namespace mc::sandbox
