#include "judge/submission/step.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstring>
#include <thread>

#include <fmt/format.h>

#include "judge/base/errors.hpp"
#include "judge/base/replace.hpp"
#include "judge/base/text_file.hpp"
#include "judge/submission/diagnostics.hpp"
#include "judge/submission/scratch.hpp"
#include "judge/submission/toolchain.hpp"
#include "runner/text.hpp"
#include "sandbox/child.hpp"
#include "sandbox/jail.hpp"
#include "sandbox/printable.hpp"

namespace mc::grader {
namespace fs = std::filesystem;
namespace {

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
  if (!sandbox::may_become(compiler_user) || !is_open(step.directory.parent_path()) ||
      !std::ranges::all_of(step.readable, is_open)) {
    return 0;
  }
  std::vector<fs::path> own{step.directory};
  for (const auto& file : fs::directory_iterator(step.directory)) own.push_back(file.path());
  for (const fs::path& one : own) {
    if (lchown(one.c_str(), compiler_user, compiler_user) != 0) return 0;
  }
  return compiler_user;
}

/// Would the machine give a process that much memory? Where it does, a compiler that got none has
/// met its own limit.
bool has_memory(std::size_t bytes) {
  void* const place =
      mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  return place != MAP_FAILED && munmap(place, bytes) == 0;
}

/// What a tool (never the text) says last if it was killed or lacked something; empty otherwise.
/// The text may print such words, but not without a position, and not after collect2.
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

sandbox::Places places_of(const Step& step) {
  if (step.trusted) return {{"/"}, step.directory};
  sandbox::Places places{toolchain(step.layout), step.directory};
  places.readable.insert(places.readable.end(), step.readable.begin(), step.readable.end());
  return places;
}

std::string without_places(const Layout& layout, const fs::path& directory,
                           const std::string& text) {
  std::string shown = text;
  for (const fs::path& place : {directory, layout.build, layout.root}) {
    shown = with_replacements(shown, {{place.string() + '/', ""}});
  }
  return shown;
}

void require_disk(const Layout& layout) {
  const rlim_t bytes = compiler_limits(layout.build).file_size;
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

namespace {

sandbox::ProcessResult run_confined(const Step& step) {
  sandbox::ProcessOptions options = compiler_limits(step.directory);
  const sandbox::Places places = places_of(step);
  options.places = &places;
  options.user = user_of(step);
  return sandbox::run_process(step.command, options);
}

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

void probe_machine(const Layout& layout) {
  const ScratchDirectory scratch(layout);
  require_disk(layout);
  write_text(scratch.path() / "known.cpp", "int main() { return 0; }\n");
  std::vector<std::string> command{layout.compiler, "known.cpp", "-o", "known.out"};
  command.insert(command.end(), layout.link_flags.begin(), layout.link_flags.end());
  require({layout, command, scratch.path(), {}, false});
  // Its exit status is irrelevant: what matters is that the sandbox can start it.
  sandbox::run_jailed(sandbox::open_program((scratch.path() / "known.out").string()), "");
}

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

}  // namespace mc::grader
