// Grading a class, with all kinds of interruptions.
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <chrono>
#include <random>
#include <set>
#include <thread>

#include "classes/verdict_store.hpp"
#include "judge/reports/verdict_json.hpp"
#include "judge/submission/compile.hpp"
#include "judge/submission/scratch.hpp"
#include "tests/classes/course.hpp"

namespace mc::tests::batch {

namespace {

/// The table without what differs between runs.
Rows comparable_rows(const fs::path& csv) {
  Rows rows = rows_of(csv);
  for (auto& [id, row] : rows) row.erase("seconds");
  return rows;
}

/// Processes that judge one of this course's submissions, by their open programs and seeds.
std::vector<std::string> processes_of(const Course& course, const std::string& seed) {
  std::set<std::string> slots;
  for (const std::string& id : course.ids) {
    slots.insert(slot_of({course.layout, find_lab(course.labs, "variance"),
                          fs::canonical(course.place() / id / "variance.cpp"), false})
                     .filename()
                     .string());
  }
  std::vector<std::string> found;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator("/proc", ignored)) {
    const std::string pid = entry.path().filename().string();
    if (pid.find_first_not_of("0123456789") != std::string::npos) continue;
    const std::string program = fs::read_symlink(entry.path() / "exe", ignored).string();
    const std::string words = read_text(entry.path() / "environ");
    bool is_ours = words.find("MC_SEED=" + seed) != std::string::npos;
    for (const std::string& slot : slots) is_ours |= program.find(slot) != std::string::npos;
    if (is_ours) found.push_back(pid + " " + program);
  }
  return found;
}

}  // namespace

TEST_CASE("a verdict survives a round trip to disk") {
  Verdict verdict;
  verdict.submission = "müller \"x\"";
  verdict.found_in = "a/b";
  verdict.seed = 0xffffffffffffffffu;
  verdict.not_judged = "line\nline";
  verdict.contents = "0123";
  verdict.jail_complete = false;
  verdict.absent = {"halton"};
  verdict.others = {"variance (1).cpp"};
  verdict.seconds = 0.1;
  LabVerdict lab;
  lab.lab = {6, "sampler", "6-sampler", {"variance", "halton"}};
  lab.no_program = "because";
  lab.unfinished = {"3", "1.4"};
  CheckResult result;
  result.check = {"6.1 a name", "6.1", {"3", "1.1"}, 2.5, true, true};
  result.report = "measured  \x01 \xff";
  result.printed = "…\n";
  for (const Status status :
       {Status::passed, Status::failed, Status::not_written, Status::withheld, Status::waiting,
        Status::not_run, Status::not_judged, Status::internal_error}) {
    result.status = status;
    lab.checks.push_back(result);
  }
  verdict.labs = {lab};
  const std::string text = verdict_to_json(verdict);
  const Verdict back = verdict_from_json(text);
  CHECK(verdict_to_json(back) == text);
  CHECK(back.seed == verdict.seed);
  CHECK(back.labs[0].checks[3].status == Status::withheld);
  for (std::size_t cut : {std::size_t{0}, text.size() / 2, text.size() - 3}) {
    CHECK_THROWS(verdict_from_json(text.substr(0, cut)));
  }
}

TEST_CASE(
    "a table for spreadsheets: no formula, no extra line, no points where nothing was judged") {
  for (const char* text :
       {"=HYPERLINK(\"x\")", "+1", "-1", "@a", "\t=1", "＝1+1", "＋1", "－1", "＠x"}) {
    CAPTURE(text);
    CHECK(csv_field(text).find('\'') < 2);
    if (text[0] != '\t') CHECK(csv_rows(csv_field(text) + "\n")[0][0] == text);
  }
  CHECK(csv_field("=1+1, x") == "\"'=1+1, x\"");
  CHECK(csv_rows(csv_field("=1+1, x") + ",2\r\n") ==
        std::vector<std::vector<std::string>>{{"=1+1, x", "2"}});
  CHECK(csv_rows("a,,\"b\"\"\n\"\n\n1").size() == 2);

  Verdict verdict;
  verdict.submission = "=x\n";
  const LabVerdict lab = verdict_of({result_of("1.1 a", Status::passed)});
  verdict.labs = {lab};
  const std::vector<LabColumns> columns{{lab.lab, {"1.1 a", "1.1 b"}}};
  const auto row = [&] {
    const std::string table = grade_table(columns, {verdict});
    return table.substr(table.find('\n') + 1);
  };
  CHECK(row() == "\"'=x \",0,,0.0,,judged,5,5,\n");
  verdict.not_judged = "the disk is full";
  CHECK(row() == "\"'=x \",0,,0.0,\"not judged: the disk is full\",\"not judged\",,,\n");
  verdict.not_judged.clear();
  verdict.absent = {"variance"};
  verdict.others = {"variance (1).cpp"};
  CHECK(contains(row(), "\"no variance.cpp; there is: variance (1).cpp\",\"no file\""));
}

TEST_CASE("a batch that is killed at any moment loses nothing and repeats nothing",
          "[.interrupted]") {
  Course course;
  course.hand_in_tiny(16);
  const std::string seed = std::to_string(700'000'000 + getpid());
  const auto start = std::chrono::steady_clock::now();
  REQUIRE_RUN(whole, course.grade({"--csv", course.csv("whole"), "--seed", seed}));
  REQUIRE(rows_of(course.csv("whole")).size() == 16);

  std::mt19937 random(static_cast<unsigned>(getpid()));
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  std::uniform_real_distribution<double> moment(0.02 * seconds.count(), 0.2 * seconds.count());
  std::size_t kills = 0, most = 0;
  while (kills < 10) {
    Words words{"--csv", course.csv(), "--seed", seed};
    const bool is_begun = fs::exists(course.path() / "grades-verdicts");
    if (is_begun && !fs::exists(course.csv())) words.push_back("--resume");
    const auto run = course.grade(words, {.wall_seconds = moment(random)});
    CAPTURE(run.exit_code, run.errors);
    REQUIRE((run.out_of_time || run.exit_code == 0));
    kills += run.out_of_time ? 1 : 0;
    if (!fs::exists(course.path() / "grades-verdicts")) continue;  // killed before it began
    std::size_t verdicts = 0;
    for (const auto& entry : fs::directory_iterator(course.path() / "grades-verdicts")) {
      if (entry.path().extension() != ".json") continue;
      ++verdicts;
      CHECK_NOTHROW(verdict_from_json(read_text(entry.path())));  // each is whole
    }
    most = std::max(most, verdicts);
  }
  CHECK(most > 0);
  std::vector<std::string> left;
  for (int i = 0; i < 100; ++i) {
    left = processes_of(course, seed);
    if (left.empty()) break;
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  CHECK(left == std::vector<std::string>());

  REQUIRE_RUN(last, course.grade({"--csv", course.csv(), "--resume"}));
  CHECK(comparable_rows(course.csv()) == comparable_rows(course.csv("whole")));
  // No leftovers: neither partial files nor compile directories.
  for (const auto& entry : fs::recursive_directory_iterator(course.path())) {
    CHECK(!contains(entry.path().string(), ".new-"));
  }
}

TEST_CASE("only changed submissions are judged again") {
  Course course;
  course.hand_in_tiny(6);
  const fs::path csv = course.csv();
  course.graded({"--seed", "7"});
  course.hand_in("s03", "int another;\n");
  REQUIRE_RUN(again, course.grade({"--csv", csv, "--resume"}));
  CHECK(contains(again.output, "6 submissions: 1 judged, 5 already judged; seed 7"));
  check_refused(course.grade({"--csv", csv, "--resume", "--seed", "8"}));
  // A truncated verdict is judged again.
  write_text(course.verdict_file("s01"), read_text(course.verdict_file("s01")).substr(0, 100));
  CHECK(contains(course.grade({"--csv", csv, "--resume"}).output, "1 judged, 5 already judged"));
  // Forgetting --resume does not delete an unfinished run, which has no table yet.
  fs::remove(csv);
  check_refused(course.grade({"--csv", csv}), "--resume continues");
  CHECK(fs::exists(course.verdict_file("s01")));
}

TEST_CASE("two runs do not write one table") {
  Course course;
  course.hand_in_tiny(2);
  fs::create_directories(course.path() / "grades-verdicts");
  const sandbox::Descriptor other(
      open((course.path() / "grades-verdicts" / "lock").c_str(), O_RDWR | O_CREAT, 0644), "lock");
  REQUIRE(flock(other.get(), LOCK_EX) == 0);
  check_refused(course.grade({"--csv", course.csv()}), "another run is writing");
}

TEST_CASE("results are never written into what is judged") {
  Course course;
  course.hand_in_tiny(1);
  for (const Words& words :
       {Words{"--class", course.place(), "--csv", course.place() / "grades.csv"},
        {course.place() / "s00", "--csv", course.place() / "s00" / "grades.csv"},
        {course.place() / "s00", "--html", course.place() / "s00" / "pages"}}) {
    check_refused(lab(joined({"grade"}, words)), "is judged: write it elsewhere");
  }
}

TEST_CASE("rows of a class: a missing file or program gives 0, an unreadable one no points") {
  Course course;
  course.hand_in_tiny(2);
  course.write("class/zoe/variance (1).cpp", "int x;\n");
  course.write("class/broken.zip", "no zip");
  std::map<std::string, std::string> cells;
  for (auto& [id, row] : course.graded({})) {
    cells[id] =
        fmt::format("{}|{}|{}", row["variance status"], row["variance total"], row["reason"]);
  }
  CHECK(cells == std::map<std::string, std::string>{
                     {"broken", "unreadable||unreadable: it is not a zip, tar or 7z archive"},
                     {"s00", "judged|0|"},
                     {"s01", "no program|0|"},
                     {"zoe", "no file|0|no variance.cpp; there is: variance (1).cpp"}});
}

TEST_CASE("the pages of a class have a cell for each task and a page for each student") {
  Course course;
  course.hand_in("anna", text_of(course.layout.solutions()));
  course.hand_in("<b>&", text_of(course.layout.starter()));
  const fs::path pages = course.path() / "pages";
  REQUIRE_RUN(run, course.grade({"--html", pages, "--no-plots", "--seed", "1"}));
  const std::string index = read_text(pages / "index.html");
  check_contains(index, {"2 submissions", "href=\"submissions/anna.html\"", "&lt;b&gt;&amp;",
                         "<strong>100</strong>", ">attempted</th>", ">passed</th>"});
  check_lacks(index, {"<b>&", "src=", "<script"});
  const std::string anna = read_text(pages / "submissions" / "anna.html");
  check_contains(anna, {"100 of 100 points", "✓ passed"});
}

TEST_CASE("unused programs are swept, recently used ones stay") {
  Layout layout = read_layout();
  const Scratch build;
  layout.build = build.path();
  const auto slot = [&](const char* name, int minutes) {
    fs::path place = build.path() / "programs" / name;
    build.write(std::string("programs/") + name + "/x.program", std::string(1000, 'x'));
    fs::last_write_time(place / "x.program",
                        fs::file_time_type::clock::now() - std::chrono::minutes(minutes));
    return place;
  };
  const auto oldest = slot("a", 100), old = slot("b", 50), fresh = slot("c", 2),
             done = slot("d", 1);
  sweep_programs(layout, 3000, {});
  CHECK(!fs::exists(oldest));
  CHECK(fs::exists(old));
  sweep_programs(layout, 0, {done});
  CHECK(!fs::exists(old));
  CHECK(fs::exists(fresh));
  CHECK(!fs::exists(done));
}

}  // namespace mc::tests::batch
