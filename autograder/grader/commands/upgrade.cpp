#include "grader/commands/upgrade.hpp"

#include <algorithm>

#include "grader/commands/git.hpp"
#include "grader/commands/tree.hpp"

namespace mc::grader {
namespace {

bool is_students_own(const std::string& file) {
  return file.starts_with("starter/") || file.starts_with("answers/");
}

/// What differs between two versions, by kind.
struct Difference {
  std::vector<std::string> labs, checks, handouts, others, removed, kept;

  std::string message(const Manifest& before, const Manifest& now) const {
    const std::string was =
        before.version == now.version ? "" : fmt::format(", was {}", before.version);
    std::string text = fmt::format("Monte Carlo labs {}{}\n\n", now.version, was);
    for (const auto& [title, names] :
         {std::pair("New labs", &labs), std::pair("Checks changed", &checks),
          std::pair("Handouts changed", &handouts), std::pair("Other files", &others),
          std::pair("Removed", &removed), std::pair("Edited here, so kept", &kept)}) {
      if (!names->empty()) text += fmt::format("{}: {}\n", title, some_of(*names));
    }
    return text;
  }
};

bool is_handout_text(const std::string& file) {
  return file.ends_with(".md") || file.ends_with(".svg") || file.ends_with(".png");
}

}  // namespace

Manifest make_manifest(const Context& context, Manifest manifest, const fs::path& tree) {
  manifest.version = context.layout.version;
  for (const Lab& lab : context.labs) {
    if (!manifest.labs.contains(lab.name)) continue;
    std::vector<fs::path> files;
    const fs::path folder = context.layout.root / "autograder" / "checks" / lab.name;
    for (const auto& entry : fs::directory_iterator(folder)) files.push_back(entry.path());
    std::ranges::sort(files);
    std::string all;
    for (const fs::path& file : files) all += read_whole_text(file);
    manifest.checks[lab.name] = fmt::format("{:016x}", hash_text(all));
  }
  manifest.files.clear();
  for (const auto& entry : fs::recursive_directory_iterator(tree)) {
    const std::string file = entry.path().lexically_relative(tree).string();
    if (!entry.is_regular_file() || file.starts_with(".git/") || file == manifest_file) continue;
    manifest.files[file] = hash_of_file(entry.path());
  }
  write_manifest(tree, manifest);
  return manifest;
}

void commit_files(const fs::path& handout, const std::vector<std::string>& files,
                  const std::string& message) {
  std::vector<std::string> add{"add", "-A", "--"};
  add.insert(add.end(), files.begin(), files.end());
  git(handout, add);
  std::vector<std::string> commit{
      "-c", "user.name=course", "-c", "user.email=course@localhost", "commit", "-q", "-m", message,
      "--"};
  commit.insert(commit.end(), files.begin(), files.end());
  git(handout, commit);
}

std::string upgrade(const fs::path& handout, const fs::path& tree) {
  const Manifest before = read_manifest(handout), now = read_manifest(tree);
  Difference difference;
  for (const std::string& lab : now.labs) {
    if (!before.labs.contains(lab)) difference.labs.push_back(lab);
  }
  for (const auto& [lab, hash] : now.checks) {
    const auto old = before.checks.find(lab);
    if (old != before.checks.end() && old->second != hash) difference.checks.push_back(lab);
  }
  std::vector<std::string> touched;
  for (const auto& [file, hash] : now.files) {
    const auto old = before.files.find(file);
    const bool was_ours = old != before.files.end(), exists = fs::exists(handout / file);
    if (was_ours && (old->second == hash || is_students_own(file))) continue;
    if (!was_ours && exists && is_students_own(file)) continue;
    if (exists && (!was_ours || hash_of_file(handout / file) != old->second)) {
      if (hash_of_file(handout / file) != hash) difference.kept.push_back(file);
      continue;
    }
    const bool is_of_new_lab =
        std::ranges::any_of(difference.labs, [&name = file](std::string lab) {
          if (name.find(lab) != std::string::npos) return true;
          std::ranges::replace(lab, '_', '-');  // of its folder
          return name.find(lab) != std::string::npos;
        });
    if (!is_of_new_lab) {
      (is_handout_text(file) ? difference.handouts : difference.others).push_back(file);
    }
    copy_into(tree / file, handout / file);
    touched.push_back(file);
  }
  for (const auto& [file, hash] : before.files) {
    if (now.files.contains(file) || is_students_own(file) || !fs::exists(handout / file)) continue;
    if (hash_of_file(handout / file) != hash) {
      difference.kept.push_back(file);
      continue;
    }
    fs::remove(handout / file);
    difference.removed.push_back(file);
    touched.push_back(file);
  }
  if (touched.empty() && before.version == now.version) return {};
  copy_into(tree / manifest_file, handout / manifest_file);
  touched.emplace_back(manifest_file);
  std::string message = difference.message(before, now);
  commit_files(handout, touched, message);
  return message;
}

}  // namespace mc::grader
