#pragma once
// What the bench measures. Like the data of plots: hidden test cases, the same measurements in the
// same jail as a check. Five kinds, which ./lab bench calls for by their tags:
//
//   [.bench-error]   once: what chance does to a result
//   [.bench-time]    several times, in turn with the other submissions: what a computer makes of it
//   [.bench-growth]  once: large N and many dimensions
//   [.bench-table]   once: numbers that belong in a separate small table (BenchTable)
//   [.bench-table-time]  the same of times: several times, in turn with the other submissions
//
// Each number is a row that is written as soon as it is there (protocol/rows.hpp). A missing number
// has no row.

#include <string>

#include "measurements/support/integrands.hpp"
#include "measurements/support/methods.hpp"
#include "measurements/support/speed_data.hpp"

namespace mc::measurements {

/// A row of kind error, relative to `exact`; and of kind time, of n values or points: false where
/// it is missing.
void bench_error(const std::string& what, const std::string& on, Count dims, Count n,
                 const ErrorSums& errors, double exact);
bool bench_time(const std::string& what, const std::string& on, Count dims, Count n,
                const Rounds& rounds);

/// Rows of kind growth and memory: the CPU time and the peak memory of n points or values, for n =
/// `least`, 10 `least`, … `most` (or another factor).
void bench_growth(const Method& method, Count dims, Count most, Count least = 1000,
                  Count factor = 10);

/// Rows of kind growth over 1, 2, 4, … 32 dimensions, 4,096 points each.
void bench_growth_of_dims(const Method& method);

/// A table that ./lab bench prints as soon as it has a cell. Columns are in the order of n, then in
/// that of their first row.
struct BenchTable {
  std::string title;
  Count n = 0;  ///< of the next cells

  void add(const std::string& row, const std::string& column, double value,
           double error = missing) const {
    bench_row({"table " + title, row, column, 0, n, value, error});
  }
  void add_mean(const std::string& row, const std::string& column, const ErrorSums& values) const {
    add(row, column, values.moment(1), values.moment_error(1));
  }
  void add_rmse(const std::string& row, const std::string& column, const ErrorSums& errors) const {
    add(row, column, errors.rmse(), errors.standard_error());
  }
  void add_kurtosis(const std::string& row, const ErrorSums& errors) const {
    add(row, column_of_n(), errors.kurtosis(), errors.kurtosis_error());
  }
  /// An RMSE relative to that of these errors.
  void add_ratio(const std::string& row, double rmse, const ErrorSums& errors) const {
    const double ratio = rmse / errors.rmse();
    add(row, "ratio", ratio, ratio * errors.standard_error() / errors.rmse());
  }
  std::string column_of_n() const { return "N = " + std::to_string(n); }
};

}  // namespace mc::measurements
