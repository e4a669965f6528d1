#include "grader/gradebook/roster.hpp"

#include <sys/stat.h>

#include <algorithm>
#include <ctime>

#include <fmt/chrono.h>

#include "grader/submission/exports.hpp"

namespace mc::grader {
namespace {

/// The columns that may hold a value, in lower case; the first that is not empty counts.
///   Canvas, gradebook: Student, ID, SIS User ID, SIS Login ID, Section. ID is the number in the
///     names of downloaded files (community.canvaslms.com, "How do I export grades in the
///     Gradebook?"; github.com/instructure/canvas-lms, lib/gradebook_importer.rb).
///   Moodle, grading worksheet: Identifier ("Participant 123"), Full name, ID number, Email
///     address, Status, Last modified (submission)
///     (github.com/moodle/moodle, mod/assign/gradingtable.php);
///     participants and grades: First name, Last name or Surname, ID number, Email address.
///   Gradescope, roster: First Name and Last Name, or Name; SID, Email, Role
///     (help.gradescope.com/article/w59nl02vyt-instructor-course-add-members).
///   GitHub Classroom: identifier, github_username, name.
using Names = std::vector<std::string_view>;
namespace roster_columns {
const Names ids{"id",         "sid",      "id number",     "student id",
                "identifier", "username", "email address", "email"};
const Names canvas_ids{"sis user id", "sis login id", "id"};
const Names names{"name", "full name", "student"};
const Names emails{"email", "email address", "e-mail", "sis login id"};
const Names logins{"sis login id", "username", "github_username"};
}  // namespace roster_columns

std::string without_blanks(const std::string& text) {
  const auto begin = text.find_first_not_of(' ');
  if (begin == std::string::npos) return {};
  return text.substr(begin, text.find_last_not_of(' ') + 1 - begin);
}

std::string trailing_digits(const std::string& text) {
  return text.substr(text.find_last_not_of("0123456789") + 1);
}

/// A row by its columns in lower case.
using Fields = std::map<std::string, std::string, std::less<>>;

std::string first_of(const Fields& fields, const Names& columns) {
  for (const std::string_view column : columns) {
    const auto found = fields.find(column);
    if (found != fields.end() && !found->second.empty()) return found->second;
  }
  return {};
}

std::string name_in(const Fields& fields) {
  std::string name = first_of(fields, roster_columns::names);
  if (name.empty()) {
    name = without_blanks(first_of(fields, {"first name"}) + ' ' +
                          first_of(fields, {"last name", "surname"}));
  }
  const auto comma = name.find(", ");  // Canvas: "Doe, Jane"
  return comma == std::string::npos ? name : name.substr(comma + 2) + ' ' + name.substr(0, comma);
}

/// Nothing for a row that is not a student: Canvas's "Points Possible" and test student, staff.
std::optional<Person> person_in(const Fields& fields) {
  const bool is_canvas = fields.contains("student");
  Person person;
  person.name = name_in(fields);
  const std::string role = in_lower_case(first_of(fields, {"role"}));
  if (person.name == "Points Possible" || person.name == "Test Student" ||
      (!role.empty() && role.find("student") == std::string::npos && role != "0")) {
    return {};
  }
  person.email = first_of(fields, roster_columns::emails);
  if (person.email.find('@') == std::string::npos) person.email.clear();
  if (is_canvas) person.number = first_of(fields, {"id"});
  if (fields.contains("full name")) {
    person.number = trailing_digits(first_of(fields, {"identifier"}));
  }
  std::string id = first_of(fields, is_canvas ? roster_columns::canvas_ids : roster_columns::ids);
  if (!person.number.empty() && !is_canvas) {  // Moodle: "Participant 123" is a poor id
    id = first_of(fields, {"id number", "username", "email address", "identifier"});
  }
  if (id.empty()) return {};
  person.id = id_from_name(id);
  for (const std::string& key :
       {id, person.email, person.name, first_of(fields, roster_columns::logins),
        person.email.substr(0, person.email.find('@'))}) {
    if (!key.empty()) person.keys.insert(in_lower_case(key));
  }
  if (!person.number.empty()) person.keys.insert('#' + person.number);
  return person;
}

/// The keys that a part of a submission's id may hold, the surest first.
std::vector<std::string> keys_in(const std::string& part) {
  std::vector<std::string> keys;
  const auto open = part.rfind('('), close = part.rfind(')');  // Gradescope: "Jane (jane@x.edu)"
  if (open != std::string::npos && close != std::string::npos && open < close) {
    keys.push_back(part.substr(open + 1, close - open - 1));
    keys.push_back(without_blanks(part.substr(0, open)));
  }
  const auto bar = part.rfind('_');  // Canvas: doejane_4711; Moodle: Jane Doe_123
  if (bar != std::string::npos && trailing_digits(part).size() == part.size() - bar - 1) {
    keys.push_back('#' + part.substr(bar + 1));
  }
  keys.push_back(part);
  if (bar != std::string::npos) keys.push_back(part.substr(0, bar));
  for (auto dash = part.find('-'); dash != std::string::npos; dash = part.find('-', dash + 1)) {
    keys.push_back(part.substr(dash + 1));  // GitHub Classroom: lab-1-anna
  }
  return keys;
}

/// Everyone by their keys; a key of several people names none of them.
class Keys {
 public:
  explicit Keys(const Roster& roster) {
    for (const Person& person : roster.people) {
      for (const std::string& key : person.keys) {
        const auto [before, is_new] = by_key_.emplace(key, &person);
        if (!is_new) before->second = nullptr;
      }
    }
  }
  const Person* find(const std::string& part) const {
    for (const std::string& key : keys_in(part)) {
      const auto found = by_key_.find(in_lower_case(key));
      if (found != by_key_.end() && found->second != nullptr) return found->second;
    }
    return nullptr;
  }
  /// All members of a group that are on the roster; the others go into `unknown`.
  std::vector<const Person*> find_all(const std::string& id,
                                      std::vector<std::string>& unknown) const {
    std::vector<const Person*> all;
    for (std::size_t begin = 0; begin < id.size();) {
      const auto end = std::min(id.find(" & ", begin), id.size());
      const std::string part = id.substr(begin, end - begin);
      const Person* const one = find(part);
      if (one == nullptr) unknown.push_back(part);
      if (one != nullptr) all.push_back(one);
      begin = end + 3;
    }
    return all;
  }

 private:
  std::map<std::string, const Person*> by_key_;
};

/// The time of the newest file, if the submission has any.
std::string file_time(const Submission& submission) {
  std::time_t newest = 0;
  for (const auto& [lab, file] : submission.files) {
    struct stat found {};
    if (stat(file.c_str(), &found) == 0) newest = std::max(newest, found.st_mtime);
  }
  return newest == 0 ? "" : fmt::format("{:%Y-%m-%d %H:%M:%S} (file time)", fmt::gmtime(newest));
}

IntakeEntry entry_of(const Person& person, IntakeEntry entry) {
  entry.submission.label = person.id;
  Delivery& delivery = entry.submission.delivery;
  delivery.name = person.name;
  delivery.email = person.email;
  const std::string time = field(person.row, "Last modified (submission)");
  if (delivery.submitted.empty() && time != "-") delivery.submitted = time;
  if (field(person.row, "Status").find("late") != std::string::npos) delivery.late = true;
  if (delivery.submitted.empty()) delivery.submitted = file_time(entry.submission);
  return entry;
}

}  // namespace

Roster read_roster(const fs::path& file) {
  const std::string shown = sandbox::printable_line(file.string());
  if (!fs::is_regular_file(file)) throw UsageError("no such roster: " + shown);
  const auto rows = csv_rows(read_whole_text(file));
  Roster roster;
  if (!rows.empty()) roster.columns = rows[0];
  for (std::string& column : roster.columns) {
    column = without_blanks(sandbox::printable_line(column));
  }
  std::set<std::string> taken;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    Fields fields;
    Row row;
    for (std::size_t k = 0; k < std::min(rows[i].size(), roster.columns.size()); ++k) {
      row[roster.columns[k]] = fields[in_lower_case(roster.columns[k])] =
          without_blanks(sandbox::printable_line(rows[i][k]));
    }
    auto person = person_in(fields);
    if (!person) continue;
    if (!taken.insert(in_lower_case(person->id)).second) {
      throw UsageError(fmt::format("{}: two people have the id '{}'", shown, person->id));
    }
    person->row = std::move(row);
    roster.people.push_back(std::move(*person));
  }
  if (roster.people.empty()) {
    throw UsageError(fmt::format(
        "{} is not a roster: it needs a row for each student, and a column of ids or e-mail "
        "addresses (id, SIS User ID, SID, ID number, Email)",
        shown));
  }
  return roster;
}

RosterReport match_roster(const Roster& roster, std::vector<IntakeEntry>& entries) {
  const Keys people(roster);
  RosterReport report;
  std::vector<IntakeEntry> matched;
  std::set<std::string> present;
  for (const IntakeEntry& entry : entries) {
    const std::string& id = entry.submission.label;
    const auto found = people.find_all(id, report.not_on_roster);
    if (found.empty()) matched.push_back(entry);
    for (const Person* const person : found) {
      if (present.insert(person->id).second) {
        matched.push_back(entry_of(*person, entry));
        continue;
      }
      report.not_on_roster.push_back(fmt::format("{} (another submission by {})", id, person->id));
      matched.push_back(entry);
    }
  }
  for (const Person& person : roster.people) {
    if (present.contains(person.id)) continue;
    report.without_submission.push_back(person.id);
    matched.push_back(entry_of(person, {}));
  }
  make_labels_unique(matched);
  std::ranges::stable_sort(
      matched, [](auto& a, auto& b) { return a.submission.label < b.submission.label; });
  entries = std::move(matched);
  return report;
}

}  // namespace mc::grader
