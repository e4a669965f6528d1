#pragma once
// A process of checks or measurements, and the records it sent.

#include <filesystem>
#include <string>
#include <vector>

#include "protocol/records.hpp"
#include "sandbox/process.hpp"

namespace mc::grader {

struct CheckProcess {
  sandbox::ProcessResult result;
  std::vector<protocol::Record> records;

  std::vector<protocol::CheckEnd> ends() const { return protocol::check_ends_in(records); }
};

/// Runs the test cases of `program` that `which` selects: a name, a tag ("[.plot]"), or all that
/// are not hidden (""). Records come over a separate pipe.
CheckProcess run_check_program(const std::filesystem::path& program, const std::string& which,
                               sandbox::ProcessOptions options);

}  // namespace mc::grader
