#include "judge/submission/from_source.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <mutex>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "judge/base/errors.hpp"
#include "judge/base/side_by_side.hpp"
#include "judge/base/text_file.hpp"
#include "judge/submission/compile.hpp"
#include "judge/submission/toolchain.hpp"
#include "sandbox/printable.hpp"
#include "sandbox/process.hpp"

namespace mc::grader {
namespace fs = std::filesystem;
namespace {

struct Source {
  fs::path file, object;
  std::vector<std::string> flags = {};  ///< for this file alone
};

/// "starter", or a whole path, as one name.
std::string name_of(const Layout& layout, const fs::path& directory) {
  const fs::path real = fs::canonical(directory), root = fs::canonical(layout.root);
  std::string name = real.lexically_relative(root).string();
  if (name.starts_with(".")) name = real.string();
  std::ranges::replace(name, '/', '_');
  return name;
}

fs::path sibling(const fs::path& file, const char* extension) {
  fs::path other = file;
  return other.replace_extension(extension);
}

/// A hash of the command and of everything that the compiler read last time, without the system's
/// headers: the object stays valid as long as it does not change.
std::string fingerprint(const std::string& command, const fs::path& object) {
  std::uint64_t hash = hash_text(command);
  for (const fs::path& file : dependencies(read_text(sibling(object, ".d")))) {
    hash = hash_text(read_text(file), hash);
  }
  return fmt::format("{:016x}", hash);
}

std::vector<std::string> command_for(const Layout& layout, const std::vector<std::string>& flags) {
  if (layout.compiler.empty()) {
    throw MachineError(
        "there is no C++ compiler: install one that supports C++20 (sudo apt install g++, or sudo "
        "dnf "
        "install gcc-c++ glibc-static libstdc++-static), or set CXX");
  }
  const auto includes = include_flags(layout, true);  // a mistake includes the solution
  std::vector<std::string> command{layout.compiler, "-std=c++20", "-ffp-contract=off"};
  command.insert(command.end(), flags.begin(), flags.end());
  command.insert(command.end(), includes.begin(), includes.end());
  return command;
}

/// Compiles one file to a temporary name and renames it. Returns the compiler's messages on
/// failure.
std::string compile_source(std::vector<std::string> command, const Source& source) {
  command.insert(command.end(), source.flags.begin(), source.flags.end());
  command.insert(command.end(), {"-c", source.file.string()});
  const std::string key = fmt::format("{}", fmt::join(command, " "));
  const fs::path known = sibling(source.object, ".key");
  if (fs::exists(source.object) && read_text(known) == fingerprint(key, source.object)) return {};
  fs::create_directories(source.object.parent_path());
  const std::string temporary = fmt::format("{}.{}", source.object.string(), getpid());
  command.insert(command.end(), {"-o", temporary, "-MMD", "-MT", "object", "-MF",
                                 sibling(source.object, ".d").string()});
  const auto run = sandbox::run_process(command);
  if (!run.succeeded()) return run.errors.empty() ? "the compiler failed\n" : run.errors;
  fs::rename(temporary, source.object);
  write_text(known, fingerprint(key, source.object));
  return {};
}

/// Compiles the files side by side. Returns the first failure's messages.
std::string compile_sources(const std::vector<Source>& sources,
                            const std::vector<std::string>& command) {
  std::vector<std::string> failures(sources.size());
  run_side_by_side(sources.size(), cores(),
                   [&](std::size_t i) { failures[i] = compile_source(command, sources[i]); });
  for (const std::string& failure : failures) {
    if (!failure.empty()) return failure;
  }
  return {};
}

/// The lab's experiments first: they take longest.
std::vector<Source> shared_sources(const Layout& layout, const Lab& lab, const fs::path& place) {
  std::vector<Source> sources{
      {layout.labs() / lab.folder / "experiments.cpp", place / lab.name / "experiments.o"}};
  for (const fs::directory_entry& file : fs::directory_iterator(layout.labs() / "runner")) {
    if (file.path().extension() != ".cpp") continue;
    sources.push_back({file.path(), place / "runner" / file.path().stem().concat(".o")});
  }
  return sources;
}

/// Throws MachineError if this compiler cannot link programs as the judge does. Links one, once.
void require_static_libraries(const Layout& layout) {
  const fs::path place = layout.build / "objects",
                 program = place / fmt::format("empty-{:016x}", hash_text(layout.compiler)),
                 source = place / "empty.cpp";
  if (fs::exists(program)) return;
  fs::create_directories(place);
  write_text(source, "#include <vector>\nint main() { return std::vector<int>{}.empty(); }\n");
  std::vector<std::string> command{layout.compiler, source.string(), "-o", program.string()};
  command.insert(command.end(), layout.link_flags.begin(), layout.link_flags.end());
  if (sandbox::run_process(command).succeeded()) return;
  throw MachineError(
      "the compiler cannot link a static program: install glibc-static and libstdc++-static "
      "(dnf), or libc6-dev and the compiler's libstdc++ package (apt)");
}

}  // namespace

BuildKind for_sanitizers() {
  const std::string sanitizers = "-fsanitize=address,undefined";
  return {"sanitize",
          {"-Og", "-g", "-fno-omit-frame-pointer", sanitizers, "-D_GLIBCXX_ASSERTIONS"},
          {sanitizers}};
}

BuildKind for_debugger() {
  return {"debug", {"-O0", "-g", "-D_GLIBCXX_ASSERTIONS"}, {}};
}

ProgramByHand build_by_hand(const Layout& layout, const Lab& lab, const Submission& submission,
                            const BuildKind& kind) {
  const fs::path place = layout.build / kind.name;
  const fs::path own = place / lab.name / name_of(layout, submission.path);
  std::vector<Source> sources = shared_sources(layout, lab, place);
  // The judge includes these headers, too.
  const std::vector<std::string> standard_headers{
      "-include", (layout.labs() / "runner" / "standard_headers.hpp").string()};
  std::vector<std::string> names = lab.depends_on;
  names.push_back(lab.name);
  for (const std::string& name : names) {
    const auto file = submission.files.find(name);
    if (file == submission.files.end()) return {{}, fmt::format("There is no {}.cpp.\n", name)};
    sources.push_back({file->second, own / (name + ".o"), standard_headers});
  }

  const std::string failure = compile_sources(sources, command_for(layout, kind.compile_flags));
  if (!failure.empty()) return {{}, failure};

  const fs::path program = own / lab.name;
  const bool is_current =
      fs::exists(program) && std::ranges::all_of(sources, [&](auto& source) {
        return fs::last_write_time(source.object) < fs::last_write_time(program);
      });
  if (is_current) return {program, {}};
  const std::string temporary = fmt::format("{}.{}", program.string(), getpid());
  std::vector<std::string> command{layout.compiler, "-o", temporary};
  command.insert(command.end(), kind.link_flags.begin(), kind.link_flags.end());
  for (const Source& source : sources) command.push_back(source.object.string());
  const auto linked = sandbox::run_process(command);
  if (!linked.succeeded()) {
    return {{},
            linked.errors +
                "(If the linker misses the sanitizers themselves: Fedora has them in the "
                "packages libasan and libubsan.)\n"};
  }
  fs::rename(temporary, program);
  return {program, {}};
}

std::vector<fs::path> shared_objects(const Layout& layout, const Lab& lab) {
  if (!layout.judge_is_compiled) return layout.objects.at(lab.name);
  static std::mutex one_at_a_time;
  const std::lock_guard lock(one_at_a_time);
  static std::map<std::string, std::vector<fs::path>> done;
  if (const auto found = done.find(lab.name); found != done.end()) return found->second;
  const auto command =
      command_for(layout, {fmt::format("-ffile-prefix-map={}/=", layout.root.string())});
  require_static_libraries(layout);
  std::vector<Source> sources = shared_sources(layout, lab, layout.build / "objects");
  for (Source& source : sources) source.flags = {"-O1"};
  sources[0].flags = {"-O3"};  // the experiments: nothing else computes for long
  const std::string failure = compile_sources(sources, command);
  if (!failure.empty()) {
    throw MachineError(fmt::format("lab {} does not compile here (C++20 is needed):\n{}",
                                   lab.number, sandbox::shortened(failure, 2000)));
  }
  std::vector<fs::path> objects;
  for (const Source& source : sources) objects.push_back(source.object);
  return done[lab.name] = objects;
}

}  // namespace mc::grader
