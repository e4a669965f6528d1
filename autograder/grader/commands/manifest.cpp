#include "grader/commands/manifest.hpp"

#include <algorithm>
#include <fstream>

namespace mc::grader {
namespace {

/// Does this name a file below the handout? Files of a manifest may be removed.
bool is_below(const fs::path& name) {
  return name.is_relative() && std::ranges::find(name, "..") == name.end();
}

}  // namespace

Manifest read_manifest(const fs::path& handout) {
  Manifest manifest;
  constexpr std::uintmax_t longest = std::uintmax_t{1} << 20;
  const auto place = handout / manifest_file;  // a submission may have anything there
  std::error_code unreadable;
  if (!fs::is_regular_file(fs::symlink_status(place, unreadable)) ||
      fs::file_size(place, unreadable) > longest || unreadable) {
    return manifest;
  }
  std::ifstream file(place);
  for (std::string line; std::getline(file, line);) {
    const auto at = line.find('='), blank = line.find(' ', at + 1);
    if (at == std::string::npos) continue;
    const std::string key = line.substr(0, at), value = line.substr(at + 1);
    if (key == "version") manifest.version = value;
    if (key == "form") manifest.form = value;
    if (key == "hints") manifest.hints = value;
    if (key == "lab") manifest.labs.insert(value);
    if (blank == std::string::npos) continue;
    const std::string hash = line.substr(at + 1, blank - at - 1), name = line.substr(blank + 1);
    if (key == "checks") manifest.checks[name] = hash;
    if (key == "file" && is_below(name)) manifest.files[name] = hash;
  }
  return manifest;
}

void write_manifest(const fs::path& handout, const Manifest& manifest) {
  std::string text = fmt::format("version={}\nform={}\nhints={}\n", manifest.version, manifest.form,
                                 manifest.hints);
  for (const std::string& lab : manifest.labs) text += fmt::format("lab={}\n", lab);
  for (const auto& [lab, hash] : manifest.checks) text += fmt::format("checks={} {}\n", hash, lab);
  for (const auto& [file, hash] : manifest.files) text += fmt::format("file={} {}\n", hash, file);
  write_text(handout / manifest_file, text);
}

std::string hash_of_file(const fs::path& file) {
  return fmt::format("{:016x}", hash_text(read_whole_text(file)));
}

}  // namespace mc::grader
