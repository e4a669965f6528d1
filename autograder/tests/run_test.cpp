// Experiments run by hand, and the words that name a lab.

#include <regex>

#include "runner/text.hpp"
#include "tests/submissions.hpp"

namespace mc::tests::run {

TEST_CASE("an experiment by hand, and what its numbers are", "[script]") {
  const std::string solutions = read_layout().solutions().string();
  const struct {
    Words words;
    std::string output;
  } cases[] = {{{"variance", "mean", "1,2,6"}, "3\n"},
               {{"variance", "mean", "-1,-2,-6"}, "-3\n"},
               {{"variance", "merge", "--a", "1:1:0", "--b", "1:3:0"},
                "# count  mean  m2\n2        2     2\n"},
               {{"halton", "radical_inverse", "2", "1,2,9"},
                "# index  x\n1        0.5\n2        0.25\n9        0.5625\n"},
               {{"halton", "halton", "--n", "2", "--dims", "2", "--first", "0"},
                "# index  x    y\n0        0    0\n1        0.5  0.3333333333333333\n"},
               {{"halton", "sobol", "0", "2", "2"}, "# index  x\n2        0.25\n3        0.75\n"},
               {{"stratification", "shuffle", "7", "2", "1"}, "# set  x\n0      7\n1      7\n"}};
  const auto run = [&](const Words& words) {
    return lab(joined({"run", "--dir", solutions}, words));
  };
  for (const auto& one : cases) {
    CAPTURE(one.words);
    CHECK(run(one.words).output == one.output);
  }
  CHECK(run({"blue_noise", "periodogram", "0", "0", "1", "1"})
            .output.starts_with("# kx  ky  power\n-1    -1  1\n0     -1  1\n"));
  CHECK(contains(run({"variance"}).output, "welford                --x LIST\n"));
  CHECK(run({"variance", "nothing"}).exit_code == 2);
  // As in its help, options follow the lab; what follows the experiment is its own.
  CHECK(lab({"run", "variance", "--dir", solutions, "mean", "-1,-2,-6"}).output == "-3\n");
  CHECK(lab({"run", "variance", "mean", "--dir", solutions}).exit_code == 1);
  CHECK(contains(lab({"run", "variance", "mean", "1,2"}).output, "not written yet"));
  // A dash works for an underscore; for a wrong name the error lists the right ones.
  const auto named = [&](const std::string& last) {
    return run({"stratification", "stratified_nd", "--n", "1", "--dims", "1", last, "1", "--sets",
                "1", "--seed", "1"})
        .output;
  };
  CHECK(named("--per-axis").starts_with("# x\n0."));
  CHECK(named("--per_axis").starts_with("# x\n0."));
  CHECK(contains(named("--peraxis"), "--per_axis is missing"));
  CHECK(contains(named("--peraxis"), "stratified_nd --n N --dims N --per_axis N"));
}

TEST_CASE("the list of experiments has the names of the declarations", "[script]") {
  const Layout layout = read_layout();
  for (const Lab& one : find_labs(layout)) {
    const std::string list = lab({"run", one.name, "--dir", layout.solutions().string()}).output;
    const std::string header = read_text(layout.labs() / one.folder / "experiments.hpp");
    std::size_t found = 0;
    for (const std::string_view line : mc::text::split(list, '\n')) {
      const auto words = mc::text::split(line, ' ');
      const std::string name(words[0]);
      std::smatch declared;  // with parameters, not as in a comment
      if (name.empty() || line.find("  --") == std::string_view::npos ||
          !std::regex_search(header, declared, std::regex(' ' + name + "\\([^)]+\\)"))) {
        continue;
      }
      ++found;
      for (const std::string_view word : words) {
        if (!word.starts_with("--")) continue;
        CAPTURE(one.name, name, word);
        const std::regex parameter(' ' + std::string(word.substr(2)) + "[,)]");
        CHECK(std::regex_search(declared.str(), parameter));
      }
    }
    CHECK(found > 0);
  }
  const std::string sampler = lab({"run", "sampler", "--dir", layout.solutions().string()}).output;
  check_contains(sampler, {"--kind is one of\n    independent stratified blue_noise halton sobol "
                           "lattice lattice_unfolded\n",
                           "\n    rect_light: x0 x1 y0 y1 height radiance\n"});
}

// Not in --quick: compiles every program with the sanitizers.
TEST_CASE("an experiment under the sanitizers", "[.sanitizers]") {
  const Layout layout = read_layout();
  const fs::path directory = layout.build / "tests" / "sanitize";
  fs::create_directories(directory);
  const auto run = [&](const std::string& text) {
    write_text(directory / "variance.cpp", text);
    return lab({"run", "--sanitize", "variance", "--dir", directory, "mean", "1,2,6"});
  };
  const std::string right = text_of(layout.solutions());
  REQUIRE_RUN(good, run(right));
  CHECK(good.output == "3\n");
  const fs::path program = last_line(good.errors);
  CHECK(program.string().starts_with((layout.build / "sanitize" / "variance").string()));
  const auto built = fs::last_write_time(program);
  CHECK(run(right).output == "3\n");
  CHECK(fs::last_write_time(program) == built);  // nothing has changed

  const auto stale = run(text_with_first_line_of_mean(
      layout, "double* few = new double[3]{}; delete[] few; return few[int(x[0])];"));
  CHECK(stale.exit_code != 0);
  CHECK(contains(stale.errors, "AddressSanitizer: heap-use-after-free"));
  const auto overflow = run(text_with_first_line_of_mean(layout, "return int(x[0]) + 2147483647;"));
  CHECK(overflow.exit_code != 0);
  CHECK(contains(overflow.errors, "runtime error: signed integer overflow"));
  const auto unfinished = run(right + "int f() { return nothing; }\n");
  CHECK(unfinished.exit_code == 1);
  check_contains(unfinished.errors, {"variance.cpp", "nothing"});
}

TEST_CASE("a lab and its task", "[script]") {
  const std::string solutions = read_layout().solutions().string();
  for (const Words& words : {Words{"check", "1.3", solutions},
                             {"check", "variance", "1.3", solutions},
                             {"check", "1", "1.3", solutions},
                             {"check", "1-variance", solutions, "--only", "1.3"}}) {
    CAPTURE(words);
    REQUIRE_RUN(run, lab(words));
    CHECK(contains(run.output, "20 of 20 points"));
    CHECK(!contains(run.output, " 1.2 "));
  }
}

}  // namespace mc::tests::run
