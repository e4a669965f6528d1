#include "grader/submission/build.hpp"

#include <algorithm>
#include <map>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "grader/base/errors.hpp"
#include "grader/base/text_file.hpp"
#include "grader/submission/cache.hpp"
#include "grader/submission/compile.hpp"
#include "grader/submission/diagnostics.hpp"
#include "grader/submission/from_source.hpp"
#include "grader/submission/scratch.hpp"
#include "grader/submission/segments.hpp"

namespace mc::grader {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t most_static_memory = std::size_t{400} << 20;

}  // namespace

BuildResult build_program(const Layout& layout, const Lab& lab, const Submission& submission,
                          unsigned workers) {
  BuildResult built;
  std::vector<std::string> names = lab.depends_on;
  names.push_back(lab.name);
  const std::vector<Lab> labs = find_labs(layout);
  std::vector<Unit> units;
  for (const std::string& name : names) {
    const auto file = submission.files.find(name);
    const Lab& owner = find_lab(labs, name);
    if (file == submission.files.end()) {
      const std::string others = what_is_there(submission);
      built.failure = name == lab.name ? fmt::format("There is no {}{}.", owner.file(), others)
                                       : fmt::format("{} depends on lab {}: it needs {} too{}.",
                                                     lab.file(), owner.number, owner.file(), others);
      return built;
    }
    units.push_back({layout, owner, file->second, submission.trusted});
  }

  const std::vector<fs::path> trusted_objects = shared_objects(layout, lab);
  std::vector<Object> compiled(units.size());
  run_side_by_side(units.size(), workers, [&](std::size_t i) { compiled[i] = compile(units[i]); });
  std::vector<fs::path> objects;
  for (const Object& object : compiled) {
    built.cpu_seconds += object.cpu_seconds;
    if (built.failure.empty()) built.failure = object.failure;
    objects.push_back(object.path);
  }
  if (!built.failure.empty()) return built;

  std::string key =
      fmt::format("{} {}", fmt::join(layout.link_flags, " "), fmt::join(submission.libraries, " "));
  for (const Object& object : compiled) {
    key += fmt::format(" {}\n{}\n", object.key.size(), object.key);
  }
  for (const fs::path& object : trusted_objects) {
    key += fmt::format("{} {}", object.string(),
                       fs::last_write_time(object).time_since_epoch().count());
  }
  const fs::path slot = slot_of(units.back());
  if (const auto path = find_cached(slot, "program", key)) {
    built.program = sandbox::open_program(path->string());
    return built;
  }

  const ScratchDirectory scratch(layout);
  const fs::path temporary = scratch.path() / "program";
  std::vector<std::string> command{layout.compiler, "-s"};
  // For an object that looks like link-time optimization, the linker would start a compiler, whose
  // includes are not checked.
  command.push_back("-fno-lto");
  if (!layout.is_clang) command.push_back("-fno-use-linker-plugin");
  command.insert(command.end(), layout.link_flags.begin(), layout.link_flags.end());
  for (const fs::path& object : objects) command.push_back(object.string());
  for (const fs::path& object : trusted_objects) command.push_back(object.string());
  command.insert(command.end(), submission.libraries.begin(), submission.libraries.end());
  command.insert(command.end(), {"-o", temporary.string()});
  const CompilerRun run =
      run_compiler(layout, command, scratch.path(), [](const std::string& errors) {
        return errors.find("undefined") != std::string::npos ||
               errors.find("multiple definition") != std::string::npos;
      });
  const sandbox::ProcessResult& linked = run.result;
  built.cpu_seconds += linked.cpu_seconds;
  if (!run.stopped.empty()) {
    built.failure = fmt::format("The linker {} on {}.", run.stopped, lab.file());
    return built;
  }
  if (!linked.succeeded()) {
    for (const fs::path& object : objects) {
      if (!fs::exists(object))
        throw MachineError(object.string() + " was removed during the build");
    }
    std::map<std::string, std::string> headers;
    for (const Lab& other : labs) {
      headers[other.name] = read_text(layout.labs() / other.folder / other.header());
    }
    built.failure = explain_link_errors(linked.errors, lab, headers);
    return built;
  }
  const Segments segments = segments_of(temporary);
  if (segments.memory > most_static_memory) {
    built.failure = fmt::format("The global variables of {} take {} MB; {} MB is the most.",
                                lab.file(), segments.memory >> 20, most_static_memory >> 20);
    return built;
  }
  // The kernel would open the loader for the program, even in the jail.
  if (segments.loader) {
    built.failure = fmt::format("{} names its own loader (a section .interp).", lab.file());
    return built;
  }
  fs::permissions(temporary, fs::perms::owner_all | fs::perms::group_read | fs::perms::group_exec |
                                 fs::perms::others_read | fs::perms::others_exec);
  sandbox::Program program = sandbox::open_program(temporary.string());  // immune to later renames
  program.path = keep_cached(slot, "program", key, temporary).string();
  built.program = std::move(program);
  return built;
}

}  // namespace mc::grader
