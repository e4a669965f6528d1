#pragma once
// The speed tasks, as check and grade report them: hidden cases tagged [.speed], timed from outside
// the program. Each figure is a row (protocol/rows.hpp).

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "protocol/rows.hpp"

namespace mc::checks {

/// Appends to the file that ./lab bench reads, and tells it at once.
void bench_row(const protocol::Row& row);

/// CPU time of so many rounds; nothing where the task is not written.
using Rounds = std::function<std::optional<double>(std::uint64_t)>;

template <class Measured>
std::optional<double> cpu_seconds_of(const Measured& measured) {
  if (!measured) return {};
  return measured->cpu_seconds;
}

/// So many rounds that they take about `wanted` seconds, the start of the program included.
std::optional<std::uint64_t> rounds_of(const Rounds& run, double wanted);

/// Seconds a round: the CPU time of 2R rounds less that of R. What a program does before its first
/// round may take longer than R of them (values to be made, memory to be had, or time to be
/// wasted): its noise must not be taken for a round, and R becomes four times as large until it is
/// not.
std::optional<double> seconds_by_difference(const Rounds& run, std::uint64_t& rounds);

/// Rows of kind speed, if `task` is one that MC_SPEED_TASKS names (the grader does: those that
/// passed): `rounds` makes `values` numbers or points each time. A seventh of a second.
void bench_speed(const std::string& task, const std::string& name, std::uint64_t values,
                 const Rounds& rounds);

/// A row of kind speed error, if `task` is asked for: the RMSE of the mean of exp(x + y), as a part
/// of its integral, over n points of the plane. `points` gives `sets` sets of them, in each its n x
/// and then its n y; nothing where the task is not written.
void bench_speed_error(
    const std::string& task, const std::string& name, std::uint64_t n,
    const std::function<std::optional<std::vector<double>>(std::uint64_t sets)>& points);

}  // namespace mc::checks
