// Reports as people see them, compared with approved files. MC_APPROVE=1 writes the files again:
// look at git diff before you commit.

#include <cstdlib>
#include <regex>

#include <nlohmann/json.hpp>

#include "commands/command.hpp"
#include "judge/base/replace.hpp"
#include "tests/classes/course.hpp"

namespace mc::tests::approved {

namespace {

/// Without what differs between machines and runs: paths, the version, times.
std::string comparable(std::string text, const Course& course) {
  text = with_replacements(text, {{fs::canonical(course.path()).string(), "PLACE"},
                                  {course.path().string(), "PLACE"},
                                  {course.layout.root.string(), "ROOT"}});
  text = std::regex_replace(text, std::regex(R"(\d+\.\d+\.\d+ \([0-9a-f]+(-dirty)?\))"), "VERSION");
  text = std::regex_replace(text, std::regex(R"re("(seconds|execution_time)": [-0-9.e]+)re"),
                            R"("$1": S)");
  text = std::regex_replace(text, std::regex(R"(,"VERSION",[0-9.]+,)"), ",VERSION,S,");
  text =
      std::regex_replace(text, std::regex(R"("contents": "[0-9a-f]+")"), R"("contents": "HASH")");
  // Speed is measured: its lines come last, behind an empty line.
  return std::regex_replace(text, std::regex("\n[^\n]* ns[^\n]*|\n[^\n]*speed is not graded[^\n]*"),
                            "");
}

void check_approved(const std::string& name, const std::string& text, const Course& course) {
  const fs::path file = course.layout.root / "autograder" / "tests" / "approved" / name;
  const std::string now = comparable(text, course);
  if (std::getenv("MC_APPROVE") != nullptr) write_text(file, now);
  CAPTURE(file);
  CHECK(now == read_text(file));
}

}  // namespace

TEST_CASE("reports are as approved", "[script][approved]") {
  Course course;
  const auto report = [&](const std::string& id, const std::string& text) {
    course.hand_in(id, text);
    return lab({"check", "1", course.place() / id, "--seed", "1"}).output;
  };
  check_approved("starter.txt", report("starter", text_of(course.layout.starter())), course);
  check_approved("mistake.txt", report("mistake", text_with_mistake(course.layout)), course);
  check_approved("no-program.txt", report("no-program", "double mean(;\n"), course);
  course.write("class/absent/Variance.cpp", "");
  course.write("class/broken.zip", "no zip");
  course.write("class/hugo.cpp", "");
  const fs::path pages = course.path() / "pages";
  REQUIRE_RUN(graded, course.grade({"--csv", course.csv(), "--html", pages, "--no-plots", "--seed",
                                    "1", "-j", "1"}));
  check_approved("class.txt", graded.output, course);
  check_approved("grades.csv", read_text(course.csv()), course);
  check_approved("verdict.json", read_text(course.verdict_file("no-program")), course);
  check_approved("index.html", read_text(pages / "index.html"), course);
  const fs::path json = course.path() / "results.json";
  CHECK(lab({"check", "1", course.place() / "mistake", "--seed", "1", "--json", json}).exit_code ==
        1);
  auto results = nlohmann::json::parse(read_text(json));
  results.erase("extra_data");  // speed is measured
  check_approved("results.json", results.dump(1) + '\n', course);
}

TEST_CASE("help is as approved", "[script][approved]") {
  const Course course;
  std::string all = lab({"--help"}).output;
  for (const Command& command : all_commands()) {
    if (!command.name.empty()) all += "\n----\n" + lab({command.name, "--help"}).output;
  }
  check_approved("help.txt", all, course);
}

}  // namespace mc::tests::approved
