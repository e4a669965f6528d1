// The hours that students report with their answers, from the file to the statistics.

#include "grader/submission/hours.hpp"
#include "tests/gradebook/course.hpp"

namespace mc::tests::reported_hours {

namespace {

/// What is read from these answers; "none" if it is nothing.
std::string hours_from(const std::string& answers) {
  Course course;
  course.hand_in("ada", "int x;\n");
  course.write("class/ada/answers/1-variance.md", answers);
  Submission submission = open_submission(course.labs, course.path() / "class/ada");
  read_hours(course.labs, submission);
  const auto& hours = submission.delivery.hours;
  return hours.empty() ? "none" : hours.at("variance");
}

}  // namespace

TEST_CASE("hours are the text after the colon of the last line that begins with Hours") {
  CHECK(hours_from("# Answers\nHours that I spent (no points): 7.5 h \r\n") == "7.5 h");
  CHECK(hours_from("Hours: 3\nHours of thought\nHours: **4**") == "4");
  CHECK(hours_from("Hours that I spent:\n") == "none");
  CHECK(hours_from("hours: 3\n") == "none");
  CHECK(hours_from("Hours: \x1b[31m" + std::string(500, '9')).size() < 30);
  CHECK(hours_from("Hours: 5\n" + std::string(2 << 20, 'x')) == "none");  // longer than a source
}

TEST_CASE("answers are next to a file or its starter directory, and links are not followed") {
  Course course;
  const fs::path place = course.path() / "clone";
  course.write("clone/starter/variance.cpp", "int x;\n");
  course.write("clone/secret.md", "Hours: 9\n");
  const auto hours = [&] {
    Submission submission = open_submission(course.labs, place / "starter");
    read_hours(course.labs, submission);
    return submission.delivery.hours["variance"];
  };
  course.write("clone/answers/1-variance.md", "Hours: 8\n");
  CHECK(hours() == "8");
  fs::remove(place / "answers/1-variance.md");
  fs::create_symlink(place / "secret.md", place / "answers/1-variance.md");
  CHECK(hours().empty());
  fs::remove_all(place / "answers");
  course.write("clone/elsewhere/1-variance.md", "Hours: 9\n");
  fs::create_directory_symlink(place / "elsewhere", place / "answers");
  CHECK(hours().empty());
}

TEST_CASE("grade keeps reported hours, and stats prints their median and quartiles") {
  Course course;
  const auto report = [&](const std::string& id, const std::string& hours) {
    course.write("class/" + id + "/answers/1-variance.md", "Hours: " + hours + '\n');
  };
  course.hand_in_tiny(9);
  const fs::path csv = course.csv(), pages = course.path() / "pages";
  course.graded({"--seed", "1"});
  CHECK(!contains(read_text(csv), "variance hours"));  // no student reports any
  CHECK(!contains(course.run({"stats", csv}).output, "hours"));
  const char* const said[] = {"4", "10", "5 h", "8 hours", "0", "200.5", "=9", "-1"};
  for (int i = 0; i < 8; ++i) report(fmt::format("s{:02}", i), said[i]);
  const auto again = course.grade({"--csv", csv, "--resume"});
  CHECK(contains(again.output, "0 judged, 9 already judged"));
  const Table table = read_table(csv);
  REQUIRE(table.rows.size() == 9);
  CHECK(field(table.rows[2], "variance hours") == "5 h");
  CHECK(contains(read_text(csv), "'=9"));  // not a formula
  // 0, 4, 5, 8, 10: the quartiles are the second and the fourth.
  const std::string line = "hours: 5 reported, median 5, quartiles 4 and 8; 3 unusable";
  CHECK(contains(course.run({"stats", csv}).output, line));
  report("s08", "6");  // 0, 4, 5, 6, 8, 10: a quarter of the way from 4 to 5, from 8 to 6
  course.graded({"--resume", "--html", pages});
  CHECK(contains(read_text(pages / "index.html"),
                 "hours: 6 reported, median 5.5, quartiles 4.25 and 7.5; 3 unusable"));
}

}  // namespace mc::tests::reported_hours
