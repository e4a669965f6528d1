#include "experiments.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <stdexcept>

#include "runner/experiment.hpp"

namespace mc::experiments {
namespace {

/// The integer nearest to the d-th root of n.
std::size_t root(std::size_t n, std::size_t d) {
  return static_cast<std::size_t>(
      std::llround(std::pow(static_cast<double>(n), 1 / static_cast<double>(d))));
}

constexpr double unwritten = std::numeric_limits<double>::quiet_NaN();

/// Fills the points with NaN, so that values that are not written can be detected.
void clear(PointSet& points) {
  for (std::size_t d = 0; d < points.dims(); ++d) {
    std::fill(points.column(d).begin(), points.column(d).end(), unwritten);
  }
}

/// Writes points of task 3.`task`. Two-dimensional patterns use the first two columns.
void make_points(unsigned task, PointSet& points, Rng& rng) {
  const std::size_t n = points.size();
  switch (task) {
    case 0:
      for (std::size_t d = 0; d < points.dims(); ++d) {
        mc::uniforms(rng, points.column(d));
      }
      return;
    case 1:
      return mc::stratified_1d(points.column(0), rng);
    case 3:
      return mc::stratified_2d(points.column(0), points.column(1), {root(n, 2), root(n, 2)}, rng);
    case 4:
      return mc::stratified(points, rng);
    case 5:
      return mc::stratified_nd(points, root(n, points.dims()), rng);
    case 6:
      return mc::latin_hypercube(points, rng);
    case 7:
      return mc::multi_jittered(points.column(0), points.column(1), {root(n, 2), root(n, 2)}, rng);
    default:
      throw std::out_of_range("task: must be 0, 1, 3, 4, 5, 6 or 7");
  }
}

/// g at one point.
template <class Coordinate>
double evaluate(const Function& function, std::size_t dims, Coordinate x) {
  double g = 0;
  switch (function.kind) {
    case 1:
      for (std::size_t d = 0; d < dims; ++d) g += std::exp(x(d));
      break;
    case 2:
      for (std::size_t d = 0; d < dims; ++d) g += x(d) - 0.5;
      g = std::exp(g);
      break;
    case 3:
      for (std::size_t d = 0; d < dims; ++d) g -= x(d) * x(d);
      g = std::exp(g);
      break;
    case 4:
      g = 1;
      for (std::size_t d = 0; d < dims; ++d) g *= x(d) - 0.5;
      break;
    case 5:
      g = std::cos(1.0) * (x(0) - 0.5) + std::sin(1.0) * (x(1) - 0.5) < function.edge ? 1 : 0;
      break;
    default:
      throw std::out_of_range("kind: must be 1 to 5");
  }
  return function.a * g + function.b;
}

double mean_of(const Function& g, const PointSet& points, std::size_t used) {
  double sum = 0;
  for (std::size_t i = 0; i < used; ++i) {
    sum += evaluate(g, points.dims(), [&](std::size_t d) { return points.column(d)[i]; });
  }
  return sum / static_cast<double>(used);
}

/// Appends points to a list, column by column.
void append(std::vector<double>& all, const PointSet& points) {
  for (std::size_t d = 0; d < points.dims(); ++d) {
    const auto column = points.column(d);
    all.insert(all.end(), column.begin(), column.end());
  }
}

/// `sets` sets of points, one after another, each column by column.
template <class Fill>
std::vector<double> many(std::uint64_t n, std::uint64_t dims, std::uint64_t sets,
                         std::uint64_t seed, Fill fill) {
  Rng rng(seed);
  std::vector<double> all;
  all.reserve(n * dims * sets);
  PointSet points(n, dims);
  for (std::uint64_t set = 0; set < sets; ++set) {
    clear(points);
    fill(points, rng);
    append(all, points);
  }
  return all;
}

using Pattern2D = void(std::span<double>, std::span<double>, Grid, Rng&);

Points many_2d(Pattern2D pattern, Grid grid, std::uint64_t sets, std::uint64_t seed) {
  Rng rng(seed);
  const std::size_t n = grid.nx * grid.ny;
  Points all{std::vector<double>(n * sets, unwritten), std::vector<double>(n * sets, unwritten)};
  for (std::uint64_t set = 0; set < sets; ++set) {
    pattern(std::span(all.x).subspan(set * n, n), std::span(all.y).subspan(set * n, n), grid, rng);
  }
  return all;
}

Points one_2d(Pattern2D pattern, std::uint64_t size_x, std::uint64_t size_y, Grid grid, Rng rng) {
  Points one{std::vector<double>(size_x, unwritten), std::vector<double>(size_y, unwritten)};
  pattern(one.x, one.y, grid, rng);
  return one;
}

std::string sizes(std::size_t n, std::size_t dims) {
  return std::to_string(n) + " x " + std::to_string(dims);
}

/// Estimates with a generator and an integrand that throw if they are not called as 3.8 specifies.
/// `first_words` has the first random word of each call of the generator, including those of
/// earlier estimates: a word that occurs twice is a repeated state.
Estimate estimate_strictly(const Integrand& g, const Generator& generator, std::uint64_t n,
                           std::uint64_t replicates, Rng& rng,
                           std::set<std::uint64_t>& first_words) {
  std::uint64_t generated = 0, evaluated = 0;
  const Integrand strict_g{
      g.dims, [&](std::span<const double> x) {
        if (x.size() != g.dims) throw std::logic_error("the integrand got a point of another size");
        if (++evaluated > n * replicates) {
          throw std::logic_error("the integrand was evaluated more than once per point");
        }
        return g.f(x);
      }};
  const Generator strict = [&](PointSet& points, Rng& from) {
    if (points.size() != n || points.dims() != g.dims) {
      throw std::logic_error("the generator got a set of " + sizes(points.size(), points.dims()) +
                             ", not of " + sizes(n, g.dims) +
                             ": each replicate has its own PointSet(n, g.dims), made in one call");
    }
    if (++generated > replicates) {
      throw std::logic_error("the generator was called more than once per replicate");
    }
    Rng copy = from;  // `from` itself must not advance
    if (!first_words.insert(copy()).second) {
      throw std::logic_error(
          "the generator got an Rng that repeats: replicates need fresh points "
          "from the same generator, not from a copy");
    }
    clear(points);
    generator(points, from);
  };
  return mc::estimate_replicated(strict_g, strict, n, replicates, rng);
}

}  // namespace

std::vector<double> stratified_1d(std::uint64_t n, std::uint64_t sets, std::uint64_t seed) {
  return many(n, 1, sets, seed,
              [](PointSet& points, Rng& rng) { mc::stratified_1d(points.column(0), rng); });
}

std::vector<double> stratified_1d_constant(std::uint64_t n, std::uint64_t word) {
  std::vector<double> x(n, unwritten);
  Rng rng = Rng::constant(word);
  mc::stratified_1d(x, rng);
  return x;
}

std::vector<Grid> strata(std::vector<std::uint64_t> n) {
  std::vector<Grid> grids;
  for (const std::uint64_t cells : n) grids.push_back(mc::strata(cells));
  return grids;
}

Points stratified_2d(Grid grid, std::uint64_t sets, std::uint64_t seed) {
  return many_2d(mc::stratified_2d, grid, sets, seed);
}
Points stratified_2d_into(std::uint64_t size_x, std::uint64_t size_y, Grid grid) {
  return one_2d(mc::stratified_2d, size_x, size_y, grid, Rng(1));
}
Points stratified_2d_upper_bits(Grid grid, std::uint64_t word) {
  const std::uint64_t n = grid.nx * grid.ny;
  return one_2d(mc::stratified_2d, n, n, grid, Rng::upper_bits(word));
}

std::vector<double> shuffle(std::vector<double> x, std::uint64_t times, std::uint64_t seed) {
  return many(x.size(), 1, times, seed, [&](PointSet& points, Rng& rng) {
    const auto column = points.column(0);
    std::ranges::copy(x, column.begin());
    mc::shuffle(column, rng);
  });
}

std::vector<double> stratified(std::uint64_t n, std::uint64_t dims, std::uint64_t sets,
                               std::uint64_t seed) {
  return many(n, dims, sets, seed, mc::stratified);
}

std::vector<double> stratified_nd(std::uint64_t n, std::uint64_t dims, std::uint64_t per_axis,
                                  std::uint64_t sets, std::uint64_t seed) {
  return many(n, dims, sets, seed,
              [&](PointSet& points, Rng& rng) { mc::stratified_nd(points, per_axis, rng); });
}

std::vector<double> latin_hypercube(std::uint64_t n, std::uint64_t dims, std::uint64_t sets,
                                    std::uint64_t seed) {
  return many(n, dims, sets, seed, mc::latin_hypercube);
}

Points multi_jittered(Grid grid, std::uint64_t sets, std::uint64_t seed) {
  return many_2d(mc::multi_jittered, grid, sets, seed);
}
Points multi_jittered_into(std::uint64_t size_x, std::uint64_t size_y, Grid grid) {
  return one_2d(mc::multi_jittered, size_x, size_y, grid, Rng(1));
}

std::vector<double> estimates(unsigned task, Function g, std::uint64_t dims, std::uint64_t n,
                              std::uint64_t used, std::uint64_t sets, std::uint64_t seed) {
  Rng rng(seed);
  PointSet points(n, dims);
  std::vector<double> means;
  for (std::uint64_t set = 0; set < sets; ++set) {
    clear(points);
    make_points(task, points, rng);
    means.push_back(mean_of(g, points, used));
  }
  return means;
}

Estimate estimate_replicated(std::vector<double> values, std::uint64_t n, std::uint64_t dims,
                             std::uint64_t replicates) {
  std::size_t next = 0;
  const Generator copying = [&](PointSet& points, Rng& from) {
    from();  // as a generator of random points would
    for (std::size_t d = 0; d < points.dims(); ++d) {
      for (double& value : points.column(d)) value = values[next++ % values.size()];
    }
  };
  const auto weighted = [dims](std::span<const double> x) {
    double sum = 0;
    for (std::size_t d = 0; d < dims; ++d) sum += static_cast<double>(d + 1) * x[d];
    return sum;
  };
  Rng rng(1);
  std::set<std::uint64_t> first_words;
  return estimate_strictly({dims, weighted}, copying, n, replicates, rng, first_words);
}

std::vector<Estimate> estimates_replicated(unsigned task, Function g, std::uint64_t dims,
                                           std::uint64_t n, std::uint64_t replicates,
                                           std::uint64_t times, std::uint64_t seed) {
  Rng rng(seed);
  const Integrand integrand{dims, [&](std::span<const double> x) {
                              return evaluate(g, dims, [&](std::size_t d) { return x[d]; });
                            }};
  const Generator generator = [&](PointSet& points, Rng& from) { make_points(task, points, from); };
  std::vector<Estimate> all;
  std::set<std::uint64_t> first_words;
  for (std::uint64_t i = 0; i < times; ++i) {
    all.push_back(estimate_strictly(integrand, generator, n, replicates, rng, first_words));
  }
  return all;
}

std::vector<Estimate> irradiance_stratified(RectLight light, Grid grid, std::uint64_t replicates,
                                            std::uint64_t times, std::uint64_t seed) {
  Rng rng(seed);
  std::vector<Estimate> all;
  for (std::uint64_t i = 0; i < times; ++i) {
    all.push_back(mc::irradiance_stratified(light, grid, replicates, rng));
  }
  return all;
}

std::vector<double> shadow(unsigned task, std::uint64_t width, std::uint64_t n,
                           std::uint64_t seed) {
  // The floor is the unit square. The light is a square of the same size, 1.2 above the floor, and
  // a sphere of radius r floats between them. A point of the light is hidden if the line to it
  // passes the sphere's center at a distance below r.
  constexpr double height = 1.2, center[] = {0.5, 0.5, 0.35}, r = 0.22;
  Rng rng(seed);
  PointSet points(n, 2);
  std::vector<double> picture;
  for (std::uint64_t row = 0; row < width; ++row) {
    for (std::uint64_t column = 0; column < width; ++column) {
      const double floor_x = (static_cast<double>(column) + 0.5) / static_cast<double>(width);
      const double floor_y = (static_cast<double>(row) + 0.5) / static_cast<double>(width);
      const double cx = center[0] - floor_x, cy = center[1] - floor_y, cz = center[2];
      make_points(task, points, rng);
      double visible = 0;
      for (std::size_t i = 0; i < n; ++i) {
        const double wx = points.column(0)[i] - floor_x, wy = points.column(1)[i] - floor_y;
        const double along = cx * wx + cy * wy + cz * height;
        const double length = wx * wx + wy * wy + height * height;
        const bool hidden = cx * cx + cy * cy + cz * cz - along * along / length < r * r;
        visible += hidden ? 0 : 1;
      }
      picture.push_back(visible / static_cast<double>(n));
    }
  }
  return picture;
}

double repeat(unsigned task, std::uint64_t n, std::uint64_t dims, std::uint64_t rounds,
              std::uint64_t seed) {
  PointSet points(n, dims);
  clear(points);
  for (std::uint64_t round = 0; round < rounds; ++round) {
    Rng rng(seed + round);
    make_points(task, points, rng);
  }
  return points.column(0).empty() ? unwritten : points.column(0).back();
}

double repeat_textbook(unsigned dims, std::uint64_t n, std::uint64_t rounds) {
  if (dims != 1 && dims != 2) throw std::out_of_range("dims: must be 1 or 2");
  std::mt19937_64 engine(1);
  std::uniform_real_distribution<double> random(0.0, 1.0);
  const std::size_t nx = root(n, dims), ny = dims == 1 ? 1 : nx;
  std::vector<double> x(nx * ny), y(nx * ny);
  for (std::uint64_t round = 0; round < rounds; ++round) {
    for (std::size_t j = 0; j < ny; ++j) {
      for (std::size_t i = 0; i < nx; ++i) {
        x[j * nx + i] = (static_cast<double>(i) + random(engine)) / static_cast<double>(nx);
        if (dims == 1) continue;
        y[j * nx + i] = (static_cast<double>(j) + random(engine)) / static_cast<double>(ny);
      }
    }
  }
  return x.back() + y.back();
}

}  // namespace mc::experiments

std::span<const mc::runner::Experiment> mc::runner::experiments() {
  static constexpr Experiment all[] = {
      // On the command line a grid is nx:ny, and a function is kind:a:b:edge.
      MC_EXPERIMENT(stratified_1d, "n sets seed", "3.1  sets of stratified points, in order",
                    {.columns = "x", .sets = "sets"}),
      MC_EXPERIMENT(stratified_1d_constant, "n word",
                    "3.1  points from a generator that always returns word", {.columns = "x"}),
      MC_EXPERIMENT(strata, "n", "3.2  the grid closest to a square for each number of cells",
                    {.row_labels = "n"}),
      MC_EXPERIMENT(stratified_2d, "grid sets seed", "3.3  jittered grids of nx x ny cells",
                    {.sets = "sets"}),
      MC_EXPERIMENT(stratified_2d_into, "size_x size_y grid",
                    "3.3  a jittered grid, written to an x and a y of these sizes"),
      MC_EXPERIMENT(stratified_2d_upper_bits, "grid word",
                    "3.3  a jittered grid from words with the upper 53 bits of word"),
      MC_EXPERIMENT(shuffle, "x times seed", "3.4  x in random orders, times times",
                    {.columns = "x", .sets = "times"}),
      MC_EXPERIMENT(stratified, "n dims sets seed", "3.4  padded patterns",
                    {.dims = "dims", .sets = "sets"}),
      MC_EXPERIMENT(stratified_nd, "n dims per_axis sets seed", "3.5  grids over all dimensions",
                    {.dims = "dims", .sets = "sets"}),
      MC_EXPERIMENT(latin_hypercube, "n dims sets seed", "3.6  Latin hypercubes",
                    {.dims = "dims", .sets = "sets"}),
      MC_EXPERIMENT(multi_jittered, "grid sets seed",
                    "3.7  multi-jittered points on grids of nx x ny cells", {.sets = "sets"}),
      MC_EXPERIMENT(multi_jittered_into, "size_x size_y grid",
                    "3.7  multi-jittered points, written to an x and a y of these sizes"),
      MC_EXPERIMENT(estimates, "task g dims n used sets seed",
                    "means of g over the first `used` points of task 3.task",
                    {.columns = "mean", .index = "set"}),
      MC_EXPERIMENT(estimate_replicated, "values n dims replicates",
                    "3.8  replicated means of x0 + 2 x1 + …, over coordinates from values"),
      MC_EXPERIMENT(estimates_replicated, "task g dims n replicates times seed",
                    "3.8  replicated estimates of g with points of task 3.task"),
      MC_EXPERIMENT(irradiance_stratified, "light grid replicates times seed",
                    "3.9  estimates from a jittered grid on the light"),
      MC_EXPERIMENT(shadow, "task width n seed", "a soft shadow with points of task 3.task",
                    {.columns = "pixel", .width = "width"}),
      MC_EXPERIMENT(repeat, "task n dims rounds seed",
                    "points of task 3.task, rounds times; returns the last x (timing)"),
      MC_EXPERIMENT(repeat_textbook, "dims n rounds",
                    "jittered points by a textbook's loop with std::mt19937_64 (timing)"),
  };
  return all;
}

std::vector<mc::runner::Choice> mc::runner::choices() {
  std::vector<std::string> kinds;
  for (std::size_t kind = 1; kind < std::size(experiments::function_names); ++kind) {
    kinds.push_back(std::to_string(kind) + "  " +
                    text::filled(experiments::function_names[kind], "edge"));
  }
  return {{"g", "is a * g + b, where g is, by its kind,", kinds}};
}
