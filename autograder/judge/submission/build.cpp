#include "judge/submission/build.hpp"

#include <elf.h>

#include <algorithm>
#include <cstring>
#include <map>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "judge/base/errors.hpp"
#include "judge/base/text_file.hpp"
#include "judge/submission/cache.hpp"
#include "judge/submission/compile.hpp"
#include "judge/submission/diagnostics.hpp"
#include "judge/submission/from_source.hpp"
#include "judge/submission/scratch.hpp"

namespace mc::grader {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t most_static_memory = std::size_t{400} << 20;

/// Why the sandbox cannot start a linked program; empty if it can.
std::string refusal_of(const fs::path& program, const Lab& lab) {
  const std::string bytes = read_whole_text(program);
  const auto read = [&](std::size_t offset, auto& to) {
    return offset <= bytes.size() && bytes.size() - offset >= sizeof to &&
           std::memcpy(&to, bytes.data() + offset, sizeof to) != nullptr;
  };
  Elf64_Ehdr file;
  if (!read(0, file)) return {};
  std::size_t memory = 0;
  for (std::size_t i = 0; i < file.e_phnum; ++i) {
    Elf64_Phdr segment;
    if (!read(file.e_phoff + i * file.e_phentsize, segment)) break;
    if (segment.p_type == PT_LOAD || segment.p_type == PT_TLS) memory += segment.p_memsz;
    // The kernel would open the loader for the program, even in the sandbox.
    if (segment.p_type == PT_INTERP) {
      return fmt::format("{} names its own loader (a section .interp).", lab.file());
    }
  }
  if (memory <= most_static_memory) return {};
  return fmt::format("The global variables of {} take {} MB; {} MB is the most.", lab.file(),
                     memory >> 20, most_static_memory >> 20);
}

/// The command that links the objects to `program`, where it runs.
std::vector<std::string> link_command(const Layout& layout, const std::vector<fs::path>& objects,
                                      const std::vector<std::string>& more) {
  // For an object that looks like link-time optimization, the linker would start a compiler.
  std::vector<std::string> command{layout.compiler, "-s", "-fno-lto"};
  if (!layout.is_clang) command.push_back("-fno-use-linker-plugin");
  command.insert(command.end(), layout.link_flags.begin(), layout.link_flags.end());
  for (const fs::path& object : objects) command.push_back(object.string());
  command.insert(command.end(), more.begin(), more.end());
  command.insert(command.end(), {"-o", "program"});
  return command;
}

/// Links a text that only includes the lab's header with the lab's own objects, whose functions
/// need not be defined. Throws MachineError if the machine cannot.
void link_known_text(const Unit& unit, std::vector<fs::path> objects) {
  const ScratchDirectory scratch(unit.layout);
  compile_known_text(unit, scratch.path());
  objects.push_back(scratch.path() / "unit.o");
  const std::vector<std::string> flags{
      "-Wl,--unresolved-symbols=ignore-all,--require-defined=main"};
  require({unit.layout, link_command(unit.layout, objects, flags), scratch.path(), objects, false});
}

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
      built.failure = name == lab.name
                          ? fmt::format("There is no {}{}.", owner.file(), others)
                          : fmt::format("{} depends on lab {}: it needs {} too{}.", lab.file(),
                                        owner.number, owner.file(), others);
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
  objects.insert(objects.end(), trusted_objects.begin(), trusted_objects.end());
  const StepResult run = run_step(
      {layout, link_command(layout, objects, submission.libraries), scratch.path(), objects,
       submission.trusted},
      [&] { link_known_text(units.back(), trusted_objects); },
      [](const std::string& errors) {
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
  built.failure = refusal_of(temporary, lab);
  if (!built.failure.empty()) return built;
  // Where this is refused (SMB, FAT), the bits are set for everyone, or starting it fails.
  std::error_code refused;
  fs::permissions(temporary, fs::perms(0755), refused);
  sandbox::Program program = sandbox::open_program(temporary.string());  // immune to later renames
  program.path = keep_cached(slot, "program", key, temporary).string();
  built.program = std::move(program);
  return built;
}

}  // namespace mc::grader
