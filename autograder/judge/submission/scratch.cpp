#include "judge/submission/scratch.hpp"

#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <system_error>
#include <vector>

#include <fmt/format.h>

#include "judge/base/errors.hpp"
#include "sandbox/descriptor.hpp"

namespace mc::grader {
namespace fs = std::filesystem;

void write_or_explain(const fs::path& place, const std::function<void()>& write) {
  try {
    write();
  } catch (const std::system_error& error) {
    if (error.code().value() != EACCES && error.code().value() != EPERM) throw;
    fs::path at = place;
    while (!fs::exists(at)) at = at.parent_path();
    struct stat status {};
    if (stat(at.c_str(), &status) != 0 || status.st_uid == geteuid()) throw;
    throw MachineError(fmt::format(
        "cannot write in {}: it belongs to another user (id {}), after a run as that user. Remove "
        "it, or: sudo chown -R {} {}",
        at.string(), status.st_uid, geteuid(), at.parent_path().string()));
  }
}

ScratchDirectory::ScratchDirectory(const Layout& layout) {
  const fs::path parent = layout.build / "tmp";
  // The name begins with its owner, for sweep_scratch().
  std::string pattern = (parent / fmt::format("{}-XXXXXX", getpid())).string();
  try {
    write_or_explain(parent, [&] {
      fs::create_directories(parent);
      if (mkdtemp(pattern.data()) == nullptr) sandbox::fail(parent.string());
    });
  } catch (const std::system_error& error) {
    throw MachineError(
        fmt::format("cannot write in {}: {}", parent.string(), error.code().message()));
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
