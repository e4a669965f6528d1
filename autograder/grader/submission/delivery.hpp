#pragma once
// Who submitted, and when, according to a learning platform or a roster.

#include <string>

namespace mc::grader {

struct Delivery {
  std::string name, email;  ///< from the roster
  /// "2026-01-02 03:04:05 Z" from the platform's metadata; "… (file time)" if only files tell it.
  std::string submitted;
  bool late = false;          ///< the platform's mark
  std::string platform_name;  ///< of the file or directory in the export, for sending feedback back

  bool operator==(const Delivery&) const = default;
};

}  // namespace mc::grader
