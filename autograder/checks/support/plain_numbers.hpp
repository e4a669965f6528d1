#pragma once

#include <string>

namespace mc::checks {

/// A story whose numbers have no sign that says nothing to its reader: "-nan" and "-0" become "nan"
/// and "0".
std::string without_empty_signs(std::string story);

}  // namespace mc::checks
