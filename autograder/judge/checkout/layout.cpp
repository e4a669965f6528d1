#include "judge/checkout/layout.hpp"

#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <system_error>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "judge/base/errors.hpp"
#include "judge/base/text_file.hpp"
#include "sandbox/programs.hpp"

namespace mc::grader {
namespace fs = std::filesystem;

namespace {

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
  fs::create_directories(layout.build);
  layout.compiler = find_compiler();
  if (layout.compiler.empty()) return;
  layout.is_clang = sandbox::run_process({layout.compiler, "--version"}).output.find("clang") !=
                    std::string::npos;
}

}  // namespace

Layout read_layout() {
  Layout layout;
  layout.bin = fs::canonical("/proc/self/exe").parent_path();
  layout.build = layout.bin.parent_path();
  const fs::path file = layout.build / "layout.json";
  if (!fs::exists(file)) throw MachineError("the build directory is incomplete: run ./lab setup");
  const auto json = nlohmann::json::parse(read_whole_text(file));
  const auto read = [&](const char* key, auto& value) {
    if (json.contains(key)) json.at(key).get_to(value);
  };
  read("judge_is_compiled", layout.judge_is_compiled);
  read("sanitized", layout.sanitized);
  read("version", layout.version);
  read("compiler", layout.compiler);
  read("is_clang", layout.is_clang);
  read("link_flags", layout.link_flags);
  read("peers", layout.peers);
  std::erase(layout.link_flags, "");  // CMake's empty lists
  for (auto& [name, flags] : layout.peers) std::erase(flags, "");
  if (json.contains("root")) layout.root = json.at("root").get<std::string>();
  if (json.contains("objects")) {
    for (const auto& [lab, objects] : json.at("objects").items()) {
      for (const auto& object : objects) layout.objects[lab].push_back(object.get<std::string>());
    }
  }
  std::ifstream packed(layout.root / "VERSION.txt");
  if (layout.judge_is_compiled) {
    find_surroundings(layout);
  } else if (std::string line; std::getline(packed, line)) {
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
