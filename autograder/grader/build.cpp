#include "grader/build.hpp"

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

#include "grader/diagnostics.hpp"
#include "grader/errors.hpp"
#include "grader/process.hpp"
#include "grader/text_file.hpp"
#include "runner/text.hpp"

namespace mc::grader {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t longest_file = std::size_t{1} << 20;
constexpr std::size_t most_static_memory = std::size_t{400} << 20;

/// What a compiler may use for one file of a submission.
ProcessOptions compiler_limits(const fs::path& directory) {
  ProcessOptions options;
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
    for (const fs::path& from : {layout.solutions(), layout.root / "autograder" / "submissions"}) {
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
/// saving to a verdict. Only GCC, and only for judging; without it everything is the same, slower.
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
    if (!run_process(command).succeeded()) return {};
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

/// Is `path` below `directory`? Both canonical.
bool is_below(const fs::path& path, const fs::path& directory) {
  return std::mismatch(directory.begin(), directory.end(), path.begin(), path.end()).first ==
         directory.end();
}

/// The files that a make rule ("a.o: b.cpp c.hpp \") depends on.
std::vector<fs::path> dependencies(const std::string& rule) {
  std::vector<fs::path> files;
  std::string word;
  const auto colon = rule.find(": ");
  if (colon == std::string::npos) return files;
  for (std::size_t i = colon + 2; i <= rule.size(); ++i) {
    const char c = i < rule.size() ? rule[i] : '\n';
    const char next = i + 1 < rule.size() ? rule[i + 1] : '\n';
    if (c == '\\' && (next == ' ' || next == '#' || next == '\\')) {
      word += rule[++i];
    } else if (c == '$' && next == '$') {
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

/// Where the compiler looks for the system's headers.
std::vector<fs::path> system_directories(const Layout& layout) {
  static std::mutex mutex;
  static std::map<std::string, std::vector<fs::path>> known;
  const std::lock_guard lock(mutex);
  auto& directories = known[layout.compiler];
  if (!directories.empty()) return directories;
  const auto listed = run_process({layout.compiler, "-E", "-x", "c++", "-v", "/dev/null"}).errors;
  bool inside = false;
  for (const std::string_view line : text::split(listed, '\n')) {
    if (line.starts_with("End of search list")) inside = false;
    if (inside) {
      std::error_code missing;
      auto directory = fs::canonical(line.substr(0, line.find(" (")), missing);
      if (!missing) directories.push_back(std::move(directory));
    }
    if (line.starts_with("#include <...>")) inside = true;
  }
  return directories;
}

/// The first file that this unit must not read. `directory` is the one it is compiled in.
std::optional<fs::path> forbidden(const Unit& unit, const fs::path& directory,
                                  const std::vector<fs::path>& files) {
  std::vector<fs::path> allowed = system_directories(unit.layout);
  allowed.push_back(fs::canonical(unit.layout.labs()));
  allowed.push_back(fs::canonical(directory));
  allowed.push_back(fs::weakly_canonical(unit.layout.build / "precompiled"));
  if (unit.trusted) allowed.push_back(fs::canonical(unit.layout.root));
  for (const fs::path& file : files) {
    const fs::path real = fs::weakly_canonical(file.is_absolute() ? file : directory / file);
    if (std::none_of(allowed.begin(), allowed.end(),
                     [&](auto& place) { return is_below(real, place); })) {
      return file;
    }
  }
  return {};
}

std::string refused(const Unit& unit, const fs::path& file) {
  return fmt::format(
      "{} reads {}.\nIt may include its lab's headers, those of labs/common and the standard "
      "library's, and nothing else.",
      unit.lab.file(), shortened(file.string(), 200));
}

/// Why a compiler did not come to its own end; empty where it did.
std::string stopped(const ProcessResult& run, const ProcessOptions& limits) {
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

/// What a compiler run with -H has to say: the files it opened, in order, and its messages.
struct Heard {
  std::vector<fs::path> opened;
  std::string messages;
};

Heard listen(const std::string& errors) {
  Heard heard;
  for (const std::string_view line : text::split(errors, '\n')) {
    const auto blank = line.find_first_not_of(".!");
    if (line.starts_with("Multiple include guards")) break;  // a list of advice, to the end
    if (blank != std::string_view::npos && blank > 0 && line[blank] == ' ') {
      heard.opened.emplace_back(line.substr(blank + 1));  // ".. file", "! file.gch"
    } else if (!line.empty()) {
      heard.messages += std::string(line) + '\n';
    }
  }
  return heard;
}

/// Does the text have an #embed? Not exactly: a comment with that word has one too.
bool may_embed(std::string text) {
  for (const char* splice : {"\\\n", "\\\r\n"}) {
    for (auto at = text.find(splice); at != std::string::npos; at = text.find(splice, at)) {
      text.erase(at, std::string_view(splice).size());
    }
  }
  return text.find("embed") != std::string::npos;
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
  auto flags = compile_flags(unit.layout, unit.variant);
  const auto includes = include_flags(unit);
  const std::string key =
      fmt::format("{} {} {} {}", text, fmt::join(flags, " "), fmt::join(includes, " "),
                  hash_of_surroundings(unit.layout, unit.trusted));
  const fs::path slot = slot_of(unit);
  const fs::path object = slot / fmt::format("{:016x}.o", hash_text(key));
  if (is_kept(object)) return {object, {}};

  const auto header = unit.variant == Variant::judged ? precompiled_header(unit.layout, flags)
                                                      : std::vector<std::string>{};
  flags.insert(flags.end(), includes.begin(), includes.end());
  const TemporaryDirectory scratch(unit.layout.build / "tmp");
  const fs::path& directory = scratch.path();
  write_text(directory / name, text);
  const ProcessOptions limits = compiler_limits(directory);

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
  const ProcessResult compiled = run_process(command, limits);
  const auto [opened, messages] = listen(compiled.errors);

  // What it may not read must not show in a message either: this comes first.
  if (const auto file = forbidden(unit, directory, opened)) {
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
    if (const auto file = forbidden(unit, directory, dependencies(read_text(directory / list)))) {
      return {{}, refused(unit, *file)};
    }
  }
  fs::create_directories(slot);
  sweep(slot);
  fs::rename(directory / "unit.o", object);
  return {object, {}};
}

/// What a static ELF program asks of the machine before its first line.
struct Segments {
  std::size_t memory = 0;  ///< globals and code, those of a thread included
  bool loader = false;     ///< another program, to be started in its place
};

Segments segments_of(const fs::path& program) {
  const std::string bytes = read_text(program);
  const auto at = [&](std::size_t offset, std::size_t size) {
    std::uint64_t value = 0;
    if (offset + size <= bytes.size()) bytes.copy(reinterpret_cast<char*>(&value), size, offset);
    return value;
  };
  Segments segments;
  if (!bytes.starts_with("\x7f"
                         "ELF\2\1"))
    return segments;  // 64 bits, little endian
  for (std::size_t i = 0; i < at(0x38, 2); ++i) {
    const std::size_t header = at(0x20, 8) + i * at(0x36, 2);
    const auto type = at(header, 4);
    constexpr unsigned load = 1, interpreter = 3, thread_local_storage = 7;
    if (type == load || type == thread_local_storage) segments.memory += at(header + 0x28, 8);
    if (type == interpreter) segments.loader = true;
  }
  return segments;
}

}  // namespace

std::vector<std::string> compile_flags(const Layout& layout, Variant variant) {
  std::vector<std::string> flags{"-std=c++20", "-O3", "-ffp-contract=off"};
#if defined(__x86_64__)
  // Never native: digits must not change with the host. A machine has these features or it has not.
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
      __builtin_cpu_supports("bmi2")) {
    flags.push_back("-march=x86-64-v3");
  }
#endif
  if (variant == Variant::judged) flags.push_back("-D_GLIBCXX_ASSERTIONS");
  (void)layout;
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
  std::string key = fmt::format("{}", fmt::join(layout.link_flags, " "));
  for (const fs::path& object : objects) key += object.string();
  for (const fs::path& object : trusted_objects) {
    key += fmt::format("{} {}", object.string(),
                       fs::last_write_time(object).time_since_epoch().count());
  }
  const fs::path slot = slot_of(units.back());
  const fs::path path = slot / fmt::format("{:016x}.program", hash_text(key));
  if (is_kept(path)) return {open_program(path.string()), {}};

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
  command.insert(command.end(), {"-o", aside.string()});
  ProcessOptions limits = compiler_limits(scratch.path());
  const ProcessResult linked = run_process(command, limits);
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
  const Program program = open_program(aside.string());  // this one, whatever is renamed over it
  fs::rename(aside, path);
  return {Program{program.descriptor, path.string()}, {}};
}

}  // namespace mc::grader
