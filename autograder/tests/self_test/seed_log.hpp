#pragma once
// Records passed seeds with their p-values in the build directory: a thousand seeds take hours, and
// an interruption should not lose them.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <vector>

#include "grader/judging/verdict.hpp"
#include "tests/self_test/proof.hpp"

namespace mc::self_test {

class SeedLog {
 public:
  /// A new program, or new checks, start from the first seed.
  explicit SeedLog(const Proof& proof);

  /// Receives the p-values of a stored seed.
  using Add = std::function<void(const std::vector<protocol::PValue>&)>;

  /// Returns the recorded p-values, seed by seed, to `add`; returns the next seed to judge.
  std::uint64_t resume(const Add& add) const;

  void keep(const std::vector<protocol::PValue>& p_values) const;

 private:
  std::string submission_;
  std::filesystem::path file_;
};

/// Remembers that the proof of a submission passed with the current checks and self-test: it need
/// not be repeated until any of them changes.
class ProofCache {
 public:
  ProofCache(const Proof& proof, const Subject& subject);
  bool before() const { return std::filesystem::exists(file_); }
  void keep() const;

 private:
  std::filesystem::path file_;
};

/// Prints the records: for each submission its seeds, and the sum of its alphas or the p-value
/// closest to missing it.
void print_power();

}  // namespace mc::self_test
