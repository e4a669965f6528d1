#pragma once
// The grades of a class on disk: a table, and next to it the full verdicts. Each is written before
// the next submission is judged, so a killed run loses no finished work.

#include <cstdint>
#include <mutex>

#include "grader/gradebook/table.hpp"
#include "sandbox/descriptor.hpp"

namespace mc::grader {

/// The directory with the verdicts of a table: grades-verdicts/ for grades.csv.
std::filesystem::path verdict_directory(const std::filesystem::path& csv);

/// The file of one verdict in it.
std::filesystem::path verdict_file(const std::filesystem::path& csv, const std::string& id);

/// That verdict; nothing if it does not exist or this autograder cannot read it.
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
    People people = People::hidden;
    std::vector<std::string> ids;  ///< all submissions, in the order of the rows
    std::uint64_t seed = 0;
    std::string version;  ///< of the autograder
    bool resume = false;  ///< false: replace an existing table
  };
  /// Throws UsageError if another run is writing the same table, std::system_error if writing
  /// fails.
  explicit Book(Setup setup);

  /// The verdict on this id from an earlier run, if it is still valid: for the same contents,
  /// autograder, seed and labs. Submissions that were not judged are judged again.
  std::optional<Verdict> known(const std::string& id, const std::vector<Lab>& labs,
                               const std::string& contents) const;

  /// Keeps the row of a known verdict.
  void keep(const Verdict& verdict);
  /// Writes the table with the known verdicts; further ones can be added then.
  void begin();
  /// Writes the verdict, then its row. Thread-safe.
  void add(const Verdict& verdict);
  std::optional<Verdict> read(const std::string& id) const;
  /// Replaces a verdict by one with more data (its speed); its row stays.
  void update(const Verdict& verdict);

  /// Sorts the rows by id; if the batch is complete, the next run may replace the table.
  void finish(bool whole);

 private:
  void write_table() const;

  const Setup setup_;
  sandbox::Descriptor lock_, table_;
  std::mutex mutex_;
  std::map<std::string, std::string> rows_;  ///< id -> its row
};

}  // namespace mc::grader
