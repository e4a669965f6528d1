#pragma once
// Methods of making points. Each lab has one table of them, `methods`, and one of its speed tasks,
// `speed_tasks` (measurements/LAB/methods.hpp), which its plots, benchmark, tables, speed lines and
// demo read.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <numeric>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "checks/support/domain.hpp"
#include "checks/support/measure.hpp"
#include "checks/support/sample_sets.hpp"
#include "checks/support/strata.hpp"
#include "common/points.hpp"

namespace mc::measurements {

using namespace checks;  // measurements are those of checks

using Count = std::uint64_t;
using Names = std::vector<std::string>;

/// A number that was not measured: its task is not written, or failed.
inline constexpr double missing = std::numeric_limits<double>::quiet_NaN();

/// Sets of points; none where the task is not written, or failed.
using Sets = std::vector<PointSet>;

/// As many as the result of a measurement may carry, 16 MB.
inline constexpr Count most_coordinates = 2'097'000;

/// What large sizes may use: below 1 GB.
inline const sandbox::Limits large{120, 240, std::size_t{1000} << 20};

/// What a run of the program took.
struct Cost {
  double seconds = missing;  ///< CPU time

  Cost(double cpu_seconds) : seconds(cpu_seconds) {}
  template <class Result>
  Cost(const std::optional<Measured<Result>>& got) {
    if (got) seconds = got->cpu_seconds;
  }
};

/// Runs the program once, for so many rounds.
using Rounds = std::function<Cost(Count rounds)>;

/// `count` sets of n points, by that seed: POINTS_BY.
using MakePoints = std::function<Sets(Count n, Count dims, Count count, Count seed)>;

/// Makes n points so many times: ROUNDS_BY.
using MakeRounds =
    std::function<Cost(Count n, Count dims, Count rounds, const sandbox::Limits& limits)>;

/// What the bench and the demo need to know of a method.
struct Traits {
  std::vector<Count> dims = {};  ///< that the bench measures; none: it does not have the method
  Count most = 65536;            ///< points
  bool power_of_root = false;    ///< only where n is the dims-th power of a whole number
  bool same_for_all_n = false;   ///< what a point costs: timed at one n only
  bool is_sequence = false;      ///< the first n of more points are the n points
  bool is_random = true;         ///< else there is one set only
};
inline Traits in_bench(std::vector<Count> dims, Traits others = {}) {
  others.dims = std::move(dims);
  return others;
}

struct Method {
  std::string key;   ///< its color and mark in every plot (labs/common/draw.gp)
  std::string task;  ///< "3.3"; empty: made here, to compare with
  std::string name;  ///< "jittered"
  MakePoints points = {};
  MakeRounds rounds = {};
  Traits traits = {};
  std::string kind = {};  ///< of a sampler: what lab 6 calls it

  std::string name_with_task() const { return task.empty() ? name : task + ' ' + name; }
  Rounds rounds_of(Count n, Count dimensions, const sandbox::Limits& limits = {}) const {
    return [=, run = rounds](Count count) { return run(n, dimensions, count, limits); };
  }
};

/// A table of methods.
class Methods : public std::vector<Method> {
 public:
  using vector::vector;
  const Method& operator[](const std::string& key) const {
    const auto found =
        std::find_if(begin(), end(), [&](const Method& one) { return one.key == key; });
    if (found == end()) throw std::out_of_range("no method " + key);
    return *found;
  }
  const Method& operator[](std::nullptr_t) const = delete;  // methods[0]: front() is meant
  Methods of(const Names& keys) const {
    Methods some;
    for (const std::string& key : keys) some.push_back((*this)[key]);
    return some;
  }
  Names keys() const {
    Names all;
    for (const Method& one : *this) all.push_back(one.key);
    return all;
  }
};

/// A speed task: `rounds` makes `values` numbers or points each time, and so does `plain`, the
/// plain definition or loop. If `points` is given, the error of `n` points in the plane is reported
/// next to their time.
struct SpeedTask {
  std::string task, name;
  Count values;
  Rounds rounds;
  MakePoints points = {};
  Count n = 0;
  Rounds plain = {};
};

/// The points and the rounds of a method by an experiment, whose arguments may be n, dims, count
/// and seed, and n, dims and rounds.
#define POINTS_BY(experiment, ...) POINTS_WITH({}, experiment, __VA_ARGS__)
#define POINTS_WITH(limits, experiment, ...)                                               \
  [=]([[maybe_unused]] Count n, [[maybe_unused]] Count dims, [[maybe_unused]] Count count, \
      [[maybe_unused]] Count seed) {                                                       \
    return sets_of(TRY_MEASURE_WITH(limits, experiment, __VA_ARGS__), n, dims, count);     \
  }
#define ROUNDS_BY(experiment, ...)                                                          \
  [=]([[maybe_unused]] Count n, [[maybe_unused]] Count dims, [[maybe_unused]] Count rounds, \
      const sandbox::Limits& limits) {                                                      \
    return Cost(TRY_MEASURE_WITH(limits, experiment, __VA_ARGS__));                         \
  }

/// The lists of a result, with `count` values each, all in `range`; nothing where they are not so.
template <class T>
std::optional<T> lists_of(const std::optional<Measured<T>>& got, std::size_t count,
                          const Range& range = finite) {
  const T* const lists = got ? got->if_list_by_list({{count, range}}) : nullptr;
  return lists ? std::optional(*lists) : std::nullopt;
}

/// Of one list: no values where it is not so.
template <class T>
std::vector<T> values_of(const std::optional<Measured<std::vector<T>>>& got, std::size_t count,
                         const Range& range = finite) {
  return lists_of(got, count, range).value_or(std::vector<T>());
}

inline Sets sets_of(const SampleSets& from) {
  Sets sets;
  for (std::size_t set = 0; set < from.size(); ++set) {
    sets.emplace_back(from.points(set), from.dims);
    for (std::size_t d = 0; d < from.dims; ++d) {
      const View column = from.column(set, d);
      std::copy(column.begin(), column.end(), sets.back().column(d).begin());
    }
  }
  return sets;
}
/// Of values set after set, each column by column.
inline Sets sets_of(const Values& values, std::size_t n, std::size_t dims) {
  return sets_of(SampleSets("", values.size() / (n * dims), n, dims, values));
}
/// Of an experiment that returns them so, or one that returns all x and all y.
template <class Result>
Sets sets_of(const std::optional<Measured<Result>>& got, std::size_t n, std::size_t dims,
             std::size_t count) {
  if constexpr (requires(Result result) { result.x; }) {
    const auto points = lists_of(got, n * count, unit);
    if (!points) return {};
    return sets_of(sets_from_xy("", points->x, points->y, std::vector<Count>(count, n)));
  } else {
    return sets_of(values_of(got, n * dims * count, unit), n, dims);
  }
}

/// Calls use(set) for each of `count` sets, which are made in parts of as many as a result may
/// carry; false where there are none.
template <class Use>
bool for_each_set(const Method& method, Count n, Count dims, Count count, Count seed, Use use) {
  const Count most = std::max<Count>(1, most_coordinates / (n * dims));
  for (Count done = 0; done < count; done += most) {
    const Sets sets = method.points(n, dims, std::min(most, count - done), seed + done);
    if (sets.empty()) return false;
    for (const PointSet& set : sets) use(set);
  }
  return true;
}

inline Sets sets_in_parts(const Method& method, Count n, Count dims, Count count, Count seed) {
  Sets all;
  const bool has_all =
      for_each_set(method, n, dims, count, seed, [&](const PointSet& set) { all.push_back(set); });
  return has_all ? all : Sets{};
}

/// Cells of a grid of side x side over two dimensions that have no point.
inline double empty_cells(const PointSet& set, std::size_t side, std::size_t first = 0) {
  std::vector<bool> is_taken(side * side);
  const auto cell = [&](double x) {
    return static_cast<std::size_t>(x * static_cast<double>(side));
  };
  for (std::size_t i = 0; i < set.size(); ++i) {
    is_taken[cell(set.column(first)[i]) * side + cell(set.column(first + 1)[i])] = true;
  }
  return static_cast<double>(std::count(is_taken.begin(), is_taken.end(), false));
}

/// The whole number nearest to the d-th root of n.
inline Count root(Count n, Count d) {
  return static_cast<Count>(
      std::llround(std::pow(static_cast<double>(n), 1 / static_cast<double>(d))));
}

/// Made here, to compare with: independent points; and one in each stratum of the line, in each
/// cell of the plane, in more dimensions such patterns padded side by side, each in an order of its
/// own.
inline const Method independent_points{
    "independent", "", "independent", [](Count n, Count dims, Count count, Count seed) {
      Rng rng(seed);
      return sets_of(uniform_values(rng, n * dims * count, 0, 1), n, dims);
    }};
inline const Method jittered_points{
    "jittered", "", "jittered", [](Count n, Count dims, Count count, Count seed) {
      Rng rng(seed);
      Sets sets(count, PointSet(n, dims));
      std::vector<std::size_t> order(n);
      std::iota(order.begin(), order.end(), std::size_t{0});
      const auto along = [&](std::size_t cell, std::size_t cells) {
        return (static_cast<double>(cell) + uniform(rng)) / static_cast<double>(cells);
      };
      for (PointSet& set : sets) {
        for (std::size_t d = 0; d < dims; d += 2) {
          const Grid grid = d + 1 < dims ? squarest(n) : Grid{n, 1};
          if (dims > 2) std::shuffle(order.begin(), order.end(), rng);
          for (std::size_t i = 0; i < n; ++i) {
            set.column(d)[i] = along(order[i] % grid.nx, grid.nx);
            if (d + 1 < dims) set.column(d + 1)[i] = along(order[i] / grid.nx, grid.ny);
          }
        }
      }
      return sets;
    }};

}  // namespace mc::measurements
