// What the comments of submissions and catalogs say, and the text of an attack.

#include <algorithm>
#include <cctype>
#include <fstream>

#include "judge/base/errors.hpp"
#include "runner/text.hpp"
#include "tests/self_test/proof.hpp"

namespace mc::self_test {

namespace {

/// The name of the mistake or attack that begins with this line of a catalog; empty if none does.
std::string section_begun_by(const std::string& line, const fs::path& catalog) {
  const std::string attack = "//// ", mistake = "namespace mc::";
  if (catalog.parent_path().parent_path().filename() == "attacks") {
    return line.starts_with(attack) ? line.substr(attack.size()) : "";
  }
  if (!line.starts_with(mistake) || !line.ends_with(" {")) return {};
  return line.substr(mistake.size(), line.size() - mistake.size() - 2);
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
      if (key == "fails") {
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
  throw UsageError(subject.file.string() + " has no section " + subject.section);
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

}  // namespace mc::self_test
