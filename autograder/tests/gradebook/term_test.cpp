// A whole term: a handout, submitted in three ways, graded by a judge that is killed in the middle;
// late, absent, resubmitted, corrected, regraded after a fixed check; feedback.
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "checks/support/catch.hpp"
#include "grader/commands/manifest.hpp"
#include "grader/gradebook/book.hpp"
#include "grader/gradebook/table.hpp"
#include "grader/reports/csv.hpp"
#include "grader/reports/html.hpp"
#include "grader/reports/verdict_json.hpp"
#include "tests/gradebook/course.hpp"

namespace mc::tests::term {

namespace fs = std::filesystem;
using namespace grader;

namespace {

/// A student's submission, and its expected result: full marks, or less.
struct Work {
  std::string variance, independent;  ///< empty: not handed in
  bool variance_is_right = false, independent_is_right = false;
};

/// Right, with a mistake, unwritten, not C++; some of them also have work on lab 2.
std::vector<Work> works(const Layout& layout) {
  const std::string variance = text_of(layout.solutions()), begun = text_of(layout.starter());
  const std::string independent = read_text(layout.solutions() / "independent.cpp");
  return {{variance, independent, true, true},
          {variance, "", true, false},
          {begun, ""},
          {"this is no C++\n", ""},
          {begun, independent},
          {text_with_mistake(layout), ""},
          {variance, read_text(layout.starter() / "independent.cpp"), true, false},
          {variance, with_change(independent, "namespace mc {", "namespace mc {\n"), true, true}};
}

/// A course with a handout, and all submissions in `class`.
struct Term : Course {
  std::vector<Work> handed = works(layout);
  fs::path handout = path() / "handout", table = csv(), roster = path() / "roster.csv",
           pages = path() / "pages", feedback = path() / "feedback";

  Term() {
    REQUIRE_RUN(written, run({"handout", handout.string(), "--labs", "1,2"}));
    for (std::size_t i = 0; i < handed.size(); ++i) {
      ids.push_back(fmt::format("student {}", i + 1));
      const fs::path place = path() / "class" / ids[i];
      if (i % 3 == 0) hand_in_folder(place, handed[i]);
      if (i % 3 == 1) hand_in_zip(place, handed[i]);
      if (i % 3 == 2) hand_in_repository(place, handed[i]);
    }
  }

  void hand_in_folder(const fs::path& place, const Work& work) const {
    fs::create_directories(place);
    write_text(place / "variance.cpp", work.variance);
    if (!work.independent.empty()) write_text(place / "independent.cpp", work.independent);
  }
  /// As `./lab submit` creates it, from a handout of an older version.
  void hand_in_zip(const fs::path& place, const Work& work) const {
    hand_in_folder(place, work);
    fs::create_directories((place / manifest_file).parent_path());
    write_text(place / manifest_file, "version=0.9\n");
    zip_content({.directory = place, .zip = place.string() + ".zip"});
    fs::remove_all(place);
  }
  /// A clone of the handout with the student's work.
  void hand_in_repository(const fs::path& place, const Work& work) const {
    git(path(), {"clone", "-q", handout.string(), place.string()});
    hand_in_folder(place / "starter", work);
    git(place, {"commit", "-q", "-a", "--allow-empty", "-m", "done"});
  }

  sandbox::ProcessResult grade_all(const std::vector<std::string>& more,
                                   const sandbox::ProcessOptions& options = {}) const {
    return run(joined({"grade", (path() / "class").string(), "--lab", "1,2", "--csv",
                       table.string(), "--html", pages.string()},
                      more),
               options);
  }
  std::map<std::string, Row> rows() const {
    std::map<std::string, Row> all;
    if (!fs::exists(table)) return all;
    for (const Row& row : read_table(table).rows) all[field(row, "id")] = row;
    return all;
  }
  std::string cell(const std::string& id, const std::string& column) const {
    return field(rows().at(id), column);
  }
};

}  // namespace

TEST_CASE("a term, from the handout to the grades", "[.term]") {
  const Term term;
  const std::size_t students = term.handed.size();
  for (const auto& entry : fs::recursive_directory_iterator(term.handout)) {
    CHECK(!contains(entry.path().string(), "solutions"));
  }

  // Killed and resumed. Later and later, until some are judged.
  std::size_t before = 0;
  for (double seconds = 1; before == 0 && seconds < 600; seconds *= 1.5) {
    const std::vector<std::string> go_on{"--resume"}, begin{"--seed", "7"};
    term.grade_all(fs::exists(term.table) ? go_on : begin, {.wall_seconds = seconds});
    before = term.rows().size();
  }
  REQUIRE(before > 0);
  REQUIRE(before < students);
  REQUIRE_RUN(resumed, term.grade_all({"--resume"}));
  CHECK(contains(resumed.output,
                 fmt::format("{} judged, {} already judged; seed 7", students - before, before)));
  CHECK(contains(resumed.output, "handout of version 0.9, judged by"));
  CHECK(contains(resumed.output, ": student 2, student 5, student 8"));
  REQUIRE(term.rows().size() == students);
  for (std::size_t i = 0; i < students; ++i) {
    CAPTURE(term.ids[i]);
    CHECK((term.cell(term.ids[i], "variance total") == "100") == term.handed[i].variance_is_right);
    CHECK((term.cell(term.ids[i], "independent total") == "100") ==
          term.handed[i].independent_is_right);
  }

  // One student hands in again: the others are not judged again.
  const auto judged = [&](const std::vector<std::string>& more) {
    REQUIRE_RUN(run, term.grade_all(joined({"--resume"}, more)));
    CHECK(contains(run.output, fmt::format("1 judged, {} already", term.rows().size() - 1)));
    return run.output;
  };
  term.hand_in_folder(term.path() / "class" / "student 4", term.handed[0]);
  judged({});
  CHECK(term.cell("student 4", "variance total") == "100");

  // With the roster, an absent student has a row, a late one the mark and the time, and no
  // submission is judged again.
  std::string people = "id,name,email,Status,Last modified (submission)\n";
  for (int i = 1; i <= 9; ++i) {
    people += fmt::format("student {0},Name {0},s{0}@example.edu,Submitted{1},\n", i,
                          i == 5 ? " - 2 days late,2026-05-04 12:00" : ",-");
  }
  write_text(term.roster, people);
  const std::vector<std::string> with_roster{"--roster", term.roster.string()};
  CHECK(contains(judged(with_roster), "without a submission: student 9"));
  CHECK(term.cell("student 9", "variance status") == "no file");
  for (const auto& [id, row] : term.rows()) {
    CHECK((field(row, "late") == "LATE") == (id == "student 5"));
    CHECK(contains(field(row, "submitted"), "(file time)") ==
          (id != "student 5" && id != "student 9"));
  }
  CHECK(term.cell("student 5", "submitted") == "2026-05-04 12:00");

  // An older version had a check that failed a right answer: it is judged again, and what the
  // instructor corrected by hand stays.
  auto older = read_verdict(term.table, "student 2");
  REQUIRE(older);
  older->version = "older";
  CheckResult& check = older->labs.at(0).checks.at(0);
  check.status = Status::failed;
  check.report = "measured  what the check got wrong";
  write_text(verdict_file(term.table, "student 2"), verdict_to_json(*older));
  const std::string mended = check.check.name;
  write_text(term.path() / "corrections.csv",
             "id,what,points,comment\nstudent 3,1,50,a typo\nstudent 7,variance written,17,\n"
             "student 5," +
                 csv_field(mended) + ",1.5,right idea\n");
  judged(with_roster);
  CHECK(term.cell("student 2", "variance total") == "100");
  CHECK(term.cell("student 3", "variance total") == "50");
  CHECK(term.cell("student 5", "variance total") == "1.5");
  CHECK(term.cell("student 7", "variance total") == "117");

  // Feedback for all, with the numbers of the verdicts.
  REQUIRE_RUN(returned, term.run({"feedback", term.table.string(), "--out", term.feedback.string(),
                                  "--roster", term.roster.string()}));
  CHECK(contains(returned.output, "9 students, a page and a text"));
  for (const auto& [id, row] : term.rows()) {
    CAPTURE(id);
    const std::string page = read_text(term.feedback / "students" / (id + ".html"));
    const std::string text = read_text(term.feedback / "students" / (id + ".txt"));
    const auto verdict = read_verdict(term.table, id);
    REQUIRE(verdict);
    CHECK(fs::exists(term.pages / "submissions" / (id + ".html")));
    CHECK(contains(page, fmt::format("{:g} of {:g} points", verdict->earned(), verdict->points())));
    CHECK(contains(page, html_escaped(field(row, "corrections"))));
    CHECK(contains(page, "submitted 2026-05-04 12:00 LATE") == (id == "student 5"));
    for (const LabVerdict& lab : verdict->labs) {
      const std::string earned = fmt::format("{:g} of {:g} points", lab.earned(), lab.points());
      CHECK(contains(page, html_escaped(lab.lab.title()) + ": " + earned));
      CHECK(contains(text, earned));
    }
  }
}

}  // namespace mc::tests::term
