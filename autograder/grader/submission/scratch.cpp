#include "grader/submission/scratch.hpp"

#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <system_error>
#include <vector>

#include <fmt/format.h>

#include "grader/base/errors.hpp"

namespace mc::grader {
namespace fs = std::filesystem;

ScratchDirectory::ScratchDirectory(const Layout& layout) {
  const fs::path parent = layout.build / "tmp";
  std::error_code error;
  fs::create_directories(parent, error);
  // The name begins with its owner, for sweep_scratch().
  std::string pattern = (parent / fmt::format("{}-XXXXXX", getpid())).string();
  if (error || mkdtemp(pattern.data()) == nullptr) {
    throw MachineError(fmt::format("cannot write in {}: {}", parent.string(),
                                   error ? error.message() : std::strerror(errno)));
  }
  path_ = pattern;
}

ScratchDirectory::~ScratchDirectory() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

void sweep_programs(const Layout& layout, std::size_t most_bytes,
                    const std::set<fs::path>& done_with) {
  struct Slot {
    fs::file_time_type used = fs::file_time_type::min();
    std::size_t bytes = 0;
    fs::path path;
  };
  std::vector<Slot> slots;
  std::size_t bytes = 0;
  std::error_code ignored;  // other processes sweep, too
  for (const auto& entry : fs::directory_iterator(layout.build / "programs", ignored)) {
    Slot slot;
    slot.path = entry.path();
    for (const auto& file : fs::directory_iterator(entry.path(), ignored)) {
      std::error_code gone;
      const auto size = file.file_size(gone);
      if (gone) continue;
      slot.bytes += size;
      slot.used = std::max(slot.used, file.last_write_time(ignored));
    }
    // An empty one was created just now.
    if (slot.bytes == 0) slot.used = entry.last_write_time(ignored);
    bytes += slot.bytes;
    slots.push_back(std::move(slot));
  }
  std::ranges::sort(slots, [](auto& a, auto& b) { return a.used < b.used; });
  // A build takes a few minutes at most: each of its compilers may use one.
  const auto old = fs::file_time_type::clock::now() - std::chrono::minutes(15);
  for (const Slot& slot : slots) {
    if (bytes <= most_bytes) return;
    if (slot.used > old && !done_with.contains(slot.path)) continue;
    fs::remove_all(slot.path, ignored);
    bytes -= slot.bytes;
  }
}

void sweep_scratch(const Layout& layout) {
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(layout.build / "tmp", ignored)) {
    const pid_t owner = std::atoi(entry.path().filename().c_str());
    if (owner > 0 && kill(owner, 0) != 0 && errno == ESRCH) fs::remove_all(entry.path(), ignored);
  }
}

}  // namespace mc::grader
