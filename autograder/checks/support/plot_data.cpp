#include "checks/support/plot_data.hpp"

#include <cstdlib>
#include <filesystem>
#include <stdexcept>

#include <fmt/format.h>

#include "protocol/environment.hpp"

namespace mc::checks {

std::ofstream plot_file(const std::string& name) {
  const char* directory = std::getenv(protocol::plot_data_variable);
  if (directory == nullptr) throw std::runtime_error("MC_PLOT_DATA is not set");
  std::ofstream file(std::filesystem::path(directory) / name);
  if (!file) throw std::runtime_error("cannot write " + name);
  return file;
}

void plot_row(std::ostream& file, std::span<const std::optional<double>> values) {
  for (const auto& value : values) file << (value ? fmt::format("{}\t", *value) : "NaN\t");
  file << '\n';
}

}  // namespace mc::checks
