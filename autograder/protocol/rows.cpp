#include "protocol/rows.hpp"

#include <cstdio>
#include <stdexcept>

#include "runner/text.hpp"

namespace mc::protocol {

std::string line_of(const Row& row) {
  char numbers[128];
  std::snprintf(numbers, sizeof numbers, "%llu\t%llu\t%.17g\t%.17g",
                static_cast<unsigned long long>(row.dims), static_cast<unsigned long long>(row.n),
                row.value, row.error);
  return row.kind + '\t' + row.what + '\t' + row.on + '\t' + numbers;
}

std::optional<Row> row_in(std::string_view line) {
  const auto fields = text::split(line, '\t');
  if (fields.size() != 7) return {};
  Row row{std::string(fields[0]), std::string(fields[1]), std::string(fields[2])};
  try {
    text::parse(fields[3], row.dims);
    text::parse(fields[4], row.n);
    text::parse(fields[5], row.value);
    text::parse(fields[6], row.error);
  } catch (const std::invalid_argument&) {
    return {};
  }
  return row;
}

}  // namespace mc::protocol
