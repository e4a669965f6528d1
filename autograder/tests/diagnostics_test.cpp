// Original messages of compilers and linkers, and what students see of them.
#include "judge/submission/diagnostics.hpp"

#include <filesystem>
#include <map>
#include <string>

#include "checks/support/catch.hpp"
#include "judge/submission/source.hpp"
#include "tests/text.hpp"

namespace mc::tests::diagnostics {

namespace fs = std::filesystem;
using grader::first_errors;
using grader::Lab;

namespace {

const Lab lab{1, "variance", "1-variance", {}};
const std::map<std::string, std::string> headers{{"variance", "double covariance(int);"},
                                                 {"independent", "double to_unit(int);"},
                                                 {"blue_noise", "double radius(int);"}};

const grader::NamedText source{"variance.cpp",
                               "#include \"variance.hpp\"\n"
                               "int unused;\n"
                               "double f() {\n"
                               "\treturn nothing;\n"
                               "}\n"};

}  // namespace

TEST_CASE("errors of GCC and clang, with their source lines and their notes, without warnings") {
  CHECK(first_errors("variance.cpp: In function 'double f()':\n"
                     "variance.cpp:4:9: error: 'nothing' was not declared in this scope\n"
                     "compilation terminated due to -fmax-errors=3.\n",
                     source) ==
        "variance.cpp: In function 'double f()':\n"
        "variance.cpp:4:9: error: 'nothing' was not declared in this scope\n"
        "| \treturn nothing;\n"
        "| \t       ^");
  CHECK(first_errors("variance.cpp:4:9: error: use of undeclared identifier 'nothing'\n"
                     "1 error generated.\n",
                     source) ==
        "variance.cpp:4:9: error: use of undeclared identifier 'nothing'\n"
        "| \treturn nothing;\n"
        "| \t       ^\n"
        "| 1 error generated.");
  const std::string kept = first_errors(
      "variance.cpp:2:5: warning: unused variable 'unused' [-Wunused-variable]\n"
      "variance.cpp:2:5: note: of the warning\n"
      "variance.cpp:4:9: error: no match\n"
      "/usr/include/c++/12/vector:64:7: note: candidate\n",
      source);
  check_lacks(kept, {"unused", "of the warning"});
  check_contains(kept, {"no match", "candidate"});
}

TEST_CASE("a missing standard include is named") {
  const auto note = [](const char* text) { return grader::missing_include({"a.cpp", text}); };
  CHECK(
      note("#include <cmath>\n// std::sort\ndouble x = std::sqrt(std::iota(1));") ==
      "a.cpp uses std::iota without #include <numeric>. It compiles here, but may not elsewhere.");
  CHECK(note("#include <numeric>\nstd::iota(") == "");
  CHECK(note("std::iotas std::io std:: std::") == "");
  CHECK(contains(note("std::sort"), "<algorithm>"));
}

TEST_CASE("no solution and no other right answer lacks a standard include") {
  const fs::path root = fs::path(MC_LAB).parent_path();
  std::size_t files = 0;
  for (const char* folder : {"solutions", "autograder/submissions/alternatives"}) {
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
      if (!entry.is_regular_file()) continue;
      ++files;
      const std::string name = entry.path().filename().string();
      CHECK(grader::missing_include({name, grader::read_source(entry.path()).text}) == "");
    }
  }
  CHECK(files >= 40);
}

TEST_CASE("positions outside the file are not quoted") {
  for (const char* place : {"99:1", "4:99", "0:1", "4:0", "-1:1", "99999999999999999999:1", ":"}) {
    const std::string line = std::string("variance.cpp:") + place + ": error: x";
    CHECK(first_errors(line + "\n", source) == line);
  }
  // The text of another file, which a #line may have named, is not known here.
  CHECK(first_errors("/etc/passwd:1:1: error: x\n", source) == "| /etc/passwd:1:1: error: x");
}

TEST_CASE("no line of a message can pass for a command to GitHub or for a line of a report") {
  CHECK(first_errors("::notice file=x:1:2: error: y\n  passed  5/5\nvariance.cpp:9:9: error: z\n",
                     source) ==
        "| ::notice file=x:1:2: error: y\n|   passed  5/5\nvariance.cpp:9:9: error: z");
}

TEST_CASE("errors are few, short and printable") {
  std::string many;
  for (int i = 0; i < 1000; ++i) {
    many += "variance.cpp:1:1: error: \x1b[2J" + std::string(5000, 'x') + "\n";
  }
  const std::string shown = first_errors(many, source);
  CHECK(shown.size() < 12000);
  CHECK(!contains(shown, "\x1b"));
  CHECK(contains(shown, "more lines"));
}

TEST_CASE("missing and duplicate definitions, as three linkers report them") {
  const std::string missing =
      "Your variance.cpp does not define `mc::covariance` with the parameters that variance.hpp "
      "declares.";
  const std::string twice = "Your variance.cpp defines `main`, but the labs have their own.";
  // A program also contains the files of the labs it depends on.
  const Lab fourth{4, "blue_noise", "4-blue-noise", {}},
      above{4, "blue_noise", "4-blue-noise", {"variance"}};
  const struct {
    const Lab& of;
    std::string text, expected;
  } cases[] = {
      {lab,  // GNU ld
       "/usr/bin/ld: build/experiments.cpp.o: in function `mc::experiments::covariance(int)':\n"
       "experiments.cpp:(.text+0x12): undefined reference to "
       "`mc::covariance(std::span<double const, 18446744073709551615ul>)'\n"
       "/usr/bin/ld: experiments.cpp:(.text+0x94): undefined reference to "
       "`mc::covariance(std::span<double const, 18446744073709551615ul>)'\n"
       "collect2: error: ld returned 1 exit status\n",
       missing},
      {lab,  // lld
       "ld.lld: error: undefined symbol: mc::covariance(std::span<double const, 18446744ul>)\n"
       ">>> referenced by experiments.cpp\n"
       ">>>               experiments.cpp.o:(mc::experiments::covariance(int))\n",
       missing},
      {lab,  // gold
       "experiments.cpp.o:experiments.cpp:function f(): error: undefined reference to "
       "'mc::covariance(std::span<double const, 18446744073709551615ul>)'\n",
       missing},
      {above, "unit.o: undefined reference to `mc::covariance(int)'\n", missing},
      {fourth, "unit.o: undefined reference to `mc::to_unit(int)'\n",
       "Your blue_noise.cpp uses `mc::to_unit`, which independent.cpp defines; lab 4 is linked "
       "with no other lab. Copy the function into blue_noise.cpp, in an unnamed namespace."},
      {lab, "unit.o: undefined reference to `helper(int)'\n",
       "Your variance.cpp uses `helper(int)`, which is not defined anywhere."},
      {lab,  // GNU ld
       "/usr/bin/ld: main.cpp.o: in function `main':\n"
       "main.cpp:(.text.startup+0x0): multiple definition of `main'; unit.o:variance.cpp:"
       "(.text+0x0): first defined here\n",
       twice},
      {lab, "ld.lld: error: duplicate symbol: main\n>>> defined at variance.cpp\n", twice},
      {lab, "ld.lld: error: duplicate symbol: mc::runner::experiments()\n",
       "`mc::runner::experiments()` is defined twice."}};
  for (const auto& one : cases) {
    CHECK(grader::explain_link_errors(one.text, one.of, headers) == one.expected);
  }
}

TEST_CASE("unknown linker messages are passed on, few and printable") {
  const std::string shown = grader::explain_link_errors(
      "ld: internal \x1b[31m trouble\n" + std::string(1 << 20, 'x'), lab, headers);
  CHECK(shown.starts_with("variance.cpp does not link:\n| ld: internal ?[31m trouble"));
  CHECK(shown.size() < 1000);
}

}  // namespace mc::tests::diagnostics
