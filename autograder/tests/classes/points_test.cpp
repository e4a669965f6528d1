// points.csv changes points without C++, and leaves tasks out everywhere.

#include "judge/judging/points.hpp"
#include "tests/classes/course.hpp"

namespace mc::tests::points {

namespace {

Check check_of(const std::string& name, double points) {
  Check check;
  check.name = name;
  check.task = name.substr(0, name.find(' '));
  check.points = points;
  return check;
}

/// "1.1 a=6 …" of a lab with three checks of 3, 1 and 5 points.
std::string points_with(const std::string& text) {
  const Scratch place;
  place.write(points_file, text);
  std::vector<Check> checks{check_of("1.1 a", 3), check_of("1.1 b", 1), check_of("1.2 c", 5)};
  apply_points(place.path(), {1, "variance", "1-variance", {}}, checks);
  std::string all;
  for (const Check& check : checks) all += fmt::format("{}={:g} ", check.name, check.points);
  return all;
}

}  // namespace

TEST_CASE("points.csv sets tasks and checks, with any total, and leaves out those with 0") {
  CHECK(points_with("") == "1.1 a=3 1.1 b=1 1.2 c=5 ");
  CHECK(points_with("what,points\n1.1,12\n") == "1.1 a=9 1.1 b=3 1.2 c=5 ");
  CHECK(points_with("1.2 c,7.5\r\n\"1.1 b\",2\r\n") == "1.1 a=3 1.1 b=2 1.2 c=7.5 ");
  CHECK(points_with("1.1,0\n") == "1.2 c=5 ");
  CHECK(points_with("1.1,0\n1.1 a,4\n") == "1.1 a=4 1.2 c=5 ");
  CHECK(points_with("2.1,3\n5.1 x,0\n") == "1.1 a=3 1.1 b=1 1.2 c=5 ");  // other labs'
  for (const char* wrong : {"1.9,4\n", "1.1\n", "1.1,-1\n", "1.1,many\n", "1.1,nan\n", "mean,4\n",
                            "task 1.1,4\n", "1,4\n", "1.,4\n"}) {
    CHECK_THROWS_AS(points_with(wrong), UsageError);
  }
}

TEST_CASE("points for a lab or a task that does not exist are refused with their line") {
  Layout layout = read_layout();
  const std::vector<Lab> labs = find_labs(layout);
  const fs::path docs = layout.root / "docs" / "points";
  const Scratch place;
  for (const char* folder : {"labs", "autograder"}) {
    fs::create_directory_symlink(layout.root / folder, place.path() / folder);
  }
  layout.root = place.path();
  const auto refusal = [&](const std::string& text) -> std::string {
    place.write(points_file, text);
    try {
      require_known_points(layout, labs);
    } catch (const UsageError& error) {
      return error.what();
    }
    return "";
  };
  CHECK(refusal("what,points\n1.1,3\n6.2,0\n2.2 any check,4\n") == "");
  CHECK(refusal("1.1,3\n99.1,2\n") == "points.csv, row 2: there is no lab 99");
  for (const char* example : {"20-hours.csv", "40-hours.csv"}) {
    CHECK(refusal(read_whole_text(docs / example)) == "");
  }
  CHECK(refusal("1.77,3\n") == "points.csv, row 1: lab 1 has no task 1.77");
}

TEST_CASE("a section ends at the next heading of its level, not at a comment in a block") {
  const std::string text = "# A\n### 1.1 x\none\n# a comment\n### 1.2 y\ntwo\n## End\nrest\n";
  CHECK(without_section(text, "### 1.1") == "# A\n### 1.2 y\ntwo\n## End\nrest\n");
  CHECK(without_section(text, "### 1.2") == "# A\n### 1.1 x\none\n# a comment\n## End\nrest\n");
  CHECK(without_section(text, "### 1.3") == text);
  CHECK(without_section("# H\n\n## 1.1\n\n### 1\nx\n\n## 1.2\ny\n", "## 1.1") ==
        "# H\n\n## 1.2\ny\n");
}

TEST_CASE("a task left out is in no table and no handout", "[.handout]") {
  // A clone of this checkout with the programs of this build.
  Course course;
  const fs::path root = course.path() / "root", build = course.path() / "build";
  git(course.path(), {"clone", "-q", "--shared", course.layout.root, root});
  write_text(root / points_file, "what,points\n1.7,0\n1.1,30\n");
  const fs::path program = built_for(root, build, "lab");
  for (const auto& entry : fs::directory_iterator(course.layout.build / "bin")) {
    const fs::path to = build / "bin" / entry.path().filename();
    if (to != program) fs::create_symlink(entry.path(), to);
  }
  const auto run = [&](const Words& words) {
    REQUIRE_RUN(done, sandbox::run_process(joined({program}, words),
                                           {.environment = {{"MC_NO_BUILD", "1"}}}));
    return done.output;
  };
  course.hand_in("anna", text_of(course.layout.solutions()));
  course.hand_in("bob", "int 1;\n");
  run({"grade", "--class", course.place(), "--lab", "1", "--csv", course.csv()});
  const std::string table = read_text(course.csv());
  CHECK(!contains(table, "\"1.7 "));
  CHECK(contains(table, " points "));  // the version says so
  const fs::path handout = course.path() / "handout";
  run({"handout", handout, "--labs", "1", "--with-sources"});
  CHECK(fs::exists(handout / points_file));
  CHECK(!contains(read_text(handout / "labs" / "1-variance" / "README.md"), "### 1.7"));
  CHECK(!contains(read_text(handout / "labs" / "1-variance" / "hints.md"), "## 1.7"));
  const std::string starter = read_text(handout / "starter" / "variance.cpp");
  CHECK(contains(starter, "TODO(1.6)"));
  CHECK(!contains(starter, "TODO(1.7)"));
}

}  // namespace mc::tests::points
