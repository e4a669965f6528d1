#include "grader/submission/sanitized.hpp"

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "grader/base/side_by_side.hpp"
#include "grader/base/text_file.hpp"
#include "grader/submission/include_policy.hpp"
#include "sandbox/process.hpp"

namespace mc::grader {
namespace fs = std::filesystem;
namespace {

const std::vector<std::string> flags{"-std=c++20",
                                     "-Og",
                                     "-g",
                                     "-ffp-contract=off",
                                     "-fno-omit-frame-pointer",
                                     "-fsanitize=address,undefined",
                                     "-D_GLIBCXX_ASSERTIONS"};

struct Source {
  fs::path file, object;
};

/// "starter", or a whole path, as one name.
std::string name_of(const Layout& layout, const fs::path& directory) {
  const fs::path real = fs::canonical(directory), root = fs::canonical(layout.root);
  std::string name = real.lexically_relative(root).string();
  if (name.starts_with(".")) name = real.string();
  std::replace(name.begin(), name.end(), '/', '_');
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

std::vector<std::string> command_for(const Layout& layout) {
  std::vector<std::string> command{layout.compiler};
  command.insert(command.end(), flags.begin(), flags.end());
  command.push_back("-I" + layout.root.string());  // a mistake includes the solution
  command.push_back("-I" + layout.labs().string());
  for (const auto& entry : fs::directory_iterator(layout.labs())) {
    if (entry.is_directory()) command.push_back("-I" + entry.path().string());
  }
  std::sort(command.begin() + 1, command.end());  // a stable key
  return command;
}

/// Compiles one file to a temporary name and renames it. Returns the compiler's messages on
/// failure.
std::string compile_sanitized(const Layout& layout, const Source& source,
                              std::atomic<bool>& something_new) {
  std::vector<std::string> command = command_for(layout);
  command.insert(command.end(), {"-c", source.file.string()});
  const std::string key = fmt::format("{}", fmt::join(command, " "));
  const fs::path known = sibling(source.object, ".key");
  if (fs::exists(source.object) && read_text(known) == fingerprint(key, source.object)) return {};
  something_new = true;
  fs::create_directories(source.object.parent_path());
  const std::string aside = fmt::format("{}.{}", source.object.string(), getpid());
  command.insert(command.end(), {"-o", aside, "-MMD", "-MT", "object", "-MF",
                                 sibling(source.object, ".d").string()});
  const auto run = sandbox::run_process(command);
  if (!run.succeeded()) return run.errors.empty() ? "the compiler failed\n" : run.errors;
  fs::rename(aside, source.object);
  write_text(known, fingerprint(key, source.object));
  return {};
}

}  // namespace

SanitizedProgram build_sanitized(const Layout& layout, const Lab& lab,
                                 const Submission& submission) {
  const fs::path place = layout.build / "sanitize" / lab.name;
  const std::string label = name_of(layout, submission.path);
  std::vector<Source> sources{
      {layout.labs() / lab.folder / "experiments.cpp", place / "experiments.o"}};
  for (const fs::directory_entry& file : fs::directory_iterator(layout.labs() / "runner")) {
    if (file.path().extension() != ".cpp") continue;
    sources.push_back({file.path(), place / file.path().stem().concat(".o")});
  }
  std::vector<std::string> names = lab.depends_on;
  names.push_back(lab.name);
  for (const std::string& name : names) {
    const auto file = submission.files.find(name);
    if (file == submission.files.end()) return {{}, fmt::format("There is no {}.cpp.\n", name)};
    sources.push_back({file->second, place / label / (name + ".o")});
  }

  std::atomic<bool> something_new = false;
  std::vector<std::string> failures(sources.size());
  run_side_by_side(sources.size(), cores(), [&](std::size_t i) {
    failures[i] = compile_sanitized(layout, sources[i], something_new);
  });
  for (const std::string& failure : failures) {
    if (!failure.empty()) return {{}, failure};
  }

  const fs::path program = place / label / lab.name;
  if (fs::exists(program) && !something_new) return {program, {}};
  const std::string aside = fmt::format("{}.{}", program.string(), getpid());
  std::vector<std::string> command{layout.compiler, "-fsanitize=address,undefined", "-o", aside};
  for (const Source& source : sources) command.push_back(source.object.string());
  const auto linked = sandbox::run_process(command);
  if (!linked.succeeded()) {
    fs::remove(program);  // the objects are newer
    return {{},
            linked.errors +
                "(If the linker misses the sanitizers themselves: Fedora has them in the "
                "packages libasan and libubsan.)\n"};
  }
  fs::rename(aside, program);
  return {program, {}};
}

}  // namespace mc::grader
