// A whole term: a handout, solved by thirty students, submitted in three ways, graded by a judge
// that is killed in the middle, by two machines, shown, and graded again.
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
#include "grader/gradebook/book.hpp"
#include "grader/gradebook/table.hpp"
#include "runner/text.hpp"
#include "tests/gradebook/course.hpp"
#include "tests/text.hpp"

namespace mc::tests::term {

namespace fs = std::filesystem;
using namespace grader;

namespace {

constexpr int students = 30;

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

/// Thirty: correct in the repository's and in other ways, with one mistake, unwritten, not C++.
/// Eight of them also have work on lab 2.
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
    if (all.size() == students) break;
    all.push_back({self_contained(layout, mistake), "", false, false});
  }
  REQUIRE(all.size() == students);
  return all;
}

/// A course with a handout, and all submissions in `class`.
struct Term : Course {
  std::vector<Work> handed = works(layout);
  fs::path handout = path() / "handout";

  /// The first `count` submissions.
  explicit Term(std::size_t count = students) {
    handed.resize(count);
    const auto written = run({"handout", handout.string(), "--labs", "1,2"});
    INFO(written.errors);
    REQUIRE(written.exit_code == 0);
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
  /// As `./lab submit` creates it.
  void hand_in_zip(const fs::path& place, const Work& work) const {
    hand_in_folder(place, work);
    std::vector<std::string> command{
        "cmake", "-E", "tar", "cf", place.string() + ".zip", "--format=zip", "variance.cpp"};
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
    const auto done = sandbox::run_process(command, {.directory = directory});
    INFO(done.errors);
    REQUIRE(done.succeeded());
  }

  std::vector<std::string> grading(const fs::path& table,
                                   const std::vector<std::string>& more) const {
    std::vector<std::string> words{
        "grade", (path() / "class").string(), "--lab", "1,2", "--csv", table.string()};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }

  /// Starts grading, and kills it after a few rows.
  void grade_and_kill(const fs::path& table, const std::string& seed) const {
    const std::string program = (layout.build / "bin" / "course").string();
    std::vector<std::string> words = grading(table, {"--seed", seed});
    words.insert(words.begin(), program);
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

/// A table without what differs between runs: seconds.
std::string without_seconds(const fs::path& csv) {
  Table table = read_table(csv);
  for (Row& row : table.rows) row.erase("seconds");
  return table_text(table);
}

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
  const std::size_t before = Term::rows(grades);
  CHECK(before >= 5);
  CHECK(before < students);
  const fs::path pages = term.path() / "pages";
  const auto resumed = term.run(term.grading(grades, {"--resume", "--html", pages.string()}));
  INFO(resumed.output << resumed.errors);
  REQUIRE(resumed.exit_code == 0);
  CHECK(contains(resumed.output,
                 fmt::format("{} judged, {} were before; seed 7", students - before, before)));
  check_grades(term, grades);

  // The statistics and the page of each student.
  const auto stats = term.run({"stats", grades.string()});
  CHECK(stats.exit_code == 0);
  // Two handed in the starter, one no C++.
  CHECK(contains(stats.output, fmt::format("Lab 1 · variance: {} attempts", students - 3)));
  CHECK(contains(stats.output, "2 not attempted, 1 not compiling"));
  CHECK(contains(stats.output, "Hints, by the submissions"));
  CHECK(fs::exists(pages / "index.html"));
  for (const std::string& id : term.ids) {
    CHECK(fs::exists(pages / "submissions" / (id + ".html")));
  }

  // One student hands in again: the others are not judged again.
  term.hand_in_folder(term.path() / "class" / term.ids[3], term.handed[0]);
  const auto late = term.run(term.grading(grades, {"--resume"}));
  CHECK(contains(late.output, fmt::format("1 judged, {} were before", students - 1)));
  CHECK(field(rows_by_id(grades).at(term.ids[3]), "variance total") == "100");

  // With the roster, an absent student has a row, and no submission is judged again.
  const fs::path roster = term.path() / "roster.csv";
  std::string people = "id,name,email\n";
  for (int i = 1; i <= students + 1; ++i) {
    people += fmt::format("student {0:02},Name {0},s{0}@example.edu\n", i);
  }
  write_text(roster, people);
  const std::vector<std::string> go_on{"--resume", "--roster", roster.string(), "--html",
                                       pages.string()};
  const auto rostered = term.run(term.grading(grades, go_on));
  CHECK(contains(rostered.output, fmt::format("1 judged, {} were before", students)));
  CHECK(contains(rostered.output, "without a submission: student 31"));
  CHECK(field(rows_by_id(grades).at("student 31"), "variance status") == "no file");

  // A check was fixed since this verdict: it is judged again, and the correction by hand stays.
  write_text(term.path() / "corrections.csv", "id,what,points,comment\nstudent 03,1,50,a typo\n");
  const fs::path verdict = verdict_file(grades, "student 02");
  std::string older = read_text(verdict);
  const std::string version = "\"version\": \"";
  REQUIRE(contains(older, version));
  older.insert(older.find(version) + version.size(), "older than ");
  write_text(verdict, older);
  const auto fixed = term.run(term.grading(grades, go_on));
  CHECK(contains(fixed.output, fmt::format("1 judged, {} were before", students)));
  CHECK(field(rows_by_id(grades).at("student 03"), "variance total") == "50");

  // Feedback for all. Each total is the sum of its checks, and is in the page and in the verdict.
  const fs::path feedback = term.path() / "feedback";
  const auto returned = term.run(
      {"feedback", grades.string(), "--out", feedback.string(), "--roster", roster.string()});
  CHECK(contains(returned.output, fmt::format("{} students, a page and a text", students + 1)));
  const std::string index = read_text(pages / "index.html");
  for (const auto& [id, row] : rows_by_id(grades)) {
    CAPTURE(id);
    double sum = 0;
    for (const auto& [column, points] : row) {
      if (is_check_column(column) && column[0] == '1') sum += std::stod(points);
    }
    const std::string total = field(row, "variance total");
    CHECK(contains(index, ">" + id + "<"));
    const std::string text = read_text(feedback / "students" / (id + ".txt"));
    CHECK(contains(text, fmt::format("{:g} of 100", sum)));
    if (id != "student 03") CHECK(total == fmt::format("{:g}", sum));
    const auto judged = read_verdict(grades, id);
    REQUIRE(judged);
    CHECK(judged->labs.at(0).earned() == sum);
  }
}

TEST_CASE("two machines give the same grades as one", "[.term-shards]") {
  const Term term(12);
  const fs::path grades = term.csv();
  REQUIRE(term.run(term.grading(grades, {"--seed", "7"})).exit_code == 0);
  check_grades(term, grades);
  std::vector<std::string> merging{"merge"};
  for (const std::string shard : {"1/2", "2/2"}) {
    const fs::path part = term.csv("part" + shard.substr(0, 1));
    REQUIRE(term.run(term.grading(part, {"--seed", "7", "--shard", shard})).exit_code == 0);
    merging.push_back(part.string());
  }
  const fs::path merged = term.csv("merged");
  merging.insert(merging.end(), {"--out", merged.string()});
  CHECK(term.run(merging).exit_code == 0);
  CHECK(without_seconds(merged) == without_seconds(grades));
}

}  // namespace mc::tests::term
