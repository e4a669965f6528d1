#pragma once
// What a plot is drawn from. A plot's data are made by a hidden test case, TEST_CASE("plot …",
// "[.plot]"), with the same measurements in the same jail as a check; labs/N-name/plots.gp draws
// them. A task that is not written, or fails, leaves a gap.

#include <fstream>
#include <string>
#include <vector>

#include "measurements/support/integrands.hpp"
#include "measurements/support/methods.hpp"
#include "measurements/support/speed_data.hpp"

namespace mc::measurements {

/// The data file `name` of the plots that are being drawn ("points-1.tsv" is of the picture
/// "points"), with a line that names its columns.
std::ofstream plot_file(const std::string& name, const Names& columns = {});

/// One row of a data file; what is missing is NaN, which gnuplot leaves out.
void plot_row(std::ostream& file, const Values& values);

/// A picture of pixels, row by row.
void plot_image(const std::string& name, const Values& pixels, std::size_t width);

struct Axis {
  std::string name;
  Values values;
};
/// A row for each value of x: x itself, and cell(x, c) in column c.
void plot_table(const std::string& name, const Axis& x, const Names& columns,
                const std::function<double(double x, std::size_t c)>& cell);
/// The same of columns that are methods; cell(n, method).
void plot_table(const std::string& name, const Axis& x, const std::vector<Method>& methods,
                const std::function<double(Count n, const Method& method)>& cell);

/// from, from times factor, … most
Values powers(double from, double factor, double most);

/// What a plot calls each method: KEY_is = "3.3 jittered", for gnuplot.
void plot_names(const std::vector<Method>& methods);

/// The two columns x and y of the first set; and of n points by each method, in "PICTURE-KEY.tsv".
void plot_points(const std::string& name, const Sets& sets);
void plot_points(const std::string& picture, const std::vector<Method>& methods, Count n,
                 Count seed);

/// A file for each integrand, "convergence-NAME.tsv": N and, in columns named by their keys, each
/// method's RMSE over `replicates(n)` sets; and more columns, for a theory. Integrands are of the
/// same dimensions.
struct ErrorPlot {
  Names names;
  std::vector<Integrand> integrands;
  std::vector<Method> methods;
  std::vector<Count> sizes;
  std::function<Count(Count n)> replicates;
  Names more = {};
  std::function<Values(Count n)> theory = [](Count) { return Values{}; };
};
void plot_errors(const ErrorPlot& plot);

/// A file "speed-KEY.tsv": nanoseconds for one of `values`, and an error.
void plot_speed(const Method& method, Count values, const Rounds& rounds, double error);

/// The same of each method, of n points, with the RMSE on an integrand.
void plot_speed(const std::vector<Method>& methods, const Integrand& integrand, Count n,
                Count replicates);

}  // namespace mc::measurements
