#pragma once
// What the bench measures. Like the data of plots: hidden test cases, the same measurements in the
// same jail as a check. Two kinds, which ./lab bench calls by their tags:
//
//   [.bench]        rows (protocol/rows.hpp): errors and times, for the page
//   [.bench-table]  numbers of a document: small tables (BenchTable)

#include <string>

#include "measurements/support/integrands.hpp"
#include "measurements/support/speed_data.hpp"

namespace mc::measurements {

/// Nanoseconds for each of n values or points: the median of three differences. NaN: missing.
double nanoseconds_of(const Rounds& rounds, Count n);

/// A table, in Markdown, that ./lab bench --tables prints. Rows and columns are in the order of
/// their first cells.
struct BenchTable {
  std::string title;
  Count n = 0;  ///< of the next cells

  void add(const std::string& row, const std::string& column, double value,
           double error = missing) const;
  void add_rmse(const std::string& row, const std::string& column, const ErrorSums& errors) const {
    add(row, column, errors.rmse(), errors.standard_error());
  }
  void add_kurtosis(const std::string& row, const ErrorSums& errors) const {
    add(row, column_of_n(), errors.kurtosis(), errors.kurtosis_error());
  }
  std::string column_of_n() const { return "N = " + std::to_string(n); }
};

}  // namespace mc::measurements
