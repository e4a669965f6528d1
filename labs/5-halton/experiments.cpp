#include "experiments.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <stdexcept>

#include "common/rng.hpp"
#include "common/todo.hpp"
#include "runner/experiment.hpp"

// These are null if the submission does not define 5.10, which older submissions lack.
namespace mc {
[[gnu::weak]] void lattice(PointSet&, std::uint64_t);
[[gnu::weak]] void tent(std::span<double>);
}  // namespace mc

namespace mc::experiments {
namespace {

/// The initial value of everything that a submission must write.
constexpr double unwritten = std::numeric_limits<double>::quiet_NaN();

PointSet unwritten_points(std::uint64_t n, std::uint64_t dims) {
  PointSet points(n, dims);
  for (std::size_t d = 0; d < dims; ++d) std::ranges::fill(points.column(d), unwritten);
  return points;
}

std::vector<double> columns_of(const PointSet& points) {
  std::vector<double> all;
  for (std::size_t d = 0; d < points.dims(); ++d) {
    const auto column = points.column(d);
    all.insert(all.end(), column.begin(), column.end());
  }
  return all;
}

void make_lattice(PointSet& points, std::uint64_t seed) {
  if (mc::lattice == nullptr) throw todo("5.10");
  mc::lattice(points, seed);
}

void apply_tent(std::span<double> column) {
  if (mc::tent == nullptr) throw todo("5.10");
  mc::tent(column);
}

/// Writes points first, first + 1, … for repeat_points().
void make_points(unsigned task, PointSet& points, std::uint64_t first, std::uint64_t seed) {
  if (task == 3) return mc::halton(points, first);
  if (task == 10) {
    make_lattice(points, seed);
    for (std::size_t d = 0; d < points.dims(); ++d) apply_tent(points.column(d));
    return;
  }
  const auto bases = task == 9 ? mc::primes(points.dims()) : std::vector<unsigned>{};
  for (std::size_t d = points.dims(); d-- > 0;) {
    const auto column = points.column(d);
    if (task == 9) {
      mc::radical_inverses_scrambled(bases[d], first, column, seed + d);
    } else {
      mc::sobol(static_cast<unsigned>(d), first, column);
      if (task == 8) mc::owen_scramble(column, seed + d);
    }
  }
}

}  // namespace

std::vector<double> radical_inverse(unsigned base, std::vector<std::uint64_t> indices) {
  std::vector<double> values;
  for (const std::uint64_t index : indices) values.push_back(mc::radical_inverse(base, index));
  return values;
}

std::vector<double> radical_inverses(unsigned base, std::uint64_t first, std::uint64_t count) {
  std::vector<double> column(count, unwritten);
  mc::radical_inverses(base, first, column);
  return column;
}

std::vector<unsigned> primes(std::uint64_t count) {
  return mc::primes(count);
}

std::vector<double> halton(std::uint64_t n, std::uint64_t dims, std::uint64_t first) {
  PointSet points = unwritten_points(n, dims);
  mc::halton(points, first);
  return columns_of(points);
}

std::vector<double> hammersley(std::uint64_t n, std::uint64_t dims) {
  PointSet points = unwritten_points(n, dims);
  mc::hammersley(points);
  return columns_of(points);
}

std::vector<double> sobol(unsigned dimension, std::uint64_t first, std::uint64_t count) {
  std::vector<double> column(count, unwritten);
  mc::sobol(dimension, first, column);
  return column;
}

double star_discrepancy_1d(std::vector<double> x) {
  return mc::star_discrepancy(x);
}

double star_discrepancy_2d(std::vector<double> x, std::vector<double> y) {
  return mc::star_discrepancy(x, y);
}

std::vector<double> random_shift(std::vector<double> points, std::uint64_t dims,
                                 std::uint64_t times, std::uint64_t seed) {
  const std::size_t n = dims == 0 ? 0 : points.size() / dims;
  Rng rng(seed);
  std::vector<double> all;
  for (std::uint64_t time = 0; time < times; ++time) {
    PointSet set(n, dims);
    for (std::size_t d = 0; d < dims; ++d) {
      std::copy_n(points.begin() + static_cast<std::ptrdiff_t>(d * n), n, set.column(d).begin());
    }
    mc::random_shift(set, rng);
    const auto shifted = columns_of(set);
    all.insert(all.end(), shifted.begin(), shifted.end());
  }
  return all;
}

std::vector<double> owen_scramble(std::vector<double> x, std::vector<std::uint64_t> seeds) {
  std::vector<double> all;
  for (const std::uint64_t seed : seeds) {
    std::vector<double> column = x;
    mc::owen_scramble(column, seed);
    all.insert(all.end(), column.begin(), column.end());
  }
  return all;
}

std::vector<double> radical_inverses_scrambled(unsigned base, std::uint64_t first,
                                               std::uint64_t count,
                                               std::vector<std::uint64_t> seeds) {
  std::vector<double> all;
  for (const std::uint64_t seed : seeds) {
    std::vector<double> column(count, unwritten);
    mc::radical_inverses_scrambled(base, first, column, seed);
    all.insert(all.end(), column.begin(), column.end());
  }
  return all;
}

std::vector<double> scrambled_one_by_one(unsigned base, std::vector<std::uint64_t> indices,
                                         std::vector<std::uint64_t> seeds) {
  std::vector<double> values;
  for (const std::uint64_t seed : seeds) {
    for (const std::uint64_t index : indices) {
      double value = unwritten;
      mc::radical_inverses_scrambled(base, index, std::span(&value, 1), seed);
      values.push_back(value);
    }
  }
  return values;
}

std::vector<double> lattice(std::uint64_t n, std::uint64_t dims, std::vector<std::uint64_t> seeds) {
  std::vector<double> all;
  for (const std::uint64_t seed : seeds) {
    PointSet points = unwritten_points(n, dims);
    make_lattice(points, seed);
    const auto one = columns_of(points);
    all.insert(all.end(), one.begin(), one.end());
  }
  return all;
}

std::vector<double> tent(std::vector<double> x) {
  apply_tent(x);
  return x;
}

double repeat(unsigned task, unsigned base_or_dimension, std::uint64_t n, std::uint64_t rounds,
              std::uint64_t seed) {
  std::vector<double> column(n, unwritten);
  for (std::uint64_t round = 0; round < rounds; ++round) {
    const std::uint64_t round_seed = seed + round, first = 4096 * (round_seed % 4096);
    switch (task) {
      case 1:
        for (std::uint64_t i = 0; i < n; ++i) column[i] = mc::radical_inverse(base_or_dimension, i);
        break;
      case 2:
        mc::radical_inverses(base_or_dimension, first, column);
        break;
      case 5:
        mc::sobol(base_or_dimension, first, column);
        break;
      case 8:
        mc::sobol(base_or_dimension, first, column);
        mc::owen_scramble(column, round_seed);
        break;
      case 9:
        mc::radical_inverses_scrambled(base_or_dimension, first, column, round_seed);
        break;
      default:
        throw std::out_of_range("task: must be 1, 2, 5, 8 or 9");
    }
  }
  return column.empty() ? unwritten : column.back();
}

double repeat_plain(unsigned task, std::uint64_t n, std::uint64_t rounds) {
  std::vector<double> column(n, unwritten);
  std::array<std::uint32_t, 32> directions{};  // of dimension 1
  std::uint32_t m = 1;
  for (unsigned k = 0; k < 32; ++k, m ^= m << 1) directions[k] = m << (31 - k);
  for (std::uint64_t round = 0; round < rounds; ++round) {
    for (std::uint64_t i = 0; i < n; ++i) {
      std::uint32_t bits = 0;
      for (std::uint64_t index = 4096 * (round % 4096) + i, k = 0; index != 0; index >>= 1, ++k) {
        if (index % 2 == 1) bits ^= directions[k];
      }
      std::uint64_t word = std::uint64_t{bits} << 32, flips = 0;
      for (unsigned k = 0; task == 8 && k < 53; ++k) {
        const std::uint64_t before = k == 0 ? 0 : word >> (64 - k);
        flips |= mix_bits(mix_bits(round ^ before) + k) >> 63 << (63 - k);
      }
      column[i] = static_cast<double>((word ^ flips) >> 11) * 0x1p-53;
    }
  }
  return column.empty() ? unwritten : column.back();
}

double repeat_points(unsigned task, std::uint64_t n, std::uint64_t dims, std::uint64_t rounds) {
  if (task != 3 && task != 5 && task != 8 && task != 9 && task != 10)
    throw std::out_of_range("task: must be 3, 5, 8, 9 or 10");
  if (dims == 0 || dims > 4096) throw std::out_of_range("dims: must be 1 to 4096");
  const std::uint64_t block =
      std::min<std::uint64_t>(n, std::max<std::uint64_t>(1024, std::bit_floor(4096 / dims)));
  PointSet points(block, dims), rest(n % block, dims);
  for (std::uint64_t round = 0; round < rounds; ++round) {
    const std::uint64_t seed = round * dims;
    std::uint64_t first = 0;
    for (; first + block <= n; first += block) make_points(task, points, first, seed);
    if (rest.size() > 0) make_points(task, rest, first, seed);
  }
  return points.column(0)[block - 1];
}

}  // namespace mc::experiments

std::span<const mc::runner::Experiment> mc::runner::experiments() {
  static constexpr Experiment all[] = {
      MC_EXPERIMENT(radical_inverse, "base indices", "5.1  radical inverses of indices",
                    {.columns = "x", .index = "index", .row_labels = "indices"}),
      MC_EXPERIMENT(radical_inverses, "base first count",
                    "5.2  radical inverses of first, first + 1, ...",
                    {.columns = "x", .index = "index", .from = "first"}),
      MC_EXPERIMENT(primes, "count", "5.3  the first primes", {.columns = "prime", .index = "d"}),
      MC_EXPERIMENT(halton, "n dims first", "5.3  Halton points first, first + 1, ...",
                    {.dims = "dims", .index = "index", .from = "first"}),
      MC_EXPERIMENT(hammersley, "n dims", "5.4  n Hammersley points",
                    {.dims = "dims", .index = "index"}),
      MC_EXPERIMENT(sobol, "dimension first count",
                    "5.5  one coordinate of Sobol' points first, first + 1, ...",
                    {.columns = "x", .index = "index", .from = "first"}),
      MC_EXPERIMENT(star_discrepancy_1d, "x", "5.6  star discrepancy of points on the line"),
      MC_EXPERIMENT(star_discrepancy_2d, "x y", "5.6  star discrepancy of points in the plane"),
      MC_EXPERIMENT(random_shift, "points dims times seed",
                    "5.7  random shifts of the given points (column by column)",
                    {.dims = "dims", .sets = "times"}),
      MC_EXPERIMENT(owen_scramble, "x seeds", "5.8  the column x scrambled with each seed",
                    {.columns = "scrambled", .sets = "seeds", .row_labels = "x"}),
      MC_EXPERIMENT(radical_inverses_scrambled, "base first count seeds",
                    "5.9  scrambled radical inverses of first, first + 1, ..., per seed",
                    {.columns = "x", .sets = "seeds", .index = "index", .from = "first"}),
      MC_EXPERIMENT(scrambled_one_by_one, "base indices seeds",
                    "5.9  scrambled radical inverses of indices, each in its own column",
                    {.columns = "x", .sets = "seeds", .row_labels = "indices"}),
      MC_EXPERIMENT(lattice, "n dims seeds", "5.10  a lattice of n points, shifted with each seed",
                    {.dims = "dims", .sets = "seeds", .index = "index"}),
      MC_EXPERIMENT(tent, "x", "5.10  the tent transform of x",
                    {.columns = "folded", .row_labels = "x"}),
      MC_EXPERIMENT(repeat, "task base_or_dimension n rounds seed",
                    "a column of task 5.task, rounds times; returns the last x (timing)"),
      MC_EXPERIMENT(
          repeat_plain, "task n rounds",
          "coordinates of Sobol' dimension 1, bit by bit; with task 8 scrambled (timing)"),
      MC_EXPERIMENT(repeat_points, "task n dims rounds",
                    "points of task 5.task, rounds times (timing)"),
  };
  return all;
}

std::vector<mc::runner::Choice> mc::runner::choices() {
  return {};
}
