#include "judge/submission/toolchain.hpp"

#include <algorithm>
#include <map>
#include <mutex>
#include <system_error>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "judge/base/errors.hpp"
#include "sandbox/printable.hpp"

namespace mc::grader {
namespace fs = std::filesystem;
namespace {

/// Adds a place; if it holds a closed one, what else is in it instead.
void add(const fs::path& place, const std::vector<fs::path>& closed, std::vector<fs::path>& to) {
  std::error_code absent;
  const fs::path real = fs::canonical(place, absent);
  if (absent || is_in(real, to) || std::ranges::find(closed, real) != closed.end()) return;
  if (std::ranges::none_of(closed, [&](auto& one) { return is_in(one, {real}); })) {
    to.push_back(real);
    return;
  }
  for (const auto& entry : fs::directory_iterator(real, absent)) {
    if (!entry.is_symlink()) add(entry.path(), closed, to);
  }
}

/// The compiler's own directories. Its headers are in PREFIX/lib/gcc/MACHINE/VERSION/include, or in
/// PREFIX/lib/clang/VERSION/include; a wrapper is elsewhere.
std::vector<fs::path> directories_of(const std::string& compiler) {
  const auto run = sandbox::run_process({compiler, "-print-file-name=include"});
  const std::string headers = run.output.substr(0, run.output.find('\n'));
  if (!run.succeeded()) {
    throw MachineError(fmt::format("{} -print-file-name=include fails: {}", compiler,
                                   sandbox::printable_line(run.errors.substr(0, 200))));
  }
  std::vector<fs::path> places{fs::path(compiler).parent_path(),
                               fs::canonical(compiler).parent_path()};
  const auto below = std::min(headers.rfind("/gcc/"), headers.rfind("/clang/"));
  const auto at = headers.rfind("/lib", below);
  if (!headers.starts_with('/') || below == headers.npos || at == headers.npos) return places;
  places.push_back(fs::path(headers).parent_path());
  const fs::path prefix = headers.substr(0, at);
  // A machine's directory has its linker and libraries: PREFIX/x86_64-conda-linux-gnu.
  const std::string machine = fs::path(headers).parent_path().parent_path().filename();
  for (const std::string part : {"bin", "include", "lib", "lib64", "libexec", machine.c_str()}) {
    places.push_back(prefix / part);
  }
  return places;
}

}  // namespace

bool is_in(const fs::path& path, const std::vector<fs::path>& places) {
  return std::ranges::any_of(places, [&](const fs::path& place) {
    return std::mismatch(place.begin(), place.end(), path.begin(), path.end()).first == place.end();
  });
}

const std::vector<fs::path>& toolchain(const Layout& layout) {
  static std::mutex mutex;
  static std::map<std::string, std::vector<fs::path>> known;
  const std::lock_guard lock(mutex);
  std::vector<fs::path>& places = known[layout.compiler + '\n' + layout.root.string()];
  if (!places.empty()) return places;
  const std::vector<fs::path> closed{fs::canonical(layout.root), fs::canonical(layout.build)};
  for (const char* place :
       {"/usr", "/bin", "/lib", "/lib32", "/lib64", "/libx32", "/opt", "/nix/store", "/gnu/store",
        "/etc/ld.so.cache", "/etc/ld.so.conf", "/etc/ld.so.conf.d"}) {
    add(place, closed, places);
  }
  for (const char* variable : {"LD_LIBRARY_PATH", "COMPILER_PATH"}) {
    for (const std::string& place : sandbox::places_in(variable)) add(place, closed, places);
  }
  for (const fs::path& place : directories_of(layout.compiler)) add(place, closed, places);
  return places;
}

sandbox::Environment compiler_environment(const fs::path& directory) {
  return {
      {"TMPDIR", directory.string()},
      {"HOME", directory.string()},
      {"COMPILER_PATH", fmt::format("{}", fmt::join(sandbox::places_in("COMPILER_PATH"), ":"))}};
}

std::string identity_of_compiler(const Layout& layout) {
  const fs::path real = fs::canonical(layout.compiler);
  std::string identity = fmt::format("{} {} {}", layout.compiler, fs::file_size(real),
                                     fs::last_write_time(real).time_since_epoch().count());
  for (const auto& [name, value] : sandbox::fixed_environment()) identity += ' ' + value;
  for (const auto& [name, value] : compiler_environment({})) identity += ' ' + value;
  // What was compiled without confinement may hold any file of that machine.
  identity += sandbox::places_are_enforced() ? " confined" : " not confined";
  return identity;
}

std::vector<fs::path> dependencies(const std::string& rule) {
  std::vector<fs::path> files;
  std::string word;
  const auto colon = rule.find(": ");
  if (colon == std::string::npos) return files;
  for (std::size_t i = colon + 2; i <= rule.size(); ++i) {
    const char c = i < rule.size() ? rule[i] : '\n';
    const char next = i + 1 < rule.size() ? rule[i + 1] : '\n';
    if ((c == '\\' && (next == ' ' || next == '#' || next == '\\')) || (c == '$' && next == '$')) {
      word += rule[++i];
    } else if (c == ' ' || c == '\n' || (c == '\\' && next == '\n')) {
      if (!word.empty()) files.emplace_back(word);
      word.clear();
    } else {
      word += c;
    }
  }
  return files;
}

}  // namespace mc::grader
