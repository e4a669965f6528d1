// A whole term: a handout, submitted in three ways, graded, regraded after a fixed check; feedback.

#include "grader/commands/manifest.hpp"
#include "grader/gradebook/book.hpp"
#include "grader/reports/html.hpp"
#include "grader/reports/verdict_json.hpp"
#include "tests/gradebook/course.hpp"

namespace mc::tests::term {

namespace {

/// A student's submission, and which of the two has full marks.
struct Work {
  std::string variance, independent;  ///< empty: not submitted
  bool variance_is_right = false, independent_is_right = false;
};

/// A course with a handout, and all submissions in `class`.
struct Term : Course {
  const std::string solution = text_of(layout.solutions()), starter = text_of(layout.starter()),
                    second = read_text(layout.solutions() / "independent.cpp");
  const std::vector<Work> submitted{
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
    for (std::size_t i = 0; i < submitted.size(); ++i) {
      ids.push_back(fmt::format("student {}", i + 1));
      const std::string place = "class/" + ids[i];
      if (i % 3 == 0) hand_in_folder(place, submitted[i]);
      if (i % 3 == 1) hand_in_zip(place, submitted[i]);
      if (i % 3 == 2) hand_in_repository(place, submitted[i]);
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
  const std::size_t students = term.submitted.size();
  REQUIRE_RUN(first, term.grade_all({"--seed", "7"}));
  check_contains(first.output,
                 {"handout of version 0.9, judged by", ": student 2, student 5, student 8"});
  auto rows = term.rows();
  REQUIRE(rows.size() == students);
  for (std::size_t i = 0; i < students; ++i) {
    const Row& row = rows.at(term.ids[i]);
    CAPTURE(row);
    CHECK((field(row, "variance total") == "100") == term.submitted[i].variance_is_right);
    CHECK((field(row, "independent total") == "100") == term.submitted[i].independent_is_right);
  }

  // An older version had a check that failed a right answer: that one is judged again.
  auto older = read_verdict(term.table, "student 2");
  REQUIRE(older);
  older->version = "older";
  CheckResult& check = older->labs.at(0).checks.at(0);
  check.status = Status::failed;
  check.report = "measured  what the check got wrong";
  write_text(verdict_file(term.table, "student 2"), verdict_to_json(*older));
  REQUIRE_RUN(again, term.grade_all({"--resume"}));
  CHECK(contains(again.output, fmt::format("1 judged, {} already", students - 1)));
  rows = term.rows();
  CHECK(rows.at("student 2").at("variance total") == "100");

  // Feedback for all, with the numbers of the verdicts.
  const fs::path feedback = term.path() / "feedback";
  CHECK(contains(term.output_of({"feedback", term.table, "--out", feedback}),
                 "8 students, a page and a text"));
  for (const auto& [id, row] : rows) {
    CAPTURE(id);
    const std::string page = read_text(feedback / "students" / (id + ".html"));
    const std::string text = read_text(feedback / "students" / (id + ".txt"));
    const auto verdict = read_verdict(term.table, id);
    REQUIRE(verdict);
    CHECK(fs::exists(term.pages / "submissions" / (id + ".html")));
    CHECK(contains(page, fmt::format("{:g} of {:g} points", verdict->earned(), verdict->points())));
    for (const LabVerdict& lab : verdict->labs) {
      const std::string earned = fmt::format("{:g} of {:g} points", lab.earned(), lab.points());
      CHECK(contains(page, html_escaped(lab.lab.title()) + ": " + earned));
      CHECK(contains(text, earned));
    }
  }
}

}  // namespace mc::tests::term
