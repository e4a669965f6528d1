#include "grader/submission.hpp"

#include <fmt/format.h>

#include "grader/errors.hpp"

namespace mc::grader {
namespace fs = std::filesystem;

Submission open_submission(const Layout& layout, const std::vector<Lab>& labs,
                           const fs::path& directory) {
  if (!fs::exists(directory)) {
    throw UsageError(fmt::format("no such directory: {}", directory.string()));
  }
  if (!fs::is_directory(directory)) {
    throw UsageError(fmt::format("{} is a file: name the directory it is in", directory.string()));
  }
  Submission submission{directory.string(), {}, false};
  while (submission.label.size() > 1 && submission.label.back() == '/') submission.label.pop_back();
  submission.trusted =
      fs::exists(layout.solutions()) && fs::equivalent(directory, layout.solutions());
  for (const Lab& lab : labs) {
    const fs::path file = directory / lab.file();
    // A link is no file of one's own: it might lead to the solution.
    if (fs::is_regular_file(fs::symlink_status(file))) {
      submission.files[lab.name] = fs::canonical(file);
    }
  }
  return submission;
}

Submission single_file_submission(const Layout& layout, const std::vector<Lab>& labs,
                                  const Lab& lab, const fs::path& file, bool trusted) {
  Submission submission{file.string(), {}, trusted};
  for (const Lab& other : labs) {
    const fs::path solution = layout.solutions() / other.file();
    if (fs::exists(solution)) submission.files[other.name] = solution;
  }
  submission.files[lab.name] = fs::canonical(file);
  return submission;
}

}  // namespace mc::grader
