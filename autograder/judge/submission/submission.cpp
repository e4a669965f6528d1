#include "judge/submission/submission.hpp"

#include <algorithm>
#include <system_error>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "judge/base/errors.hpp"
#include "sandbox/printable.hpp"

namespace mc::grader {
namespace fs = std::filesystem;

std::string what_is_there(const Submission& submission) {
  if (submission.others.empty()) return {};
  return sandbox::shortened(fmt::format("; there is: {}", fmt::join(submission.others, ", ")), 200);
}

std::map<std::string, fs::path> files_in(const std::vector<Lab>& labs, const fs::path& directory) {
  std::map<std::string, fs::path> files;
  if (fs::is_symlink(fs::symlink_status(directory))) return files;
  for (const Lab& lab : labs) {
    const fs::path file = directory / lab.file();
    if (fs::is_regular_file(fs::symlink_status(file))) files[lab.name] = fs::canonical(file);
  }
  return files;
}

Submission open_submission(const std::vector<Lab>& labs, const fs::path& directory) {
  std::string name = directory.string();
  while (name.size() > 1 && name.ends_with('/')) name.pop_back();
  const std::string shown = sandbox::printable_line(name);
  if (!fs::exists(name)) throw UsageError("no such directory: " + shown);
  if (!fs::is_directory(name)) {
    throw UsageError(shown + " is a file: name the directory it is in");
  }
  if (fs::is_symlink(name)) throw UsageError(shown + " is a link: name the directory itself");
  return {shown, directory, files_in(labs, name), false};
}

bool is_reference(const Layout& layout, const Submission& submission) {
  std::error_code missing;
  return fs::equivalent(submission.path, layout.solutions(), missing) && !missing;
}

Submission single_file_submission(const Layout& layout, const std::vector<Lab>& labs,
                                  const Lab& lab, const fs::path& file, bool trusted) {
  Submission submission{file.string(), file, {}, trusted};
  for (const Lab& other : labs) {
    const fs::path solution = layout.solutions() / other.file();
    if (fs::exists(solution)) submission.files[other.name] = solution;
  }
  submission.files[lab.name] = fs::canonical(file);
  return submission;
}

std::optional<Submission> peer_submission(const Layout& layout, const std::vector<Lab>& labs,
                                          const Lab& lab, const std::string& library) {
  const fs::path file = layout.submissions() / "peers" / library / lab.file();
  if (!layout.peers.contains(library) || !fs::exists(file)) return {};
  Submission peer = single_file_submission(layout, labs, lab, file, true);
  for (const std::string& other : lab.depends_on) {  // its own file, if it has one
    const fs::path own = file.parent_path() / (other + ".cpp");
    if (fs::exists(own)) peer.files[other] = own;
  }
  peer.label = library;
  peer.libraries = layout.peers.at(library);
  return peer;
}

std::vector<std::string> peer_libraries(const Layout& layout) {
  std::vector<std::string> names;
  const fs::path peers = layout.submissions() / "peers";
  if (!fs::exists(peers)) return names;
  for (const auto& entry : fs::directory_iterator(peers)) {
    if (entry.is_directory()) names.push_back(entry.path().filename().string());
  }
  std::ranges::sort(names);
  return names;
}

}  // namespace mc::grader
