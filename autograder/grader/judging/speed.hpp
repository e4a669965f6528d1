#pragma once
// The speed tasks of a submission compared with the reference: reported, never graded.

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "grader/judging/verdict.hpp"
#include "protocol/rows.hpp"
#include "sandbox/jail.hpp"

namespace mc::grader {

/// Rows of the lab's [.speed] cases, of those of its `tasks`.
std::vector<protocol::Row> speed_rows(const Layout& layout, const Lab& lab,
                                      const sandbox::Program& program,
                                      const std::set<std::string>& tasks);

/// What the reference takes, in additions of a running sum (protocol/rows.hpp): a file of the lab,
/// written by ./lab bench --calibrate, for checkouts without solutions.
std::filesystem::path ratios_file(const Layout& layout, const Lab& lab);

/// Such a file's ratios, by the names of the speed tasks.
std::map<std::string, double> kept_ratios(const std::filesystem::path& file);

/// Measures the speed tasks of which all checks passed, on a program of the variant for speed, and
/// the reference's right after them; or says what that takes by its ratio.
std::vector<Speed> measure_speed(const Layout& layout, const LabVerdict& verdict,
                                 const sandbox::Program& program);

}  // namespace mc::grader
