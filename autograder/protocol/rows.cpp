#include "protocol/rows.hpp"

#include <array>
#include <cstdio>
#include <cstdlib>

namespace mc::protocol {

std::string line_of(const Row& row) {
  char numbers[128];
  std::snprintf(numbers, sizeof numbers, "%llu\t%llu\t%.17g\t%.17g",
                static_cast<unsigned long long>(row.dims), static_cast<unsigned long long>(row.n),
                row.value, row.error);
  return row.kind + '\t' + row.what + '\t' + row.on + '\t' + numbers;
}

std::optional<Row> row_in(std::string_view line) {
  std::array<std::string, 7> fields;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const auto tab = line.find('\t');
    if ((tab == std::string_view::npos) != (i + 1 == fields.size())) return {};
    fields[i] = line.substr(0, tab);
    line.remove_prefix(tab == std::string_view::npos ? line.size() : tab + 1);
  }
  return Row{fields[0],
             fields[1],
             fields[2],
             std::strtoull(fields[3].c_str(), nullptr, 10),
             std::strtoull(fields[4].c_str(), nullptr, 10),
             std::strtod(fields[5].c_str(), nullptr),
             std::strtod(fields[6].c_str(), nullptr)};
}

}  // namespace mc::protocol
