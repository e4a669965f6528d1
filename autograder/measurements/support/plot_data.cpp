#include "measurements/support/plot_data.hpp"

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <set>
#include <stdexcept>

#include <fmt/format.h>

#include "protocol/environment.hpp"

namespace mc::checks {

namespace {

std::ofstream open_data(const std::string& name) {
  const char* directory = std::getenv(protocol::plot_data_variable);
  if (directory == nullptr) throw std::runtime_error("MC_PLOT_DATA is not set");
  std::ofstream file(std::filesystem::path(directory) / name);
  if (!file) throw std::runtime_error("cannot write " + name);
  return file;
}

std::set<std::string> pictures, reasons;  // of this process: one case

void write_missing() {
  if (reasons.empty()) return;
  for (const std::string& picture : pictures) {
    std::ofstream file = open_data(fmt::format("{}.{}.missing", picture, getpid()));
    for (const std::string& reason : reasons) file << reason << '\n';
  }
}

/// "5.3 is not written yet", "halton threw: …"
std::string reason_of(std::string_view experiment, const sandbox::Outcome& outcome) {
  if (!outcome.answered) return fmt::format("{} {}", experiment, outcome.failure);
  if (outcome.status == wire::Status::todo) return outcome.bytes + " is not written yet";
  return fmt::format("{} threw: {}", experiment, outcome.bytes);
}

[[maybe_unused]] const bool listens = [] {
  on_missing = [](std::string_view experiment, const Call& call) {
    if (reasons.insert(reason_of(experiment, call.outcome)).second) write_missing();
  };
  return true;
}();

}  // namespace

std::ofstream plot_file(const std::string& name) {
  if (pictures.insert(name.substr(0, name.find_first_of("-."))).second) write_missing();
  return open_data(name);
}

void plot_row(std::ostream& file, std::span<const std::optional<double>> values) {
  for (const auto& value : values) file << (value ? fmt::format("{}\t", *value) : "NaN\t");
  file << '\n';
}

}  // namespace mc::checks
