#pragma once
// Methods of making points. Each lab has one table of them (measurements/LAB/methods.hpp), which
// its plots, benchmark, tables, speed lines and demo read.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <iterator>
#include <numeric>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "checks/support/domain.hpp"
#include "checks/support/measure.hpp"
#include "checks/support/strata.hpp"
#include "common/points.hpp"

namespace mc::measurements {

using namespace checks;  // measurements are those of checks

using Number = std::optional<double>;

/// Sets of points; none where the task is not written, or failed.
using Sets = std::vector<PointSet>;

/// As many as the result of a measurement may carry, 16 MB.
inline constexpr std::uint64_t most_coordinates = 2'097'000;

struct Method {
  std::string key;   ///< its color and mark in every plot (labs/common/draw.gp)
  std::string task;  ///< "3.3"; empty: made here, to compare with
  std::string name;  ///< "jittered"
  /// `count` sets of n points, by that seed.
  std::function<Sets(std::uint64_t n, std::uint64_t dims, std::uint64_t count, std::uint64_t seed)>
      points = {};
  /// CPU seconds of making n points so many times.
  std::function<Number(std::uint64_t n, std::uint64_t dims, std::uint64_t rounds)> rounds = {};
  std::vector<std::uint64_t> dims = {2};  ///< that the bench measures
  std::uint64_t most = 65536;             ///< points
  bool power_of_root = false;             ///< only where n is the dims-th power of a whole number
  bool same_for_all_n = false;            ///< what a point costs: timed at one n only
  bool is_sequence = false;               ///< the first n of more points are the n points
  bool is_random = true;                  ///< else there is one set only
};

inline const Method& method(const std::vector<Method>& all, const std::string& key) {
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Method& one) { return one.key == key; });
  if (found == all.end()) throw std::out_of_range("no method " + key);
  return *found;
}

inline std::vector<Method> methods_of(const std::vector<Method>& all,
                                      const std::vector<std::string>& keys) {
  std::vector<Method> some;
  for (const std::string& key : keys) some.push_back(method(all, key));
  return some;
}

/// What large sizes may use: below 1 GB.
inline const sandbox::Limits large{120, 240, std::size_t{1000} << 20};

inline std::vector<std::string> keys_of(const std::vector<Method>& all) {
  std::vector<std::string> keys;
  for (const Method& one : all) keys.push_back(one.key);
  return keys;
}

template <class Measured>
Number cpu_seconds_of(const Measured& measured) {
  if (!measured) return {};
  return measured->cpu_seconds;
}

/// The lists of a result, with `count` values each, all in `range`; nothing where they are not so.
template <class T>
std::optional<T> lists_of(const std::optional<Measured<T>>& got, std::size_t count,
                          const Range& range = finite) {
  const T* const lists = got ? got->if_list_by_list({{count, range}}) : nullptr;
  return lists ? std::optional(*lists) : std::nullopt;
}

/// Of values set after set, each column by column.
inline Sets sets_of(std::span<const double> values, std::size_t n, std::size_t dims) {
  Sets sets(values.size() / (n * dims), PointSet(n, dims));
  auto from = values.begin();
  for (PointSet& set : sets) {
    for (std::size_t d = 0; d < dims; ++d, from += static_cast<std::ptrdiff_t>(n)) {
      std::copy_n(from, n, set.column(d).begin());
    }
  }
  return sets;
}

/// Of an experiment that returns them so.
inline Sets sets_of(const std::optional<Measured<std::vector<double>>>& got, std::size_t n,
                    std::size_t dims, std::size_t count) {
  const auto values = lists_of(got, n * dims * count, unit);
  return values ? sets_of(*values, n, dims) : Sets{};
}

/// Of one that returns all x and all y.
template <class Points>
Sets plane_sets_of(const std::optional<Measured<Points>>& got, std::size_t n, std::size_t count) {
  const auto points = lists_of(got, n * count, unit);
  if (!points) return {};
  Sets sets(count, PointSet(n, 2));
  for (std::size_t set = 0; set < count; ++set) {
    std::copy_n(points->x.data() + set * n, n, sets[set].column(0).begin());
    std::copy_n(points->y.data() + set * n, n, sets[set].column(1).begin());
  }
  return sets;
}

/// As many sets as asked for, in parts of as many as a result may carry.
inline Sets sets_in_parts(const Method& method, std::uint64_t n, std::uint64_t dims,
                          std::uint64_t count, std::uint64_t seed) {
  Sets all;
  const std::uint64_t most = std::max<std::uint64_t>(1, most_coordinates / (n * dims));
  while (all.size() < count) {
    Sets some = method.points(n, dims, std::min(most, count - all.size()), seed + all.size());
    if (some.empty()) return {};
    std::move(some.begin(), some.end(), std::back_inserter(all));
  }
  return all;
}

/// The whole number nearest to the d-th root of n.
inline std::uint64_t root(std::uint64_t n, std::uint64_t d) {
  return static_cast<std::uint64_t>(
      std::llround(std::pow(static_cast<double>(n), 1 / static_cast<double>(d))));
}

/// Made here, to compare with: independent points; and one in each stratum of the line, in each
/// cell of the plane, in more dimensions such patterns padded side by side, each in an order of its
/// own.
inline Method independent_points() {
  return {
      .key = "independent",
      .task = "",
      .name = "independent",
      .points = [](std::uint64_t n, std::uint64_t dims, std::uint64_t count, std::uint64_t seed) {
        Rng rng(seed);
        return sets_of(uniform_values(rng, n * dims * count, 0, 1), n, dims);
      }};
}
inline Method jittered_points() {
  return {
      .key = "jittered",
      .task = "",
      .name = "jittered",
      .points = [](std::uint64_t n, std::uint64_t dims, std::uint64_t count, std::uint64_t seed) {
        Rng rng(seed);
        Sets sets(count, PointSet(n, dims));
        std::vector<std::size_t> order(n);
        std::iota(order.begin(), order.end(), std::size_t{0});
        for (PointSet& set : sets) {
          for (std::size_t d = 0; d < dims; d += 2) {
            const Grid grid = d + 1 < dims ? squarest(n) : Grid{n, 1};
            if (dims > 2) std::shuffle(order.begin(), order.end(), rng);
            const auto along = [&](std::size_t cell, std::size_t cells) {
              return (static_cast<double>(cell) + uniform(rng)) / static_cast<double>(cells);
            };
            for (std::size_t i = 0; i < n; ++i) {
              set.column(d)[i] = along(order[i] % grid.nx, grid.nx);
              if (d + 1 < dims) set.column(d + 1)[i] = along(order[i] / grid.nx, grid.ny);
            }
          }
        }
        return sets;
      }};
}

}  // namespace mc::measurements
