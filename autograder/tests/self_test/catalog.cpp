#include "tests/self_test/catalog.hpp"

#include <cxxabi.h>
#include <fcntl.h>
#include <sys/file.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <fstream>
#include <map>
#include <memory>

#include "grader/base/errors.hpp"
#include "runner/text.hpp"
#include "sandbox/process.hpp"

namespace mc::self_test {

namespace fs = std::filesystem;

namespace {

/// The functions of namespace mc that objects define or need: mangled names by readable ones.
std::map<std::string, std::string> functions(const std::vector<fs::path>& objects,
                                             const std::string& which) {
  std::vector<std::string> command{"nm", "-P", which};
  for (const fs::path& object : objects) command.push_back(object.string());
  const sandbox::ProcessResult run = sandbox::run_process(command);
  if (!run.succeeded()) throw grader::MachineError("nm: " + run.errors);
  std::map<std::string, std::string> mangled;
  for (const std::string_view line : text::split(run.output, '\n')) {
    const std::string name(line.substr(0, line.find(' ')));
    const std::unique_ptr<char, decltype(&std::free)> readable(
        abi::__cxa_demangle(name.c_str(), nullptr, nullptr, nullptr), &std::free);
    if (readable && std::string_view(readable.get()).starts_with("mc::")) {
      mangled[readable.get()] = name;
    }
  }
  return mangled;
}

/// The name of the mistake or attack that begins with this line of a catalog; empty if none does.
std::string section_begun_by(const std::string& line, const fs::path& catalog) {
  const std::string attack = "//// ", mistake = "namespace mc::";
  if (catalog.parent_path().parent_path().filename() == "attacks") {
    return line.starts_with(attack) ? line.substr(attack.size()) : "";
  }
  if (!line.starts_with(mistake) || !line.ends_with(" {")) return {};
  return line.substr(mistake.size(), line.size() - mistake.size() - 2);
}

std::string defines(const std::string& function, const std::string& by) {
  return "-Wl,--defsym=" + function + '=' + by;
}

}  // namespace

bool is_catalog(const fs::path& file) {
  return std::isdigit(static_cast<unsigned char>(file.filename().string()[0])) != 0;
}

std::vector<Subject> subjects_in(const fs::path& file) {
  if (!is_catalog(file)) return {{file, ""}};
  std::vector<Subject> subjects;
  std::ifstream text(file);
  for (std::string line; std::getline(text, line);) {
    const std::string name = section_begun_by(line, file);
    if (!name.empty()) subjects.push_back({file, name});
  }
  return subjects;
}

std::vector<std::string> said(const Subject& subject, const std::string& key) {
  const std::string start = "// " + key + ": ";
  const bool names_checks = key == "caught by" || key == "fails";
  std::vector<std::string> values;
  bool is_inside = subject.section.empty();
  std::ifstream file(subject.file);
  for (std::string line; std::getline(file, line);) {
    const std::string section = section_begun_by(line, subject.file);
    if (line.starts_with("////")) {  // the comments of an attack follow its name
      is_inside = section == subject.section;
      values.clear();
      continue;
    }
    if (line.starts_with(start)) {
      const std::string value = line.substr(start.size());
      if (names_checks) {
        for (const std::string_view name : text::split(value, ',')) {
          values.emplace_back(name.substr(name.find_first_not_of(' ')));
        }
      } else {
        values.push_back(value);
      }
    }
    if (line.starts_with("//")) continue;
    if (is_inside || section == subject.section) return values;  // those of a mistake precede it
    values.clear();
  }
  throw grader::UsageError(subject.file.string() + " has no section " + subject.section);
}

std::string attack_in(const Subject& subject, const std::string& starter) {
  std::string attack;
  bool is_inside = true;  // above the first section is what all of them share
  std::ifstream file(subject.file);
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("////"))
      is_inside = section_begun_by(line, subject.file) == subject.section;
    if (is_inside) attack += line + '\n';
  }
  const std::string todo = "throw todo(\"1.1\")";
  if (attack.find("attack()") != std::string::npos) {
    std::string rest = starter;
    return attack + rest.replace(rest.find(todo), todo.size(), "return attack()");
  }
  std::string rest;
  bool replaces = false;
  for (std::size_t from = 0, end = 0; from < starter.size(); from = end) {
    end = std::min(starter.find("\n\n", from), starter.size() - 2) + 2;
    const std::string paragraph = starter.substr(from, end - from);
    const std::string function = paragraph.substr(0, paragraph.find('(')) + '(';
    const bool is_task = paragraph.find("throw todo(") != std::string::npos;
    const bool is_replaced = is_task && attack.find('\n' + function) != std::string::npos;
    if (!is_replaced) rest += paragraph;
    replaces = replaces || is_replaced;
  }
  return replaces ? attack + rest : attack;
}

CatalogLock::CatalogLock(const fs::path& slot) {
  fs::create_directories(slot);
  lock_ = sandbox::Descriptor(open((slot / "lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644),
                              "opening the lock");
  flock(lock_.get(), LOCK_EX);
}

std::vector<Definition> definitions_of(const grader::Layout& layout, const grader::Lab& lab,
                                       const fs::path& object, const Subject& subject) {
  std::vector<fs::path> callers = layout.objects.at(lab.name);
  callers.push_back(object);
  const auto defined = functions({object}, "--defined-only");
  std::vector<Definition> definitions;
  bool differs = false;
  for (const auto& [name, symbol] : functions(callers, "--undefined-only")) {
    const std::string function = name.substr(std::string_view("mc::").size());
    const auto mistaken = defined.find("mc::" + subject.section + "::" + function);
    const auto right = defined.find("mc::right_" + function);
    const bool is_mistaken = mistaken != defined.end();
    if (!is_mistaken && right == defined.end()) continue;
    if (right == defined.end()) throw grader::UsageError(function + " is not renamed");
    differs = differs || is_mistaken;
    definitions.push_back({symbol, right->second, is_mistaken ? mistaken->second : ""});
  }
  if (!differs) throw grader::UsageError(subject.section + " replaces no function of the lab");
  return definitions;
}

std::vector<std::string> linker_flags(const std::vector<Definition>& definitions) {
  std::vector<std::string> flags;
  for (const Definition& one : definitions) {
    flags.push_back(defines(one.function, one.mistaken.empty() ? one.right : one.mistaken));
  }
  return flags;
}

std::vector<std::string> linker_flags_to_abort(const std::string& function,
                                               const std::vector<Definition>& definitions) {
  std::vector<std::string> flags;
  for (const Definition& one : definitions) {
    flags.push_back(defines(one.function, one.function == function ? "abort" : one.right));
  }
  return flags;
}

}  // namespace mc::self_test
