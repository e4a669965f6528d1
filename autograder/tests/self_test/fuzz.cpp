// Programs that lie: the judge survives every answer.

#include <algorithm>
#include <cstring>

#include <fmt/format.h>

#include "judge/base/errors.hpp"
#include "judge/base/text_file.hpp"
#include "judge/submission/scratch.hpp"
#include "tests/fuzz/plan.hpp"
#include "tests/self_test/proof.hpp"

namespace mc::self_test {

namespace {

using fuzz::Plan;

constexpr std::uint8_t drawn = 255;  ///< an index beyond all values and sizes

std::string words_of(const Plan& plan) {
  return fmt::format("plan {} {} {} {}", plan.value, plan.size, plan.few, plan.honesty);
}

/// The lab's lying program with this plan.
sandbox::Program program_with(const Layout& layout, const Lab& lab, const Plan& plan,
                              const fs::path& place) {
  std::string bytes = read_text(layout.build / "bin" / ("fuzz_" + lab.name));
  const auto at = bytes.find(plan.mark);
  if (at == std::string::npos) throw MachineError("fuzz_" + lab.name + " is not built");
  std::memcpy(bytes.data() + at, &plan, sizeof plan);
  const fs::path path = place / words_of(plan);
  write_text(path, bytes);
  fs::permissions(path, fs::perms::all);
  return sandbox::open_program(path.string());
}

/// All values and sizes, for all numbers and for a few; then as many random ones.
std::vector<Plan> plans(unsigned count) {
  std::vector<Plan> all(count);
  for (unsigned i = 0; i < count; ++i) {
    const unsigned k = i / 2, sizes = k / fuzz::value_count;
    const bool is_random = i % 2 == 0;
    const bool lies_often = is_random ? i % 4 == 0 : sizes / fuzz::size_count % 2 == 0;
    all[i].value = is_random ? drawn : static_cast<std::uint8_t>(k % fuzz::value_count);
    all[i].size = is_random ? drawn : static_cast<std::uint8_t>(sizes % fuzz::size_count);
    all[i].few = lies_often ? 0 : 7;
    all[i].honesty = is_random ? 128 : 0;
  }
  return all;
}

/// Lies with an answer that cannot be right, every time.
bool cannot_be_right(const Plan& plan) {
  const bool is_wrong = (plan.few == 0 && fuzz::is_impossible(plan.value)) ||
                        (plan.size > 0 && plan.size < fuzz::size_count);
  return plan.honesty == 0 && is_wrong;
}

}  // namespace

void prove_against_lies(const std::string& name, unsigned count) {
  constexpr unsigned all_plans = 2 * fuzz::value_count * fuzz::size_count * 2;
  if (number_from("MC_SEEDS", 0) >= 100) count = std::max(count, all_plans);
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
        complain(fmt::format("{}: '{}' has fallen: {}", words_of(plan), result.check.name,
                             result.report));
      }
      if (result.status == Status::passed && result.check.is_main && cannot_be_right(plan)) {
        complain(fmt::format("{}: '{}' passed", words_of(plan), result.check.name));
      }
    }
  }
  fmt::print("{} programs that lie about {}: the judge survived; the slowest check took {:.1f} s\n",
             count, name, slowest);
}

}  // namespace mc::self_test
