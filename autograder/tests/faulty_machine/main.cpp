// Runs a command on a machine that lacks something:
//   faulty_machine [--disk FROM TO KB] [--descriptors N] [--processes UID N] [--refuse CALL]...
//                  COMMAND...
// Exit status 77 if this machine does not allow that.
#include <sched.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

#ifdef MC_HAVE_SECCOMP
#include <seccomp.h>
#endif

namespace {

constexpr int not_possible = 77;

void demand(bool done, const char* what) {
  if (done) return;
  std::fprintf(stderr, "%s: %s\n", what, std::strerror(errno));
  std::exit(not_possible);
}

struct Disk {
  const char *from, *to, *kilobytes;
};
/// A small disk at `to` with the content of `from`, visible to this process only and removed with
/// it.
void mount_disk(const Disk& disk) {
  demand(unshare(CLONE_NEWNS) == 0, "unshare");
  demand(mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) == 0, "mount /");
  const std::string size = std::string("size=") + disk.kilobytes + "k";
  demand(mount("none", disk.to, "tmpfs", 0, size.c_str()) == 0, "mount");
  const pid_t copier = fork();
  if (copier == 0) {
    execlp("cp", "cp", "-a", (std::string(disk.from) + "/.").c_str(), disk.to, nullptr);
    _exit(1);
  }
  int status = 1;
  demand(waitpid(copier, &status, 0) == copier && status == 0, "cp");
}

void limit(decltype(RLIMIT_NPROC) what, const char* most) {
  const rlim_t value = std::strtoul(most, nullptr, 10);
  const rlimit both{value, value};
  demand(setrlimit(what, &both) == 0, "setrlimit");
}

#ifdef MC_HAVE_SECCOMP
void refuse(scmp_filter_ctx filter, const std::string& call) {
  int error = 0;
  if (call == "seccomp") {
    error = seccomp_rule_add(filter, SCMP_ACT_ERRNO(EINVAL), SCMP_SYS(seccomp), 0);
    constexpr unsigned set_seccomp = 22;  // PR_SET_SECCOMP
    error |= seccomp_rule_add(filter, SCMP_ACT_ERRNO(EINVAL), SCMP_SYS(prctl), 1,
                              scmp_arg_cmp{0, SCMP_CMP_EQ, set_seccomp, 0});
  } else {
    const int number = seccomp_syscall_resolve_name(call.c_str());
    error = seccomp_rule_add(filter, SCMP_ACT_ERRNO(EPERM), number, 0);
  }
  errno = -error;
  demand(error == 0, "seccomp_rule_add");
}
#endif

}  // namespace

int main(int, char** words) {
  ++words;
#ifdef MC_HAVE_SECCOMP
  const scmp_filter_ctx filter = seccomp_init(SCMP_ACT_ALLOW);
  bool refuses = false;
#endif
  for (;;) {
    const std::string option = *words == nullptr ? "" : *words;
    if (option == "--disk") {
      mount_disk({.from = words[1], .to = words[2], .kilobytes = words[3]});
      words += 4;
    } else if (option == "--descriptors") {
      limit(RLIMIT_NOFILE, words[1]);
      words += 2;
    } else if (option == "--processes") {
      const auto user = static_cast<uid_t>(std::strtoul(words[1], nullptr, 10));
      limit(RLIMIT_NPROC, words[2]);
      demand(setgid(user) == 0 && setuid(user) == 0, "setuid");
      words += 3;
#ifdef MC_HAVE_SECCOMP
    } else if (option == "--refuse") {
      refuse(filter, words[1]);
      refuses = true;
      words += 2;
#endif
    } else {
      break;
    }
  }
#ifdef MC_HAVE_SECCOMP
  errno = refuses ? -seccomp_load(filter) : 0;
  demand(errno == 0, "seccomp_load");
#endif
  execv(words[0], words);
  std::perror(words[0]);
  return not_possible;
}
