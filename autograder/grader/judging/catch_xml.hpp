#pragma once
// Catch2's XML report, version 2 or 3: they differ in the root only.

#include <string>
#include <string_view>
#include <vector>

namespace mc::grader {

/// One test case's part of the report.
struct XmlRecord {
  std::string name, tags;
  bool success = false;
  std::string message;   ///< of the first failure
  bool crashed = false;  ///< by an exception or a signal: the check itself is at fault, nobody else
};

/// The records of a report; none of one that is cut short.
std::vector<XmlRecord> read_catch_xml(std::string_view xml);

}  // namespace mc::grader
