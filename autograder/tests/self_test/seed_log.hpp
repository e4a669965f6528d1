#pragma once
// Seeds that went well, with their p-values, kept in the build directory: a thousand seeds take
// hours, and what interrupts them should not cost what is done.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <vector>

#include "grader/judging/verdict.hpp"
#include "tests/self_test/proof.hpp"

namespace mc::self_test {

class SeedLog {
 public:
  /// Another program, or other checks, begin anew.
  explicit SeedLog(const Proof& proof);

  /// Receives the p-values of a stored seed.
  using Add = std::function<void(const std::vector<protocol::PValue>&)>;

  /// Gives back what was kept, seed by seed; the first seed that is still to be judged.
  std::uint64_t resume(const Add& add) const;

  void keep(const std::vector<protocol::PValue>& p_values) const;

 private:
  std::string submission_;
  std::filesystem::path file_;
};

/// The proof of a submission, with the checks and the self-test that there are now: one that went
/// well once need not be repeated until any of them changes.
class ProofCache {
 public:
  ProofCache(const Proof& proof, const Subject& subject);
  bool before() const { return std::filesystem::exists(file_); }
  void keep() const;

 private:
  std::filesystem::path file_;
};

/// Prints what is kept: for each submission its seeds, and the sum of its alphas or the p-value by
/// which it was all but missed.
void print_power();

}  // namespace mc::self_test
