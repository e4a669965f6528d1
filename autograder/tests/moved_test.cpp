// A checkout that was moved or copied with its build, and one on a machine that lacks a package. A
// stub replaces what the entry script builds: it says where it was configured.
#include <chrono>
#include <cstdlib>
#include <map>
#include <thread>

#include "tests/submissions.hpp"

namespace mc::tests::moved {

namespace {

constexpr const char* stub = R"(cmake_minimum_required(VERSION 3.22)
project(stub LANGUAGES NONE)
file(APPEND ${CMAKE_SOURCE_DIR}/configured.txt "${CMAKE_BINARY_DIR}\n")
file(WRITE ${CMAKE_BINARY_DIR}/layout.json "{}\n")
file(WRITE ${CMAKE_BINARY_DIR}/bin/lab "#!/bin/sh\necho ${CMAKE_SOURCE_DIR}\n")
file(CHMOD ${CMAKE_BINARY_DIR}/bin/lab PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE)
add_custom_target(start COMMAND ${CMAKE_COMMAND} -E touch ${CMAKE_BINARY_DIR}/built)
)";

sandbox::ProcessResult run_lab(const fs::path& checkout, const Words& words = {"--version"},
                               const std::string& search_path = std::getenv("PATH")) {
  return sandbox::run_process(
      joined({checkout / "lab"}, words),
      {.environment = {{"MC_BUILD", ""}, {"CI", "true"}, {"PATH", search_path}}});
}

/// A checkout in which ./lab has been called once.
struct Checkout : Scratch {
  fs::path first, other;

  Checkout() {
    const fs::path here = fs::canonical(path());
    first = here / "first", other = here / "the other";
    fs::create_directories(first / "cmake");
    for (const char* file : {"lab", "cmake/setup.sh"}) {
      fs::copy_file(read_layout().root / file, first / file);
    }
    write("first/CMakeLists.txt", stub);
    REQUIRE(run_lab(first).output == first.string() + '\n');
    write("first/build/progress/variance", "40 100 1.5 1\n");
  }
};

/// All files below, with their modification times.
std::map<fs::path, fs::file_time_type> listing(const fs::path& directory) {
  std::map<fs::path, fs::file_time_type> all;
  for (const auto& entry : fs::recursive_directory_iterator(directory)) {
    all[entry.path()] = entry.last_write_time();
  }
  return all;
}

std::size_t configured(const fs::path& checkout) {
  return lines(read_text(checkout / "configured.txt"));
}

/// It is configured and built at its own path, once, and a message says so.
void is_rebuilt_there(const Checkout& checkout) {
  REQUIRE_RUN(run, run_lab(checkout.other));
  CHECK(run.output == checkout.other.string() + '\n');
  CHECK(contains(run.errors, "was built for " + checkout.first.string()));
  const auto again = run_lab(checkout.other);
  CHECK(again.output == run.output);
  CHECK(again.errors.empty());
  CHECK(configured(checkout.other) == 2);
  CHECK(fs::exists(checkout.other / "build" / "built"));
  CHECK(fs::exists(checkout.other / "build" / "progress" / "variance"));
}

}  // namespace

TEST_CASE("a copied checkout is built again, and nothing is written into the original",
          "[script]") {
  const Checkout checkout;
  fs::copy(checkout.first, checkout.other, fs::copy_options::recursive);
  const auto before = listing(checkout.first);
  is_rebuilt_there(checkout);
  CHECK(listing(checkout.first) == before);
}

TEST_CASE("two calls at once in a moved checkout build it again, once", "[script]") {
  const Checkout checkout;
  fs::rename(checkout.first, checkout.other);
  sandbox::ProcessResult runs[2];
  std::thread second([&] { runs[1] = run_lab(checkout.other); });
  runs[0] = run_lab(checkout.other);
  second.join();
  for (const auto& run : runs) {
    CAPTURE(run.errors);
    CHECK(run.output == checkout.other.string() + '\n');
  }
  CHECK(configured(checkout.other) == 2);
}

TEST_CASE("a checkout called through a link keeps its build", "[script]") {
  const Checkout checkout;
  fs::create_directory_symlink(checkout.first, checkout.other);
  const auto run = run_lab(checkout.other);
  CHECK(run.output == checkout.first.string() + '\n');
  CHECK(run.errors.empty());
  CHECK(configured(checkout.first) == 1);
}

TEST_CASE("a path that CMake cannot build in is one line", "[script]") {
  const Checkout checkout;
  for (const char* name : {"a;b", "labs [2026]"}) {
    fs::copy(checkout.first, checkout.path() / name, fs::copy_options::recursive);
    const auto run = run_lab(checkout.path() / name);
    CHECK(run.exit_code == 3);
    CHECK(lines(run.errors) == 1);
    CHECK(contains(run.errors, name));
  }
}

TEST_CASE("files of the future are named in one line, before a build that would never end",
          "[script]") {
  const Checkout checkout;
  fs::remove_all(checkout.first / "build");
  fs::last_write_time(checkout.first / "cmake" / "setup.sh",
                      fs::file_time_type::clock::now() + std::chrono::hours(1));
  const auto run = run_lab(checkout.first);
  CHECK(run.exit_code == 3);
  CHECK(lines(run.errors) == 1);
  CHECK(contains(run.errors, "setup.sh is dated in the future: set the clock"));
}

TEST_CASE("the first call installs what is missing, and builds", "[script]") {
  const Checkout checkout;
  fs::remove_all(checkout.first / "build");
  // A search path without gnuplot, whose apt-get installs it.
  const fs::path programs = checkout.path() / "programs";
  fs::create_directories(programs);
  for (const char* directory : {"/usr/bin", "/bin", "/usr/local/bin"}) {
    if (!fs::exists(directory)) continue;
    for (const auto& program : fs::directory_iterator(directory)) {
      const fs::path name = program.path().filename();
      if (name == "gnuplot" || name == "apt-get" || name == "sudo") continue;
      if (fs::exists(fs::symlink_status(programs / name))) continue;
      fs::create_symlink(program.path(), programs / name);
    }
  }
  write_text(
      programs / "apt-get",
      fmt::format("#!/bin/sh\n[ $1 = update ] || cp {0}/true {0}/gnuplot\n", programs.string()));
  fs::permissions(programs / "apt-get", fs::perms::owner_all);
  const auto run = run_lab(checkout.first, {"check", "variance"}, programs);
  CAPTURE(run.errors);
  CHECK(run.exit_code == 0);
  check_contains(run.errors,
                 {"Missing: gnuplot", "apt-get install -y --no-install-recommends gnuplot-nox"});
  CHECK(fs::exists(programs / "gnuplot"));
  CHECK(fs::exists(checkout.first / "build" / "built"));
}

}  // namespace mc::tests::moved
