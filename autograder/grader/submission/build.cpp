#include "grader/submission/build.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <future>
#include <map>
#include <mutex>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "grader/context/errors.hpp"
#include "grader/context/text_file.hpp"
#include "grader/submission/diagnostics.hpp"
#include "grader/submission/include_policy.hpp"
#include "grader/submission/segments.hpp"
#include "sandbox/process.hpp"

namespace mc::grader {
namespace fs = std::filesystem;
namespace {

/// Raised when the rules of what a submission may read change: objects made by older rules are then
/// not taken from the cache.
constexpr int rules = 1;

constexpr std::size_t longest_file = std::size_t{1} << 20;
constexpr std::size_t most_static_memory = std::size_t{400} << 20;

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

/// A directory that goes away with its owner.
class TemporaryDirectory {
 public:
  explicit TemporaryDirectory(const fs::path& parent) {
    fs::create_directories(parent);
    std::string pattern = (parent / "XXXXXX").string();
    if (mkdtemp(pattern.data()) == nullptr) {
      throw std::system_error(errno, std::generic_category(), "cannot write in " + parent.string());
    }
    path_ = pattern;
  }
  ~TemporaryDirectory() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  TemporaryDirectory(const TemporaryDirectory&) = delete;
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

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
  for (const fs::path& file : files) hash = hash_text(read_text(file), hash);
  return hash;
}

/// The standard headers that nearly every file includes, compiled once: this halves the time from
/// saving to a verdict. Only GCC; without it everything is the same, slower.
std::vector<std::string> precompiled_header(const Layout& layout,
                                            const std::vector<std::string>& flags) {
  if (layout.is_clang) return {};
  const fs::path source = layout.labs() / "runner" / "standard_headers.hpp";
  const std::string key =
      fmt::format("{} {} {}", layout.compiler, fmt::join(flags, " "),
                  fs::last_write_time(layout.compiler).time_since_epoch().count());
  const fs::path place = layout.build / "precompiled" /
                         fmt::format("{:016x}", hash_text(read_text(source), hash_text(key)));
  const fs::path header = place / "standard_headers.hpp";
  const fs::path compiled = place / "standard_headers.hpp.gch";
  static std::mutex one_at_a_time;
  const std::lock_guard lock(one_at_a_time);
  if (!fs::exists(compiled)) {
    const TemporaryDirectory scratch(layout.build / "tmp");
    fs::create_directories(place);
    write_text(header, read_text(source));
    std::vector<std::string> command{layout.compiler};
    command.insert(command.end(), flags.begin(), flags.end());
    const fs::path aside = scratch.path() / "gch";
    command.insert(command.end(), {"-x", "c++-header", header.string(), "-o", aside.string()});
    if (!sandbox::run_process(command).succeeded()) return {};
    fs::rename(aside, compiled);
  }
  return {"-include", header.string()};
}

/// One file of a submission, on its way to an object.
struct Unit {
  const Layout& layout;
  const Lab& lab;
  fs::path file;
  bool trusted;
  Variant variant;
};

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

/// Removes what earlier builds left in a slot. Not the newest: another run may be about to link it.
void sweep(const fs::path& slot) {
  const auto old = fs::file_time_type::clock::now() - std::chrono::hours(1);
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(slot, ignored)) {
    if (entry.last_write_time(ignored) < old) fs::remove(entry.path(), ignored);
  }
}

std::string refused(const Unit& unit, const fs::path& file) {
  return fmt::format(
      "{} reads {}.\nIt may include its lab's headers, those of labs/common and the standard "
      "library's, and nothing else.",
      unit.lab.file(), sandbox::shortened(file.string(), 200));
}

/// Why a compiler did not come to its own end; empty where it did.
std::string stopped(const sandbox::ProcessResult& run, const sandbox::ProcessOptions& limits) {
  const std::string& text = run.errors;
  const auto says = [&](const char* words) { return text.find(words) != std::string::npos; };
  if (run.signal == SIGXFSZ || says("File size limit exceeded") || says("File too large")) {
    return fmt::format("wanted to write more than {} MB", limits.file_size >> 20);
  }
  if (run.out_of_time) return fmt::format("was stopped after {} s", limits.wall_seconds);
  if (run.signal == SIGXCPU || says("CPU time limit exceeded") ||
      run.cpu_seconds >= limits.cpu_seconds) {
    return fmt::format("was stopped after {} s of CPU time", limits.cpu_seconds);
  }
  if (says("out of memory") || says("cannot allocate memory") || says("Cannot allocate memory") ||
      says("memory exhausted") || says("std::bad_alloc")) {
    return fmt::format("wanted more than {} MB of memory", limits.memory >> 20);
  }
  if (run.signal != 0 || says("internal compiler error") || says("Killed signal")) {
    return "crashed";
  }
  return {};
}

struct Object {
  fs::path path;
  std::string failure;
};

std::vector<std::string> include_flags(const Unit& unit) {
  std::vector<std::string> flags{"-I" + unit.layout.labs().string()};
  for (const auto& entry : fs::directory_iterator(unit.layout.labs())) {
    if (entry.is_directory()) flags.push_back("-I" + entry.path().string());
  }
  if (unit.trusted) flags.push_back("-I" + unit.layout.root.string());
  std::sort(flags.begin(), flags.end());
  return flags;
}

/// Compiles one file in a directory that holds nothing else, and judges what was read for it. What
/// counts is what this very run opened: a second run that only lists could be told apart (by the
/// precompiled header, by /proc) and shown another text.
Object compile(const Unit& unit) {
  const std::string name = unit.lab.file();
  if (const auto size = fs::file_size(unit.file); size > longest_file) {  // before it is in memory
    return {{}, fmt::format("{} is {} KB long; 1 MB is the most.", name, size >> 10)};
  }
  const std::string text = read_text(unit.file);
  if (text.find_first_not_of(" \t\r\n\xef\xbb\xbf") == std::string::npos) {
    return {{}, fmt::format("{} is empty.", name)};
  }
  auto flags = compile_flags(unit.variant);
  const auto includes = include_flags(unit);
  const std::string key =
      fmt::format("{} {} {} {} {}", rules, fmt::join(flags, " "), fmt::join(includes, " "),
                  hash_of_surroundings(unit.layout, unit.trusted), text);
  const fs::path slot = slot_of(unit);
  const fs::path object = slot / fmt::format("{:016x}.o", hash_text(key));
  const fs::path whole_key = slot / fmt::format("{:016x}.key", hash_text(key));
  // The hash is only a name, and one can make texts to fit it: what counts is the whole key.
  if (is_kept(whole_key) && read_text(whole_key) == key && is_kept(object)) return {object, {}};

  const auto header = precompiled_header(unit.layout, flags);
  flags.insert(flags.end(), includes.begin(), includes.end());
  const TemporaryDirectory scratch(unit.layout.build / "tmp");
  const fs::path& directory = scratch.path();
  write_text(directory / name, text);
  const sandbox::ProcessOptions limits = compiler_limits(directory);

  std::vector<std::string> command{unit.layout.compiler};
  command.insert(command.end(), flags.begin(), flags.end());
  command.insert(command.end(), header.begin(), header.end());
  // -H names each file as it is opened, also where the compilation fails in the end; -MD and --MD
  // write their lists only where it succeeds, but leave nothing out.
  command.insert(command.end(), {"-c", name, "-o", "unit.o", "-H", "-MD", "-MF", "preprocessor.d",
                                 "-Wa,--MD,assembler.d", "-fdiagnostics-color=never"});
  // No source lines in the messages: GCC would quote whatever file a #line names.
  if (unit.layout.is_clang) {
    command.insert(command.end(),
                   {"-fno-integrated-as", "-ferror-limit=3", "-fno-caret-diagnostics"});
  } else {
    command.insert(command.end(), {"-fmax-errors=3", "-fno-diagnostics-show-caret"});
  }
  const sandbox::ProcessResult compiled = sandbox::run_process(command, limits);
  const auto [opened, messages] = parse_compiler_output(compiled.errors);

  // What it may not read must not show in a message either: this comes first.
  if (const auto file = forbidden(unit.layout, unit.trusted, directory, opened)) {
    return {{}, refused(unit, *file)};
  }
  if (const std::string why = stopped(compiled, limits); !why.empty()) {
    return {{}, fmt::format("The compiler {} on {}.", why, name)};
  }
  if (!compiled.succeeded()) {
    // The assembler quotes what an .include brings in, and leaves no list of it.
    if (compiled.errors.find("Assembler messages:") != std::string::npos) {
      return {{}, fmt::format("The assembler does not understand an asm in {}.", name)};
    }
    if (may_embed(text)) {  // -H does not know of those
      return {
          {},
          fmt::format("{} does not compile. Take the word embed out of it to be told why.", name)};
    }
    return {{}, fmt::format("{} does not compile:\n{}", name, first_errors(messages, name, text))};
  }
  for (const char* list : {"preprocessor.d", "assembler.d"}) {  // the latter knows of .incbin
    if (const auto file = forbidden(unit.layout, unit.trusted, directory,
                                    dependencies(read_text(directory / list)))) {
      return {{}, refused(unit, *file)};
    }
  }
  fs::create_directories(slot);
  sweep(slot);
  fs::rename(directory / "unit.o", object);
  write_text(whole_key, key);
  return {object, {}};
}

}  // namespace

std::vector<std::string> compile_flags(Variant variant) {
  std::vector<std::string> flags{"-std=c++20", "-O3", "-ffp-contract=off"};
#if defined(__x86_64__)
  // Never native: digits must not change with the host. A machine has these features or it has not.
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
      __builtin_cpu_supports("bmi2")) {
    flags.push_back("-march=x86-64-v3");
  }
#endif
  if (variant == Variant::judged) flags.push_back("-D_GLIBCXX_ASSERTIONS");
  return flags;
}

Built build_program(const Layout& layout, const Lab& lab, const Submission& submission,
                    Variant variant) {
  std::vector<std::string> names = lab.stands_on;
  names.push_back(lab.name);
  const std::vector<Lab> labs = find_labs(layout);
  std::vector<Unit> units;
  for (const std::string& name : names) {
    const auto file = submission.files.find(name);
    const Lab& owner = find_lab(labs, name);
    if (file == submission.files.end()) {
      return {{},
              name == lab.name ? fmt::format("There is no {}.", owner.file())
                               : fmt::format("{} stands on lab {}: it needs {} too.", lab.file(),
                                             owner.number, owner.file())};
    }
    units.push_back({layout, owner, file->second, submission.trusted, variant});
  }

  std::vector<std::future<Object>> compiling;
  for (const Unit& unit : units) {
    compiling.push_back(std::async(units.size() > 1 ? std::launch::async : std::launch::deferred,
                                   [&unit] { return compile(unit); }));
  }
  std::vector<fs::path> objects;
  std::string failure;
  for (auto& object : compiling) {
    const Object done = object.get();
    if (failure.empty()) failure = done.failure;
    objects.push_back(done.path);
  }
  if (!failure.empty()) return {{}, failure};

  const auto& trusted_objects = layout.objects.at(lab.name);
  std::string key =
      fmt::format("{} {}", fmt::join(layout.link_flags, " "), fmt::join(submission.libraries, " "));
  for (const fs::path& object : objects) key += object.string();
  for (const fs::path& object : trusted_objects) {
    key += fmt::format("{} {}", object.string(),
                       fs::last_write_time(object).time_since_epoch().count());
  }
  const fs::path slot = slot_of(units.back());
  const fs::path path = slot / fmt::format("{:016x}.program", hash_text(key));
  if (is_kept(path)) return {sandbox::open_program(path.string()), {}};

  const TemporaryDirectory scratch(layout.build / "tmp");
  const fs::path aside = scratch.path() / "program";
  std::vector<std::string> command{layout.compiler, "-s"};
  // An object that looks like link-time optimisation would have the linker start a compiler, whose
  // reading nobody judges.
  command.push_back("-fno-lto");
  if (!layout.is_clang) command.push_back("-fno-use-linker-plugin");
  command.insert(command.end(), layout.link_flags.begin(), layout.link_flags.end());
  for (const fs::path& object : objects) command.push_back(object.string());
  for (const fs::path& object : trusted_objects) command.push_back(object.string());
  command.insert(command.end(), submission.libraries.begin(), submission.libraries.end());
  command.insert(command.end(), {"-o", aside.string()});
  sandbox::ProcessOptions limits = compiler_limits(scratch.path());
  const sandbox::ProcessResult linked = sandbox::run_process(command, limits);
  if (const std::string why = stopped(linked, limits); !why.empty()) {
    return {{}, fmt::format("The linker {} on {}.", why, lab.file())};
  }
  if (!linked.succeeded()) return {{}, explain_link_errors(linked.errors, lab)};
  const Segments segments = segments_of(aside);
  if (segments.memory > most_static_memory) {
    return {{},
            fmt::format("The global variables of {} take {} MB; {} MB is the most.", lab.file(),
                        segments.memory >> 20, most_static_memory >> 20)};
  }
  // The kernel would open it on the program's behalf, jail or no jail.
  if (segments.loader) {
    return {{}, fmt::format("{} names a loader of its own (a section .interp).", lab.file())};
  }
  fs::permissions(aside, fs::perms::owner_all | fs::perms::group_read | fs::perms::group_exec |
                             fs::perms::others_read | fs::perms::others_exec);
  sandbox::Program program = sandbox::open_program(aside.string());  // whatever is renamed over it
  fs::rename(aside, path);
  program.path = path.string();
  return {std::move(program), {}};
}

}  // namespace mc::grader
