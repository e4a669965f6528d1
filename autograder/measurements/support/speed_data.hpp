#pragma once
// What methods cost: times, seen from outside the program; and the speed tasks, as check and grade
// report them: hidden cases tagged [.speed]. Each number is in a row (protocol/rows.hpp).

#include <string>

#include "measurements/support/methods.hpp"
#include "protocol/rows.hpp"

namespace mc::measurements {

using protocol::Row;

/// Appends to the file that the grader reads, and flushes it.
void bench_row(const Row& row);

/// So many rounds that they take about `wanted` seconds, the start of the program included;
/// `first` or more. 0 where the task is not written.
Count rounds_for(const Rounds& run, double wanted, Count first = 1);

/// Seconds a round: the CPU time of 2R rounds less that of R. What a program does before its first
/// round may take longer than R of them (values to be made, memory to be had, or time to be
/// wasted): its noise must not be taken for a round, and R becomes four times as large until it is
/// not.
double seconds_by_difference(const Rounds& run, Count& rounds);

/// The median of so many such differences, R rounds of which take about `wanted` seconds: the two
/// runs of each are close together, since a shared machine changes its pace from one second to the
/// next. Missing where what came back was wrong.
double seconds_of(const Rounds& run, double wanted = 0.025, int differences = 1, Count first = 1);

/// Rows of a speed task, if MC_SPEED_TASKS names its task (the grader does: those that passed): of
/// its time and of its plain counterpart's in turn, three times each; and of the error of its
/// points.
void bench_speed(const SpeedTask& task);

}  // namespace mc::measurements
