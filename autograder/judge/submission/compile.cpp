#include "judge/submission/compile.hpp"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <mutex>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "judge/base/text_file.hpp"
#include "judge/submission/cache.hpp"
#include "judge/submission/diagnostics.hpp"
#include "judge/submission/scratch.hpp"
#include "judge/submission/source.hpp"
#include "judge/submission/toolchain.hpp"
#include "sandbox/confinement.hpp"
#include "sandbox/printable.hpp"
#include "sandbox/process.hpp"

namespace mc::grader {
namespace fs = std::filesystem;
namespace {

/// Increment when the rules for what a submission may read change: objects made by older rules are
/// then not taken from the cache.
constexpr int rules = 4;

/// Everything else that a compilation reads, as one hash.
std::uint64_t hash_of_surroundings(const Layout& layout, bool trusted) {
  std::set<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(layout.labs())) {
    if (entry.path().extension() == ".hpp") files.insert(entry.path());
  }
  if (trusted) {
    for (const fs::path& from : {layout.solutions(), layout.submissions()}) {
      if (!fs::exists(from)) continue;
      for (const auto& entry : fs::recursive_directory_iterator(from)) {
        if (entry.is_regular_file()) files.insert(entry.path());
      }
    }
  }
  std::uint64_t hash = hash_text(identity_of_compiler(layout));
  for (const fs::path& file : files) hash = hash_text(read_whole_text(file), hash);
  return hash;
}

/// The flags of every submission here: messages and programs name no directory of this machine.
std::vector<std::string> all_flags(const Layout& layout) {
  std::vector<std::string> flags = compile_flags();
  for (const fs::path& place : {layout.root, layout.build}) {
    flags.push_back(fmt::format("-ffile-prefix-map={}/=", place.string()));
  }
  return flags;
}

/// A header that includes the standard headers that nearly every file needs. If it was precompiled,
/// a file takes half the time. Every file includes it in any case.
fs::path standard_headers(const Layout& layout) {
  const std::string text = read_whole_text(layout.labs() / "runner" / "standard_headers.hpp");
  const std::string key =
      fmt::format("{} {}", identity_of_compiler(layout), fmt::join(all_flags(layout), " "));
  const fs::path place =
      layout.build / "precompiled" / fmt::format("{:016x}", hash_text(text, hash_text(key)));
  fs::path header = place / "standard_headers.hpp";
  static std::mutex one_at_a_time;
  const std::lock_guard lock(one_at_a_time);
  if (!fs::exists(header)) {
    write_or_explain(place, [&] {
      fs::create_directories(place);
      write_text(header, text);
    });
  }
  return header;
}

/// The command that compiles the lab's file, which is in the directory where it runs.
std::vector<std::string> command_for(const Unit& unit) {
  std::vector<std::string> command{unit.layout.compiler};
  for (const auto& words :
       {all_flags(unit.layout),
        include_flags(unit.layout, unit.trusted),
        {"-include", standard_headers(unit.layout).string(), "-c", unit.lab.file(), "-o", "unit.o",
         "-MD", "-MF", "unit.d", "-fdiagnostics-color=never"}}) {
    command.insert(command.end(), words.begin(), words.end());
  }
  // No source lines in the messages: GCC would quote whatever file a #line names.
  if (unit.layout.is_clang) {
    command.insert(command.end(), {"-ferror-limit=3", "-fno-caret-diagnostics"});
  } else {
    command.insert(command.end(), {"-fmax-errors=3", "-fno-diagnostics-show-caret"});
  }
  return command;
}

Step step_for(const Unit& unit, const fs::path& directory) {
  return {unit.layout,
          command_for(unit),
          directory,
          {fs::canonical(unit.layout.labs()), fs::canonical(unit.layout.build / "precompiled")},
          unit.trusted};
}

/// Does the compiler report a position in the file?
bool blames(const std::string& errors, const std::string& name) {
  return errors.starts_with(name + ':') || errors.find('\n' + name + ':') != std::string::npos;
}

constexpr const char* what_may_be_included =
    "It may include its lab's headers, those of labs/common and the standard library's, and "
    "nothing else.";

/// The student's message for a failed compilation.
std::string failure_of(const Unit& unit, const std::string& text, const fs::path& directory,
                       const std::string& errors) {
  const std::string name = unit.lab.file();
  // The assembler quotes files that .include reads.
  if (errors.find("Assembler messages:") != std::string::npos ||  // of GNU as, of clang
      errors.find("<inline asm>:") != std::string::npos) {
    return fmt::format("The assembler rejects an asm statement in {}.", name);
  }
  const std::string shown = without_places(unit.layout, directory, errors);
  const bool is_refused = errors.find("Permission denied") != std::string::npos;
  return fmt::format("{} does not compile:\n{}{}{}", name, first_errors(shown, {name, text}),
                     is_refused ? "\n" : "", is_refused ? what_may_be_included : "");
}

/// Where the kernel cannot enforce the places: why a compiled file is refused; empty if it is not.
std::string refusal_of(const Step& step, const std::string& name) {
  if (sandbox::places_are_enforced() || step.trusted) return {};
  std::vector<fs::path> places = places_of(step).readable;
  places.push_back(fs::canonical(step.directory));
  for (const fs::path& file : dependencies(read_whole_text(step.directory / "unit.d"))) {
    if (is_in(fs::weakly_canonical(step.directory / file), places)) continue;
    return fmt::format("{} reads {}.\n{}", name,
                       sandbox::printable_line(sandbox::shortened(
                           without_places(step.layout, step.directory, file.string()), 200)),
                       what_may_be_included);
  }
  return {};
}

}  // namespace

fs::path slot_of(const Unit& unit) {
  return unit.layout.build / "programs" /
         fmt::format("{}-{:016x}", unit.lab.name, hash_text(unit.file.string()));
}

std::vector<std::string> compile_flags() {
  std::vector<std::string> flags{"-std=c++20", "-O3", "-ffp-contract=off", "-D_GLIBCXX_ASSERTIONS"};
#if defined(__x86_64__)
  if (std::getenv("MC_BASELINE") != nullptr) return flags;  // for tests: as on any x86-64
  // Never native: results must not change with the host. A machine has all these features or none.
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
      __builtin_cpu_supports("bmi2")) {
    flags.push_back("-march=x86-64-v3");
  }
#endif
  return flags;
}

std::vector<std::string> include_flags(const Layout& layout, bool with_repository) {
  std::vector<std::string> flags{"-I" + layout.labs().string()};
  for (const auto& entry : fs::directory_iterator(layout.labs())) {
    if (entry.is_directory()) flags.push_back("-I" + entry.path().string());
  }
  if (with_repository) flags.push_back("-I" + layout.root.string());
  std::ranges::sort(flags);
  return flags;
}

void precompile_headers(const Layout& layout) {
  if (layout.is_clang) return;
  const fs::path header = standard_headers(layout);
  const fs::path compiled = header.string() + ".gch";
  if (fs::exists(compiled)) return;
  const ScratchDirectory scratch(layout);
  const fs::path temporary = scratch.path() / "gch";
  std::vector<std::string> command{layout.compiler};
  const auto flags = all_flags(layout);
  command.insert(command.end(), flags.begin(), flags.end());
  command.insert(command.end(), {"-x", "c++-header", header.string(), "-o", temporary.string()});
  // Without it, files only take longer.
  const auto run =
      sandbox::run_process(command, {.environment = compiler_environment(scratch.path())});
  if (run.succeeded()) fs::rename(temporary, compiled);
}

void compile_known_text(const Unit& unit, const fs::path& directory) {
  require_disk(unit.layout);
  write_text(directory / unit.lab.file(), fmt::format("#include \"{}\"\n", unit.lab.header()));
  require(step_for(unit, directory));
}

Object compile(const Unit& unit) {
  const std::string name = unit.lab.file();
  const SourceFile source = read_source(unit.file);
  if (!source.problem.empty()) return {{}, source.problem};
  const std::string& text = source.text;
  if (text.find_first_not_of(" \t\r\n\xef\xbb\xbf") == std::string::npos) {
    return {{}, fmt::format("{} is empty.", name)};
  }
  const std::string key =
      fmt::format("{} {} {} {} {}", rules, fmt::join(all_flags(unit.layout), " "),
                  fmt::join(include_flags(unit.layout, unit.trusted), " "),
                  hash_of_surroundings(unit.layout, unit.trusted), text);
  const fs::path slot = slot_of(unit);
  if (const auto object = find_cached(slot, "o", key)) return {*object, {}, 0, key};
  // Other labs of this run use the same files.
  static std::mutex mutex;
  static std::map<std::string, std::string> failures;
  {
    const std::lock_guard lock(mutex);
    if (const auto known = failures.find(key); known != failures.end()) return {{}, known->second};
  }

  // Compiled in a directory that holds nothing else.
  const ScratchDirectory scratch(unit.layout);
  const fs::path& directory = scratch.path();
  write_text(directory / name, text);
  const Step step = step_for(unit, directory);
  const auto probe = [&] {
    const ScratchDirectory known(unit.layout);
    compile_known_text(unit, known.path());
  };
  const StepResult run =
      run_step(step, probe, [&](const std::string& errors) { return blames(errors, name); });
  const auto failed = [&](const std::string& why) {
    const std::lock_guard lock(mutex);
    return Object{{}, failures[key] = why, run.result.cpu_seconds};
  };
  if (!run.stopped.empty()) return failed(fmt::format("The compiler {} on {}.", run.stopped, name));
  if (!run.result.succeeded()) {
    return failed(failure_of(unit, text, directory, run.result.errors));
  }
  if (const std::string why = refusal_of(step, name); !why.empty()) return failed(why);
  return {keep_cached(slot, "o", key, directory / "unit.o"), {}, run.result.cpu_seconds, key};
}

}  // namespace mc::grader
