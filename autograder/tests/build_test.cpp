// How a submission is compiled, and the student's message if it does not compile.
#include <thread>

#include "grader/submission/include_policy.hpp"
#include "sandbox/printable.hpp"
#include "tests/submissions.hpp"

namespace mc::tests::build {

namespace {

struct Labs : FirstLab {
  /// Why `text` as variance.cpp gives no program; empty if it gives one.
  std::string failure(const std::string& text, const fs::path& directory = "scratch") const {
    const Scratch scratch(directory.native());
    scratch.write("variance.cpp", text);
    return build(scratch.path()).failure;
  }
};

}  // namespace

TEST_CASE("files that are not program text, or not files") {
  const Labs labs;
  const Scratch scratch;
  CHECK(labs.build(scratch.path()).failure == "There is no variance.cpp.");
  CHECK(labs.failure("") == "variance.cpp is empty.");
  CHECK(labs.failure("\xef\xbb\xbf \r\n\t\n") == "variance.cpp is empty.");
  CHECK(labs.failure(std::string(3 << 20, ' ')) ==
        "variance.cpp is 3072 KB long; 1 MB is the limit.");
  const std::string strange = labs.failure(std::string("int \0 \xff \x1b[31m;\n", 15));
  CHECK(!strange.empty());
  CHECK(sandbox::printable(strange) == strange);
  const auto files = [&] { return open_submission(labs.labs, scratch.path()).files.size(); };
  const fs::path file = scratch.path() / "variance.cpp";
  fs::create_symlink(labs.layout.solutions() / "variance.cpp", file);
  CHECK(files() == 0);
  fs::remove(file);
  fs::create_directory(file);
  CHECK(files() == 0);
  fs::remove(file);
  write_text(file, labs.starter);
  CHECK(files() == 1);
  CHECK_FALSE(open_submission(labs.labs, scratch.path()).trusted);
}

TEST_CASE("a byte order mark, carriage returns, blanks and umlauts are accepted") {
  const Labs labs;
  std::string text = "\xef\xbb\xbf";
  for (const char c : labs.starter) text += c == '\n' ? "\r\n" : std::string(1, c);
  CHECK(labs.failure(text, "übung eins (Müller)").empty());
}

TEST_CASE("a compile error names the line and the file's own name") {
  const Labs labs;
  const std::string failure =
      labs.failure("#include \"variance.hpp\"\n\nint x = \"no\";\nint y = z;\n");
  check_contains(failure, {"variance.cpp does not compile:", "variance.cpp:3:"});
  CHECK(!contains(failure, "scratch"));
  CHECK(contains(labs.failure("#include \"missing.hpp\"\n"), "missing.hpp"));
  CHECK(contains(labs.failure("#error stop here\n"), "stop here"));
}

TEST_CASE("a missing function is reported by its name") {
  const Labs labs;
  const std::string failure = labs.failure("#include \"variance.hpp\"\n");
  check_contains(failure, {"Your variance.cpp does not define `mc::covariance`", "variance.hpp"});
  CHECK(contains(labs.failure(labs.starter + "int main() {}\n"), "defines `main`"));
}

TEST_CASE("a text that exhausts the compiler is stopped") {
  const Labs labs;
  const bool clang = labs.layout.is_clang;
  CHECK(labs.failure("#include \"/dev/zero\"\n")
            .starts_with(clang ? "variance.cpp reads /dev/zero."  // as an empty file
                               : "The compiler tried to use more than 1536 MB of memory"));
  const std::string endless = labs.failure(
      "template <int n> int f() { return f<n + 1>() + f<n + 2>(); }\n"
      "int x = f<0>();\n");
  check_contains(endless,
                 {"variance.cpp:1:", clang ? "exceeded maximum depth" : "depth exceeds maximum"});
  // Its data do not fit into a file: the assembler crashes, or reports it without being quoted.
  CHECK(labs.failure("char a[3000000000u] = {1};\n")
            .starts_with(clang ? "The assembler does not understand" : "The compiler crashed on"));
  CHECK(contains(labs.failure("char a[1000000000u];\n" + labs.starter), "global variables"));
}

TEST_CASE("files outside the labs and the system's headers are not read") {
  const Labs labs;
  for (const std::string file : {"/etc/passwd", "/etc/../etc/hosts"}) {
    const std::string failure = labs.failure("#include \"" + file + "\"\n");
    CHECK(!contains(failure, "root:"));
    CHECK(contains(failure, "its errors are not shown: its compilation reads " + file));
  }
  CHECK(contains(labs.failure("#include \"../../solutions/variance.cpp\"\n"),
                 "solutions/variance.cpp.\nIt may include"));
  CHECK(contains(labs.failure("asm(\".incbin \\\"/etc/passwd\\\"\");\n" + labs.starter),
                 "reads /etc/passwd"));
}

// As Debian 13 has /usr/include/…/asm/types.h.
TEST_CASE("a system header may be a link to a file elsewhere") {
  const Scratch place;
  const fs::path root = fs::canonical(place.path());
  for (const char* name : {"include", "elsewhere", "unit"}) fs::create_directories(root / name);
  place.write("elsewhere/types.h", "");
  place.write("elsewhere/secret.h", "");
  fs::create_symlink(root / "elsewhere" / "types.h", root / "include" / "types.h");
  fs::create_symlink(root / "elsewhere", root / "include" / "more");
  place.write("c++", "#!/bin/sh\necho '#include <...> search starts here:' >&2\necho ' " +
                         (root / "include").string() + "' >&2\necho 'End of search list.' >&2\n");
  fs::permissions(root / "c++", fs::perms(0755));
  Layout layout = read_layout();
  layout.compiler = (root / "c++").string();
  const auto is_forbidden = [&](const std::string& name) {
    return forbidden(layout, false, root / "unit", {root / name}).has_value();
  };
  CHECK_FALSE(is_forbidden("include/types.h"));
  CHECK(is_forbidden("elsewhere/types.h"));
  CHECK(is_forbidden("include/more/secret.h"));
  CHECK(is_forbidden("include/more/../secret.h"));
  CHECK(is_forbidden("include/../elsewhere/secret.h"));
}

TEST_CASE("two concurrent builds do not interfere") {
  const Labs labs;
  const Scratch scratch;
  scratch.write("variance.cpp", labs.starter);
  BuildResult one, two;
  std::thread first([&] { one = labs.build(scratch.path()); });
  two = labs.build(scratch.path());
  first.join();
  CHECK(one.program.has_value());
  CHECK(two.program.has_value());
}

}  // namespace mc::tests::build
