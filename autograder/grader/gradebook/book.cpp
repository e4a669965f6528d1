#include "grader/gradebook/book.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <sstream>
#include <thread>

#include "grader/reports/verdict_json.hpp"

namespace mc::grader {
namespace {

fs::path state_file(const fs::path& csv) {
  return verdict_directory(csv) / "state";
}

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

}  // namespace

fs::path verdict_directory(const fs::path& csv) {
  return fs::absolute(csv).parent_path() / (csv.stem().string() + "-verdicts");
}

fs::path verdict_file(const fs::path& csv, const std::string& id) {
  return verdict_directory(csv) / (id + ".json");
}

std::optional<Verdict> read_verdict(const fs::path& csv, const std::string& id) {
  const fs::path file = verdict_file(csv, id);
  if (!fs::exists(file)) return {};
  const std::string text = read_whole_text(file);
  try {
    Verdict verdict = verdict_from_json(text);
    return verdict.submission == id ? std::optional(std::move(verdict)) : std::nullopt;
  } catch (const std::exception&) {  // of another version, or edited by hand
    return {};
  }
}

BookState read_book_state(const fs::path& csv) {
  BookState state;
  std::istringstream text(read_text(state_file(csv)));
  std::string how, seed;
  state.exists = static_cast<bool>(text >> how >> seed >> state.seed);
  state.finished = how == "finished";
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(verdict_directory(csv), none)) {
    state.verdicts += entry.path().extension() == ".json" ? 1 : 0;
  }
  return state;
}

void write_book_state(const fs::path& csv, bool finished, std::uint64_t seed) {
  write_text(state_file(csv), fmt::format("{} seed {}\n", finished ? "finished" : "begun", seed));
}

Book::Book(Setup setup) : setup_(std::move(setup)) {
  const fs::path directory = verdict_directory(setup_.csv);
  fs::create_directories(directory);
  // Held until this process ends in any way.
  lock_ = sandbox::Descriptor(
      open((directory / "lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644), "opening the lock");
  // A run that was just killed may have a child that has not called exec yet.
  const auto patience = std::chrono::steady_clock::now() + std::chrono::seconds(3);
  while (flock(lock_.get(), LOCK_EX | LOCK_NB) != 0) {
    if (std::chrono::steady_clock::now() < patience) {
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
      continue;
    }
    throw UsageError(fmt::format("another run is writing {}", setup_.csv.string()));
  }
  sweep_unfinished(directory, "");
  sweep_unfinished(fs::absolute(setup_.csv).parent_path(), setup_.csv.filename().string());
  if (!setup_.resume) {
    for (const auto& entry : fs::directory_iterator(directory)) {
      if (entry.path().extension() == ".json") fs::remove(entry.path());
    }
  }
  write_book_state(setup_.csv, false, setup_.seed);
}

void Book::keep(const Verdict& verdict) {
  rows_[verdict.submission] = csv_row(setup_.columns, verdict, setup_.people);
}

void Book::begin() {
  write_table();
  table_ = sandbox::Descriptor(open(setup_.csv.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC),
                               "opening " + setup_.csv.string());
}

std::optional<Verdict> Book::known(const std::string& id, const std::vector<Lab>& labs,
                                   const std::string& contents) const {
  if (!setup_.resume) return {};
  auto verdict = read(id);
  if (!verdict) return {};
  const bool same_labs = verdict->labs.size() == labs.size() &&
                         std::equal(labs.begin(), labs.end(), verdict->labs.begin(),
                                    [](auto& lab, auto& one) { return lab.name == one.lab.name; });
  const bool is_current = verdict->contents == contents && verdict->version == setup_.version &&
                          verdict->seed == setup_.seed && same_labs && verdict->not_judged.empty();
  return is_current ? verdict : std::nullopt;
}

std::optional<Verdict> Book::read(const std::string& id) const {
  return read_verdict(setup_.csv, id);
}

void Book::add(const Verdict& verdict) {
  const std::string row = csv_row(setup_.columns, verdict, setup_.people);
  const std::lock_guard lock(mutex_);
  write_text(verdict_file(setup_.csv, verdict.submission), verdict_to_json(verdict));
  rows_[verdict.submission] = row;
  // In one write: a reader, and the next run after a kill, sees whole rows.
  const ssize_t written = write(table_.get(), row.data(), row.size());
  if (written != static_cast<ssize_t>(row.size())) {
    if (written >= 0) errno = ENOSPC;
    sandbox::fail("writing " + setup_.csv.string());
  }
}

void Book::update(const Verdict& verdict) {
  write_text(verdict_file(setup_.csv, verdict.submission), verdict_to_json(verdict));
}

void Book::finish(bool whole) {
  const std::lock_guard lock(mutex_);
  write_table();
  write_book_state(setup_.csv, whole, setup_.seed);
}

void Book::write_table() const {
  std::string table = csv_header(setup_.columns, setup_.people);
  for (const std::string& id : setup_.ids) {
    if (const auto row = rows_.find(id); row != rows_.end()) table += row->second;
  }
  write_text(setup_.csv, table);
}

}  // namespace mc::grader
