#include "grader/submission/scratch.hpp"

#include <signal.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <system_error>

#include <fmt/format.h>

#include "grader/context/errors.hpp"

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

void sweep_scratch(const Layout& layout) {
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(layout.build / "tmp", ignored)) {
    const pid_t owner = std::atoi(entry.path().filename().c_str());
    if (owner > 0 && kill(owner, 0) != 0 && errno == ESRCH) fs::remove_all(entry.path(), ignored);
  }
}

}  // namespace mc::grader
