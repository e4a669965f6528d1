#pragma once
// Replaces this process by another program.

#include <unistd.h>

#include <cstdio>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "grader/base/errors.hpp"

namespace mc::grader {

/// Returns only by throwing.
[[noreturn]] inline void become(std::vector<std::string> command) {
  std::vector<char*> pointers;
  for (std::string& word : command) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  std::fflush(nullptr);
  execvp(pointers[0], pointers.data());
  throw MachineError(fmt::format("cannot run {}", command[0]));
}

}  // namespace mc::grader
