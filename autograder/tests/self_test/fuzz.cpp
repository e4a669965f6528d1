// Programs that lie: the judge survives every answer.

#include <sys/stat.h>

#include <algorithm>
#include <chrono>

#include <fmt/format.h>

#include "grader/base/errors.hpp"
#include "grader/base/side_by_side.hpp"
#include "grader/base/text_file.hpp"
#include "grader/submission/scratch.hpp"
#include "tests/self_test/proof.hpp"

namespace mc::self_test {

namespace fs = std::filesystem;
using namespace grader;

namespace {

/// As in tests/fuzz/mutation.cpp: ten values, six sizes; `drawn` stands for a random one.
constexpr unsigned value_count = 10, size_count = 6;
constexpr unsigned char drawn = 255;

struct Plan {
  unsigned char value, size, few, honesty;
  std::string words() const { return fmt::format("plan {} {} {} {}", value, size, few, honesty); }
};

/// The lab's lying program with this plan.
sandbox::Program program_with(const Layout& layout, const Lab& lab, const Plan& plan,
                              const fs::path& place) {
  std::string bytes = read_text(layout.build / "bin" / ("fuzz_" + lab.name));
  const std::string mark = "mc-fuzz-plan-->>";
  const auto at = bytes.find(mark);
  if (at == std::string::npos) throw MachineError("fuzz_" + lab.name + " is not built");
  for (std::size_t i = 0; i < 4; ++i) {
    const unsigned char fields[] = {plan.value, plan.size, plan.few, plan.honesty};
    bytes[at + mark.size() + i] = static_cast<char>(fields[i]);
  }
  const fs::path path = place / plan.words();
  write_text(path, bytes);
  fs::permissions(path, fs::perms::all);
  return sandbox::open_program(path.string());
}

/// All values and sizes, for all numbers and for a few; then as many random ones.
std::vector<Plan> plans(unsigned count) {
  std::vector<Plan> all;
  for (unsigned i = 0; i < count; ++i) {
    if (i % 2 == 0) {
      all.push_back({drawn, drawn, static_cast<unsigned char>(i % 4 == 0 ? 0 : 7), 128});
      continue;
    }
    const unsigned k = i / 2;
    all.push_back({static_cast<unsigned char>(k % value_count),
                   static_cast<unsigned char>(k / value_count % size_count),
                   static_cast<unsigned char>(k / value_count / size_count % 2 == 0 ? 0 : 7), 0});
  }
  return all;
}

/// Lies with an answer that cannot be right, every time.
bool cannot_be_right(const Plan& plan) {
  const bool wrong_value = plan.few == 0 && (plan.value <= 2 || plan.value == 7);
  return plan.honesty == 0 && (wrong_value || (plan.size > 0 && plan.size < size_count));
}

}  // namespace

void prove_against_lies(const std::string& name, unsigned count) {
  constexpr unsigned all_plans = 2 * value_count * size_count * 2;
  if (number_from("MC_SEEDS", 0) >= 100) count = std::max(count, all_plans);  // --full
  Proof proof;
  proof.lab = find_lab(proof.labs, name);
  proof.submission.label = "solutions";
  const ScratchDirectory scratch(proof.layout);
  double slowest = 0;
  for (const Plan& plan : plans(count)) {
    BuildResult built;
    built.program = program_with(proof.layout, proof.lab, plan, scratch.path());
    proof.built = std::move(built);
    const LabVerdict verdict = proof.judge(1);
    for (const CheckResult& result : verdict.checks) {
      slowest = std::max(slowest, result.seconds);
      const bool has_fallen =
          result.status == Status::internal_error || result.status == Status::not_judged;
      if (has_fallen) {
        complain(
            fmt::format("{}: '{}' has fallen: {}", plan.words(), result.check.name, result.report));
      }
      if (result.status == Status::passed && result.check.is_main && cannot_be_right(plan)) {
        complain(fmt::format("{}: '{}' passed", plan.words(), result.check.name));
      }
    }
  }
  fmt::print("{} programs that lie about {}: the judge survived; the slowest check took {:.1f} s\n",
             count, name, slowest);
}

}  // namespace mc::self_test
