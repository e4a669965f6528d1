#pragma once
// The speed tasks of a submission compared with plain code: reported, never graded.

#include <set>
#include <string>
#include <vector>

#include "judge/judging/verdict.hpp"
#include "protocol/rows.hpp"
#include "sandbox/jail.hpp"

namespace mc::grader {

/// Rows of the lab's [.speed] cases, restricted to `tasks`.
std::vector<protocol::Row> speed_rows(const Layout& layout, const Lab& lab,
                                      const sandbox::Program& program,
                                      const std::set<std::string>& tasks);

/// What such rows say.
std::vector<Speed> speed_in(const std::vector<protocol::Row>& rows);

/// Measures the speed tasks whose checks all passed, each in turn with its plain definition or
/// loop.
std::vector<Speed> measure_speed(const Layout& layout, const LabVerdict& verdict,
                                 const sandbox::Program& program);

}  // namespace mc::grader
