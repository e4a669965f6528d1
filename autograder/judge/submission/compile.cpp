#include "judge/submission/compile.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <map>
#include <mutex>
#include <set>
#include <thread>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "judge/base/errors.hpp"
#include "judge/base/replace.hpp"
#include "judge/base/text_file.hpp"
#include "judge/submission/cache.hpp"
#include "judge/submission/diagnostics.hpp"
#include "judge/submission/scratch.hpp"
#include "judge/submission/source.hpp"
#include "judge/submission/toolchain.hpp"
#include "runner/text.hpp"
#include "sandbox/child.hpp"
#include "sandbox/jail.hpp"
#include "sandbox/printable.hpp"

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

/// The limits of a compiler or linker for one file of a submission.
sandbox::ProcessOptions compiler_limits(const fs::path& directory) {
  sandbox::ProcessOptions options;
  options.directory = directory;
  options.environment = compiler_environment(directory);
  options.cpu_seconds = 20;
  options.wall_seconds = 120;
  options.memory = std::size_t{1536} << 20;
  options.file_size = std::size_t{64} << 20;
  return options;
}

std::string lowered_limit_of(const sandbox::ProcessOptions& limits) {
  return sandbox::lowered_limit(limits.cpu_seconds, limits.memory, limits.file_size);
}

/// Compilers run as a separate user when the judge is root.
constexpr uid_t compiler_user = 65533;

/// Can other users read the file, or the directory? Not below a directory that is closed to them.
bool is_open(const fs::path& file) {
  fs::perms needed = fs::perms::others_read;
  for (fs::path at = fs::canonical(file); at != at.root_path(); at = at.parent_path()) {
    if ((fs::status(at).permissions() & needed) == fs::perms::none) return false;
    needed = fs::perms::others_exec;
  }
  return true;
}

/// The user that runs the step, who then owns its directory; 0 for the user of the judge.
uid_t user_of(const Step& step) {
  if (!sandbox::may_become(compiler_user) || !is_open(standard_headers(step.layout)) ||
      !is_open(step.layout.labs() / "runner" / "standard_headers.hpp") ||
      !is_open(step.directory.parent_path())) {
    return 0;
  }
  std::vector<fs::path> own{step.directory};
  for (const auto& file : fs::directory_iterator(step.directory)) own.push_back(file.path());
  for (const fs::path& one : own) {
    if (lchown(one.c_str(), compiler_user, compiler_user) != 0) return 0;
  }
  return compiler_user;
}

sandbox::Places places_of(const Step& step) {
  if (step.trusted) return {{"/"}, step.directory};
  sandbox::Places places{toolchain(step.layout), step.directory};
  places.readable.insert(places.readable.end(), step.readable.begin(), step.readable.end());
  return places;
}

sandbox::ProcessResult run_confined(const Step& step) {
  sandbox::ProcessOptions options = compiler_limits(step.directory);
  const sandbox::Places places = places_of(step);
  options.places = &places;
  options.user = user_of(step);
  return sandbox::run_process(step.command, options);
}

/// Does the compiler report a position in the file?
bool blames(const std::string& errors, const std::string& name) {
  return errors.starts_with(name + ':') || errors.find('\n' + name + ':') != std::string::npos;
}

/// A message without this machine's directories: students need not see where the checkout is.
std::string without_places(const Layout& layout, const fs::path& directory,
                           const std::string& text) {
  std::string shown = text;
  for (const fs::path& place : {directory, layout.build, layout.root}) {
    shown = with_replacements(shown, {{place.string() + '/', ""}});
  }
  return shown;
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

/// Throws MachineError if the disk has no room for what a compiler may write: it may be full, or
/// the quota used up.
void require_disk(const Layout& layout, rlim_t bytes) {
  rlimit allowed{};
  getrlimit(RLIMIT_FSIZE, &allowed);
  const ScratchDirectory scratch(layout);
  const sandbox::Descriptor file(
      open((scratch.path() / "room").c_str(), O_CREAT | O_WRONLY | O_CLOEXEC, 0600), "open");
  const int error =
      posix_fallocate(file.get(), 0, static_cast<off_t>(std::min(bytes, allowed.rlim_cur)));
  if (error == 0) return;
  throw MachineError(error == ENOSPC ? fmt::format("the disk of {} is full", layout.build.string())
                                     : fmt::format("cannot write in {}: {}", layout.build.string(),
                                                   std::strerror(error)));
}

/// Would the machine give a process that much memory? Where it does, a compiler that got none has met
/// its own limit.
bool has_memory(std::size_t bytes) {
  void* const place =
      mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  return place != MAP_FAILED && munmap(place, bytes) == 0;
}

/// What a tool (never the text) says last if it was killed or lacked something; empty otherwise. The
/// text may print such words, but not without a position, and not after collect2.
std::string fault_of_machine(const std::string& errors, std::size_t memory) {
  std::string last;
  for (const std::string_view line : text::split(errors, '\n')) {
    if (line == "Assembler messages:" || is_error(line)) return {};
    if (!line.empty() && line != "compilation terminated.") last = line;
  }
  const auto says = [&](const char* word) { return last.find(word) != std::string::npos; };
  constexpr const char* faults[] = {"Killed",
                                    "No space left",
                                    "Disk quota exceeded",
                                    "Stale file handle",
                                    "Read-only file system",
                                    "Input/output error"};
  constexpr const char* lacks[] = {"Cannot allocate memory", "out of memory", "memory exhausted"};
  const bool is_fault = std::ranges::any_of(faults, says) ||
                        (std::ranges::any_of(lacks, says) && !has_memory(memory));
  return is_fault ? sandbox::printable_line(last.substr(0, 200)) : "";
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

void require(const Step& step) {
  const auto run = run_confined(step);
  if (run.succeeded()) return;
  const std::string low = lowered_limit_of(compiler_limits(step.directory));
  if (!low.empty()) throw MachineError(low);
  const std::string why = without_places(step.layout, step.directory, run.errors);
  throw MachineError(
      fmt::format("the compiler fails on any file here: {}",
                  why.empty() ? fmt::format("exit status {}, signal {}", run.exit_code, run.signal)
                              : sandbox::printable_line(why.substr(0, why.find('\n')))));
}

void compile_known_text(const Unit& unit, const fs::path& directory) {
  require_disk(unit.layout, compiler_limits(directory).file_size);
  write_text(directory / unit.lab.file(), fmt::format("#include \"{}\"\n", unit.lab.header()));
  require(step_for(unit, directory));
}

void probe_machine(const Layout& layout) {
  const ScratchDirectory scratch(layout);
  require_disk(layout, compiler_limits(scratch.path()).file_size);
  write_text(scratch.path() / "known.cpp", "int main() { return 0; }\n");
  std::vector<std::string> command{layout.compiler, "known.cpp", "-o", "known.out"};
  command.insert(command.end(), layout.link_flags.begin(), layout.link_flags.end());
  require({layout, command, scratch.path(), {}, false});
  // Its exit status is irrelevant: what matters is that the sandbox can start it.
  sandbox::run_jailed(sandbox::open_program((scratch.path() / "known.out").string()), "");
}

namespace {

/// Why a compiler or linker was stopped, from its signal and its resource use; empty if it was not.
/// Its output is not used: it can come from the text.
std::string stopped(const sandbox::ProcessResult& run, const sandbox::ProcessOptions& limits) {
  if (run.signal == SIGXCPU || run.cpu_seconds >= limits.cpu_seconds) {
    return fmt::format("was stopped after {} s of CPU time", limits.cpu_seconds);
  }
  if (run.signal == SIGXFSZ || run.written >= limits.file_size) {
    return fmt::format("tried to write more than {} MB", limits.file_size >> 20);
  }
  // Address space exceeds resident memory.
  if (run.peak_memory >= limits.memory / 2) {
    return fmt::format("tried to use more than {} MB of memory", limits.memory >> 20);
  }
  if (run.out_of_time) return fmt::format("was stopped after waiting {} s", limits.wall_seconds);
  if (run.signal != 0) return fmt::format("crashed (signal {})", run.signal);
  // GCC's driver exits with 4 if the compiler or the assembler died of a signal.
  constexpr int gcc_lost_a_program = 4;
  return run.exit_code == gcc_lost_a_program ? "crashed" : "";
}

}  // namespace

StepResult run_step(const Step& step, const std::function<void()>& probe,
                    const std::function<bool(const std::string& errors)>& is_text_at_fault) {
  const sandbox::ProcessOptions limits = compiler_limits(step.directory);
  StepResult run{run_confined(step)};
  double used = run.result.cpu_seconds;
  for (const bool is_last : {false, true}) {
    if (run.result.succeeded()) break;
    run.stopped = stopped(run.result, limits);
    const std::string low = lowered_limit_of(limits);
    if (!run.stopped.empty() && !low.empty()) throw MachineError(low);
    const auto start = std::chrono::steady_clock::now();
    probe();
    const std::chrono::duration<double> probed = std::chrono::steady_clock::now() - start;
    // A pause of the machine, or a moment without free processes, is not the student's fault.
    const bool was_killed =
        run.result.signal == SIGKILL && run.result.cpu_seconds < limits.cpu_seconds;
    const std::string fault = fault_of_machine(run.result.errors, limits.memory);
    const bool is_text = run.stopped.empty() ? fault.empty() && is_text_at_fault(run.result.errors)
                                             : !run.result.out_of_time && !was_killed;
    if (is_text) break;
    if (is_last) {
      if (!fault.empty()) throw MachineError(fault);
      if (run.result.out_of_time ? probed.count() >= limits.wall_seconds / 10 : was_killed) {
        throw MachineError(fmt::format("the machine is too busy: a compiler {}", run.stopped));
      }
      break;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    run.result = run_confined(step);
    used += run.result.cpu_seconds;
  }
  if (run.result.succeeded()) run.stopped.clear();
  run.result.cpu_seconds = used;
  return run;
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
