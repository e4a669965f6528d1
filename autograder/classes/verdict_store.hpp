#pragma once
// The verdicts on a class on disk: a JSON file for each submission, in grades-verdicts/ for
// grades.csv. Each is written before the next submission is judged, so a killed run loses no
// finished work, and --resume needs nothing else.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "judge/judging/verdict.hpp"
#include "sandbox/descriptor.hpp"

namespace mc::grader {

enum class StoreMode {
  anew,    ///< removes earlier verdicts and the table
  resume,  ///< keeps them
  task     ///< one of many processes that add to a run: no lock, nothing is removed
};

class VerdictStore {
 public:
  /// Throws UsageError if another run is writing this table, or if `mode` is `anew` and there are
  /// verdicts of a run that never wrote its table. Throws std::system_error if writing fails.
  VerdictStore(const std::filesystem::path& csv, StoreMode mode);

  const std::filesystem::path& directory() const { return directory_; }
  /// The seed of the verdicts that are there; nothing without verdicts.
  std::optional<std::uint64_t> seed() const { return seed_; }

  /// The verdict on this id from an earlier run, if it is still valid: for the same contents, seed,
  /// version and labs. Submissions that were not judged are judged again.
  std::optional<Verdict> known(const Verdict& wanted) const;
  /// Thread-safe for different ids.
  void add(const Verdict& verdict) const;

 private:
  std::filesystem::path directory_;
  std::optional<std::uint64_t> seed_;
  bool may_reuse_ = false;
  sandbox::Descriptor lock_;
};

}  // namespace mc::grader
