#include "sandbox/confinement.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <iterator>

#ifdef __linux__
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#if __has_include(<linux/landlock.h>) && defined(SYS_landlock_create_ruleset)
#include <linux/landlock.h>
#define MC_HAVE_LANDLOCK 1
#endif
#endif

namespace mc::sandbox {
namespace {

#ifdef MC_HAVE_LANDLOCK

/// Every change to a file system that this kernel can forbid (landlock(7)).
std::uint64_t forbidden_writes(long abi) {
  std::uint64_t all = LANDLOCK_ACCESS_FS_WRITE_FILE | LANDLOCK_ACCESS_FS_REMOVE_DIR |
                      LANDLOCK_ACCESS_FS_REMOVE_FILE | LANDLOCK_ACCESS_FS_MAKE_CHAR |
                      LANDLOCK_ACCESS_FS_MAKE_DIR | LANDLOCK_ACCESS_FS_MAKE_REG |
                      LANDLOCK_ACCESS_FS_MAKE_SOCK | LANDLOCK_ACCESS_FS_MAKE_FIFO |
                      LANDLOCK_ACCESS_FS_MAKE_BLOCK | LANDLOCK_ACCESS_FS_MAKE_SYM;
#ifdef LANDLOCK_ACCESS_FS_REFER
  if (abi >= 2) all |= LANDLOCK_ACCESS_FS_REFER;
#endif
#ifdef LANDLOCK_ACCESS_FS_TRUNCATE
  if (abi >= 3) all |= LANDLOCK_ACCESS_FS_TRUNCATE;
#endif
  (void)abi;
  return all;
}

#endif

}  // namespace

Descriptor ruleset_for([[maybe_unused]] const std::filesystem::path& writable) {
#ifdef MC_HAVE_LANDLOCK
  const long abi =
      syscall(SYS_landlock_create_ruleset, nullptr, 0, LANDLOCK_CREATE_RULESET_VERSION);
  if (abi < 1) return {};
  landlock_ruleset_attr handled{};
  handled.handled_access_fs = forbidden_writes(abi);
  const long raw = syscall(SYS_landlock_create_ruleset, &handled, sizeof handled, 0);
  if (raw < 0) return {};
  Descriptor ruleset(static_cast<int>(raw), "landlock");
  const auto allow = [&](const char* place, std::uint64_t access) {
    const Descriptor parent(open(place, O_PATH | O_CLOEXEC), place);
    const landlock_path_beneath_attr rule{access, parent.get()};
    if (syscall(SYS_landlock_add_rule, ruleset.get(), LANDLOCK_RULE_PATH_BENEATH, &rule, 0) != 0) {
      fail("landlock");
    }
  };
  allow(writable.c_str(), handled.handled_access_fs);
  allow("/dev/null", LANDLOCK_ACCESS_FS_WRITE_FILE);
  return ruleset;
#else
  return {};
#endif
}

bool confine([[maybe_unused]] const Descriptor& ruleset) {
#ifdef __linux__
  if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) return false;
#ifdef MC_HAVE_LANDLOCK
  if (ruleset && syscall(SYS_landlock_restrict_self, ruleset.get(), 0) != 0) return false;
#endif
  // socket() fails with EACCES. If a container allows no filter, compilers run without one: they do
  // not use the network, and run no untrusted code.
  constexpr auto call = static_cast<std::uint32_t>(SYS_socket);
  sock_filter rules[] = {
      BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr)),
      BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, call, 0, 1),
      BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | (EACCES & SECCOMP_RET_DATA)),
      BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW),
  };
  const sock_fprog filter{static_cast<unsigned short>(std::size(rules)), rules};
  prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &filter);
#endif
  return true;
}

}  // namespace mc::sandbox
