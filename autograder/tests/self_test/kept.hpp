#pragma once
// Seeds that went well, with their p-values, kept in the build directory: a thousand seeds take
// hours, and what interrupts them should not cost what is done.

#include <cstdint>
#include <filesystem>
#include <functional>

#include "grader/judging/verdict.hpp"
#include "tests/self_test/proof.hpp"

namespace mc::self_test {

class Kept {
 public:
  /// Another program, or other checks, begin anew.
  explicit Kept(const Proof& proof);

  /// Gives back what was kept, seed by seed (its p-values, in one check); the first seed that is
  /// still to be judged.
  std::uint64_t resume(const std::function<void(const grader::LabVerdict&)>& add) const;

  void keep(const grader::LabVerdict& verdict) const;

 private:
  std::string submission_;
  std::filesystem::path file_;
};

/// Prints what is kept: for each submission its seeds, for each lab the sum of its alphas.
void print_power();

}  // namespace mc::self_test
