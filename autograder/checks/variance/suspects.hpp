#pragma once
// What well-known mistakes give for a list, and the hint for each. All of it is
// computed in double, as a submission would.

#include <vector>

#include "checks/support/expect.hpp"
#include "data_sets.hpp"

namespace mc::checks {

/// For a mean.
std::vector<Suspect> mean_suspects(const List& list);

/// For a sample variance: its scale, and other ways to it than the one that was asked for.
std::vector<Suspect> variance_suspects(const List& list);

/// The same for a sum of squared deviations, `divided` by something or by nothing.
std::vector<Suspect> m2_suspects(const List& list);

/// The corrected two-pass variance, not stopped at 0.
double two_pass_here(const Values& x);

}  // namespace mc::checks
