#pragma once
// Writes zip files, which every hand-in system accepts, where neither zip nor CMake may be
// installed.

#include <ctime>
#include <string>
#include <vector>

namespace mc::grader {

struct ZipEntry {
  std::string name;  ///< with slashes, relative
  std::string content;
  std::time_t modified = 0;
};

/// The bytes of a zip archive of these files, without compression (PKWARE's APPNOTE 6.3.10,
/// sections 4.3.7, 4.3.12 and 4.3.16), with Info-ZIP's extra field of the time, which is in UTC.
std::string zip_of(const std::vector<ZipEntry>& entries);

}  // namespace mc::grader
