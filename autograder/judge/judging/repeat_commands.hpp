#pragma once
// The commands in the report of a failure: one judges the check again, one runs the failing input
// by hand.

#include <string>
#include <vector>

#include "judge/judging/judge.hpp"

namespace mc::grader {

/// "./lab check variance --only 1.3 --seed 8123"
std::string repeat_command(const Lab& lab, const Check& check, const JudgeOptions& options);

/// The same for a student's own checkout, not where the submission was judged.
std::string own_repeat_command(const Lab& lab, const Check& check, std::uint64_t seed);

/// "./lab run variance covariance --x 1,2,4 --y 3,1,2" of an experiment and its arguments.
/// Arguments of more than a line are written to a file below build/inputs, and named by "@file".
std::string by_hand_command(const Layout& layout, const Lab& lab,
                            const std::vector<std::string>& call, const JudgeOptions& options);

}  // namespace mc::grader
