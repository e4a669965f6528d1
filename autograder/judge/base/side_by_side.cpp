#include "judge/base/side_by_side.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <fstream>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace mc::grader {

void run_side_by_side(std::size_t count, unsigned workers,
                      const std::function<void(std::size_t)>& work) {
  std::mutex mutex;
  std::size_t next = 0;
  std::exception_ptr failure;
  const auto worker = [&] {
    for (;;) {
      std::size_t mine = 0;
      {
        const std::lock_guard lock(mutex);
        if (failure || next == count) return;
        mine = next++;
      }
      try {
        work(mine);
      } catch (...) {
        const std::lock_guard lock(mutex);
        if (!failure) failure = std::current_exception();
      }
    }
  };
  std::vector<std::thread> threads;
  // The caller works too: with one worker, no thread is created.
  for (unsigned i = 1; i < workers && i < count; ++i) {
    try {
      threads.emplace_back(worker);
    } catch (const std::system_error&) {  // no more threads: the existing ones do the work
      break;
    }
  }
  worker();
  for (std::thread& thread : threads) thread.join();
  if (failure) std::rethrow_exception(failure);
}

unsigned cores() {
  unsigned count = std::max(1u, std::thread::hardware_concurrency());  // those of our affinity
  // A container may have less: "150000 100000" is one and a half.
  std::ifstream limit("/sys/fs/cgroup/cpu.max");
  double quota = 0, period = 0;
  if (limit >> quota >> period && quota > 0 && period > 0) {
    count = std::min(count, static_cast<unsigned>(std::ceil(quota / period)));
  }
  return count;
}

}  // namespace mc::grader
