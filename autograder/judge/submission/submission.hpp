#pragma once
// A submission: files in place of a student's, one per lab.

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "judge/checkout/labs.hpp"
#include "judge/checkout/layout.hpp"

namespace mc::grader {

struct Submission {
  std::string label;  ///< its name in reports
  /// The directory, archive or file, as named on the command line or found in a class.
  std::filesystem::path path;
  std::map<std::string, std::filesystem::path> files;  ///< lab name -> file
  /// May include the repository's own sources, as mistakes and alternatives do. The caller decides;
  /// it is never derived from a path.
  bool trusted = false;
  std::vector<std::string> libraries = {};  ///< flags to link the library of a peer
  std::string found_in = {};  ///< where below `path` the files are; empty if at the top
  /// Names of files that may have been meant where a lab's file is missing: "variance (1).cpp".
  std::vector<std::string> others = {};
};

/// "; there is: variance (1).cpp", after the news that a file is missing; empty if nothing is like
/// it.
std::string what_is_there(const Submission& submission);

/// The lab files in `directory` itself, by the lab's name. Links are ignored, also as the
/// directory: they might lead to the solutions.
std::map<std::string, std::filesystem::path> files_in(const std::vector<Lab>& labs,
                                                      const std::filesystem::path& directory);

/// A directory with some of the labs' .cpp files. Throws UsageError if it does not exist, is a link
/// (it might lead to the solutions), or is not a directory.
Submission open_submission(const std::vector<Lab>& labs, const std::filesystem::path& directory);

/// Is this the directory of the reference solutions?
bool is_reference(const Layout& layout, const Submission& submission);

/// One file for `lab`; the other labs' files are the solutions.
Submission single_file_submission(const Layout& layout, const std::vector<Lab>& labs,
                                  const Lab& lab, const std::filesystem::path& file, bool trusted);

/// A library behind a lab's interface, autograder/submissions/peers/<library>/<lab>.cpp. Nothing if
/// the library has no adapter for this lab or is not installed.
std::optional<Submission> peer_submission(const Layout& layout, const std::vector<Lab>& labs,
                                          const Lab& lab, const std::string& library);

/// The libraries that have adapters.
std::vector<std::string> peer_libraries(const Layout& layout);

}  // namespace mc::grader
