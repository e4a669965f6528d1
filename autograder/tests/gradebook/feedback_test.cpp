// What goes back to students and platforms.

#include "tests/gradebook/course.hpp"

namespace mc::tests::feedback {

namespace {

/// A class of a Canvas download, graded; anna fails, bob did not hand in.
struct CanvasClass : Course {
  fs::path roster = path() / "roster.csv", out = path() / "feedback";
  CanvasClass() {
    write("class/ashanna_LATE_4711_991_variance-1.cpp", text_with_mistake(layout));
    write("class/zoe_4999_992_variance.cpp", "int 7;\n");
    write("roster.csv",
          "Student,ID,SIS User ID,SIS Login ID,Section,Variance (88),Final\n"
          "    Points Possible,,,,,100,\n\"Ash, Anna\",4711,a7,anna@x.edu,S1,,\n"
          "\"Bo, Bob\",4712,b8,bob@x.edu,S1,,\n");
    write("corrections.csv", "id,what,points,comment\na7,variance,91,a typo\n");
    REQUIRE_RUN(run, grade({"--csv", csv(), "--roster", roster, "--seed", "7"}));
  }
};

}  // namespace

TEST_CASE("feedback goes back by name, without anything of the grading machine") {
  const CanvasClass course;
  const fs::path students = course.out / "students";
  const std::string output =
      course.output_of({"feedback", course.csv(), "--out", course.out, "--roster", course.roster});
  CHECK(contains(output, "3 students, a page and a text each; 2 pages named for upload"));
  const std::string page = read_text(students / "a7.html"), text = read_text(students / "a7.txt");
  for (const std::string& one : {page, text}) {
    check_contains(one, {"./lab check variance --only 1.", "--seed 7", course.layout.version,
                         "variance: 91 (a typo); total of variance: 91"});
    check_lacks(one, {course.path(), course.layout.root});
  }
  CHECK(contains(page, "LATE"));
  CHECK(read_text(course.out / "canvas" / "ashanna_LATE_4711_991_variance-1.html") == page);
  CHECK(fs::exists(students / "b8.html"));
  // Canvas's columns, and its name for the assignment.
  CHECK(read_text(course.out / "canvas-grades.csv") ==
        "Student,ID,\"SIS User ID\",\"SIS Login ID\",Section,\"Variance (88)\"\n"
        "\"Ash, Anna\",4711,a7,anna@x.edu,S1,91\n\"Bo, Bob\",4712,b8,bob@x.edu,S1,0\n");
  // A later run replaces its own output, and nothing else.
  const auto again = [&] { return course.run({"feedback", course.csv(), "--out", course.out}); };
  CHECK(again().exit_code == 0);
  CHECK(fs::exists(students / "a7.html"));
  CHECK(!fs::exists(course.out / "canvas-grades.csv"));  // this run had no roster
  write_text(students / "a7.txt", text + "Well done!\n");
  check_refused(again(), "not what ./lab feedback wrote: students/a7.txt");
  CHECK(contains(read_text(students / "a7.txt"), "Well done!"));
  write_text(students / "a7.txt", text);
  write_text(course.out / "canvas.zip", "");
  check_refused(again(), "not what ./lab feedback wrote: canvas.zip");
  CHECK(fs::exists(students / "b8.html"));
}

TEST_CASE("Moodle gets its worksheet back, and pages under its names") {
  Course course;
  course.write("class/Anna Ash_12_assignsubmission_file/variance.cpp", "int 1;\n");
  const fs::path roster = course.path() / "worksheet.csv", out = course.path() / "feedback";
  const std::string header =
      "Identifier,\"Full name\",\"Email address\",Status,Grade,\"Maximum Grade\",\"Last modified "
      "(submission)\",\"Last modified (grade)\"\n";
  write_text(roster, header +
                         "Participant 12,Anna Ash,anna@x.edu,Submitted,,100,\"Friday, 2 May\",-\n"
                         "Participant 13,Bob Bo,bob@x.edu,No submission,,100,-,-\n");
  course.graded({"--roster", roster});
  course.output_of({"feedback", course.csv(), "--out", out, "--roster", roster});
  CHECK(fs::exists(out / "moodle" / "Anna Ash_12_assignsubmission_file_feedback.html"));
  CHECK(fs::exists(out / "moodle" / "Bob Bo_13_assignsubmission_file_feedback.html"));
  const auto rows = csv_rows(read_text(out / "moodle-variance.csv"));
  REQUIRE(rows.size() == 3);
  CHECK(rows[0] == csv_rows(header)[0]);
  CHECK(rows[1][0] == "Participant 12");
  CHECK(rows[1][4] == "0");
  CHECK(rows[1][7] == "-");
}

}  // namespace mc::tests::feedback
