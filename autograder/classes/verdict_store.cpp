#include "classes/verdict_store.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <thread>

#include <fmt/format.h>

#include "judge/base/errors.hpp"
#include "judge/base/text_file.hpp"
#include "judge/reports/verdict_json.hpp"

namespace mc::grader {
namespace fs = std::filesystem;
namespace {

/// Removes temporary files of write_text() that a killed process left.
void sweep_unfinished(const fs::path& directory, const std::string& begin) {
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(directory, ignored)) {
    const std::string name = entry.path().filename().string();
    const auto at = name.rfind(".new-");
    if (at == std::string::npos || !name.starts_with(begin)) continue;
    const pid_t owner = std::atoi(name.c_str() + at + 5);
    if (owner > 0 && kill(owner, 0) != 0 && errno == ESRCH) fs::remove(entry.path(), ignored);
  }
}

std::vector<fs::path> verdict_files(const fs::path& directory) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(directory)) {
    if (entry.path().extension() == ".json") files.push_back(entry.path());
  }
  return files;
}

/// Nothing if the file is absent, truncated, of another version or edited.
std::optional<Verdict> read_verdict(const fs::path& file) {
  if (!fs::exists(file)) return {};
  const std::string text = read_whole_text(file);
  try {
    return verdict_from_json(text);
  } catch (const std::exception&) {
    return {};
  }
}

/// Held until this process ends in any way.
sandbox::Descriptor lock_of(const fs::path& directory, const fs::path& csv) {
  sandbox::Descriptor lock(open((directory / "lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644),
                           "opening the lock");
  // A run that was just killed may have a child that has not called exec yet.
  const auto patience = std::chrono::steady_clock::now() + std::chrono::seconds(3);
  while (flock(lock.get(), LOCK_EX | LOCK_NB) != 0) {
    if (errno == EINTR) continue;
    if (errno != EWOULDBLOCK) {
      fmt::print(stderr, "lab: no locks on this file system: start only one run for {}\n",
                 csv.string());
      break;
    }
    if (std::chrono::steady_clock::now() >= patience) {
      throw UsageError(fmt::format("another run is writing {}", csv.string()));
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  return lock;
}

}  // namespace

VerdictStore::VerdictStore(const fs::path& csv, StoreMode mode)
    : directory_(fs::absolute(csv).parent_path() / (csv.stem().string() + "-verdicts")),
      may_reuse_(mode != StoreMode::anew) {
  fs::create_directories(directory_);
  if (mode == StoreMode::task) return;
  lock_ = lock_of(directory_, csv);
  sweep_unfinished(directory_, "");
  sweep_unfinished(fs::absolute(csv).parent_path(), csv.filename().string());
  const auto files = verdict_files(directory_);
  if (mode == StoreMode::resume) {
    for (const fs::path& file : files) {
      if (const auto verdict = read_verdict(file)) seed_ = verdict->seed;
      if (seed_) break;
    }
    return;
  }
  if (!files.empty() && !fs::exists(csv)) {
    throw UsageError(
        fmt::format("{} has {} verdicts of an unfinished run: --resume continues it; to start "
                    "over, remove it",
                    directory_.string(), files.size()));
  }
  fs::remove(csv);
  for (const fs::path& file : files) fs::remove(file);
}

std::optional<Verdict> VerdictStore::known(const Verdict& wanted) const {
  if (!may_reuse_) return {};
  auto verdict = read_verdict(directory_ / (wanted.submission + ".json"));
  if (!verdict) return {};
  const bool same_labs = std::ranges::equal(
      verdict->labs, wanted.labs, {}, [](auto& one) { return one.lab.name; },
      [](auto& one) { return one.lab.name; });
  const bool is_current = verdict->submission == wanted.submission && same_labs &&
                          verdict->contents == wanted.contents &&
                          verdict->version == wanted.version && verdict->seed == wanted.seed &&
                          verdict->not_judged.empty();
  return is_current ? std::move(verdict) : std::nullopt;
}

void VerdictStore::add(const Verdict& verdict) const {
  write_text(directory_ / (verdict.submission + ".json"), verdict_to_json(verdict));
}

}  // namespace mc::grader
