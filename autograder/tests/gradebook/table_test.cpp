// Merging the tables of several shards.

#include "grader/gradebook/book.hpp"
#include "tests/gradebook/course.hpp"

namespace mc::tests::tables {

namespace {

/// Removes what differs between runs: seconds.
std::string without_seconds(const fs::path& csv) {
  Table table = read_table(csv);
  for (Row& row : table.rows) row.erase("seconds");
  return table_text(table);
}

std::string merged_text(const std::vector<Table>& tables) {
  return table_text(merge_tables(tables, find_labs(read_layout())).table);
}

}  // namespace

TEST_CASE("the tables of two shards merge into that of one run, verdicts included") {
  Course course;
  course.hand_in_tiny(5);
  course.hand_in("=1+1, \"zoe\"", "int x\n");  // a name that must be quoted in a table
  course.hand_in("right", text_of(course.layout.solutions()));
  const auto whole = course.csv("whole"), merged = course.csv("merged");
  REQUIRE(course.grade({"--csv", whole, "--seed", "1"}).succeeded());
  Words words{"merge", "--out", merged};
  for (const std::string which : {"2", "1"}) {  // in any order
    words.push_back(course.csv("part" + which));
    REQUIRE(
        course.grade({"--csv", words.back(), "--shard", which + "/2", "--seed", "1"}).succeeded());
  }
  for (const char* wrong : {"0/2", "3/2", "1", "1/2/3", "x/y"}) {
    check_refused(course.grade({"--shard", wrong}));
  }
  REQUIRE_RUN(run, course.run(words));
  CHECK(run.errors.empty());
  CHECK(contains(run.output, "7 submissions of 2 tables"));
  CHECK(without_seconds(merged) == without_seconds(whole));
  const Table table = read_table(merged);
  CHECK(read_verdicts(table).size() == 7);
  const auto one = read_verdict(merged, "s03");
  REQUIRE(one);
  CHECK(one->labs[0].no_program == read_verdict(whole, "s03")->labs[0].no_program);
  // A later run accepts it as its own: nothing is judged again, and everyone has a page.
  const std::string before = read_text(merged);
  const fs::path pages = course.path() / "pages";
  const auto again = course.grade({"--csv", merged, "--resume", "--html", pages});
  CHECK(contains(again.output, "7 submissions: 0 judged, 7 already judged; seed 1"));
  CHECK(read_text(merged) == before);
  CHECK(fs::exists(pages / "submissions" / "s04.html"));
  // Without an output file it is printed, byte by byte the same.
  words.erase(words.begin() + 1, words.begin() + 3);
  CHECK(course.run(words).output == read_text(merged));
}

TEST_CASE("an id with different rows in two tables is an error that names both") {
  const Scratch place;
  const auto a = read_table(place.write("a.csv", "id,seed,variance total\nada,1,10\nbob,1,20\n"));
  const auto same = read_table(place.write("b.csv", "id,variance total,seed\nada,10,1\n"));
  const auto other = read_table(place.write("c.csv", "id,seed,variance total\nada,1,11\n"));
  CHECK(merged_text({a, same}) == "id,seed,\"variance total\"\nada,1,10\nbob,1,20\n");
  CHECK_THROWS_WITH(merged_text({a, same, other}), "ada is in " + a.file.string() + " and in " +
                                                       other.file.string() +
                                                       ", with different rows: which one counts?");
}

TEST_CASE("merge reports versions and seeds that differ, with their tables") {
  const Scratch place;
  const auto a = place.write("a.csv", "id,seed,version\nada,1,1.0\nbob,1,1.0\n").string();
  const auto b = place.write("b.csv", "id,seed,version\ncy,2,1.1\n").string();
  const auto merged = merge_tables({read_table(a), read_table(b)}, {});
  CHECK(merged.differences ==
        std::vector<std::string>{"the versions differ: " + a + " 1.0, " + b + " 1.1",
                                 "the seeds differ: " + a + " 1, " + b + " 2"});
  CHECK(merge_tables({read_table(a)}, {}).differences.empty());
  REQUIRE_RUN(run, Course().run({"merge", a, b}));
  CHECK(contains(run.errors, "the seeds differ"));
  CHECK(!contains(run.output, "differ"));  // only the table
}

TEST_CASE("merge reports a table whose run did not finish, and so does its own result") {
  Course course;
  course.hand_in_tiny(2);
  const std::string part = course.csv("part"), merged = course.csv("merged");
  REQUIRE(course.grade({"--csv", part, "--seed", "3"}).succeeded());
  CHECK(course.run({"merge", part, "--out", merged}).errors.empty());
  CHECK(read_book_state(merged).finished);
  write_book_state(part, false, 3);  // the state that a killed run leaves
  REQUIRE_RUN(run, course.run({"merge", part, "--out", merged}));
  CHECK(contains(run.errors, part + " is incomplete: its run did not finish"));
  CHECK(read_book_state(merged).seed == 3);
  CHECK(!read_book_state(merged).finished);
}

TEST_CASE("columns merge by name, in the order of a run") {
  const Scratch place;
  const auto halton =
      read_table(place.write("h.csv",
                             "id,seed,halton status,halton total,halton hours,5.1 a,5.10 b,remark\n"
                             "bob,1,judged,3,9,3,0,late\n"));
  const auto variance = read_table(
      place.write("v.csv", "id,seed,variance status,variance total,1.1 a\nada,1,judged,4,4\n"));
  CHECK(merged_text({halton, variance}) ==
        "id,seed,\"variance status\",\"variance total\",\"halton status\",\"halton total\","
        "\"halton hours\",\"1.1 a\",\"5.1 a\",\"5.10 b\",remark\n"
        "ada,1,judged,4,,,,4,,,\n"
        "bob,1,,,judged,3,9,,3,0,late\n");
}

TEST_CASE("a file that is not a table of grades is refused, with the reason") {
  const Scratch place;
  const auto why = [&](const std::string& text) {
    const fs::path file = place.write("x.csv", text);
    try {
      read_table(file);
    } catch (const UsageError& error) {
      return std::string(error.what()).substr(file.string().size());
    }
    return std::string();
  };
  CHECK(why("") == " is not a table of grades: it has no 'id' column");
  CHECK(why("id;seed\nada;1\n") == " is not a table of grades: it has no 'id' column");
  CHECK(why("id,seed\nada\n") ==
        " is not a table of grades: row 2 has 1 fields, but the header has 2");
  CHECK(why("id,a,a\n") == " is not a table of grades: there are two columns 'a'");
  CHECK(why("id,seed\n../ada,1\n") == " is not a table of grades: '../ada' is not a valid id");
  CHECK(why("id,seed\n,1\n") == " is not a table of grades: '' is not a valid id");
  CHECK(read_table(place.write("e.csv", "id,\x1b[2J\nada,\x1b[2J\n")).columns[1] == "?[2J");
  CHECK(why("\xef\xbb\xbfid,seed\r\nada,1\r\n").empty());  // as a spreadsheet saves it
  CHECK_THROWS_WITH(read_table("/no/such.csv"), "no such table: /no/such.csv");
}

}  // namespace mc::tests::tables
