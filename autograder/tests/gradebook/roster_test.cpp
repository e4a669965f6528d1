// Every student has a row, whatever platform the list and the submissions come from.

#include "grader/gradebook/roster.hpp"
#include "tests/gradebook/course.hpp"

namespace mc::tests::roster {

namespace {

/// "anna Anna Ash anna@x.edu #7; …"
std::string summary(const Roster& roster) {
  std::string all;
  for (const Person& one : roster.people) {
    all += fmt::format("{}{} {} {} #{}", all.empty() ? "" : "; ", one.id, one.name, one.email,
                       one.number);
  }
  return all;
}

IntakeEntry handed_in(const std::string& id, const Delivery& delivery = {}) {
  IntakeEntry entry;
  entry.submission.label = id;
  entry.submission.delivery = delivery;
  return entry;
}

/// The ids after matching, and who is missing on either side.
std::string matched(const Roster& roster, std::vector<IntakeEntry> entries) {
  const RosterReport report = match_roster(roster, entries);
  std::vector<std::string> ids;
  for (const IntakeEntry& one : entries) ids.push_back(one.submission.label);
  return fmt::format("{} | {} | {}", fmt::join(ids, ","), fmt::join(report.not_on_roster, ","),
                     fmt::join(report.without_submission, ","));
}

}  // namespace

TEST_CASE("rosters of Canvas, Moodle, Gradescope and GitHub Classroom are read by their columns") {
  const Scratch place;
  const auto read = [&](const std::string& text) {
    return summary(read_roster(place.write("r.csv", text)));
  };
  const std::string expected = "anna7 Anna Ash anna@x.edu #";
  CHECK(read("id,name,email\nanna7,Anna Ash,anna@x.edu\n") == expected);
  CHECK(read("\xef\xbb\xbfStudent,ID,SIS User ID,SIS Login ID,Section,Lab 1 (99)\r\n"
             "    Points Possible,,,,,100\r\n\"Ash, Anna\",4711,anna7,anna@x.edu,S1,\r\n"
             "\"Student, Test\",1,t,t@x.edu,S1,\r\n") == expected + "4711");
  CHECK(read("Identifier,Full name,ID number,Email address,Status,Grade,Last modified (grade)\n"
             "Participant 123,Anna Ash,anna7,anna@x.edu,-,-,-\n") == expected + "123");
  CHECK(read("First name,Surname,ID number,Email address\nAnna,Ash,anna7,anna@x.edu\n") ==
        expected);
  CHECK(read("First Name,Last Name,SID,Email,Role\nAnna,Ash,anna7,anna@x.edu,Student\n"
             "Ina,Ink,9,ina@x.edu,Instructor\n") == expected);
  CHECK(read("\"identifier\",\"github_username\",\"github_id\",\"name\"\nanna7,ash,1,Anna Ash\n") ==
        "anna7 Anna Ash  #");
  CHECK_THROWS_AS(read("a,b\n1,2\n"), UsageError);
  CHECK_THROWS_AS(read("id,name\nx,A\nX,B\n"), UsageError);
  CHECK_THROWS_AS(read_roster("/no/such.csv"), UsageError);
}

TEST_CASE("submissions of every platform find their person, and none is dropped") {
  const Scratch place;
  const Roster canvas = read_roster(
      place.write("c.csv",
                  "Student,ID,SIS User ID,SIS Login ID\n\"Ash, Anna\",4711,a7,anna@x.edu\n"
                  "\"Bo, Bob\",4712,b8,bob@x.edu\n\"Cy, Cy\",4713,c9,cy@x.edu\n"));
  CHECK(matched(canvas, {handed_in("ashanna_4711"), handed_in("zoe_4999"), handed_in("b8")}) ==
        "a7,b8,c9,zoe_4999 | zoe_4999 | c9");
  CHECK(matched(canvas, {handed_in("Anna Ash (ANNA@x.edu) & Cy (cy@x.edu)"), handed_in("lab-1-bob"),
                         handed_in("a7")}) == "a7,a7 (2),b8,c9 | a7 (another submission by a7) | ");
  CHECK(matched(canvas, {handed_in("Anna Ash (anna@x.edu) & Di (di@x.edu)")}) ==
        "a7,b8,c9 | Di (di@x.edu) | b8,c9");
  // Two people of one name: the name alone does not say which.
  const Roster twins = read_roster(place.write("t.csv", "id,name\n1,Al Bo\n2,Al Bo\n"));
  CHECK(matched(twins, {handed_in("Al Bo")}) == "1,2,Al Bo | Al Bo | 1,2");
  const Roster moodle = read_roster(place.write(
      "m.csv",
      "Identifier,Full name,Email address,Status,Last modified (submission)\n"
      "Participant 12,Al Bo,al@x.edu,Submitted for grading - 2 days late,\"Friday, 2 May\"\n"));
  std::vector<IntakeEntry> entries{handed_in("Al Bo_12")};
  match_roster(moodle, entries);
  const Delivery& delivery = entries.at(0).submission.delivery;
  CHECK(delivery.late);
  CHECK(delivery.submitted == "Friday, 2 May");
}

TEST_CASE("a graded roster has a row for everyone") {
  Course course;
  course.hand_in("anna", "int 1;\n");
  course.hand_in("zoe", "int 2;\n");
  const fs::path roster = course.path() / "roster.csv";
  write_text(roster, "id,name,email\nanna,Anna Ash,anna@x.edu\nbob,Bob Bo,bob@x.edu\n");
  REQUIRE_RUN(run, course.grade({"--csv", course.csv(), "--roster", roster, "--seed", "1"}));
  check_contains(run.output, {"without a submission: bob", "not on the roster: zoe"});
  const Table table = read_table(course.csv());
  REQUIRE(table.rows.size() == 3);
  const Row &anna = table.rows[0], &bob = table.rows[1];
  CHECK(anna.at("name") == "Anna Ash");
  CHECK(anna.at("variance status") == "no program");
  CHECK(contains(anna.at("submitted"), "(file time)"));
  CHECK(bob.at("email") == "bob@x.edu");
  CHECK(bob.at("variance status") == "no file");
  CHECK(bob.at("variance total") == "0");
  CHECK(table.rows[2].at("id") == "zoe");
  // A corrected name does not judge anyone again.
  write_text(roster, "id,name,email\nanna,Anna Oak,anna@x.edu\nbob,Bob Bo,bob@x.edu\n");
  const auto again = course.grade({"--csv", course.csv(), "--roster", roster, "--resume"});
  CHECK(contains(again.output, "0 judged, 3 already judged"));
  CHECK(field(read_table(course.csv()).rows[0], "name") == "Anna Oak");
}

TEST_CASE("Canvas's LATE mark and Gradescope's time become columns, from zips too") {
  Course course;
  course.write("class/roe_LATE_4712_993_variance.cpp", "int 1;\n");
  course.write("class/doe_4711_991_variance.cpp", "int 2;\n");
  Table table = course.graded({"--seed", "1"});
  REQUIRE(table.rows.size() == 2);
  CHECK(field(table.rows[0], "late") == "");
  CHECK(field(table.rows[1], "late") == "LATE");

  course.write("in/submission_11/variance.cpp", "int 3;\n");
  course.write("in/submission_12/variance.cpp", "int 3;\n");
  course.write("in/submission_metadata.yml",
               "---\nsubmission_11:\n  :submitters:\n  - :name: Jane Doe\n"
               "    :email: jane@example.edu\n  :created_at: 2026-01-02 03:04:05.170614000 Z\n"
               "  :history:\n  - :id: 5\n    :created_at: 2025-01-01 00:00:00 Z\n");
  const fs::path zip = course.path() / "export.zip";
  zip_content({.directory = course.path() / "in", .zip = zip});
  course.output_of({"grade", zip, "--lab", "1", "--csv", course.csv()});
  table = read_table(course.csv());
  REQUIRE(table.rows.size() == 2);
  CHECK(field(table.rows[0], "id") == "Jane Doe (jane@example.edu)");
  CHECK(field(table.rows[0], "submitted") == "2026-01-02 03:04:05");
}

TEST_CASE("a lone lab can be judged with the reference's earlier labs") {
  Course course;
  course.write("class/anna/independent.cpp",
               read_text(course.layout.solutions() / "independent.cpp"));
  const auto graded = [&](const Words& more) {
    const std::string output =
        course.output_of(joined({"grade", course.path() / "class" / "anna", "--lab", "2", "--csv",
                                 course.csv(), "--no-plots"},
                                more));
    const Row row = read_table(course.csv()).rows.at(0);
    return std::pair(output, row);
  };
  CHECK(graded({}).second.at("independent total") == "0");
  const auto [output, row] = graded({"--with-reference"});
  CHECK(contains(output, "judged with the reference's variance"));
  CHECK(row.at("independent total") == "100");
  CHECK(row.at("independent status") == "judged on reference");
}

}  // namespace mc::tests::roster
