#pragma once
// A class on a cluster: one task of a Slurm job array per submission. A task is a shard of one
// submission with its own table, so it can be killed, requeued and restarted like any other run.

#include <cstdint>

#include "grader/gradebook/table.hpp"

namespace mc::grader {

struct SlurmTasks {
  std::filesystem::path csv;              ///< the final table
  std::vector<std::string> options = {};  ///< options of ./lab grade for every task
  std::vector<std::string> words = {};    ///< the submissions
  std::size_t count = 0;                  ///< number of submissions: task k has the k-th
  std::uint64_t seed = 0;
  bool is_resumed = false;  ///< keep the results of an earlier job's tasks
};

/// Submits the tasks from this directory with sbatch; returns the job's number. Throws MachineError
/// if there is no Slurm or it refuses the job.
std::string submit_tasks(const Context& context, const SlurmTasks& tasks);

/// Reads the verdicts that tasks have written next to this table; returns their number. Throws
/// UsageError while the job is still in the queue.
std::size_t gather_tasks(const std::filesystem::path& csv);

}  // namespace mc::grader
