// A whole term: a handout, submitted in three ways; late, absent, resubmitted, corrected, regraded
// after a fixed check; feedback.

#include "grader/commands/manifest.hpp"
#include "grader/gradebook/book.hpp"
#include "grader/reports/html.hpp"
#include "grader/reports/verdict_json.hpp"
#include "tests/gradebook/course.hpp"

namespace mc::tests::term {

namespace {

/// A student's submission, and which of the two has full marks.
struct Work {
  std::string variance, independent;  ///< empty: not handed in
  bool variance_is_right = false, independent_is_right = false;
};

/// A course with a handout, and all submissions in `class`.
struct Term : Course {
  const std::string solution = text_of(layout.solutions()), starter = text_of(layout.starter()),
                    second = read_text(layout.solutions() / "independent.cpp");
  const std::vector<Work> handed{
      {solution, second, true, true},
      {solution, "", true},
      {starter, ""},
      {"this is no C++\n", ""},
      {starter, second},
      {text_with_mistake(layout), ""},
      {solution, read_text(layout.starter() / "independent.cpp"), true},
      {solution, with_change(second, "namespace mc {", "namespace mc {\n"), true, true}};
  fs::path handout = path() / "handout", table = csv(), pages = path() / "pages";

  Term() {
    output_of({"handout", handout, "--labs", "1,2"});
    for (std::size_t i = 0; i < handed.size(); ++i) {
      ids.push_back(fmt::format("student {}", i + 1));
      const std::string place = "class/" + ids[i];
      if (i % 3 == 0) hand_in_folder(place, handed[i]);
      if (i % 3 == 1) hand_in_zip(place, handed[i]);
      if (i % 3 == 2) hand_in_repository(place, handed[i]);
    }
  }

  void hand_in_folder(const std::string& place, const Work& work) const {
    write(place + "/variance.cpp", work.variance);
    if (!work.independent.empty()) write(place + "/independent.cpp", work.independent);
  }
  /// As `./lab submit` creates it, from a handout of an older version.
  void hand_in_zip(const std::string& place, const Work& work) const {
    hand_in_folder(place, work);
    write(place + '/' + manifest_file, "version=0.9\n");
    zip_content({.directory = path() / place, .zip = path() / (place + ".zip")});
    fs::remove_all(path() / place);
  }
  /// A clone of the handout with the student's work.
  void hand_in_repository(const std::string& place, const Work& work) const {
    git(path(), {"clone", "-q", handout, path() / place});
    hand_in_folder(place + "/starter", work);
    git(path() / place, {"commit", "-q", "-a", "--allow-empty", "-m", "done"});
  }

  sandbox::ProcessResult grade_all(const Words& more) const {
    const Words words{"grade", path() / "class", "--lab", "1,2", "--csv", table, "--html", pages};
    return run(joined(words, more));
  }
  std::map<std::string, Row> rows() const {
    std::map<std::string, Row> all;
    for (const Row& row : read_table(table).rows) all[field(row, "id")] = row;
    return all;
  }
};

}  // namespace

TEST_CASE("a term, from the handout to the grades", "[.term]") {
  const Term term;
  const std::size_t students = term.handed.size();
  REQUIRE_RUN(first, term.grade_all({"--seed", "7"}));
  check_contains(first.output,
                 {"handout of version 0.9, judged by", ": student 2, student 5, student 8"});
  auto rows = term.rows();
  REQUIRE(rows.size() == students);
  for (std::size_t i = 0; i < students; ++i) {
    const Row& row = rows.at(term.ids[i]);
    CAPTURE(row);
    CHECK((field(row, "variance total") == "100") == term.handed[i].variance_is_right);
    CHECK((field(row, "independent total") == "100") == term.handed[i].independent_is_right);
  }

  // One student hands in again: the others are not judged again.
  const auto judge_one = [&](const Words& more) {
    REQUIRE_RUN(run, term.grade_all(joined({"--resume"}, more)));
    rows = term.rows();
    CHECK(contains(run.output, fmt::format("1 judged, {} already", rows.size() - 1)));
    return run.output;
  };
  const auto total = [&](const char* id) { return rows.at(id).at("variance total"); };
  term.hand_in_folder("class/student 4", term.handed[0]);
  judge_one({});
  CHECK(total("student 4") == "100");

  // With the roster, an absent student has a row, a late one the mark and the time, and no
  // submission is judged again.
  std::string people = "id,name,email,Status,Last modified (submission)\n";
  for (int i = 1; i <= 9; ++i) {
    people += fmt::format("student {0},Name {0},s{0}@example.edu,Submitted{1},\n", i,
                          i == 5 ? " - 2 days late,2026-05-04 12:00" : ",-");
  }
  const Words with_roster{"--roster", term.write("roster.csv", people)};
  CHECK(contains(judge_one(with_roster), "without a submission: student 9"));
  CHECK(rows.at("student 9").at("variance status") == "no file");
  for (const auto& [id, row] : rows) {
    CHECK((field(row, "late") == "LATE") == (id == "student 5"));
    CHECK(contains(field(row, "submitted"), "(file time)") ==
          (id != "student 5" && id != "student 9"));
  }
  CHECK(rows.at("student 5").at("submitted") == "2026-05-04 12:00");

  // An older version had a check that failed a right answer: it is judged again, and what the
  // instructor corrected by hand stays.
  auto older = read_verdict(term.table, "student 2");
  REQUIRE(older);
  older->version = "older";
  CheckResult& check = older->labs.at(0).checks.at(0);
  check.status = Status::failed;
  check.report = "measured  what the check got wrong";
  write_text(verdict_file(term.table, "student 2"), verdict_to_json(*older));
  term.write("corrections.csv",
             "id,what,points,comment\nstudent 3,1,50,a typo\nstudent 7,variance written,17,\n"
             "student 5," +
                 csv_field(check.check.name) + ",1.5,right idea\n");
  judge_one(with_roster);
  CHECK(total("student 2") == "100");
  CHECK(total("student 3") == "50");
  CHECK(total("student 5") == "1.5");
  CHECK(total("student 7") == "117");

  // Feedback for all, with the numbers of the verdicts.
  const fs::path feedback = term.path() / "feedback";
  CHECK(contains(term.output_of(joined({"feedback", term.table, "--out", feedback}, with_roster)),
                 "9 students, a page and a text"));
  for (const auto& [id, row] : rows) {
    CAPTURE(id);
    const std::string page = read_text(feedback / "students" / (id + ".html"));
    const std::string text = read_text(feedback / "students" / (id + ".txt"));
    const auto verdict = read_verdict(term.table, id);
    REQUIRE(verdict);
    CHECK(fs::exists(term.pages / "submissions" / (id + ".html")));
    check_contains(page, {fmt::format("{:g} of {:g} points", verdict->earned(), verdict->points()),
                          html_escaped(field(row, "corrections"))});
    CHECK(contains(page, "submitted 2026-05-04 12:00 LATE") == (id == "student 5"));
    for (const LabVerdict& lab : verdict->labs) {
      const std::string earned = fmt::format("{:g} of {:g} points", lab.earned(), lab.points());
      CHECK(contains(page, html_escaped(lab.lab.title()) + ": " + earned));
      CHECK(contains(text, earned));
    }
  }
}

}  // namespace mc::tests::term
