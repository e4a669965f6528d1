#pragma once
// A figure that a hidden case has measured, for bench and for the speed that a report shows. One
// row a line, its fields separated by tabs, written as soon as it is there.
//
//   kind         what, on what                         value
//   error        a point set, an integrand             root mean square error of the mean of n
// points
//   time         a point set or an algorithm           nanoseconds a point, or a value
//   integrand    an integrand                          nanoseconds a value
//   variance     an integrand                          of its value at a uniform point
//   digits       an algorithm, data                    correct decimal digits of its result
//   growth       an algorithm, "n" or "dims"           seconds a call
//   memory       an algorithm                          bytes, at their most
//   speed        a speed task ("1.8 moments")          nanoseconds a value, for check and grade
//   speed unit   a speed task                          nanoseconds of one addition of a running sum
//   speed error  a speed task, an integrand            RMSE of its points
//   table TITLE  a row of a table, a column of it      whatever the title says

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
  double error = std::numeric_limits<double>::quiet_NaN();  ///< standard error; NaN: none is known
};

std::string line_of(const Row& row);

/// Nothing for a line that is no whole row.
std::optional<Row> row_in(std::string_view line);

}  // namespace mc::protocol
