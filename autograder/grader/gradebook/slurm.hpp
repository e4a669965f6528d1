#pragma once
// A class on a cluster: one task of a Slurm job array for each submission. A task is a shard of
// one, with a table of its own, so that it may be killed, requeued and begun again like any other
// run.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "grader/checkout/context.hpp"

namespace mc::grader {

struct SlurmTasks {
  std::filesystem::path csv;              ///< the table that is gathered in the end
  std::vector<std::string> options = {};  ///< of ./lab grade, that every task has
  std::vector<std::string> words = {};    ///< what was handed in
  std::size_t count = 0;                  ///< submissions: task k has the k-th
  std::uint64_t seed = 0;
  bool go_on = false;  ///< keeps what the tasks of an earlier job have written
};

/// Submits them from this directory, by sbatch; the number of the job. Throws MachineError where
/// there is no Slurm, or it takes no job.
std::string submit_tasks(const Context& context, const SlurmTasks& tasks);

/// Reads the verdicts that tasks have written next to this table; returns their number. Throws
/// UsageError while the job is still in the queue.
std::size_t gather_tasks(const std::filesystem::path& csv);

}  // namespace mc::grader
