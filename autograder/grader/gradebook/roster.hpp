#pragma once
// The list of a course's students: a table with the columns id, name, email, or what Canvas
// (gradebook), Moodle (grading worksheet, participants, grades), Gradescope (roster) or GitHub
// Classroom export. Columns are found by their headers.

#include <set>

#include "grader/gradebook/table.hpp"
#include "grader/submission/intake.hpp"

namespace mc::grader {

struct Person {
  std::string id, name, email;
  std::string number;          ///< the platform's, in the names of exported files; may be empty
  std::set<std::string> keys;  ///< all that may name this person, in lower case
  Row row;                     ///< of the roster, for tables that go back to the platform
};

struct Roster {
  std::vector<std::string> columns;
  std::vector<Person> people;
};

/// Throws UsageError if the file is not a roster, or if two people have the same id.
Roster read_roster(const std::filesystem::path& file);

/// The submissions of people who are not on a roster, and the people without a submission.
struct RosterReport {
  std::vector<std::string> not_on_roster, without_submission;
};

/// Gives each submission the id of its person, a group's to each of its members, and everyone
/// without a submission an empty one. A submission that the roster does not know, or a second one
/// of a person, keeps its id. Times that no platform gives are the files'.
RosterReport match_roster(const Roster& roster, std::vector<IntakeEntry>& entries);

}  // namespace mc::grader
