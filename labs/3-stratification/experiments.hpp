#pragma once
// What lab 3 measures of a submission. Where an experiment makes several sets of points, they are
// made in turn with one generator, and returned one after the other. Whatever is to
// be written holds NaN before.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "runner/text.hpp"
#include "runner/wire.hpp"
#include "stratification.hpp"

namespace mc {
MC_FIELDS(Grid, nx, ny)
}  // namespace mc

namespace mc::experiments {

/// Points of the plane.
struct Points {
  std::vector<double> x, y;
};
MC_FIELDS(Points, x, y)

/// a g + b, to be integrated over the unit cube of any number of dimensions (5: of two), g the one
/// of these names; {} is the edge.
struct Function {
  unsigned kind = 1;
  double a = 1, b = 0, edge = 0.1;
};
MC_FIELDS(Function, kind, a, b, edge)

inline constexpr std::string_view function_names[] = {
    "",
    "(exp(x) + exp(y) + ...)",        // a sum of functions of one coordinate each
    "exp(x - 1/2) exp(y - 1/2) ...",  // a product of them
    "exp(-x^2 - y^2 - ...)",          // another
    "(x - 1/2) (y - 1/2) ...",        // nothing but interaction
    "(1 if cos(1) (x - 1/2) + sin(1) (y - 1/2) < {}, else 0)"};

/// As a formula: "2 * exp(-x^2 - y^2 - ...) + 1".
inline std::string spelled(const Function& function) {
  std::string all = text::filled(function_names[function.kind < 6 ? function.kind : 0],
                                 text::print(function.edge));
  if (function.a != 1) all = text::print(function.a) + " * " + all;
  if (function.b < 0) return all + " - " + text::print(-function.b);
  return function.b == 0 ? all : all + " + " + text::print(function.b);
}

/// 3.1: `sets` sets of n points.
std::vector<double> stratified_1d(std::uint64_t n, std::uint64_t sets, std::uint64_t seed);

/// 3.2: of each n.
std::vector<Grid> strata(std::vector<std::uint64_t> n);

/// 3.3, 3.7: `sets` sets of nx ny points; and one set, for x and y of given sizes.
Points stratified_2d(Grid grid, std::uint64_t sets, std::uint64_t seed);
Points stratified_2d_into(std::uint64_t size_x, std::uint64_t size_y, Grid grid);
Points multi_jittered(Grid grid, std::uint64_t sets, std::uint64_t seed);
Points multi_jittered_into(std::uint64_t size_x, std::uint64_t size_y, Grid grid);

/// 3.1, 3.3: one set, from a generator that returns `word` for ever; or whose words all have its
/// upper 53 bits.
std::vector<double> stratified_1d_constant(std::uint64_t n, std::uint64_t word);
Points stratified_2d_upper_bits(Grid grid, std::uint64_t word);

/// 3.4: x, shuffled `times` times, each time from the given order.
std::vector<double> shuffle(std::vector<double> x, std::uint64_t times, std::uint64_t seed);

/// 3.4, 3.5, 3.6: `sets` sets of n points, each of them column by column.
std::vector<double> stratified(std::uint64_t n, std::uint64_t dims, std::uint64_t sets,
                               std::uint64_t seed);
std::vector<double> stratified_nd(std::uint64_t n, std::uint64_t dims, std::uint64_t per_axis,
                                  std::uint64_t sets, std::uint64_t seed);
std::vector<double> latin_hypercube(std::uint64_t n, std::uint64_t dims, std::uint64_t sets,
                                    std::uint64_t seed);

/// The mean of `g` over the first `used` of n points in `dims` dimensions, for each of `sets` sets.
/// Points of task 3.`task`: 1, 3, 4, 5, 6 or 7, where n must be a square for 3 and 7, and the power
/// dims of a whole number for 5; independent points for 0.
std::vector<double> estimates(unsigned task, Function g, std::uint64_t dims, std::uint64_t n,
                              std::uint64_t used, std::uint64_t sets, std::uint64_t seed);

/// 3.8: what came of it, and what was asked for on the way.
struct Replicated {
  double value = 0, standard_error = 0;
  std::uint64_t n = 0;
  std::uint64_t generated = 0, evaluated = 0;  ///< calls of the generator and of the integrand
  std::uint64_t misshapen = 0;  ///< of them with sets that are not n x dims, points of other dims
  std::uint64_t repeated = 0;   ///< calls of the generator with random numbers that it had before
};
MC_FIELDS(Replicated, value, standard_error, n, generated, evaluated, misshapen, repeated)

/// Estimates, one after the other, and the points that they were computed from, set by set, each
/// column by column: as many as expected, cut or filled up with zeros.
struct ReplicatedTraces {
  std::vector<Replicated> estimates;
  std::vector<double> points;
};
MC_FIELDS(ReplicatedTraces, estimates, points)

/// 3.8: of x0 + 2 x1 + 3 x2 + …, with a generator that deals out `values` in turn, over and over,
/// column by column.
Replicated estimate_replicated(std::vector<double> values, std::uint64_t n, std::uint64_t dims,
                               std::uint64_t replicates);

/// 3.8: `times` times of `g` over n points of task 3.`task`, as in estimates().
ReplicatedTraces estimates_replicated(unsigned task, Function g, std::uint64_t dims,
                                      std::uint64_t n, std::uint64_t replicates,
                                      std::uint64_t times, std::uint64_t seed);

/// A picture of width x width pixels, row by row: the soft shadow of a ball under a square light,
/// each pixel the mean of n points on the light, as in estimates().
std::vector<double> shadow(unsigned task, std::uint64_t width, std::uint64_t n, std::uint64_t seed);

/// For timing: n points of `dims` dimensions as in estimates(), `rounds` times, round r with a
/// generator of seed `seed` + r. The last x.
double repeat(unsigned task, std::uint64_t n, std::uint64_t dims, std::uint64_t rounds,
              std::uint64_t seed);

/// For timing: the same points, jittered in 1 or 2 dimensions by the loop of a textbook, with
/// std::mt19937_64 and std::uniform_real_distribution.
double repeat_textbook(unsigned dims, std::uint64_t n, std::uint64_t rounds);

}  // namespace mc::experiments
