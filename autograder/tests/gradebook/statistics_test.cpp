// Statistics of a class, compared with values computed by hand.
#include <algorithm>
#include <cmath>

#include "grader/gradebook/book.hpp"
#include "grader/gradebook/class_page.hpp"
#include "grader/gradebook/statistics.hpp"
#include "grader/reports/report.hpp"
#include "grader/reports/verdict_json.hpp"
#include "runner/text.hpp"
#include "tests/gradebook/course.hpp"
#include "tests/gradebook/page_cells.hpp"

namespace mc::tests::class_statistics {

namespace {

const std::vector<Lab> two_labs{{1, "variance", "1-variance", {}}, {5, "halton", "5-halton", {}}};

/// With points in the table alone.
CheckResult result_of(const std::string& name, Status status, const std::string& report = "") {
  CheckResult result = tests::result_of(name, status, report);
  result.check.points = 0;
  return result;
}

Verdict verdict_on(const std::string& id, std::vector<CheckResult> results) {
  Verdict verdict;
  verdict.submission = id;
  verdict.seed = 7;
  verdict.version = "1.0";
  verdict.labs = {verdict_of(std::move(results))};
  return verdict;
}

/// "passed wrong waiting withheld not-written"
std::string counts(const CheckStatistics& one) {
  return fmt::format("{} {} {} {} {}", one.passed, one.wrong, one.waiting, one.withheld,
                     one.not_written);
}

/// The labs of a table with this text and these verdicts.
std::vector<LabStatistics> labs_in(const std::string& csv,
                                   const std::vector<Verdict>& verdicts = {}) {
  const Scratch place;
  std::map<std::string, Verdict> by_id;
  for (const Verdict& verdict : verdicts) by_id[verdict.submission] = verdict;
  return statistics_of(read_table(place.write("g.csv", csv)), by_id, two_labs).labs;
}

/// Six people, of whom four attempted the lab; bob wrote 1.1 but not 1.2.
struct SmallClass : Scratch {
  fs::path csv = write("g.csv",
                       "id,seed,version,seconds,reason,variance status,variance total,1.1 a,1.1 b,"
                       "1.2 c\n"
                       "ada,7,1.0,1,,judged,100,50,30,20\n"
                       "bob,7,1.0,1,,judged,50,50,0,0\n"
                       "cy,7,1.0,1,,\"no file\",0,0,0,0\n"
                       "dee,7,1.0,1,,judged,30,0,30,0\n"
                       "eve,7,1.0,1,,judged,80,50,30,0\n"
                       "fay,7,1.0,1,\"not judged: disk\",\"not judged\",,,,\n");
  SmallClass() {
    fs::create_directories(verdict_directory(csv));
    const std::string hint = "measured  1\nlikely    it divides by n\nread      x";
    keep(verdict_on("ada", {result_of("1.1 a", Status::passed, "likely    nothing")}));
    keep(verdict_on("bob", {result_of("1.1 b", Status::failed, hint),
                            result_of("1.2 c", Status::not_written)}));
    keep(
        verdict_on("eve", {result_of("1.1 b", Status::failed, hint),
                           result_of("1.2 c", Status::failed, hint + "\nlikely    it <b>rounds")}));
    keep(verdict_on("dee", {result_of("1.2 c", Status::not_written)}));
  }
  void keep(const Verdict& verdict) const {
    write_text(verdict_file(csv, verdict.submission), verdict_to_json(verdict));
  }
  ClassStatistics statistics() const {
    const Table table = read_table(csv);
    return statistics_of(table, read_verdicts(table), two_labs);
  }
};

}  // namespace

TEST_CASE("the point-biserial correlation, and when it is undefined") {
  // Means 4 and 1.5, squares 10: 2.5 sqrt(3 * 2 / 5) / sqrt(10) = sqrt(0.75)
  CHECK(*point_biserial({true, true, false, false, true}, {5, 3, 2, 1, 4}) ==
        Approx(std::sqrt(0.75)));
  CHECK(*point_biserial({true, false}, {1, 2}) == Approx(-1));
  CHECK(*point_biserial({true, false, true, false}, {1, 1, 2, 2}) == Approx(0).margin(1e-15));
  CHECK(!point_biserial({true, true}, {1, 2}));
  CHECK(!point_biserial({false, false}, {1, 2}));
  CHECK(!point_biserial({true, false}, {0.1, 0.1}));
  CHECK(!point_biserial({}, {}));
}

TEST_CASE(
    "statistics are over attempts, and count the rest by kind; hints count once per student") {
  const ClassStatistics statistics = SmallClass().statistics();
  REQUIRE(statistics.labs.size() == 1);  // there is no column for halton
  const std::string page = statistics_page(statistics);
  CHECK(contains(page, "Statistics of 6 submissions"));
  CHECK(contains(page, "4 attempts; mean 65.0, median 65<br>1 not attempted, 1 not judged</p>"));
  // Task 1.1: 80 points; 80, 50, 30 and 80 of them. Task 1.2: 20 points, earned once.
  CHECK(cells_after(page, ": tasks\"") == Cells{{"1.1", "75 %", "2"}, {"1.2", "25 %", "1"}});
  // 1.1 a: passed by ada, bob, eve with 50, 0, 30 of the rest, not by dee with 30: means 26.7 and
  // 30, squares 1275, so -3.33 sqrt(3/4) / sqrt(1275). In the same way the others.
  CHECK(cells_after(page, ": checks\"") == Cells{{"1.1 a", "3", "1", "0", "0", "0", "-0.08"},
                                                 {"1.1 b", "3", "1", "0", "0", "0", "-0.17"},
                                                 {"1.2 c", "1", "1", "0", "0", "2", "0.54"}});
  CHECK(cells_after(page, "\"hints\"") ==
        Cells{{"it divides by n", "2"}, {"it &lt;b&gt;rounds", "1"}});
  const Cells bars = cells_after(page, "<h3>Points");
  REQUIRE(bars.size() == 12);
  CHECK(bars[3] == std::vector<std::string>{"30+", "1", ""});
  CHECK(bars[10] == std::vector<std::string>{"100", "1", ""});
}

TEST_CASE("waiting, withheld, not compiling and not begun are different from wrong") {
  const LabStatistics lab = labs_in(
                                "id,variance status,variance total,1.1 a,1.2 b\n"
                                "ada,judged,0,0,0\nbob,judged,0,0,0\n"
                                "cy,\"no program\",0,0,0\ndee,\"no program\",91,0,0\n",
                                {verdict_on("ada", {result_of("1.1 a", Status::withheld),
                                                    result_of("1.2 b", Status::waiting)}),
                                 verdict_on("bob", {result_of("1.1 a", Status::not_written),
                                                    result_of("1.2 b", Status::not_written)})})
                                .at(0);
  CHECK(lab.totals == std::vector<double>{0, 91});  // dee's was corrected by hand
  CHECK(other_submissions(lab) == "1 not attempted, 1 not compiling");
  CHECK(counts(lab.checks[0]) == "0 0 0 1 0");
  CHECK(counts(lab.checks[1]) == "0 0 1 0 0");
}

TEST_CASE("a check worth no points counts as passed if its verdict says so") {
  const auto labs =
      labs_in("id,variance status,variance total,1.1 a\nada,judged,0,0\nbob,judged,0,0\n",
              {verdict_on("ada", {result_of("1.1 a", Status::passed)}),
               verdict_on("bob", {result_of("1.1 a", Status::failed)})});
  CHECK(counts(labs.at(0).checks.at(0)) == "1 1 0 0 0");
}

TEST_CASE("a check or a lab that a row's table lacks does not count for that row") {
  const auto checks = labs_in(
                          "id,variance status,variance total,1.1 a,1.2 b\n"
                          "ada,judged,3,1,2\nbob,judged,0,0,0\ncy,judged,9,,9\n")[0]
                          .checks;
  CHECK(counts(checks[0]) == "1 1 0 0 0");
  CHECK(*checks[0].discrimination == Approx(1));  // only ada and bob
  const auto labs = labs_in(
      "id,variance status,variance total,halton status,halton total,1.1 a,5.1 b\n"
      "ada,judged,0,\"no file\",,0,\nbob,\"no file\",,judged,7,,7\ncy,unreadable,,unreadable,,,\n");
  REQUIRE(labs.size() == 2);
  CHECK(labs[0].totals == std::vector<double>{0});
  CHECK(labs[1].totals == std::vector<double>{7});
  CHECK(labs[1].not_judged == 1);
  CHECK(counts(labs[0].checks[0]) == "0 1 0 0 0");
  CHECK(counts(labs[1].checks[0]) == "1 0 0 0 0");
}

TEST_CASE("without verdicts, unwritten tasks count as wrong, and the report says so") {
  SmallClass place;
  place.keep(verdict_on("bob", {result_of("1.2 c", Status::not_written)}));
  Verdict older = verdict_on("dee", {result_of("1.2 c", Status::not_written)});
  older.seed = 8;  // a verdict that does not belong to the row
  place.keep(older);
  Verdict newer = verdict_on("eve", {});
  newer.version = "1.1";
  place.keep(newer);
  CHECK(counts(place.statistics().labs[0].checks[2]) == "1 2 0 0 1");
  CHECK(place.statistics().without_verdict == 4);
  fs::remove_all(verdict_directory(place.csv));
  const auto statistics = place.statistics();
  CHECK(counts(statistics.labs[0].checks[2]) == "1 3 0 0 0");
  CHECK(statistics.hints.empty());
  CHECK(contains(report_statistics(statistics), "6 of them have no verdict next to the table"));
  CHECK(contains(statistics_page(statistics), "6 of 6 submissions have no verdict"));
}

TEST_CASE("a histogram has ten bars, one for all points, and one for more") {
  const auto ranges = [](const std::vector<double>& totals, double points) {
    std::string counted;
    for (const PointsBar& bar : histogram_of(totals, points)) {
      counted += fmt::format("{}:{} ", bar.range, bar.submissions);
    }
    return counted;
  };
  CHECK(ranges({0, 9.5, 10, 99.5, 100, 104, -3}, 100) ==
        "0+:3 10+:1 20+:0 30+:0 40+:0 50+:0 60+:0 70+:0 80+:0 90+:1 100:1 >100:1 ");
  CHECK(ranges({20, 19, 2}, 20) ==
        "0+:0 2+:1 4+:0 6+:0 8+:0 10+:0 12+:0 14+:0 16+:0 18+:1 20:1 >20:0 ");
  CHECK(center_of({}).empty());
  CHECK(center_of({1, 2, 4, 9}) == "mean 4.0, median 3");
}

TEST_CASE("statistics fit 80 columns, for large classes and long names") {
  ClassStatistics statistics;
  statistics.submissions = statistics.without_verdict = 100'000;
  LabStatistics lab;
  lab.lab = two_labs[0];
  lab.totals.assign(99'999, 42.0);
  lab.not_attempted = lab.not_compiled = lab.not_judged = 100'000;
  lab.totals.push_back(7);
  std::string name = "1.1 the";
  for (int i = 0; i < 20; ++i) name += " variance";
  lab.checks = {{name, 100'000, 100'000, 100'000, 100'000, 100'000, -0.5}};
  lab.tasks = {{"1.10", {name}, 7, 1, 100'000}};
  statistics.labs = {lab};
  statistics.hints = {{name, 100'000}};
  const std::string text = report_statistics(statistics);
  for (const auto line : text::split(text, '\n')) CHECK(columns_of(line) <= 80);
  CHECK(contains(text, "0+      1  #\n"));  // a single one is visible among very many
  CHECK(contains(text, "-0.50  1.1 the variance"));
}

TEST_CASE("stats of a graded class, as text and as a page without names") {
  Course course;
  course.hand_in_tiny(5);
  course.graded({"--seed", "1"});
  const fs::path csv = course.csv(), page = course.path() / "stats.html";
  const std::string output = course.output_of({"stats", csv, "--html", page});
  CHECK(contains(output, "Lab 1 · variance: 0 attempts\n  1 not attempted, 4 not compiling"));
  const std::string html = read_text(page);
  CHECK(contains(html, "1 not attempted, 4 not compiling"));
  CHECK(!contains(html, "s03"));
  for (const char* wrong : {"/no/such.csv", "/"}) check_refused(course.run({"stats", wrong}));
  check_refused(course.run({"stats", csv, "--html", "/no/such/place/x.html"}));
  for (const std::string points : {"ten", "nan", "1e999", "2;5"}) {
    write_text(csv, "id,variance total,1.1 a\nada," + points + ",1\n");
    check_refused(course.run({"stats", csv}), "'" + points + "' of ada is not a number of points");
  }
}

}  // namespace mc::tests::class_statistics
