// Right answers: full marks with many seeds, and uniform p-values of their random checks.

#include <algorithm>
#include <cstdlib>
#include <map>

#include <fmt/format.h>

#include "checks/support/distributions.hpp"
#include "judge/judging/speed.hpp"
#include "tests/self_test/proof.hpp"

namespace mc::self_test {

using protocol::PValue;

namespace {

/// The p-values of a lab's random checks, over many runs of a right answer.
class PValues {
 public:
  /// One run: may it fail a right answer with probability above 1e-6?
  void add(const std::vector<PValue>& run) {
    double alphas = 0;
    for (const PValue& value : run) {
      alphas += value.alpha;
      of_null_[value.null].push_back(value.p);
      all_.push_back(value.p);
    }
    most_ = std::max(most_, alphas);
  }

  /// All runs: their p-values are uniform, together and test by test.
  void conclude() const {
    if (all_.empty()) return;
    if (most_ >= 1e-6) complain(fmt::format("its alphas add up to {:.2g}: 1e-6 or more", most_));
    double least = 1;
    for (const auto& [null, values] : of_null_) {
      const double p = uniformity(values);
      if (p < least) least = p;
      if (p < 1e-6 / static_cast<double>(of_null_.size())) {
        complain(fmt::format("p-values that are not uniform (p = {:.2g}): {}", p, null));
      }
    }
    const double together = uniformity(all_);
    if (together < 1e-6) complain(fmt::format("p-values are not uniform (p = {:.2g})", together));
    fmt::print(
        "{} p-values of {} tests, alphas of one run {:.2g} in all; smallest {:.2g}; uniform "
        "together with p = {:.2g}, test by test with {:.2g} at least\n",
        all_.size(), of_null_.size(), most_, *std::min_element(all_.begin(), all_.end()), together,
        least);
  }

 private:
  /// p-value of Kolmogorov and Smirnov's test that `p` is uniform.
  static double uniformity(std::vector<double> p) {
    return checks::kolmogorov_tails(checks::distance_from_uniform(p), p.size()).upper;
  }

  double most_ = 0;
  std::map<std::string, std::vector<double>> of_null_;
  std::vector<double> all_;
};

}  // namespace

void prove_right(const Proof& proof, const Subject& subject) {
  const bool is_full = std::getenv("MC_SEEDS") != nullptr;
  // By default: the reference five times, which shows that no check depends on the seed, and others
  // once; in --quick all once.
  const bool is_reference = proof.submission.label.starts_with("solutions");
  const bool is_quick = std::getenv("MC_QUICK") != nullptr;
  const std::uint64_t seeds = number_from("MC_SEEDS", is_quick || !is_reference ? 1 : 5);
  // Checks of fresh data without a random outcome: twice, or twice as often with MC_SEEDS.
  const std::uint64_t fresh_seeds = is_full ? 2 * seeds : std::min<std::uint64_t>(seeds, 2);
  // An alternative may miss stretch tasks, as plain loops miss a speed task.
  const auto names = said(subject, "fails");
  const std::set<std::string> missed(names.begin(), names.end());
  PValues p_values;
  std::uint64_t seed = 1;
  std::set<std::string> checks, random, fresh;  // empty: all
  const auto choose = [&] {
    checks = seed <= seeds ? random : std::set<std::string>{};
    if (seed <= fresh_seeds) checks.insert(fresh.begin(), fresh.end());
    return !checks.empty();
  };
  // The first run, with all checks, identifies the random ones.
  const LabVerdict first = proof.judge(1);
  for (const CheckResult& result : first.checks) {
    (result.p_values.empty() ? fresh : random).insert(result.check.name);
  }
  for (; seed == 1 || choose(); ++seed) {
    const LabVerdict verdict = seed == 1 ? first : proof.judge(seed, checks);
    const bool is_right =
        std::all_of(verdict.checks.begin(), verdict.checks.end(), [&](const CheckResult& result) {
          return result.status == Status::passed ||
                 (!is_reference && result.check.is_stretch() &&
                  (result.status == Status::not_written || missed.contains(result.check.task)));
        });
    if (!is_right) {
      proof.show(verdict, seed);
      complain(fmt::format("seed {}: a right answer without full marks", seed));
      return;
    }
    std::vector<PValue> run;
    for (const CheckResult& result : verdict.checks) {
      run.insert(run.end(), result.p_values.begin(), result.p_values.end());
    }
    p_values.add(run);
  }
  fmt::print("full marks with {} seeds\n", seeds);
  p_values.conclude();
}

}  // namespace mc::self_test
