// The cost of measurements of right answers, on the least capable machine.

#include <algorithm>
#include <cstdlib>

#include <fmt/format.h>

#include "tests/self_test/proof.hpp"

namespace mc::self_test {

namespace {

/// A tenth of the limit of a measurement: a slower machine, or a plainer answer, still passes.
constexpr double most_allowed = 0.2;

/// The costliest measurement of a check: its CPU time, and its experiment.
struct Cost {
  double seconds;
  std::string experiment, check, file;
};

double seconds_of(const CheckResult& result) {
  return std::strtod(result.costliest.c_str(), nullptr);
}

/// No right answer comes nearer to the limit of a growth than this factor.
constexpr double nearest_allowed = 4;

/// Prints each growth of a right answer with its limit: "1.8 32 a candidate".
void print_growths(const CheckResult& result, const std::string& file) {
  for (const std::string& text : result.growths) {
    char* rest = nullptr;
    const double growth = std::strtod(text.c_str(), &rest), limit = std::strtod(rest, &rest);
    fmt::print("  growth {:.2f}, limit {:.0f}:{} in '{}', {}\n", growth, limit, rest,
               result.check.name, file);
    if (growth * nearest_allowed > limit) complain("  nearer to its limit than a factor of 4");
  }
}

/// The minimum of three: other work on the machine only adds time.
double seconds_at_least(const Proof& proof, const CheckResult& first) {
  double least = seconds_of(first);
  for (std::uint64_t seed = 2; seed <= 3 && least > most_allowed; ++seed) {
    for (const CheckResult& result : proof.judge(seed, {first.check.name}).checks) {
      if (result.check.name == first.check.name) least = std::min(least, seconds_of(result));
    }
  }
  return least;
}

}  // namespace

void prove_cost(const std::string& lab) {
  setenv("MC_BASELINE", "1", 1);  // as on any x86-64
  const Layout layout = read_layout();
  std::vector<fs::path> files{layout.solutions() / (lab + ".cpp")};
  const fs::path alternatives = layout.submissions() / "alternatives" / lab;
  if (fs::exists(alternatives)) {
    for (const auto& entry : fs::directory_iterator(alternatives)) files.push_back(entry.path());
  }
  std::vector<Cost> costs;
  for (const fs::path& file : files) {
    const Proof proof = proof_of({file});
    if (!proof.built.program) return complain(proof.built.failure);
    for (const CheckResult& result : proof.judge(1).checks) {
      if (result.status != Status::passed) continue;  // a stretch task that it does without
      print_growths(result, file.filename().string());
      if (result.costliest.empty()) continue;
      const auto blank = result.costliest.find(' ');
      costs.push_back({seconds_at_least(proof, result), result.costliest.substr(blank + 1),
                       result.check.name, file.filename().string()});
    }
  }
  std::sort(costs.begin(), costs.end(),
            [](const Cost& a, const Cost& b) { return a.seconds > b.seconds; });
  fmt::print("{}: {} right answers without -march; seconds of CPU time of one measurement:\n", lab,
             files.size());
  for (std::size_t i = 0; i < costs.size() && (i < 5 || costs[i].seconds > most_allowed); ++i) {
    const Cost& one = costs[i];
    fmt::print("  {:.3f}  {} in '{}', {}\n", one.seconds, one.experiment, one.check, one.file);
    if (one.seconds > most_allowed) complain(fmt::format("  more than {} s", most_allowed));
  }
  if (costs.empty()) fmt::print("  none above 0.02\n");
}

}  // namespace mc::self_test
