#pragma once
// The experiments of lab 3: what is run and measured in a submission. An experiment that makes
// several sets of points makes them with one generator and returns them one after another. Every
// value that the submission must write is NaN before the call.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "runner/text.hpp"
#include "runner/wire.hpp"
#include "stratification.hpp"

namespace mc {
MC_FIELDS(Grid, nx, ny)
MC_FIELDS(Estimate, value, standard_error, n)
MC_FIELDS(RectLight, x0, x1, y0, y1, height, radiance)
}  // namespace mc

namespace mc::experiments {

/// Points in the plane.
struct Points {
  std::vector<double> x, y;
};
MC_FIELDS(Points, x, y)

/// The integrand a g + b on the unit cube, where `kind` is the index of g in function_names. Kind 5
/// has two dimensions; the others have any number.
struct Function {
  unsigned kind = 1;
  double a = 1, b = 0, edge = 0.1;
};
MC_FIELDS(Function, kind, a, b, edge)

/// The formulas of g; {} is the edge.
inline constexpr std::string_view function_names[] = {
    "",
    "(exp(x) + exp(y) + ...)",        // a sum of functions of one coordinate
    "exp(x - 1/2) exp(y - 1/2) ...",  // a product of functions of one coordinate
    "exp(-x^2 - y^2 - ...)",          // a Gaussian, at its maximum in the corner
    "(x - 1/2) (y - 1/2) ...",        // only interaction: every projection is zero
    "(1 if cos(1) (x - 1/2) + sin(1) (y - 1/2) < {}, else 0)"};

/// The formula of an integrand, such as "2 * exp(-x^2 - y^2 - ...) + 1".
inline std::string spelled(const Function& function) {
  std::string all = text::filled(function_names[function.kind < 6 ? function.kind : 0],
                                 text::print(function.edge));
  if (function.a != 1) all = text::print(function.a) + " * " + all;
  if (function.b < 0) return all + " - " + text::print(-function.b);
  return function.b == 0 ? all : all + " + " + text::print(function.b);
}

/// 3.1: `sets` sets of n points on the line.
std::vector<double> stratified_1d(std::uint64_t n, std::uint64_t sets, std::uint64_t seed);

/// 3.2: the grid of each number of cells.
std::vector<Grid> strata(std::vector<std::uint64_t> n);

/// 3.3, 3.7: `sets` sets of nx ny points; and one set, written to an x and a y of the given sizes.
Points stratified_2d(Grid grid, std::uint64_t sets, std::uint64_t seed);
Points stratified_2d_into(std::uint64_t size_x, std::uint64_t size_y, Grid grid);
Points multi_jittered(Grid grid, std::uint64_t sets, std::uint64_t seed);
Points multi_jittered_into(std::uint64_t size_x, std::uint64_t size_y, Grid grid);

/// 3.1, 3.3: one set from a generator that always returns `word` (Rng::constant), and one from a
/// generator whose words all have the upper 53 bits of `word` (Rng::upper_bits).
std::vector<double> stratified_1d_constant(std::uint64_t n, std::uint64_t word);
Points stratified_2d_upper_bits(Grid grid, std::uint64_t word);

/// 3.4: `times` shuffles of x, each of which starts from the given order.
std::vector<double> shuffle(std::vector<double> x, std::uint64_t times, std::uint64_t seed);

/// 3.4, 3.5, 3.6: `sets` sets of n points in `dims` dimensions, each column by column.
std::vector<double> stratified(std::uint64_t n, std::uint64_t dims, std::uint64_t sets,
                               std::uint64_t seed);
std::vector<double> stratified_nd(std::uint64_t n, std::uint64_t dims, std::uint64_t per_axis,
                                  std::uint64_t sets, std::uint64_t seed);
std::vector<double> latin_hypercube(std::uint64_t n, std::uint64_t dims, std::uint64_t sets,
                                    std::uint64_t seed);

/// For each of `sets` sets of n points in `dims` dimensions, the mean of `g` over the first `used`
/// points. The points are those of task 3.`task` (1, 3, 4, 5, 6 or 7), or independent for task 0.
/// For tasks 3 and 7, n must be a square; for task 5, the dims-th power of an integer.
std::vector<double> estimates(unsigned task, Function g, std::uint64_t dims, std::uint64_t n,
                              std::uint64_t used, std::uint64_t sets, std::uint64_t seed);

/// 3.8: the estimate of x0 + 2 x1 + 3 x2 + …, with a generator that copies `values` to the points
/// in order, column by column, and starts again at the end of `values`. Here and in
/// estimates_replicated(), the generator throws if it is called with a set of another size than
/// n x dims, more than `replicates` times, or with an Rng in a state that it has seen before; the
/// integrand throws if it gets a point of another size or is called for more than n * replicates
/// points.
Estimate estimate_replicated(std::vector<double> values, std::uint64_t n, std::uint64_t dims,
                             std::uint64_t replicates);

/// 3.8: `times` estimates of `g` over n points of task 3.`task`, numbered as in estimates().
std::vector<Estimate> estimates_replicated(unsigned task, Function g, std::uint64_t dims,
                                           std::uint64_t n, std::uint64_t replicates,
                                           std::uint64_t times, std::uint64_t seed);

/// 3.9: `times` estimates of the irradiance from a light.
std::vector<Estimate> irradiance_stratified(RectLight light, Grid grid, std::uint64_t replicates,
                                            std::uint64_t times, std::uint64_t seed);

/// A picture of width x width pixels, row by row: the soft shadow of a sphere under a square light.
/// Each pixel is the fraction of n points on the light that are visible, with the tasks of
/// estimates().
std::vector<double> shadow(unsigned task, std::uint64_t width, std::uint64_t n, std::uint64_t seed);

/// For timing: makes n points in `dims` dimensions `rounds` times, with the tasks of estimates().
/// Round r uses a generator with the seed `seed` + r. Returns the last x.
double repeat(unsigned task, std::uint64_t n, std::uint64_t dims, std::uint64_t rounds,
              std::uint64_t seed);

/// For timing: the same in 1 or 2 dimensions by a textbook's loop, with std::mt19937_64 and
/// std::uniform_real_distribution.
double repeat_textbook(unsigned dims, std::uint64_t n, std::uint64_t rounds);

}  // namespace mc::experiments
