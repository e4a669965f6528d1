// The same verdict on a busy machine as on an idle one.

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fmt/format.h>

#include "grader/judging/verdict.hpp"
#include "tests/self_test/proof.hpp"

namespace mc::self_test {

namespace fs = std::filesystem;
using grader::CheckResult;
using grader::LabVerdict;

namespace {

/// So many processes that do nothing but compute, until it is gone.
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

bool meets_a_limit(const LabVerdict& verdict) {
  for (const CheckResult& result : verdict.checks) {
    if (result.status == grader::Status::not_run) return true;
    for (const char* words : {"stopped after", "wanted more than", "already timed out"}) {
      if (result.story.find(words) != std::string::npos) return true;
    }
  }
  return false;
}

/// Every check with its status and its points.
std::string fate_of(const LabVerdict& verdict) {
  std::string all;
  for (const CheckResult& result : verdict.checks) {
    all += fmt::format("{}: {}, {:g}\n", result.check.name, describe(result, verdict),
                       result.earned());
  }
  return all;
}

}  // namespace

void prove_under_load(const std::vector<fs::path>& files, unsigned runs) {
  std::size_t judged = 0;
  for (const fs::path& file : files) {
    const Proof proof = proof_of(fs::canonical(file));
    if (!proof.built.program) continue;
    const LabVerdict idle = proof.judge(1);
    if (!meets_a_limit(idle)) continue;
    const std::string fate = fate_of(idle);
    const BusyLoops loops(4);
    for (const unsigned workers : {1u, 2u, 4u}) {
      for (unsigned run = 0; run < runs; ++run, ++judged) {
        const std::string busy = fate_of(proof.judge(1, {}, workers));
        if (busy == fate) continue;
        complain(fmt::format("{}, with {} workers beside four busy loops:\n{}instead of\n{}",
                             proof.submission.label, workers, busy, fate));
        return;
      }
    }
    fmt::print("{}: the same verdict\n", proof.submission.label);
    std::fflush(stdout);
  }
  fmt::print("{} verdicts beside four busy loops, each the same as on an idle machine\n", judged);
}

}  // namespace mc::self_test
