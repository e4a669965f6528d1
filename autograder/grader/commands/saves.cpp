#include "grader/commands/saves.hpp"

#include <sys/stat.h>

#include <set>
#include <system_error>
#include <utility>

#ifdef __linux__
#include <sys/inotify.h>
#endif

namespace mc::grader {
namespace fs = std::filesystem;

Saves::Saves(std::vector<fs::path> files) : files_(std::move(files)) {
#ifdef __linux__
  const int notes = inotify_init1(IN_CLOEXEC | IN_NONBLOCK);
  if (notes >= 0) notes_ = sandbox::Descriptor(notes, "inotify");
#endif
  listen();
  for (const fs::path& file : files_) states_.push_back(look_at(file));
}

/// Watches the directories: replacing a file would remove a watch on the file itself.
void Saves::listen() {
#ifdef __linux__
  if (!notes_) return;
  std::set<fs::path> directories;
  for (const fs::path& file : files_) directories.insert(file.parent_path());
  for (const fs::path& directory : directories) {  // watching one again changes nothing
    inotify_add_watch(notes_.get(), directory.empty() ? "." : directory.c_str(),
                      IN_CLOSE_WRITE | IN_MOVED_TO | IN_CREATE | IN_DELETE | IN_MOVED_FROM);
  }
#endif
}

Saves::State Saves::look_at(const fs::path& file) {
  State state;
  struct stat found {};
  if (stat(file.c_str(), &found) != 0 || !S_ISREG(found.st_mode)) return state;
  std::error_code vanished;
  state.time = fs::last_write_time(file, vanished);
  state.size = static_cast<std::uintmax_t>(found.st_size);
  state.inode = static_cast<std::uintmax_t>(found.st_ino);
  state.is_there = !vanished;
  return state;
}

bool Saves::changed() {
  if (notes_) {
    std::string ignored;
    sandbox::read_available(notes_, ignored, std::size_t{1} << 16);
    listen();  // a directory may have been replaced, too
  }
  bool is_other = false;
  for (std::size_t i = 0; i < files_.size(); ++i) {
    const State now = look_at(files_[i]);
    is_other = is_other || now != states_[i];
    states_[i] = now;
  }
  return is_other;
}

std::string Saves::missing() const {
  for (std::size_t i = 0; i < files_.size(); ++i) {
    if (!states_[i].is_there) return files_[i].filename().string();
  }
  return {};
}

}  // namespace mc::grader
