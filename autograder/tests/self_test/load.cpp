// The same verdict on a busy machine as on an idle one.

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>

#include <fmt/format.h>

#include "judge/judging/verdict.hpp"
#include "tests/self_test/proof.hpp"

namespace mc::self_test {

namespace {

/// This many processes in a busy loop, for the lifetime of the object.
class BusyLoops {
 public:
  explicit BusyLoops(int count) {
    for (int i = 0; i < count; ++i) {
      const pid_t pid = fork();
      if (pid == 0) {
        volatile unsigned long x = 0;
        for (;;) x = x + 1;
      }
      if (pid > 0) loops_.push_back(pid);
    }
  }
  ~BusyLoops() {
    for (const pid_t pid : loops_) {
      kill(pid, SIGKILL);
      waitpid(pid, nullptr, 0);
    }
  }
  BusyLoops(const BusyLoops&) = delete;

 private:
  std::vector<pid_t> loops_;
};

/// Every check with its status and its points.
std::string fate_of(const LabVerdict& verdict) {
  std::string all;
  for (const CheckResult& result : verdict.checks) {
    all += fmt::format("{}: {}, {:g}\n", result.check.name, describe(result, verdict),
                       result.earned());
  }
  return all;
}

/// Did a measurement run out of time or of memory?
bool meets_a_limit(const LabVerdict& verdict) {
  if (!verdict.no_program.empty()) return false;  // the compiler's limits do not count
  for (const CheckResult& result : verdict.checks) {
    if (result.status != Status::failed) continue;  // waiting does not depend on limits
    if (result.report.find("did not end within") != std::string::npos) return true;
  }
  return false;
}

}  // namespace

void compare_limits(const Subject& subject, const LabVerdict& verdict) {
  const bool meets = meets_a_limit(verdict), says = !said(subject, "limit").empty();
  if (meets && !says) complain("it meets a limit of time or memory: the file must say 'limit:'");
  if (says && !meets) complain("the file says 'limit:', and no measurement met one");
}

void prove_under_load(std::vector<fs::path> files, unsigned runs) {
  const bool all = files.empty();
  if (all) {
    for (const auto& entry : fs::recursive_directory_iterator(read_layout().submissions())) {
      if (entry.path().extension() == ".cpp") files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
  }
  std::vector<Subject> subjects;
  for (const fs::path& file : files) {
    for (const Subject& subject : subjects_in(fs::canonical(file))) {
      if (!all || !said(subject, "limit").empty()) subjects.push_back(subject);
    }
  }
  std::size_t judged = 0;
  for (const Subject& subject : subjects) {
    const Proof proof = proof_of(subject);
    if (!proof.built.program) continue;
    const LabVerdict idle = proof.judge(1);
    const std::string fate = fate_of(idle);
    const BusyLoops loops(4);
    for (const unsigned workers : {1u, 2u, 4u}) {
      for (unsigned run = 0; run < runs; ++run, ++judged) {
        const std::string busy = fate_of(proof.judge(1, {}, workers));
        if (busy == fate) continue;
        complain(fmt::format("{}, with {} workers next to four busy loops:\n{}instead of\n{}",
                             proof.submission.label, workers, busy, fate));
        return;
      }
    }
    fmt::print("{}: the same verdict\n", proof.submission.label);
    std::fflush(stdout);
  }
  fmt::print("{} verdicts next to four busy loops, each the same as on an idle machine\n", judged);
}

}  // namespace mc::self_test
