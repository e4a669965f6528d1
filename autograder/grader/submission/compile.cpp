#include "grader/submission/compile.hpp"

#include <sys/types.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <map>
#include <mutex>
#include <set>
#include <thread>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "grader/base/errors.hpp"
#include "grader/base/replace.hpp"
#include "grader/base/text_file.hpp"
#include "grader/submission/cache.hpp"
#include "grader/submission/diagnostics.hpp"
#include "grader/submission/include_policy.hpp"
#include "grader/submission/scratch.hpp"
#include "grader/submission/source.hpp"
#include "sandbox/jail.hpp"
#include "sandbox/printable.hpp"

namespace mc::grader {
namespace fs = std::filesystem;
namespace {

/// Increment when the rules for what a submission may read change: objects made by older rules are
/// then not taken from the cache.
constexpr int rules = 3;

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
  std::uint64_t hash = hash_text(layout.compiler);
  for (const fs::path& file : files) hash = hash_text(read_whole_text(file), hash);
  return hash;
}

/// A header that includes the standard headers that nearly every file needs. If it was precompiled,
/// a file takes half the time. Every file includes it in any case.
fs::path standard_headers(const Layout& layout, const std::vector<std::string>& flags) {
  const std::string text = read_whole_text(layout.labs() / "runner" / "standard_headers.hpp");
  const std::string key =
      fmt::format("{} {} {}", layout.compiler, fmt::join(flags, " "),
                  fs::last_write_time(layout.compiler).time_since_epoch().count());
  const fs::path place =
      layout.build / "precompiled" / fmt::format("{:016x}", hash_text(text, hash_text(key)));
  fs::path header = place / "standard_headers.hpp";
  static std::mutex one_at_a_time;
  const std::lock_guard lock(one_at_a_time);
  if (!fs::exists(header)) {
    fs::create_directories(place);
    write_text(header, text);
  }
  return header;
}

/// A file's path relative to the checkout: students need not see where the checkout is.
std::string shown(const Unit& unit, const fs::path& file) {
  std::string name = file.string();
  const std::string root = unit.layout.root.string() + '/';
  if (name.starts_with(root)) name.erase(0, root.size());
  return sandbox::printable_line(sandbox::shortened(name, 200));
}

Object refused(const Unit& unit, const fs::path& file) {
  return {
      {},
      fmt::format("{} reads {}.\nIt may include its lab's headers, those of labs/common and the "
                  "standard library's, and nothing else.",
                  unit.lab.file(), shown(unit, file))};
}

/// The command that compiles `name` and lists what it reads: -H names each file on opening it, even
/// if the compilation fails later; -MD and --MD write their lists only if it succeeds, but those
/// are complete.
std::vector<std::string> command_for(const Unit& unit, const std::vector<std::string>& flags,
                                     const std::vector<std::string>& includes,
                                     const std::string& name) {
  std::vector<std::string> command{unit.layout.compiler};
  const std::vector<std::string> header{"-include", standard_headers(unit.layout, flags).string()};
  for (const auto* words : {&flags, &includes, &header}) {
    command.insert(command.end(), words->begin(), words->end());
  }
  command.insert(command.end(), {"-c", name, "-o", "unit.o", "-H", "-MD", "-MF", "preprocessor.d",
                                 "-Wa,--MD,assembler.d", "-fdiagnostics-color=never"});
  // No source lines in the messages: GCC would quote whatever file a #line names.
  if (unit.layout.is_clang) {
    command.insert(command.end(),
                   {"-fno-integrated-as", "-ferror-limit=3", "-fno-caret-diagnostics"});
  } else {
    command.insert(command.end(), {"-fmax-errors=3", "-fno-diagnostics-show-caret",
                                   "-fno-canonical-system-headers"});
  }
  return command;
}

/// The limits of a compiler or linker for one file of a submission.
sandbox::ProcessOptions compiler_limits(const fs::path& directory) {
  sandbox::ProcessOptions options;
  options.directory = directory;
  options.environment = {{"LC_ALL", "C"},                  // the messages parsed below
                         {"TMPDIR", directory.string()}};  // the assembler's input is there too
  options.cpu_seconds = 20;
  options.wall_seconds = 120;
  options.memory = std::size_t{1536} << 20;
  options.file_size = std::size_t{64} << 20;
  return options;
}

/// Compilers run as a separate user when the judge is root.
constexpr uid_t compiler_user = 65533;

/// Can that user read the labs and work in the directory? Not if the checkout is in a directory
/// that is closed to other users.
bool can_read_labs(const Layout& layout, const fs::path& directory) {
  static std::mutex mutex;
  static std::map<fs::path, bool> known;
  const std::lock_guard lock(mutex);
  const auto [found, is_new] = known.emplace(layout.build, false);
  if (is_new) {
    const std::string header = standard_headers(layout, compile_flags()).string();
    const auto run = sandbox::run_process(
        {"test", "-r", (layout.labs() / "runner" / "standard_headers.hpp").string(), "-a", "-r",
         header, "-a", "-w", directory.string()},
        {.user = compiler_user});
    found->second = run.succeeded();
  }
  return found->second;
}

sandbox::ProcessResult run_confined(const Layout& layout, const std::vector<std::string>& command,
                                    const fs::path& directory) {
  sandbox::ProcessOptions options = compiler_limits(directory);
  options.confined = true;
  if (geteuid() == 0 && chown(directory.c_str(), compiler_user, compiler_user) == 0 &&
      can_read_labs(layout, directory)) {
    options.user = compiler_user;
  }
  return sandbox::run_process(command, options);
}

/// Does the compiler report a position in the file?
bool blames(const std::string& errors, const std::string& name) {
  return errors.starts_with(name + ':') || errors.find('\n' + name + ':') != std::string::npos;
}

/// The student's message for a failed compilation.
std::string failure_of(const Unit& unit, const std::string& text, const fs::path& directory,
                       const sandbox::ProcessResult& compiled) {
  const std::string name = unit.lab.file();
  auto [opened, messages] = parse_compiler_output(compiled.errors);
  for (const fs::path& place : {directory, unit.layout.build, unit.layout.root}) {
    // Students need not see where the checkout is.
    messages = with_replacements(messages, {{place.string() + '/', ""}});
  }
  // Messages must not show files that are off limits. The text itself may add lines to the list:
  // they hide its own messages and do no other harm.
  if (const auto file = forbidden(unit.layout, unit.trusted, directory, opened)) {
    return fmt::format(
        "{} does not compile, and its errors are not shown: its compilation reads {}, which is not "
        "a header of a lab or of the standard library.",
        name, shown(unit, *file));
  }
  // The assembler quotes files that .include reads, and does not list them.
  if (compiled.errors.find("Assembler messages:") != std::string::npos) {
    return fmt::format("The assembler rejects an asm statement in {}.", name);
  }
  if (may_embed(text)) {  // -H does not list embedded files
    return fmt::format("{} does not compile. Remove the word embed from it to see why.", name);
  }
  return fmt::format("{} does not compile:\n{}", name, first_errors(messages, {name, text}));
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
  const auto flags = compile_flags();
  const fs::path header = standard_headers(layout, flags);
  const fs::path compiled = header.string() + ".gch";
  if (fs::exists(compiled)) return;
  const ScratchDirectory scratch(layout);
  const fs::path temporary = scratch.path() / "gch";
  std::vector<std::string> command{layout.compiler};
  command.insert(command.end(), flags.begin(), flags.end());
  command.insert(command.end(), {"-x", "c++-header", header.string(), "-o", temporary.string()});
  if (sandbox::run_process(command).succeeded()) fs::rename(temporary, compiled);
}

namespace {

/// Throws MachineError if the compiler fails on a text that is known to be right.
void compile_known_program(const Layout& layout, const fs::path& directory,
                           const std::vector<std::string>& more) {
  write_text(directory / "known.cpp", "int main() { return 0; }\n");
  std::vector<std::string> command{layout.compiler, "known.cpp", "-o", "known.out"};
  command.insert(command.end(), more.begin(), more.end());
  const auto run = run_confined(layout, command, directory);
  if (!run.succeeded()) {
    const std::string why = sandbox::printable_line(run.errors.substr(0, run.errors.find('\n')));
    throw MachineError(fmt::format("the compiler fails on any file here: {}", why));
  }
}

}  // namespace

void require_working_machine(const Layout& layout) {
  std::error_code unknown;
  const auto space = fs::space(layout.build, unknown);
  constexpr std::uintmax_t enough = std::uintmax_t{64} << 20;
  if (!unknown && space.available < enough) {
    throw MachineError(fmt::format("the disk of {} is full", layout.build.string()));
  }
  const ScratchDirectory scratch(layout);
  compile_known_program(layout, scratch.path(), {"-c"});
}

void probe_machine(const Layout& layout) {
  require_working_machine(layout);
  const ScratchDirectory scratch(layout);
  compile_known_program(layout, scratch.path(), {});
  const fs::path program = scratch.path() / "known.out";
  fs::permissions(program, fs::perms(0755));
  // Its exit status is irrelevant: what matters is that the sandbox can start it.
  sandbox::run_jailed(sandbox::open_program(program.string()), "");
}

namespace {

/// Why a compiler or linker was stopped, from its signal and its resource use; empty if it was not.
/// Its output is not used: it can come from the text.
std::string stopped(const Layout& layout, const sandbox::ProcessResult& run,
                    const sandbox::ProcessOptions& limits) {
  if (run.succeeded()) return {};
  if (run.out_of_time) {
    // It was blocked if it used nearly no CPU time while the same compiler, on a known text,
    // finishes in a tenth of the time.
    const auto start = std::chrono::steady_clock::now();
    require_working_machine(layout);
    const std::chrono::duration<double> probe = std::chrono::steady_clock::now() - start;
    if (run.cpu_seconds < 1 && probe.count() < limits.wall_seconds / 10) {
      return fmt::format("was stopped after waiting {} s", limits.wall_seconds);
    }
    throw MachineError(fmt::format("the machine is too busy: a compiler did not finish in {} s",
                                   limits.wall_seconds));
  }
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
  if (run.signal != 0) return fmt::format("crashed (signal {})", run.signal);
  constexpr int gcc_lost_a_program =
      4;  // the driver's exit code if the compiler or assembler died of a signal
  if (run.exit_code == gcc_lost_a_program) return "crashed";
  return {};
}

}  // namespace

CompilerRun run_compiler(const Layout& layout, const std::vector<std::string>& command,
                         const fs::path& directory,
                         const std::function<bool(const std::string& errors)>& is_text_at_fault) {
  const sandbox::ProcessOptions limits = compiler_limits(directory);
  CompilerRun run{run_confined(layout, command, directory), {}};
  run.stopped = stopped(layout, run.result, limits);
  if (run.result.succeeded() || !run.stopped.empty()) return run;
  require_working_machine(layout);
  if (is_text_at_fault(run.result.errors)) return run;
  // The machine may have been out of processes for a moment.
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  run.result = run_confined(layout, command, directory);
  run.stopped = stopped(layout, run.result, limits);
  if (!run.result.succeeded() && run.stopped.empty()) require_working_machine(layout);
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
  const auto flags = compile_flags();
  const auto includes = include_flags(unit.layout, unit.trusted);
  const std::string key =
      fmt::format("{} {} {} {} {}", rules, fmt::join(flags, " "), fmt::join(includes, " "),
                  hash_of_surroundings(unit.layout, unit.trusted), text);
  const fs::path slot = slot_of(unit);
  if (const auto object = find_cached(slot, "o", key)) return {*object, {}, 0, key};

  // Compiled in a directory that holds nothing else. What counts is what this very run opened: the
  // text could detect a second run that only lists (by the precompiled header, by /proc) and behave
  // differently in it.
  const ScratchDirectory scratch(unit.layout);
  const fs::path& directory = scratch.path();
  write_text(directory / name, text);
  const auto command = command_for(unit, flags, includes, name);
  const CompilerRun run =
      run_compiler(unit.layout, command, directory,
                   [&](const std::string& errors) { return blames(errors, name); });
  const sandbox::ProcessResult& compiled = run.result;
  if (!run.stopped.empty()) {
    return {{}, fmt::format("The compiler {} on {}.", run.stopped, name), compiled.cpu_seconds};
  }
  if (!compiled.succeeded()) {
    return {{}, failure_of(unit, text, directory, compiled), compiled.cpu_seconds};
  }
  for (const char* list : {"preprocessor.d", "assembler.d"}) {  // the latter lists .incbin
    if (const auto file = forbidden(unit.layout, unit.trusted, directory,
                                    dependencies(read_whole_text(directory / list)))) {
      return refused(unit, *file);
    }
  }
  return {keep_cached(slot, "o", key, directory / "unit.o"), {}, compiled.cpu_seconds, key};
}

}  // namespace mc::grader
