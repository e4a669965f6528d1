#pragma once
// Work for a few threads.

#include <cstddef>
#include <functional>

namespace mc::grader {

/// Runs `work(i)` for all i below `count` with up to `workers` threads, in order of i as they
/// become free. An exception of one ends the others after what they are at, and reaches the caller.
void run_side_by_side(std::size_t count, unsigned workers,
                      const std::function<void(std::size_t)>& work);

/// How many the machine has.
unsigned cores();

}  // namespace mc::grader
