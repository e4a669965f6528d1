// Grading a class, with all kinds of interruptions.
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <random>
#include <set>
#include <thread>

#include "grader/gradebook/book.hpp"
#include "grader/reports/verdict_json.hpp"
#include "grader/submission/compile.hpp"
#include "grader/submission/scratch.hpp"
#include "tests/gradebook/course.hpp"

namespace mc::tests::batch {

namespace {

/// The table without what differs between runs: id -> its row.
std::map<std::string, Row> rows_of(const fs::path& csv) {
  std::map<std::string, Row> by_id;
  for (Row& row : read_table(csv).rows) {  // refuses truncated rows
    row.erase("seconds");
    REQUIRE(by_id.emplace(field(row, "id"), row).second);  // each id once
  }
  return by_id;
}

/// All verdicts next to a table, without seconds.
std::map<std::string, std::string> verdicts_of(const fs::path& csv) {
  std::map<std::string, std::string> all;
  for (const auto& entry : fs::directory_iterator(verdict_directory(csv))) {
    if (entry.path().extension() != ".json") continue;
    Verdict verdict = verdict_from_json(read_text(entry.path()));
    verdict.seconds = 0;
    for (LabVerdict& lab : verdict.labs) {
      lab.seconds = 0;
      for (CheckResult& result : lab.checks) result.seconds = 0;
    }
    all[verdict.submission] = verdict_to_json(verdict);
  }
  return all;
}

/// Processes that judge one of this course's submissions: compilers by their working directory,
/// checks and programs by their open files.
std::vector<std::string> processes_of(const Course& course, const std::string& seed) {
  std::set<std::string> slots;
  for (const std::string& id : course.ids) {
    slots.insert(slot_of({course.layout, find_lab(course.labs, "variance"),
                          fs::canonical(course.path() / "class" / id / "variance.cpp"), false})
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
  verdict.delivery = {"Ada", "a@b", "2026", true, "ada_1", {{"halton", "7.5"}}};
  verdict.seed = 0xffffffffffffffffu;
  verdict.not_judged = "line\nline";
  verdict.unreadable = "no";
  verdict.contents = "caf\xe9 \xff ü";
  verdict.version = "1";
  verdict.flags = "-O3";
  verdict.jail_complete = false;
  verdict.absent = {"halton"};
  verdict.seconds = 0.1;
  LabVerdict lab;
  lab.lab = {6, "sampler", "6-sampler", {"variance", "halton"}};
  lab.no_program = "because";
  lab.unfinished = {"3", "1.4"};
  lab.seconds = 1e-9;
  CheckResult result;
  result.check = {"6.1 a name", "6.1", {"3", "1.1"}, 2.5, true, true};
  result.report = "measured  \x01 \xff";
  result.printed = "…\n";
  result.repeat = "./lab";
  result.by_hand = "./lab run";
  result.seconds = 2;
  for (const Status status :
       {Status::passed, Status::failed, Status::not_written, Status::withheld, Status::waiting,
        Status::not_run, Status::not_judged, Status::internal_error}) {
    result.status = status;
    lab.checks.push_back(result);
  }
  lab.speed = {{"1.8 moments", 0.5, 1.0, true, {}, 3.0, 1u << 20, "edge", 0.25}};
  verdict.labs = {lab};
  const std::string text = verdict_to_json(verdict);
  const Verdict back = verdict_from_json(text);
  CHECK(verdict_to_json(back) == text);
  CHECK(back.contents == verdict.contents);
  CHECK(back.delivery == verdict.delivery);
  CHECK(back.labs[0].checks[3].status == Status::withheld);
  CHECK(!back.labs[0].speed[0].error.has_value());
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
  const auto row = [&] { return csv_rows(csv_row(columns, verdict))[0]; };
  CHECK(csv_rows(csv_header(columns))[0].size() == row().size());
  CHECK(csv_row(columns, verdict) == "\"'=x \",0,,0.0,,judged,5,5,\n");
  verdict.not_judged = "the disk is full";
  CHECK(csv_row(columns, verdict) ==
        "\"'=x \",0,,0.0,\"not judged: the disk is full\",\"not judged\",,,\n");
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
  int kills = 0, hits = 0;
  while (kills < 10) {
    const auto state = read_book_state(course.csv());
    Words words{"--csv", course.csv(), "--seed", seed};
    if (!state.finished) words.push_back("--resume");
    const auto run = course.grade(words, {.wall_seconds = moment(random)});
    CAPTURE(run.exit_code, run.errors);
    REQUIRE((run.out_of_time || run.exit_code == 0));
    kills += run.out_of_time ? 1 : 0;
    if (!fs::exists(course.csv())) continue;  // killed before it began
    hits += rows_of(course.csv()).empty() ? 0 : 1;
    for (const auto& [id, verdict] : verdicts_of(course.csv())) CHECK(verdict.size() > 100);
  }
  CHECK(hits > 0);
  std::vector<std::string> left;
  for (int i = 0; i < 100; ++i) {
    left = processes_of(course, seed);
    if (left.empty()) break;
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  CHECK(left == std::vector<std::string>());

  REQUIRE_RUN(last, course.grade({"--csv", course.csv(), "--resume"}));
  CHECK(rows_of(course.csv()) == rows_of(course.csv("whole")));
  const auto verdicts = verdicts_of(course.csv());
  for (const auto& [id, verdict] : verdicts_of(course.csv("whole"))) {
    CHECK(verdicts.at(id) == verdict);
  }
  // No leftovers: neither partial files nor compile directories.
  for (const auto& entry : fs::recursive_directory_iterator(course.path())) {
    CHECK(!contains(entry.path().string(), ".new-"));
  }
  CHECK(read_book_state(course.csv()).finished);
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
  // Forgetting --resume does not delete an unfinished run.
  write_text(verdict_directory(csv) / "state", "begun seed 7\n");
  check_refused(course.grade({"--csv", csv}), "--resume continues");
  // A row damaged by an editor, a truncated verdict: judged again.
  const fs::path verdict = verdict_file(csv, "s01");
  write_text(verdict, read_text(verdict).substr(0, 100));
  CHECK(contains(course.grade({"--csv", csv, "--resume"}).output, "1 judged, 5 already judged"));
  CHECK(verdicts_of(csv).size() == 6);
}

TEST_CASE("two runs do not write one table") {
  Course course;
  course.hand_in_tiny(2);
  fs::create_directories(verdict_directory(course.csv()));
  const sandbox::Descriptor other(
      open((verdict_directory(course.csv()) / "lock").c_str(), O_RDWR | O_CREAT, 0644), "lock");
  REQUIRE(flock(other.get(), LOCK_EX) == 0);
  check_refused(course.grade({"--csv", course.csv()}), "another run is writing");
}

TEST_CASE("rows of a class: a missing file or program gives 0, an unreadable one no points") {
  Course course;
  course.hand_in_tiny(2);
  fs::create_directories(course.path() / "class" / "zoe" / "notes");
  write_text(course.path() / "class" / "broken.zip", "no zip");
  std::map<std::string, std::string> cells;
  const Table table = course.graded({});
  for (const Row& row : table.rows) {
    const std::string first_check = table.columns.at(7);
    cells[field(row, "id")] =
        fmt::format("{}|{}|{}|{}", field(row, "variance status"), field(row, "variance total"),
                    field(row, first_check), field(row, "reason"));
  }
  CHECK(cells == std::map<std::string, std::string>{
                     {"broken", "unreadable|||unreadable: it is not a zip file"},
                     {"s00", "judged|0|0|"},
                     {"s01", "no program|0|0|"},
                     {"zoe", "no file|0|0|"}});
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
