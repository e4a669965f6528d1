#pragma once
// What the grader passes to a process of checks: environment variables and descriptors.

namespace mc::protocol {

// The program under judgment, open on this descriptor.
inline constexpr const char* program_variable = "MC_PROGRAM_DESCRIPTOR";
inline constexpr int program_descriptor = 10;
// By hand instead: its path.
inline constexpr const char* program_path_variable = "MC_PROGRAM";

// Where a check writes its records (records.hpp).
inline constexpr const char* records_variable = "MC_RECORDS_DESCRIPTOR";
inline constexpr int records_descriptor = 11;

// The run's seed; a check's own is a hash of it and of its name.
inline constexpr const char* seed_variable = "MC_SEED";

// Of hidden cases: the directory for the data of plots, the file for rows (rows.hpp), the speed
// tasks to be timed, and the picture to be rendered (render.hpp).
inline constexpr const char* plot_data_variable = "MC_PLOT_DATA";
inline constexpr const char* rows_variable = "MC_BENCH_DATA";
inline constexpr const char* speed_tasks_variable = "MC_SPEED_TASKS";
inline constexpr const char* render_variable = "MC_RENDER";

}  // namespace mc::protocol
