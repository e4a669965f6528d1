#pragma once
// What is known of a submission besides its files: who submitted it, and when, according to a
// learning platform or a roster, and the hours that the student reports.

#include <map>
#include <string>

namespace mc::grader {

struct Delivery {
  std::string name, email;  ///< from the roster
  /// "2026-01-02 03:04:05 Z" from the platform's metadata; "… (file time)" if only files tell it.
  std::string submitted;
  bool late = false;          ///< the platform's mark
  std::string platform_name;  ///< of the file or directory in the export, for sending feedback back
  std::map<std::string, std::string> hours = {};  ///< by lab, as the student wrote them

  bool operator==(const Delivery&) const = default;
};

}  // namespace mc::grader
