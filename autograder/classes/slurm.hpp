#pragma once
// A class on a cluster: one task of a Slurm job array per submission. A task judges one submission
// and writes its verdict next to the table, so it can be killed, requeued and restarted; --resume
// makes the table.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "classes/verdict_store.hpp"
#include "judge/checkout/labs.hpp"

namespace mc::grader {

/// The number of the submission, from 0, that this process judges as a task; nothing elsewhere.
std::optional<std::size_t> slurm_task();

/// Submits an array of `count` tasks from this directory, each `lab WORDS...`; returns the job's
/// number. Throws MachineError if there is no Slurm or it refuses the job.
std::string submit_tasks(const Context& context, const VerdictStore& store,
                         const std::vector<std::string>& words, std::size_t count);

/// Throws UsageError while the job of this store is still in the queue.
void require_finished_tasks(const VerdictStore& store);

}  // namespace mc::grader
