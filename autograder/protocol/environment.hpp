#pragma once
// What the grader passes to a process of checks: environment variables and descriptors.

namespace mc::protocol {

// The program to be judged, open on this descriptor.
inline constexpr const char* program_variable = "MC_PROGRAM_DESCRIPTOR";
inline constexpr int program_descriptor = 10;
// Its path instead, for use by hand.
inline constexpr const char* program_path_variable = "MC_PROGRAM";

// The file to which a check writes its records (records.hpp).
inline constexpr const char* records_variable = "MC_RECORDS_DESCRIPTOR";
inline constexpr int records_descriptor = 11;

// The seed of the run; each check's seed is a hash of it and the check's name.
inline constexpr const char* seed_variable = "MC_SEED";

// For hidden cases: the directory for the data of plots, the file for rows (rows.hpp), the speed
// tasks to time, and the picture to render (render.hpp).
inline constexpr const char* plot_data_variable = "MC_PLOT_DATA";
inline constexpr const char* rows_variable = "MC_BENCH_DATA";
inline constexpr const char* speed_tasks_variable = "MC_SPEED_TASKS";
inline constexpr const char* render_variable = "MC_RENDER";

}  // namespace mc::protocol
