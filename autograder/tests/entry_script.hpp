#pragma once
// Runs ./lab as a user would; everything is built already.

#include <string>
#include <utility>
#include <vector>

#include "grader/checkout/layout.hpp"
#include "sandbox/process.hpp"
#include "tests/require_run.hpp"
#include "tests/text.hpp"

namespace mc::tests {

inline sandbox::ProcessResult lab(const std::vector<std::string>& words,
                                  const sandbox::ProcessOptions& options = {}) {
  const auto program = grader::read_layout().build / "bin" / "grader";
  return sandbox::run_process(joined({program.string()}, words), options);
}

}  // namespace mc::tests
