// feedback: what goes back to the students, a page and a text each, and to the platform.

#include <map>

#include "grader/commands/command.hpp"
#include "grader/commands/manifest.hpp"
#include "grader/gradebook/corrections.hpp"
#include "grader/gradebook/roster.hpp"
#include "grader/reports/html.hpp"
#include "grader/reports/report.hpp"
#include "grader/submission/exports.hpp"

namespace mc::grader {
namespace {

/// What the instructor changed, and the totals that count.
std::string corrections_of(const Row& row, const Verdict& verdict) {
  std::string all = field(row, "corrections");
  if (all.empty()) return all;
  for (const LabVerdict& lab : verdict.labs) {
    all += fmt::format("; total of {}: {}", lab.lab.name, field(row, lab.lab.name + " total"));
  }
  return all;
}

/// The same without anything of the grading machine: paths in commands, and why it failed.
Verdict for_student(Verdict verdict) {
  if (!verdict.not_judged.empty()) verdict.not_judged = "the grading machine failed";
  for (LabVerdict& lab : verdict.labs) {
    for (CheckResult& result : lab.checks) {
      result.repeat = fmt::format("./lab check {} --only {} --seed {}", lab.lab.name,
                                  result.check.task, verdict.seed);
      result.by_hand.clear();
      if (result.status == Status::not_judged) result.report = verdict.not_judged;
    }
  }
  return verdict;
}

std::string text_for(const Verdict& verdict, const std::string& corrections) {
  const Terminal paper{.color = false, .width = 80, .interactive = false};
  std::string all = verdict.unreadable.empty() ? "" : "unreadable: " + verdict.unreadable + '\n';
  for (const LabVerdict& lab : verdict.labs) all += report_lab(lab, verdict, paper) + '\n';
  if (!corrections.empty()) all += "Corrected by hand: " + corrections + '\n';
  return all + "Judged by version " + verdict.version + '\n';
}

/// The folder and name under which a platform takes a student's page for that student.
///   Canvas finds user and attachment by the first two numbers between underscores of the
///     downloaded file's name: doejane_4711_991_variance.html (infer_comment_context_from_filename
///     in app/models/abstract_assignment.rb of github.com/instructure/canvas-lms).
///   Moodle takes fullname_userid_assignsubmission_file_anything
///     (github.com/moodle/moodle, mod/assign/feedback/file/importziplib.php).
///   Gradescope has no upload of feedback files: the page has the name of the submission.
std::optional<fs::path> upload_name(const Verdict& verdict, const Person* person) {
  const std::string& name = verdict.delivery.platform_name;
  const std::string plugin = "_assignsubmission_file_";
  const auto at = name.find("_assignsubmission_");
  if (at != std::string::npos) {
    return fs::path("moodle") / (name.substr(0, at) + plugin + "feedback.html");
  }
  if (name.empty()) {  // no submission: Moodle's worksheet still knows the number
    const bool is_moodle = person != nullptr && !field(person->row, "Identifier").empty();
    if (!is_moodle || person->number.empty()) return {};
    return fs::path("moodle") /
           (id_from_name(person->name) + '_' + person->number + plugin + "feedback.html");
  }
  if (name.starts_with("submission_")) return fs::path("gradescope") / (name + ".html");
  const auto dot = name.rfind('.');
  return fs::path("canvas") / (name.substr(0, dot) + ".html");
}

/// The column of a lab's assignment in Canvas's export, "variance (123)"; else a new one.
std::string assignment_of(const Roster& roster, const Lab& lab) {
  for (const std::string& column : roster.columns) {
    std::string text = column;
    for (char& c : text) c = c == ' ' ? '_' : static_cast<char>(std::tolower(c));
    if (text.ends_with(')') && text.find(lab.name) != std::string::npos) return column;
  }
  return fmt::format("Lab {} {}", lab.number, lab.name);
}

using Grades = std::map<std::string, Row>;  // id -> its row of the table of grades

/// The roster's rows, with the total of a lab in each of these columns.
std::string upload_table(const Roster& roster, std::vector<std::string> columns,
                         const std::vector<std::pair<std::string, Lab>>& labs,
                         const Grades& grades) {
  Table table{{}, std::move(columns), {}};
  for (const auto& [column, lab] : labs) add_column(table.columns, column);
  for (const Person& person : roster.people) {
    Row row = person.row;
    const auto graded = grades.find(person.id);
    for (const auto& [column, lab] : labs) {
      row[column] = graded == grades.end() ? "" : field(graded->second, lab.name + " total");
    }
    table.rows.push_back(std::move(row));
  }
  return table_text(table);
}

/// Writes tables of grades as the platform of this roster imports them; returns their names.
///   Canvas, gradebook: Student, ID, SIS User ID, SIS Login ID, Section, then a column for each
///     assignment (teaching.resources.osu.edu, "Import CSV file to Carmen Grades";
///     GradebookImporter in github.com/instructure/canvas-lms).
///   Moodle, grading worksheet of one assignment: it requires Identifier, Grade and Last modified
///     (grade) (github.com/moodle/moodle, mod/assign/feedback/offline/importgradeslib.php).
///   Moodle, grades: any columns; the import maps e-mail address or ID number to a student
///     (docs.moodle.org/en/Grade_import).
std::vector<std::string> write_tables(const fs::path& out, const Roster& roster,
                                      const std::vector<Lab>& labs, const Grades& grades) {
  std::vector<std::string> files;
  const auto write = [&](const std::string& name, const std::string& table) {
    write_text(out / name, table);
    files.push_back(name);
  };
  if (has_column(roster.columns, "Identifier") && has_column(roster.columns, "Grade")) {
    for (const Lab& lab : labs) {
      write(fmt::format("moodle-{}.csv", lab.name),
            upload_table(roster, roster.columns, {{"Grade", lab}}, grades));
    }
    return files;
  }
  const bool is_canvas = has_column(roster.columns, "Student");
  std::vector<std::string> columns{"Student", "ID", "SIS User ID", "SIS Login ID", "Section"};
  if (!is_canvas) columns = roster.columns;
  std::erase_if(columns, [&](auto& column) { return !has_column(roster.columns, column); });
  std::vector<std::pair<std::string, Lab>> assignments;
  for (const Lab& lab : labs) assignments.emplace_back(assignment_of(roster, lab), lab);
  write(is_canvas ? "canvas-grades.csv" : "moodle-grades.csv",
        upload_table(roster, columns, assignments, grades));
  return files;
}

/// Lists the files that a run wrote and their hashes: the next run replaces these and no others.
constexpr const char* list_file = "written-by-feedback.txt";

/// Removes what an earlier run wrote. Throws UsageError if there is any other or edited file.
void remove_earlier_output(const fs::path& out) {
  const std::string listed = '\n' + read_text(out / list_file);
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(out)) {
    if (fs::is_directory(entry.symlink_status())) continue;
    files.push_back(entry.path());
    const std::string name = entry.path().lexically_relative(out).string();
    if (name == list_file) continue;
    if (!fs::is_regular_file(entry.symlink_status()) ||
        listed.find(fmt::format("\n{} {}\n", hash_of_file(entry.path()), name)) == listed.npos) {
      throw UsageError(fmt::format(
          "{} has a file that is not what ./lab feedback wrote: {}. Move it away, or name another "
          "directory",
          sandbox::printable_line(out.string()), sandbox::printable_line(name)));
    }
  }
  for (const fs::path& file : files) fs::remove(file);
}

void list_output(const fs::path& out) {
  std::string list;
  for (const auto& entry : fs::recursive_directory_iterator(out)) {
    if (entry.is_directory()) continue;
    list += fmt::format("{} {}\n", hash_of_file(entry.path()),
                        entry.path().lexically_relative(out).string());
  }
  write_text(out / list_file, list);
}

/// Writes the pages and texts of these students, and prints their number.
void write_students(const fs::path& out, const Table& table, const Roster& roster) {
  const auto verdicts = read_verdicts(table);
  std::map<std::string, const Person*> people;
  for (const Person& person : roster.people) people[person.id] = &person;
  std::size_t count = 0, named = 0;
  for (const Row& row : table.rows) {
    const std::string id = field(row, "id");
    const auto found = verdicts.find(id);
    if (found == verdicts.end()) {
      fmt::print("left out: {}: it has no verdict next to the table\n", id);
      continue;
    }
    const Verdict verdict = for_student(found->second);
    const std::string corrections = corrections_of(row, verdict);
    const std::string page = submission_page(verdict, {{}, {}, corrections});
    write_text(out / "students" / (id + ".html"), page);
    write_text(out / "students" / (id + ".txt"), text_for(verdict, corrections));
    ++count;
    const auto person = people.find(id);
    const auto name = upload_name(verdict, person == people.end() ? nullptr : person->second);
    if (!name) continue;
    fs::create_directories((out / *name).parent_path());
    write_text(out / *name, page);
    ++named;
  }
  fmt::print("{}: {} students, a page and a text each", sandbox::printable_line(out.string()),
             count);
  if (named > 0) fmt::print("; {} pages named for upload", named);
  fmt::print("\n");
}

int feedback(const Context& context, const Arguments& arguments) {
  const auto to = arguments.get("out");
  if (!to) throw WrongUsage();
  const fs::path out = *to;
  if (fs::exists(out) && !fs::is_directory(out)) {
    throw UsageError(fmt::format("{} is not a directory", sandbox::printable_line(out.string())));
  }
  const Table table = read_corrected_table(arguments.words[0], context.labs);
  Roster roster;
  if (const auto file = arguments.get("roster")) roster = read_roster(*file);
  if (fs::exists(out)) remove_earlier_output(out);
  fs::create_directories(out / "students");
  write_students(out, table, roster);
  if (!roster.people.empty()) {
    std::vector<Lab> labs = context.labs;
    std::erase_if(labs,
                  [&](const Lab& lab) { return !has_column(table.columns, lab.name + " total"); });
    Grades grades;
    for (const Row& row : table.rows) grades[field(row, "id")] = row;
    for (const std::string& file : write_tables(out, roster, labs, grades)) {
      fmt::print("grades to upload: {}\n", sandbox::printable_line((out / file).string()));
    }
  }
  list_output(out);
  return 0;
}

const RegisterCommand feedback_command{
    {.usage = "feedback grades.csv --out DIR [--roster FILE]",
     .details =
         "Writes DIR/students/ID.html and ID.txt for each student of a table from ./lab grade "
         "--csv: every check, with commands for the student's own checkout, and your corrections. "
         "Pages of students whose work came from a platform's export are in DIR/canvas, DIR/moodle "
         "or DIR/gradescope too, under the names that the platform's bulk upload expects.",
     .options = {{"--out DIR",
                  "a new or empty directory, or that of an earlier run, whose files are replaced"},
                 {"--roster FILE",
                  "also write tables of grades for Canvas or Moodle; FILE is the list that this "
                  "platform exported (Canvas: gradebook; Moodle: grading worksheet)"}},
     .run = feedback,
     .least_words = 1,
     .most_words = 1}};

}  // namespace
}  // namespace mc::grader
