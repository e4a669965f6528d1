#pragma once
// What a compiler of submissions may use: a list of places and an environment.

#include <filesystem>
#include <string>
#include <vector>

#include "judge/checkout/layout.hpp"
#include "sandbox/process.hpp"

namespace mc::grader {

/// The places of system and compiler (headers, libraries, programs), without the checkout and the
/// build directory, if these are in one. Throws MachineError if the compiler cannot be asked.
const std::vector<std::filesystem::path>& toolchain(const Layout& layout);

/// What is added to the environment of a compiler that works in `directory`: COMPILER_PATH is for
/// GCC's own programs what PATH is for others.
sandbox::Environment compiler_environment(const std::filesystem::path& directory);

/// The compiler and all of the environment that decides what it makes, for the key of a cache.
std::string identity_of_compiler(const Layout& layout);

/// Is `path` one of the places, or below one? All canonical.
bool is_in(const std::filesystem::path& path, const std::vector<std::filesystem::path>& places);

/// The files that a make rule ("a.o: b.cpp c.hpp \\") depends on.
std::vector<std::filesystem::path> dependencies(const std::string& rule);

}  // namespace mc::grader
