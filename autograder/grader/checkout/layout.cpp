#include "grader/checkout/layout.hpp"

#include <fstream>

#include "grader/base/errors.hpp"
#include "runner/text.hpp"
#include "sandbox/process.hpp"

#ifdef __APPLE__
#include <mach-o/dyld.h>
#endif

namespace mc::grader {
namespace fs = std::filesystem;

namespace {

/// The build directory: this program is in its bin/.
fs::path build_directory() {
#ifdef __APPLE__
  char path[4096];
  std::uint32_t size = sizeof path;
  if (_NSGetExecutablePath(path, &size) != 0) throw MachineError("where is this program?");
  return fs::canonical(path).parent_path().parent_path();
#else
  return fs::canonical("/proc/self/exe").parent_path().parent_path();
#endif
}

}  // namespace

Layout read_layout() {
  const fs::path build = build_directory();
  std::ifstream file(build / "layout.txt");
  if (!file) throw MachineError("the build directory is incomplete: run ./lab setup");
  Layout layout;
  layout.build = build;
  std::string line;
  while (std::getline(file, line)) {
    const auto at = line.find('=');
    if (at == std::string::npos) continue;
    const std::string key = line.substr(0, at), value = line.substr(at + 1);
    if (key == "root") layout.root = value;
    if (key == "compiler") layout.compiler = value;
    if (key == "sanitized") layout.sanitized = value == "yes";
    if (key == "version") layout.version = value;
    if (key == "compiler_id") layout.is_clang = value.find("Clang") != std::string::npos;
    if (key.starts_with("peers.")) layout.peers[key.substr(6)];
    if (key == "link_flags" || key.starts_with("objects.") || key.starts_with("peers.")) {
      for (const std::string_view part : text::split(value, ';')) {
        if (part.empty()) continue;
        if (key == "link_flags") {
          layout.link_flags.emplace_back(part);
        } else if (key.starts_with("peers.")) {
          layout.peers[key.substr(6)].emplace_back(part);
        } else {
          layout.objects[key.substr(8)].emplace_back(part);
        }
      }
    }
  }
  // A package from ./lab gradescope records the version it was made from.
  if (std::ifstream taken(layout.root / "VERSION.txt"); std::getline(taken, line)) {
    layout.version = line;
    return layout;
  }
  const auto commit = sandbox::run_process(
      {"git", "-C", layout.root.string(), "describe", "--always", "--dirty", "--exclude=*"});
  if (commit.succeeded()) {
    layout.version += " (" + commit.output.substr(0, commit.output.find('\n')) + ")";
  }
  return layout;
}

}  // namespace mc::grader
