#pragma once
// The grades of a class on disk: a table, and next to it the full verdicts. Each is written before
// the next submission is judged, so a killed run loses no finished work.

#include <cstdint>
#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "grader/judging/verdict.hpp"
#include "grader/reports/csv.hpp"
#include "sandbox/descriptor.hpp"

namespace mc::grader {

/// Where the verdicts of a table lie: grades.csv has grades-verdicts/.
std::filesystem::path verdict_directory(const std::filesystem::path& csv);

/// The file of one verdict in there.
std::filesystem::path verdict_file(const std::filesystem::path& csv, const std::string& id);

/// That verdict; nothing where it is not there, or is none that this autograder can read.
std::optional<Verdict> read_verdict(const std::filesystem::path& csv, const std::string& id);

/// What an earlier run left next to a table.
struct BookState {
  bool exists = false, finished = false;
  std::uint64_t seed = 0;
  std::size_t verdicts = 0;
};
BookState read_book_state(const std::filesystem::path& csv);
void write_book_state(const std::filesystem::path& csv, bool finished, std::uint64_t seed);

class Book {
 public:
  struct Setup {
    std::filesystem::path csv;
    std::vector<LabColumns> columns;
    std::vector<std::string> ids;  ///< of all submissions, in the order of the rows
    std::uint64_t seed = 0;
    bool resume = false;  ///< false: what is there is replaced
  };
  /// Throws UsageError where another run is writing the same table, std::system_error where nothing
  /// can be written.
  explicit Book(Setup setup);

  /// The verdict on this id from an earlier run, if it can stand: on the same contents, by the same
  /// autograder, with the same seed, of these labs. What was not judged is judged again.
  std::optional<Verdict> known(const std::string& id, const std::string& contents,
                               const std::string& version, const std::vector<Lab>& labs) const;

  /// A known verdict keeps its row.
  void keep(const Verdict& verdict);
  /// Writes the table with what is known, and is ready for more.
  void begin();
  /// Writes the verdict, then its row. For several threads.
  void add(const Verdict& verdict);
  std::optional<Verdict> read(const std::string& id) const;
  /// The same verdict with more in it (its speed): its row stays.
  void update(const Verdict& verdict);

  /// Rows in the order of the ids; if the batch is whole, the next one may replace it.
  void finish(bool whole);

 private:
  void write_table() const;
  void write_state(bool finished) const;

  const Setup setup_;
  sandbox::Descriptor lock_, table_;
  std::mutex mutex_;
  std::map<std::string, std::string> rows_;  ///< id -> its row
};

}  // namespace mc::grader
