// The commands of ./lab, used as a user would, correctly and wrongly.
#include <algorithm>
#include <chrono>

#include <nlohmann/json.hpp>

#include "judge/checkout/hints.hpp"
#include "judge/reports/report.hpp"
#include "judge/submission/archive.hpp"
#include "tests/submissions.hpp"

namespace mc::tests::entry_script {

TEST_CASE("bad usage gives one line with the error and the usage, and exit status 2", "[script]") {
  const Scratch empty;
  const Scratch full;
  const fs::path file = full.write("variance.cpp", "\n");
  const struct {
    Words words;
    std::string says;
  } cases[] = {
      {{"chekc", "1"}, "did you mean 'check'"},
      {{"check"}, "usage: ./lab check LAB"},
      {{"check", "varianc"}, "did you mean 'variance'"},
      {{"check", "99"}, "no lab '99'"},
      {{"check", "variance", "/no/such/place"}, "no such directory: /no/such/place"},
      {{"check", "variance", file}, "is a file"},
      {{"check", "variance", empty.path()}, "has no variance.cpp"},
      {{"check", "variance", "--only"}, "--only takes a value"},
      {{"check", "variance", "--onyl", "1.3"}, "no option --onyl; did you mean --only?"},
      {{"check", "variance", "--only", "7.7"}, "no task 7.7"},
      {{"check", "1.77"}, "no task 1.77"},
      {{"check", "variance", "2.3"}, "2.3 is not a task of lab variance"},
      {{"check", "99.1"}, "no lab '99'"},
      {{"check", "variance", "1.3", "a", "b"}, "usage: ./lab check LAB"},
      {{"check", "variance", "--seed", "-1"}, "whole number"},
      {{"check", "variance", "--seed", "12x"}, "whole number"},
      {{"check", "variance", "--json", "/no/such/place/results.json"}, "no such directory"},
      {{"check", "variance", "--watch", "--json", "x.json"}, "--watch cannot be combined"},
      {{"grade"}, "usage: ./lab grade DIR"},
      {{"grade", "/no/such/place"}, "no such directory"},
      {{"grade", empty.path()}, "contains no lab files"},
      {{"grade", "a", "b", "--json", "x.json"}, "--json takes one DIR"},
      {{"grade", "a", "--class", "b"}, "not both"},
      {{"grade", "--class", empty.path()}, "there is no submission"},
      {{"grade", "--class", "/no/such/place"}, "no such directory"},
      {{"grade", "a", "--resume"}, "--resume needs the --csv"},
      {{"grade", "a", "--slurm"}, "--slurm needs --csv FILE"},
      {{"grade", "a", "--slurm", "--csv", "x.csv", "--html", "x"}, "no --html"},
      {{"gradescope", "1"}, "usage: ./lab gradescope LAB"},
      {{"plot", "vriance"}, "did you mean 'variance'"},
      {{"render", "egde"}, "the pictures are edge, penumbra"},
      {{"render", "--sampler", "random"}, "the kinds are independent, stratified"},
      {{"render", "--spp", "0"}, "--spp takes 1 to"},
      {{"render", "--spp", "many"}, "whole number"},
      {{"run"}, "usage: ./lab run LAB"},
      {{"submit", "0"}, "no lab '0'"},
      {{"test", "everything"}, "usage: ./lab test"},
  };
  for (const auto& wrong : cases) {
    const auto run = lab(wrong.words);
    CAPTURE(wrong.words);
    check_refused(run, wrong.says);
    CHECK(lines(run.errors) == 1);
  }
}

TEST_CASE("the verdict is the same in the terminal, in JSON and in CSV", "[script]") {
  const Layout layout = read_layout();
  const Scratch scratch, results_place;
  scratch.write("variance.cpp", text_with_mistake(layout));
  const fs::path json = results_place.path() / "results.json",
                 csv = results_place.path() / "table.csv";
  REQUIRE_RUN(run, lab({"grade", scratch.path(), "--json", json, "--no-plots", "--seed", "5"}));
  REQUIRE_RUN(tabled, lab({"grade", scratch.path(), "--csv", csv, "--no-plots", "--seed", "5"}));
  CHECK(!contains(run.output, "\x1b["));  // no color without a terminal

  const auto results = nlohmann::json::parse(read_text(json));
  const double score_of_100 = results["score"].get<double>();
  CHECK(score_of_100 > 80);
  CHECK(score_of_100 < 100);
  CHECK(contains(run.output, fmt::format("{:g} of 100 points", score_of_100)));
  CHECK(results["execution_time"] > 0);
  CHECK(results["extra_data"]["seed"] == 5);
  CHECK(results["extra_data"].contains("version"));
  double score = 0, most = 0;
  for (const auto& test : results["tests"]) {
    for (const char* key : {"name", "number", "status", "output"}) {
      CHECK(test[key].is_string());
    }
    CHECK((test["score"] == test["max_score"]) == (test["status"] == "passed"));
    score += test["score"].get<double>();
    most += test["max_score"].get<double>();
    if (test["status"] == "failed") {
      check_contains(test["output"], {"./lab check variance", "--seed 5"});
    }
  }
  CHECK(score == score_of_100);
  CHECK(most == 100);
  const std::string table = read_text(csv);
  CHECK(lines(table) == 2);
  CHECK(contains(table, fmt::format(",judged,{:g},", score_of_100)));
}

TEST_CASE("results are complete when nothing compiles or nothing was handed in", "[script]") {
  const Scratch place, empty, out;
  const fs::path json = out.path() / "results.json";
  place.write("variance.cpp", "not C++ at all \xff\xfe \x1b[31m\n");
  const auto results_of = [&](const Words& words, int exit_code) {
    CHECK(lab(joined(words, {"--json", json})).exit_code == exit_code);
    auto results = nlohmann::json::parse(read_text(json));
    CHECK(results["score"] == 0);
    return results;
  };
  CHECK(results_of({"check", "variance", empty.path()}, 1)["tests"].size() > 20);
  results_of({"grade", empty.path()}, 0);
  const auto broken = results_of({"check", "variance", place.path()}, 1);
  CHECK(broken["tests"].size() > 20);
  CHECK(contains(broken["output"], "does not compile"));
}

TEST_CASE("a full disk leaves the old result intact") {
  const Scratch scratch;
  const fs::path json = scratch.write("results.json", "old");
  // The new text is first written to a device that is always full.
  fs::create_symlink("/dev/full", json.string() + ".new-" + std::to_string(getpid()));
  CHECK_THROWS(write_text(json, "new"));
  CHECK(read_text(json) == "old");
}

TEST_CASE("a hint is a step, and the next call shows the next", "[script]") {
  const Layout layout = read_layout();
  fs::remove(layout.build / "hints" / "4.1");
  for (const char* step : {"step 1 of 3", "step 2 of 3", "step 3 of 3", "step 3 of 3"}) {
    REQUIRE_RUN(run, lab({"hint", "4.1"}));
    CHECK(contains(run.output, step));
  }
  CHECK(contains(lab({"hint", "4.1", "2"}).output, "step 2 of 3"));
  CHECK(contains(lab({"hint", "blue_noise", "4.1", "1"}).output, "circle"));
  for (const Words& wrong : {Words{"4.1", "4"}, {"4"}, {"4.99"}}) {
    check_refused(lab(joined({"hint"}, wrong)));
  }
  fs::remove(layout.build / "hints" / "4.1");
  const std::string text = read_text(layout.labs() / "4-blue-noise" / "hints.md");
  CHECK(with_fewer_hints(text, 3) == text);
  CHECK(!contains(with_fewer_hints(text, 1), "### 2"));
  CHECK(contains(with_fewer_hints(text, 1), "### 1"));
  CHECK(!contains(with_fewer_hints(text, 0), "### 1"));
}

TEST_CASE("a lab has the name that a shell completes", "[script]") {
  const auto run = lab({"check", "labs/1-variance/", "--only", "1.1", "--seed", "1"});
  CHECK(run.exit_code == 1);
  CHECK(contains(run.output, "Lab 1"));
  CHECK(contains(lab({"variance"}).errors, "did you mean './lab check variance'"));
  CHECK(contains(lab({"check", "99"}).errors, "there are 1 to "));
}

TEST_CASE("several submissions get one line each", "[script]") {
  const Scratch empty;
  REQUIRE_RUN(run, lab({"grade", read_layout().starter(), empty.path(), "--seed", "1"}));
  CHECK(lines(run.output) == 3);  // two rows, a summary
  CHECK(contains(run.output, "it contains no lab files"));
}

TEST_CASE("the zip to hand in", "[script]") {
  const Scratch scratch;
  REQUIRE_RUN(run, lab({"submit", "variance"}, {.directory = scratch.path()}));
  const fs::path out = scratch.path() / "out", given = read_layout().starter() / "variance.cpp";
  fs::create_directories(out);
  unpack({.archive = scratch.path() / "1-variance.zip", .to = out});
  CHECK(read_text(out / "variance.cpp") == read_text(given));
  const auto age = fs::last_write_time(given) - fs::last_write_time(out / "variance.cpp");
  CHECK(std::chrono::abs(age) < std::chrono::seconds(2));  // the time when it was written is kept
}

TEST_CASE("a report fits a small terminal") {
  CheckResult failed =
      result_of("1.1 a name that is long enough to be broken somewhere in it", Status::failed,
                "measured  mean({1, 2, 3, 4, 5, … (1000 values)}) = 17\nexpected  3, with digits");
  failed.repeat = "./lab check variance --only 1.1 --seed 1";
  const LabVerdict verdict = verdict_of({failed, result_of("1.1 short", Status::passed)});
  Verdict whole;
  whole.submission = "starter";
  const std::string report = report_lab(verdict, whole, {false, 48});
  std::size_t column = 0, widest = 0, full = 0;
  for (const char c : report) {
    if ((c & 0xc0) == 0x80) continue;
    if (c == '\n' && column == 48) ++full;
    column = c == '\n' ? 0 : column + 1;
    widest = std::max(widest, column);
  }
  CHECK(widest <= 52);  // a word that does not fit is alone on its line
  CHECK(full == 2);     // points end at the right, whether the name is broken or not
}

namespace {

/// A directory that is always the same, so that six labs are compiled only once.
fs::path copy_of_solutions(const Layout& layout, const std::string& name) {
  fs::path copy = layout.build / "tests" / name;
  fs::create_directories(copy);
  fs::copy(layout.solutions(), copy,
           fs::copy_options::recursive | fs::copy_options::overwrite_existing);
  return copy;
}

}  // namespace

TEST_CASE("--first does not stop at a stretch task that is not written", "[script]") {
  const Layout layout = read_layout();
  const fs::path file = copy_of_solutions(layout, "first") / "sampler.cpp";
  const std::string unwritten =
      ",\n                          {\"lattice\", dimensions_of<fill_lattice<true>>, &blocks},\n"
      "                          {\"lattice_unfolded\", dimensions_of<fill_lattice<false>>, "
      "&blocks}";
  const std::string refusal =
      "    if (samples == 0) throw std::invalid_argument(\"samples: must be positive\");\n";
  write_text(file, with_change(with_change(read_text(file), unwritten, ""), refusal, ""));
  const auto run = lab({"check", "sampler", file.parent_path(), "--first"});
  CHECK(contains(run.output, "✗ 6.4 0 samples and too many are refused"));
}

TEST_CASE("a failure in lab 6 waits for a lab it depends on that is not finished", "[script]") {
  const Layout layout = read_layout();
  const fs::path student = copy_of_solutions(layout, "waiting");
  const fs::path file = student / "stratification.cpp";
  const std::string moves = "    move_into(strata, first, block);\n";  // into their strata, in 3.1
  write_text(file, with_change(read_text(file), moves, ""));
  const auto run = lab({"check", "sampler", student, "--only", "6.2"});
  CHECK(run.exit_code == 1);
  CHECK(contains(run.output, "waiting for lab 3"));
  CHECK(!contains(run.output, "measured"));  // one fault, and it is not here
}

}  // namespace mc::tests::entry_script
