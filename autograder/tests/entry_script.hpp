#pragma once
// Runs ./lab as a user would; everything is built already.

#include <string>
#include <utility>
#include <vector>

#include "grader/checkout/layout.hpp"
#include "sandbox/process.hpp"

namespace mc::tests {

inline sandbox::ProcessResult lab(std::vector<std::string> words,
                                  const sandbox::ProcessOptions& options = {}) {
  words.insert(words.begin(), (grader::read_layout().build / "bin" / "grader").string());
  return sandbox::run_process(words, options);
}

}  // namespace mc::tests
