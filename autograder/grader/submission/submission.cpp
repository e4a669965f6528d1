#include "grader/submission/submission.hpp"

#include <algorithm>
#include <system_error>

#include <fmt/format.h>

#include "grader/base/errors.hpp"
#include "sandbox/printable.hpp"

namespace mc::grader {
namespace fs = std::filesystem;

Submission open_submission(const std::vector<Lab>& labs, const fs::path& directory) {
  if (!fs::exists(directory)) {
    throw UsageError(
        fmt::format("no such directory: {}", sandbox::printable_line(directory.string())));
  }
  if (!fs::is_directory(directory)) {
    throw UsageError(fmt::format("{} is a file: name the directory it is in",
                                 sandbox::printable_line(directory.string())));
  }
  Submission submission{sandbox::printable_line(directory.string()), directory, {}, false};
  while (submission.label.size() > 1 && submission.label.back() == '/') submission.label.pop_back();
  if (fs::is_symlink(
          fs::path(directory.string().substr(0, directory.string().find_last_not_of('/') + 1)))) {
    throw UsageError(fmt::format("{} is a link: name the directory itself", submission.label));
  }
  for (const Lab& lab : labs) {
    const fs::path file = directory / lab.file();
    // Links are ignored: they might lead to the solution.
    if (fs::is_regular_file(fs::symlink_status(file))) {
      submission.files[lab.name] = fs::canonical(file);
    }
  }
  return submission;
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
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace mc::grader
