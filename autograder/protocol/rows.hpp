#pragma once
// A number measured by a hidden case, for bench and for the speed in a report. One row per line,
// fields separated by tabs, written as soon as it is known.
//
//   kind         what, on what                    value
//   error        a point set, an integrand        root mean square error of the mean of n points
//   time         a point set or an algorithm      nanoseconds per point or value
//   integrand    an integrand                     nanoseconds per value
//   variance     an integrand                     variance of its value at a uniform point
//   digits       an algorithm, data               correct decimal digits of its result
//   growth       an algorithm, "n" or "dims"      seconds per call
//   memory       an algorithm                     peak memory in bytes
//   speed        a speed task ("1.8 moments")     nanoseconds per value, for check and grade
//   speed unit   a speed task                     nanoseconds per addition of a running sum
//   speed error  a speed task, an integrand       RMSE of its points
//   table TITLE  a row of a table, its column     as the title says

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

namespace mc::protocol {

struct Row {
  std::string kind, what, on = "";
  std::uint64_t dims = 0, n = 0;
  double value = 0;
  double error = std::numeric_limits<double>::quiet_NaN();  ///< standard error; NaN: not known
};

std::string line_of(const Row& row);

/// Nothing if the line is not a complete row.
std::optional<Row> row_in(std::string_view line);

}  // namespace mc::protocol
