#pragma once
// Runs work on a few threads.

#include <cstddef>
#include <functional>

namespace mc::grader {

/// Runs `work(i)` for all i below `count` on up to `workers` threads, in order of i as threads
/// become free. If one throws, the others finish their current item and the caller gets the
/// exception.
void run_side_by_side(std::size_t count, unsigned workers,
                      const std::function<void(std::size_t)>& work);

/// The number of cores that this process may use, by affinity and by the limit of its container.
unsigned cores();

}  // namespace mc::grader
