// A whole term with a roster of thirty: a handout, submitted in three ways, graded by a judge that
// is killed in the middle; late, absent, resubmitted, corrected, regraded after a fixed check;
// feedback.
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <map>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include <fmt/format.h>

#include "checks/support/catch.hpp"
#include "grader/commands/manifest.hpp"
#include "grader/gradebook/book.hpp"
#include "grader/gradebook/table.hpp"
#include "grader/reports/csv.hpp"
#include "grader/reports/html.hpp"
#include "grader/reports/verdict_json.hpp"
#include "runner/text.hpp"
#include "tests/gradebook/course.hpp"
#include "tests/gradebook/page_numbers.hpp"
#include "tests/text.hpp"

namespace mc::tests::term {

namespace fs = std::filesystem;
using namespace grader;

namespace {

constexpr int students = 30;  ///< the last one hands in nothing

/// A file of the repository with its includes pasted in: a student has no solutions to include.
std::string self_contained(const Layout& layout, const std::string& file) {
  std::string all;
  std::istringstream text(file);
  for (std::string line; std::getline(text, line);) {
    constexpr std::string_view include = "#include \"solutions/";
    if (line.starts_with(include)) {
      const std::string name = line.substr(include.size(), line.size() - include.size() - 1);
      all += read_whole_text(layout.solutions() / name);
    } else {
      all += line + '\n';
    }
  }
  return all;
}

/// Every `step`-th file of a folder, ordered by name.
std::vector<fs::path> some_of(const fs::path& folder, std::size_t step = 1) {
  std::vector<fs::path> all, some;
  for (const auto& entry : fs::directory_iterator(folder)) all.push_back(entry.path());
  std::sort(all.begin(), all.end());
  for (std::size_t i = 0; i < all.size(); i += step) some.push_back(all[i]);
  return some;
}

/// Every `step`-th mistake of a folder of catalogs, each as a separate file. Only from catalogs
/// that rename a single function, because each of their mistakes defines it.
std::vector<std::string> mistakes_of(const fs::path& folder, std::size_t step) {
  const std::string mark = "\n// mistake: ", renamed = "\n#define ", section = "namespace mc::";
  std::vector<std::string> all, some;
  for (const fs::path& file : some_of(folder)) {
    const std::string text = read_whole_text(file);
    const std::string head = text.substr(0, text.find(mark));
    if (head.find(renamed) == std::string::npos || head.find(renamed) != head.rfind(renamed)) {
      continue;
    }
    for (auto at = text.find(mark); at != std::string::npos; at = text.find(mark, at + 1)) {
      std::string one = text.substr(at, text.find(mark, at + 1) - at);
      const auto name = one.find(section) + section.size() - 2;
      one.erase(name, one.find(" {", name) - name);
      all.push_back(head + one);
    }
  }
  for (std::size_t i = 0; i < all.size(); i += step) some.push_back(all[i]);
  return some;
}

/// A student's submission, and its expected result: full marks, or less.
struct Work {
  std::string variance, independent;  ///< empty: not handed in
  bool variance_is_right = false, independent_is_right = false;
};

/// Correct in the repository's and in other ways, with one mistake, unwritten, not C++. Some of
/// them also have work on lab 2.
std::vector<Work> works(const Layout& layout) {
  const std::string variance = read_whole_text(layout.solutions() / "variance.cpp");
  const std::string independent = read_whole_text(layout.solutions() / "independent.cpp");
  const std::string begun = read_whole_text(layout.starter() / "variance.cpp");
  std::vector<Work> all{{variance, independent, true, true},
                        {variance, "", true, false},
                        {begun, ""},
                        {"this is no C++\n", ""},
                        {begun, independent}};
  const fs::path place = layout.submissions();
  for (const fs::path& file : some_of(place / "alternatives" / "variance", 2)) {
    all.push_back({self_contained(layout, read_whole_text(file)), "", true, false});
  }
  for (const fs::path& file : some_of(place / "alternatives" / "independent", 2)) {
    all.push_back({variance, self_contained(layout, read_whole_text(file)), true, true});
  }
  for (const std::string& mistake : mistakes_of(place / "mistakes" / "independent", 15)) {
    all.push_back({variance, self_contained(layout, mistake), true, false});
  }
  for (const std::string& mistake : mistakes_of(place / "mistakes" / "variance", 4)) {
    if (all.size() == students - 1) break;
    all.push_back({self_contained(layout, mistake), "", false, false});
  }
  REQUIRE(all.size() == students - 1);
  return all;
}

/// A course with a handout, and all submissions in `class`.
struct Term : Course {
  std::vector<Work> handed = works(layout);
  fs::path handout = path() / "handout";

  Term() {
    REQUIRE_RUN(written, run({"handout", handout.string(), "--labs", "1,2"}));
    for (std::size_t i = 0; i < handed.size(); ++i) {
      ids.push_back(fmt::format("student {:02}", i + 1));
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
    std::vector<std::string> command{
        "cmake",        "-E",           "tar",        "cf", place.string() + ".zip",
        "--format=zip", "variance.cpp", manifest_file};
    if (!work.independent.empty()) command.emplace_back("independent.cpp");
    must(command, place);
    fs::remove_all(place);
  }
  /// A clone of the handout with the student's work.
  void hand_in_repository(const fs::path& place, const Work& work) const {
    must({"git", "clone", "-q", handout.string(), place.string()}, path());
    hand_in_folder(place / "starter", work);
    must({"git", "-c", "user.name=s", "-c", "user.email=s@example.org", "commit", "-q", "-a",
          "--allow-empty", "-m", "done"},
         place);
  }
  static void must(const std::vector<std::string>& command, const fs::path& directory) {
    REQUIRE_RUN(done, sandbox::run_process(command, {.directory = directory}));
  }

  std::vector<std::string> grading(const fs::path& table,
                                   const std::vector<std::string>& more) const {
    return joined({"grade", (path() / "class").string(), "--lab", "1,2", "--csv", table.string()},
                  more);
  }

  /// Starts grading, and kills it after a few rows.
  void grade_and_kill(const fs::path& table, const std::string& seed) const {
    const std::string program = (layout.build / "bin" / "course").string();
    std::vector<std::string> words = joined({program}, grading(table, {"--seed", seed}));
    std::vector<char*> pointers;
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    const std::string log = (path() / "killed.log").string();
    const pid_t judge = fork();
    if (judge == 0) {
      if (std::freopen(log.c_str(), "w", stdout) == nullptr) _exit(126);
      execv(program.c_str(), pointers.data());
      _exit(127);
    }
    for (int i = 0; i < 6000 && rows(table) < 5; ++i) {  // at most ten minutes
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
    kill(judge, SIGKILL);
    waitpid(judge, nullptr, 0);
  }
  static std::size_t rows(const fs::path& table) {
    return fs::exists(table) ? read_table(table).rows.size() : 0;
  }
};

std::map<std::string, Row> rows_by_id(const fs::path& csv) {
  std::map<std::string, Row> rows;
  for (const Row& row : read_table(csv).rows) rows[field(row, "id")] = row;
  return rows;
}

void check_grades(const Term& term, const fs::path& csv) {
  const auto rows = rows_by_id(csv);
  REQUIRE(rows.size() == term.handed.size());
  for (std::size_t i = 0; i < term.handed.size(); ++i) {
    const Work& work = term.handed[i];
    const Row& row = rows.at(term.ids[i]);
    CAPTURE(term.ids[i]);
    CHECK((field(row, "variance total") == "100") == work.variance_is_right);
    CHECK((field(row, "independent total") == "100") == work.independent_is_right);
  }
}

}  // namespace

TEST_CASE("a term, from the handout to the grades", "[.term]") {
  const Term term;
  for (const auto& entry : fs::recursive_directory_iterator(term.handout)) {
    CHECK(!contains(entry.path().string(), "solutions"));
  }

  // Killed and resumed.
  const fs::path grades = term.csv();
  term.grade_and_kill(grades, "7");
  const std::size_t before = Term::rows(grades), handed_in = term.handed.size();
  CHECK(before >= 5);
  CHECK(before < handed_in);
  const fs::path pages = term.path() / "pages";
  REQUIRE_RUN(resumed, term.run(term.grading(grades, {"--resume", "--html", pages.string()})));
  CHECK(contains(resumed.output,
                 fmt::format("{} judged, {} already judged; seed 7", handed_in - before, before)));
  check_grades(term, grades);
  CHECK(contains(resumed.output, "handout of version 0.9, judged by"));
  CHECK(contains(resumed.output, ": student 02, student 05, student 08,"));

  // One student hands in again: the others are not judged again.
  term.hand_in_folder(term.path() / "class" / term.ids[3], term.handed[0]);
  const auto again = term.run(term.grading(grades, {"--resume"}));
  CHECK(contains(again.output, fmt::format("1 judged, {} already judged", handed_in - 1)));
  CHECK(field(rows_by_id(grades).at(term.ids[3]), "variance total") == "100");

  // With the roster, an absent student has a row, a late one the mark and the time, and no
  // submission is judged again.
  const fs::path roster = term.path() / "roster.csv";
  std::string people = "id,name,email,Status,Last modified (submission)\n";
  for (int i = 1; i <= students; ++i) {
    people += fmt::format("student {0:02},Name {0},s{0}@example.edu,Submitted{1},\n", i,
                          i == 5 ? " - 2 days late,2026-05-04 12:00" : ",-");
  }
  write_text(roster, people);
  const std::vector<std::string> go_on{"--resume", "--roster", roster.string(), "--html",
                                       pages.string()};
  const auto rostered = term.run(term.grading(grades, go_on));
  CHECK(contains(rostered.output, fmt::format("1 judged, {} already judged", handed_in)));
  CHECK(contains(rostered.output, "without a submission: student 30"));
  CHECK(field(rows_by_id(grades).at("student 30"), "variance status") == "no file");
  for (const auto& [id, row] : rows_by_id(grades)) {
    CHECK((field(row, "late") == "LATE") == (id == "student 05"));
    CHECK(contains(field(row, "submitted"), "(file time)") ==
          (id != "student 05" && id != "student 30"));
  }
  CHECK(field(rows_by_id(grades).at("student 05"), "submitted") == "2026-05-04 12:00");

  // An older version had a check that failed a right answer: it is judged again, and what the
  // instructor corrected by hand stays.
  auto older = read_verdict(grades, "student 02");
  REQUIRE(older);
  older->version = "older";
  CheckResult& check = older->labs.at(0).checks.at(0);
  check.status = Status::failed;
  check.report = "measured  what the check got wrong";
  write_text(verdict_file(grades, "student 02"), verdict_to_json(*older));
  const std::string mended = check.check.name;
  write_text(term.path() / "corrections.csv",
             "id,what,points,comment\nstudent 03,1,50,a typo\nstudent 06,variance written,17,\n"
             "student 05," +
                 csv_field(mended) + ",1.5,right idea\n");
  const auto fixed = term.run(term.grading(grades, go_on));
  CHECK(contains(fixed.output, fmt::format("1 judged, {} already judged", handed_in)));
  const auto rows = rows_by_id(grades);
  REQUIRE(rows.size() == students);
  CHECK(field(rows.at("student 02"), "variance total") == "100");
  CHECK(field(rows.at("student 03"), "variance total") == "50");
  CHECK(field(rows.at("student 05"), "variance total") == "1.5");
  CHECK(field(rows.at("student 06"), "variance total") == "117");

  // Feedback for all.
  const fs::path feedback = term.path() / "feedback";
  const auto returned = term.run(
      {"feedback", grades.string(), "--out", feedback.string(), "--roster", roster.string()});
  CHECK(contains(returned.output, fmt::format("{} students, a page and a text", students)));
  CHECK(contains(read_text(feedback / "students" / "student 05.html"),
                 "submitted 2026-05-04 12:00 LATE"));

  // Every number on the class's page and in the feedback is in the table or in a verdict.
  check_numbers_of_class(read_text(pages / "index.html"), grades);
  for (const auto& [id, row] : rows) {
    CAPTURE(id);
    const std::string page = read_text(feedback / "students" / (id + ".html"));
    const std::string text = read_text(feedback / "students" / (id + ".txt"));
    const auto judged = read_verdict(grades, id);
    REQUIRE(judged);
    CHECK(fs::exists(pages / "submissions" / (id + ".html")));
    CHECK(contains(page, fmt::format("{:g} of {:g} points", judged->earned(), judged->points())));
    CHECK(contains(page, html_escaped(field(row, "corrections"))));
    for (const LabVerdict& lab : judged->labs) {
      double sum = 0;
      for (const CheckResult& result : lab.checks) {
        sum += result.earned();
        const bool is_corrected = id == "student 05" && result.check.name == mended;
        CHECK(field(row, result.check.name) ==
              (is_corrected ? "1.5" : fmt::format("{:g}", result.earned())));
      }
      const std::string earned = fmt::format("{:g} of {:g} points", sum, lab.points());
      CHECK(contains(page, html_escaped(lab.lab.title()) + ": " + earned));
      CHECK(contains(text, earned));
      const bool is_changed = lab.lab.number == 1 && !field(row, "corrections").empty();
      CHECK((field(row, lab.lab.name + " total") == fmt::format("{:g}", sum)) != is_changed);
    }
  }
}

}  // namespace mc::tests::term
