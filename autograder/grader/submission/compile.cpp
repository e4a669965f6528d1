#include "grader/submission/compile.hpp"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <mutex>
#include <set>
#include <thread>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "grader/context/errors.hpp"
#include "grader/context/text_file.hpp"
#include "grader/submission/diagnostics.hpp"
#include "grader/submission/include_policy.hpp"
#include "grader/submission/scratch.hpp"
#include "sandbox/printable.hpp"

namespace mc::grader {
namespace fs = std::filesystem;
namespace {

/// Raised when the rules of what a submission may read change: objects made by older rules are then
/// not taken from the cache.
constexpr int rules = 2;

constexpr std::size_t longest_file = std::size_t{1} << 20;

/// Everything a compilation reads besides the file itself, as one number.
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

/// Where the standard headers lie that nearly every file includes, and compiled beside them, if
/// somebody did that: then a file takes half of the time. They are included in any case.
fs::path standard_headers(const Layout& layout, const std::vector<std::string>& flags) {
  const std::string text = read_whole_text(layout.labs() / "runner" / "standard_headers.hpp");
  const std::string key =
      fmt::format("{} {} {}", layout.compiler, fmt::join(flags, " "),
                  fs::last_write_time(layout.compiler).time_since_epoch().count());
  const fs::path place =
      layout.build / "precompiled" / fmt::format("{:016x}", hash_text(text, hash_text(key)));
  const fs::path header = place / "standard_headers.hpp";
  static std::mutex one_at_a_time;
  const std::lock_guard lock(one_at_a_time);
  if (!fs::exists(header)) {
    fs::create_directories(place);
    write_text(header, text);
  }
  return header;
}

/// Removes what earlier builds left in a slot. Not the newest: another run may be about to link it.
void sweep(const fs::path& slot) {
  const auto old = fs::file_time_type::clock::now() - std::chrono::hours(1);
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(slot, ignored)) {
    if (entry.last_write_time(ignored) < old) fs::remove(entry.path(), ignored);
  }
}

/// A file of the checkout as seen from there: where the checkout lies is nothing to a student.
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

std::vector<std::string> include_flags(const Unit& unit) {
  std::vector<std::string> flags{"-I" + unit.layout.labs().string()};
  for (const auto& entry : fs::directory_iterator(unit.layout.labs())) {
    if (entry.is_directory()) flags.push_back("-I" + entry.path().string());
  }
  if (unit.trusted) flags.push_back("-I" + unit.layout.root.string());
  std::sort(flags.begin(), flags.end());
  return flags;
}

/// The command that compiles `name` and lists what it reads: -H names each file as it is opened,
/// also where the compilation fails in the end; -MD and --MD write their lists only where it
/// succeeds, but leave nothing out.
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
    command.insert(command.end(), {"-fmax-errors=3", "-fno-diagnostics-show-caret"});
  }
  return command;
}

/// Does the compiler say where in the file it is wrong?
bool blames(const std::string& errors, const std::string& name) {
  return errors.starts_with(name + ':') || errors.find('\n' + name + ':') != std::string::npos;
}

/// What a failed compilation tells the student.
std::string failure_of(const Unit& unit, const std::string& text, const fs::path& directory,
                       const sandbox::ProcessResult& compiled) {
  const std::string name = unit.lab.file();
  const auto [opened, messages] = parse_compiler_output(compiled.errors);
  // What it may not read must not show in a message. The list may hold lines that the text itself
  // has put there: they hide its messages, and accuse nobody.
  if (const auto file = forbidden(unit.layout, unit.trusted, directory, opened)) {
    return fmt::format(
        "{} does not compile, and nothing is shown of it: its compilation names {}, which is no "
        "header of a lab or of the standard library.",
        name, shown(unit, *file));
  }
  // The assembler quotes what an .include brings in, and leaves no list of it.
  if (compiled.errors.find("Assembler messages:") != std::string::npos) {
    return fmt::format("The assembler does not understand an asm in {}.", name);
  }
  if (may_embed(text)) {  // -H does not know of those
    return fmt::format("{} does not compile. Take the word embed out of it to be told why.", name);
  }
  return fmt::format("{} does not compile:\n{}", name, first_errors(messages, name, text));
}

}  // namespace

/// What a compiler may use for one file of a submission.
sandbox::ProcessOptions compiler_limits(const fs::path& directory) {
  sandbox::ProcessOptions options;
  options.directory = directory;
  options.environment = {
      {"LC_ALL", "C"},                  // the messages that are recognised below
      {"TMPDIR", directory.string()}};  // the assembler's input lies in there too
  options.cpu_seconds = 20;
  options.wall_seconds = 60;
  options.memory = std::size_t{1536} << 20;
  options.file_size = std::size_t{64} << 20;
  return options;
}

fs::path slot_of(const Unit& unit) {
  return unit.layout.build / "programs" /
         fmt::format("{}-{:016x}", unit.lab.name, hash_text(unit.file.string()));
}

/// Is there such a file from an earlier build? Then it stays for another hour.
bool is_kept(const fs::path& file) {
  std::error_code missing;
  fs::last_write_time(file, fs::file_time_type::clock::now(), missing);
  return !missing;
}

std::vector<std::string> compile_flags() {
  std::vector<std::string> flags{"-std=c++20", "-O3", "-ffp-contract=off", "-D_GLIBCXX_ASSERTIONS"};
#if defined(__x86_64__)
  if (std::getenv("MC_BASELINE") != nullptr) return flags;  // for tests: as on any x86-64
  // Never native: digits must not change with the host. A machine has these features or it has not.
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
      __builtin_cpu_supports("bmi2")) {
    flags.push_back("-march=x86-64-v3");
  }
#endif
  return flags;
}

void precompile_headers(const Layout& layout) {
  if (layout.is_clang) return;
  const auto flags = compile_flags();
  const fs::path header = standard_headers(layout, flags);
  const fs::path compiled = header.string() + ".gch";
  if (fs::exists(compiled)) return;
  const ScratchDirectory scratch(layout);
  const fs::path aside = scratch.path() / "gch";
  std::vector<std::string> command{layout.compiler};
  command.insert(command.end(), flags.begin(), flags.end());
  command.insert(command.end(), {"-x", "c++-header", header.string(), "-o", aside.string()});
  if (sandbox::run_process(command).succeeded()) fs::rename(aside, compiled);
}

std::string stopped(const sandbox::ProcessResult& run, const sandbox::ProcessOptions& limits) {
  if (run.succeeded()) return {};
  if (run.out_of_time) {
    throw MachineError(fmt::format("the machine is too busy: a compiler did not end in {} s",
                                   limits.wall_seconds));
  }
  if (run.signal == SIGXCPU || run.cpu_seconds >= limits.cpu_seconds) {
    return fmt::format("was stopped after {} s of CPU time", limits.cpu_seconds);
  }
  if (run.signal == SIGXFSZ || run.written >= limits.file_size) {
    return fmt::format("wanted to write more than {} MB", limits.file_size >> 20);
  }
  // Address space is more than what is resident of it.
  if (run.peak_memory >= limits.memory / 2) {
    return fmt::format("wanted more than {} MB of memory", limits.memory >> 20);
  }
  if (run.signal != 0) return fmt::format("crashed (signal {})", run.signal);
  constexpr int gcc_lost_a_program =
      4;  // its driver, when the compiler or assembler died of a signal
  if (run.exit_code == gcc_lost_a_program) return "crashed";
  return {};
}

void require_sound_machine(const Layout& layout) {
  std::error_code unknown;
  const auto space = fs::space(layout.build, unknown);
  constexpr std::uintmax_t enough = std::uintmax_t{64} << 20;
  if (!unknown && space.available < enough) {
    throw MachineError(fmt::format("the disk of {} is full", layout.build.string()));
  }
  const ScratchDirectory scratch(layout);
  write_text(scratch.path() / "sound.cpp", "int main() { return 0; }\n");
  const auto run = sandbox::run_process({layout.compiler, "-c", "sound.cpp", "-o", "sound.o"},
                                        compiler_limits(scratch.path()));
  if (!run.succeeded()) {
    const std::string why = sandbox::printable_line(run.errors.substr(0, run.errors.find('\n')));
    throw MachineError(fmt::format("the compiler fails on any file here: {}", why));
  }
}

Object compile(const Unit& unit) {
  const std::string name = unit.lab.file();
  // One that is gone or cannot be opened is no wrong answer: both throw.
  const auto size = fs::file_size(unit.file);
  if (size > longest_file) {  // before it is in memory
    return {{}, fmt::format("{} is {} KB long; 1 MB is the most.", name, size >> 10)};
  }
  const std::string text = read_whole_text(unit.file);
  if (text.find_first_not_of(" \t\r\n\xef\xbb\xbf") == std::string::npos) {
    return {{}, fmt::format("{} is empty.", name)};
  }
  const auto flags = compile_flags();
  const auto includes = include_flags(unit);
  const std::string key =
      fmt::format("{} {} {} {} {}", rules, fmt::join(flags, " "), fmt::join(includes, " "),
                  hash_of_surroundings(unit.layout, unit.trusted), text);
  const fs::path slot = slot_of(unit);
  const fs::path object = slot / fmt::format("{:016x}.o", hash_text(key));
  const fs::path whole_key = slot / fmt::format("{:016x}.key", hash_text(key));
  // The hash is only a name, and one can make texts to fit it: what counts is the whole key.
  if (is_kept(whole_key) && read_text(whole_key) == key && is_kept(object)) return {object, {}};

  // Compiled in a directory that holds nothing else. What counts is what this very run opened: a
  // second run that only lists could be told apart (by the precompiled header, by /proc) and shown
  // another text.
  const ScratchDirectory scratch(unit.layout);
  const fs::path& directory = scratch.path();
  write_text(directory / name, text);
  const sandbox::ProcessOptions limits = compiler_limits(directory);
  const auto command = command_for(unit, flags, includes, name);
  auto compiled = sandbox::run_process(command, limits);
  if (!compiled.succeeded() && stopped(compiled, limits).empty() &&
      !blames(compiled.errors, name)) {
    // Perhaps there was no process left for a moment.
    require_sound_machine(unit.layout);
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    compiled = sandbox::run_process(command, limits);
  }
  if (!compiled.succeeded()) {
    if (const std::string why = stopped(compiled, limits); !why.empty()) {
      return {{}, fmt::format("The compiler {} on {}.", why, name), compiled.cpu_seconds};
    }
    require_sound_machine(unit.layout);
    return {{}, failure_of(unit, text, directory, compiled), compiled.cpu_seconds};
  }
  for (const char* list : {"preprocessor.d", "assembler.d"}) {  // the latter knows of .incbin
    if (const auto file = forbidden(unit.layout, unit.trusted, directory,
                                    dependencies(read_whole_text(directory / list)))) {
      return refused(unit, *file);
    }
  }
  fs::create_directories(slot);
  sweep(slot);
  fs::rename(directory / "unit.o", object);
  write_text(whole_key, key);
  return {object, {}, compiled.cpu_seconds};
}

}  // namespace mc::grader
