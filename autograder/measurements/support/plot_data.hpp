#pragma once
// What plots and the demo are drawn from. A plot's data are made by a hidden test case,
// TEST_CASE("plot …", "[.plot]"), with the same measurements in the same jail as a check;
// labs/N-name/plots.gp draws them. A task that is not written, or fails, leaves a gap.

#include <fstream>
#include <span>
#include <string>
#include <utility>
#include <variant>
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
void plot_table(const std::string& name, const Axis& x, const Methods& methods,
                const std::function<double(Count n, const Method& method)>& cell);

/// from, from times factor, … most
Values powers(double from, double factor, double most);

/// The two columns x and y of the first set; and of n points by each method, in "PICTURE-KEY.tsv".
void plot_points(const std::string& name, const Sets& sets);
void plot_points(const std::string& picture, const Methods& methods, Count n, Count seed);

/// A file for each integrand, "convergence-NAME.tsv": N and, in columns named by their keys, each
/// method's RMSE over `replicates(n)` sets. Integrands are of the same dimensions.
void plot_errors(const Names& names, const std::vector<Integrand>& integrands,
                 const Methods& methods, const Values& sizes,
                 const std::function<Count(Count n)>& replicates);

/// A file "speed-KEY.tsv": nanoseconds for one of `values`, and an error; and for each method, of
/// n points, with the RMSE on an integrand.
void plot_speed(const std::string& key, Count values, const Rounds& rounds, double error);
void plot_speed(const Methods& methods, const Integrand& integrand, Count n, Count replicates);

// The interactive page (./lab demo): a lab's hidden cases, tagged [.demo], write records of what
// the submission makes; the page's script draws them, and computes what follows from them.

/// Numbers in [0, 1) as text: each is rounded down to `characters` of 6 bits.
std::string encoded(std::span<const double> values, std::size_t characters);

/// At the beginning of a case: from here on the page says which tasks are missing, and why.
void begin_demo();

using DemoField = std::variant<std::string, double, std::vector<double>, std::vector<std::string>>;

/// Writes demo-`lab`-KEY.json, a record of these fields and the lab. NaN becomes null.
void write_demo(int lab, const std::string& key,
                const std::vector<std::pair<std::string, DemoField>>& fields);

/// The whole case of a lab's points of the plane: of each method, sets of 1, 4, … 1,024.
void demo_points(int lab, const Methods& methods);

}  // namespace mc::measurements
