#pragma once
// What hidden cases measure, in one form: plots, the bench's page and the speed in a report read
// it. One row per line of CSV, written as soon as it is known.

#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace mc::protocol {

inline constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

struct Row {
  std::string lab = {};        ///< empty: that of the process that measured
  std::string method = {};     ///< "Sobol', scrambled"
  std::string task = {};       ///< "5.8"; in a comparison, what is compared
  std::string integrand = {};  ///< "smooth 2D"; empty: none
  std::uint64_t dimensions = 0, n = 0;
  double rmse = unknown;  ///< of the mean of n points, relative to the exact mean
  double ns = unknown;    ///< nanoseconds per point, integrand included, or per value
};

inline constexpr const char* rows_header = "lab,method,task,integrand,dimensions,n,rmse,ns";
std::string line_of(const Row& row);

/// Nothing if the line is not a complete row.
std::optional<Row> row_in(std::string_view line);
/// The complete rows of a file.
std::vector<Row> rows_in(const std::filesystem::path& file);

/// Two ways to do the same, timed in turn: rows of the same task, one without a method and one with
/// the name of the other way, several times.
struct Comparison {
  std::string task, against;
  double ns = unknown, other = unknown;                   ///< medians
  double ratio = unknown, low = unknown, high = unknown;  ///< other / ns: median and range
};
std::vector<Comparison> comparisons_in(const std::vector<Row>& rows);

}  // namespace mc::protocol
