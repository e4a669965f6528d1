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

/// Rows of the lab's [.speed] cases, restricted to `tasks`.
std::vector<protocol::Row> speed_rows(const Layout& layout, const Lab& lab,
                                      const sandbox::Program& program,
                                      const std::set<std::string>& tasks);

/// The reference's times, in additions of a running sum (protocol/rows.hpp): a file of the lab,
/// which ./lab bench --calibrate writes for checkouts without solutions.
std::filesystem::path ratios_file(const Layout& layout, const Lab& lab);

/// The ratios in such a file, by the names of the speed tasks.
std::map<std::string, double> kept_ratios(const std::filesystem::path& file);

/// Measures the speed tasks whose checks all passed, and right after them the reference's; without
/// the reference, estimates its time from the stored ratio.
std::vector<Speed> measure_speed(const Layout& layout, const LabVerdict& verdict,
                                 const sandbox::Program& program);

}  // namespace mc::grader
