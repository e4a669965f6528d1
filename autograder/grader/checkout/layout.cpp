#include "grader/checkout/layout.hpp"

#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <system_error>

#include <fmt/format.h>

#include "grader/base/errors.hpp"
#include "grader/base/text_file.hpp"
#include "runner/text.hpp"
#include "sandbox/programs.hpp"

#ifdef __APPLE__
#include <mach-o/dyld.h>
#endif

namespace mc::grader {
namespace fs = std::filesystem;

namespace {

/// The directory of this program.
fs::path program_directory() {
#ifdef __APPLE__
  char path[4096];
  std::uint32_t size = sizeof path;
  if (_NSGetExecutablePath(path, &size) != 0)
    throw MachineError("cannot find the path of this program");
  return fs::canonical(path).parent_path();
#else
  return fs::canonical("/proc/self/exe").parent_path();
#endif
}

/// The first C++ compiler on the path; CXX comes first. Empty if there is none.
std::string find_compiler() {
  const char* const chosen = std::getenv("CXX");
  for (const char* name : {chosen == nullptr ? "" : chosen, "c++", "g++", "clang++"}) {
    std::string file = sandbox::found_in_path(name);
    if (file.find('/') != std::string::npos && !fs::is_directory(file) &&
        access(file.c_str(), X_OK) == 0) {
      return file;
    }
  }
  return {};
}

/// Where a handout builds: in itself, elsewhere if it is read-only.
fs::path writable_build_directory(const fs::path& root) {
  if (const char* const chosen = std::getenv("MC_BUILD"); chosen != nullptr && *chosen != '\0') {
    return chosen;
  }
  std::error_code error;
  fs::create_directories(root / "build", error);
  if (!error && access((root / "build").c_str(), W_OK) == 0) return root / "build";
  const char* const cache = std::getenv("XDG_CACHE_HOME");
  const char* const home = std::getenv("HOME");
  const fs::path place =
      cache != nullptr ? fs::path(cache) : fs::path(home == nullptr ? "/tmp" : home) / ".cache";
  return place / "monte-carlo-labs" / fmt::format("{:016x}", hash_text(root.string()));
}

/// The layout of a handout with a compiled judge.
void find_surroundings(Layout& layout) {
  layout.root = layout.bin.parent_path().parent_path().parent_path();
  layout.build = writable_build_directory(layout.root);
  std::error_code error;
  fs::create_directories(layout.build, error);
  if (error) {
    throw MachineError(fmt::format("cannot write in {} or in {}: set MC_BUILD to another directory",
                                   (layout.root / "build").string(), layout.build.string()));
  }
  layout.compiler = find_compiler();
  if (layout.compiler.empty()) return;
  layout.is_clang = sandbox::run_process({layout.compiler, "--version"}).output.find("clang") !=
                    std::string::npos;
}

/// The parts of one of CMake's lists.
std::vector<std::string> parts_of(const std::string& list) {
  std::vector<std::string> parts;
  for (const std::string_view part : text::split(list, ';')) {
    if (!part.empty()) parts.emplace_back(part);
  }
  return parts;
}

}  // namespace

Layout read_layout() {
  Layout layout;
  layout.bin = program_directory();
  layout.build = layout.bin.parent_path();
  std::ifstream file(layout.build / "layout.txt");
  if (!file) throw MachineError("the build directory is incomplete: run ./lab setup");
  std::string line;
  while (std::getline(file, line)) {
    const auto at = line.find('=');
    if (at == std::string::npos) continue;
    const std::string key = line.substr(0, at), value = line.substr(at + 1);
    const std::vector<std::string> parts = parts_of(value);
    if (key == "root") layout.root = value;
    if (key == "compiler") layout.compiler = value;
    if (key == "judge_is_compiled") layout.judge_is_compiled = value == "yes";
    if (key == "sanitized") layout.sanitized = value == "yes";
    if (key == "version") layout.version = value;
    if (key == "compiler_id") layout.is_clang = value.find("Clang") != std::string::npos;
    if (key == "link_flags") layout.link_flags = parts;
    if (key.starts_with("peers.")) layout.peers[key.substr(6)] = parts;
    if (key.starts_with("objects.")) layout.objects[key.substr(8)] = {parts.begin(), parts.end()};
  }
  if (layout.judge_is_compiled) {
    find_surroundings(layout);
  } else if (std::ifstream packed(layout.root / "VERSION.txt"); std::getline(packed, line)) {
    layout.version = line;  // Gradescope's package with sources: its points are in it
    return layout;
  } else {
    const auto commit =
        sandbox::run_git(layout.root, {"describe", "--always", "--dirty", "--exclude=*"});
    if (commit.succeeded()) {
      layout.version += " (" + commit.output.substr(0, commit.output.find('\n')) + ")";
    }
  }
  // A verdict with other points is another version's.
  const std::string points = read_text(layout.root / "points.csv");
  if (!points.empty() && layout.version.find(" points ") == std::string::npos) {
    layout.version += fmt::format(" points {:08x}", hash_text(points) & 0xffffffffu);
  }
  return layout;
}

}  // namespace mc::grader
