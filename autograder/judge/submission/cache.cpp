#include "judge/submission/cache.hpp"

#include <chrono>
#include <system_error>

#include <fmt/format.h>

#include "judge/base/text_file.hpp"
#include "judge/submission/scratch.hpp"

namespace mc::grader {
namespace fs = std::filesystem;
namespace {

/// The file that records a cached build: its name in the slot, a newline, the key.
fs::path entry_of(const fs::path& slot, std::string_view kind, const std::string& key) {
  return slot / fmt::format("{:016x}.{}-key", hash_text(key), kind);
}

/// Marks a file as used now. False if it no longer exists.
bool touch(const fs::path& file) {
  std::error_code missing;
  fs::last_write_time(file, fs::file_time_type::clock::now(), missing);
  return !missing;
}

/// Not the newest, because another run may be about to use it.
void sweep(const fs::path& slot) {
  const auto old = fs::file_time_type::clock::now() - std::chrono::hours(1);
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(slot, ignored)) {
    if (entry.last_write_time(ignored) < old) fs::remove(entry.path(), ignored);
  }
}

}  // namespace

std::optional<fs::path> find_cached(const fs::path& slot, std::string_view kind,
                                    const std::string& key) {
  const fs::path entry = entry_of(slot, kind, key);
  const std::string text = read_text(entry);
  const auto line_end = text.find('\n');
  if (line_end == std::string::npos || text.compare(line_end + 1, std::string::npos, key) != 0) {
    return {};
  }
  const fs::path file = slot / text.substr(0, line_end);
  if (!touch(entry) || !touch(file)) return {};
  return file;
}

fs::path keep_cached(const fs::path& slot, std::string_view kind, const std::string& key,
                     const fs::path& made) {
  // The scratch directory that it was made in has a unique name.
  const std::string name = fmt::format("{}.{}", made.parent_path().filename().string(), kind);
  write_or_explain(slot, [&] {
    fs::create_directories(slot);
    sweep(slot);
    fs::rename(made, slot / name);
    write_text(entry_of(slot, kind, key), name + '\n' + key);
  });
  return slot / name;
}

}  // namespace mc::grader
