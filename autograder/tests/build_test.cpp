// How a submission is compiled, and the student's message if it does not compile.
#include <thread>

#include "judge/submission/toolchain.hpp"
#include "sandbox/printable.hpp"
#include "tests/submissions.hpp"

namespace mc::tests::build {

namespace {

/// A directory that other users can read: compilers run as another user if the judge is root.
struct OpenScratch : Scratch {
  OpenScratch() { fs::permissions(path(), fs::perms(0755)); }
  fs::path write_program(const std::string& name, const std::string& text) const {
    const fs::path file = write(name, "#!/bin/sh\n" + text);
    fs::permissions(file, fs::perms(0755));
    return file;
  }
};

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

TEST_CASE("a file in UTF-16 is named as such") {
  const Labs labs;
  for (const std::string mark : {"\xff\xfe", ""}) {
    std::string text = mark;
    for (const char c : labs.starter) text += {c, '\0'};
    CHECK(labs.failure(text) ==
          "variance.cpp is encoded in UTF-16, which compilers do not read. Save it as UTF-8.");
  }
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
  for (const std::string file :
       {"/etc/passwd", "/etc/../etc/hosts", "/dev/zero", "/dev/ptmx", "/proc/self/environ",
        "../../solutions/variance.cpp", "common/../../solutions/variance.cpp"}) {
    const std::string failure = labs.failure("#include \"" + file + "\"\n");
    CAPTURE(failure);
    CHECK(!contains(failure, "root:"));
    CHECK(contains(failure, "Permission denied"));
    CHECK(contains(failure, "nothing else."));
    CHECK(!contains(failure, labs.layout.root.string()));
  }
  CHECK(labs.failure("asm(\".incbin \\\"/etc/passwd\\\"\");\n" + labs.starter) ==
        "The assembler rejects an asm statement in variance.cpp.");
  CHECK(labs.failure("#include <linux/types.h>\n" + labs.starter).empty());
}

TEST_CASE("a checkout in a place of the system is not one of the compiler's places") {
  Layout layout = read_layout();
  layout.root = "/usr/share";
  const auto& places = toolchain(layout);
  CHECK(is_in("/usr/include/stdio.h", places));
  CHECK(is_in(fs::canonical(layout.compiler), places));
  CHECK_FALSE(is_in("/usr/share/solutions/variance.cpp", places));
  CHECK_FALSE(is_in("/etc/passwd", places));
}

TEST_CASE("what a build command depends on, in a make rule") {
  const auto files = dependencies("unit.o: a.cpp \\\n /b\\ c/d.hpp $$e\n");
  CHECK(files == std::vector<fs::path>{"a.cpp", "/b c/d.hpp", "$e"});
}

// The compiler's own programs stand in for a machine that kills them, or that lacks something.
TEST_CASE("a tool that was killed or found no room is the machine's fault, not the submission's",
          "[.slow]") {
  Labs labs;
  const OpenScratch place;
  const std::string compiler = labs.layout.compiler;
  if (labs.layout.is_clang) return;  // it has the compiler in the same process
  labs.layout.compiler =
      place
          .write_program(
              "c++", "exec " + compiler + " -B " + (place.path() / "bin").string() + "/ \"$@\"\n")
          .string();
  const auto real = [&](const std::string& name) {
    const std::string path = sandbox::run_process({compiler, "-print-prog-name=" + name}).output;
    return sandbox::found_in_path(path.substr(0, path.find('\n')));
  };
  const std::string cc1plus = real("cc1plus"), large = "grep -qs LARGE variance.cpp && ";
  const struct {
    const char* program;
    std::string text, says;
  } faults[] = {
      {"cc1plus", "kill -9 $$", "Killed"},
      {"cc1plus", large + "kill -9 $$\nexec " + cc1plus + " \"$@\"", "Killed"},
      {"as", "echo 'Fatal error: can not write: Disk quota exceeded' >&2; exit 1", "quota"},
      {"ld", "kill -9 $$", "signal 9"},
      {"ld", "echo 'final link failed: No space left on device' >&2; exit 1", "No space"},
  };
  for (const auto& fault : faults) {
    const fs::path program = place.write_program(std::string("bin/") + fault.program, fault.text);
    CAPTURE(fault.program, fault.text);
    CHECK_THROWS_AS(labs.failure(labs.starter + "// LARGE " + fault.says + '\n'), MachineError);
    fs::remove(program);
  }
  // A text that says so is at fault.
  CHECK(contains(labs.failure("static_assert(false, \"\\ng++: fatal error: Killed signal\");\n"),
                 "does not compile"));
  CHECK(labs.failure(labs.starter).empty());
}

TEST_CASE("a file that does not compile is compiled once, for all labs that use it") {
  const Labs labs;
  const Scratch scratch;
  scratch.write("variance.cpp", "int x = \"no\";\n");
  const BuildResult first = labs.build(scratch.path()), second = labs.build(scratch.path());
  CHECK(first.cpu_seconds > 0);
  CHECK(second.cpu_seconds == 0);
  CHECK(first.failure == second.failure);
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
