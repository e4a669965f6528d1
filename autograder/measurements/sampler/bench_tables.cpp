// Lab 6 in the bench: what each next2() is worth, and what a number costs where samples are few.

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>

#include "6-sampler/experiments.hpp"
#include "checks/sampler/samplers.hpp"
#include "checks/support/catch.hpp"
#include "checks/support/known_scenes.hpp"
#include "measurements/sampler/point_by_point.hpp"
#include "measurements/sampler/timed.hpp"
#include "measurements/support/bench_data.hpp"

namespace mc::checks {
namespace {

constexpr std::size_t table_n = 1024, table_uses = 17;
constexpr std::array<std::size_t, 4> shown_uses{1, 8, 13, 17};  // the k of the k-th next2()
constexpr std::size_t of_sums = 12, of_products = 6;

/// Pairs of columns, one for each use; as many of them as there are.
using Pairs = std::vector<std::pair<View, View>>;

/// What is made of a point set with `table_uses` pairs, over all sets.
class Worth {
 public:
  void add(const Pairs& pairs) {
    for (std::size_t k = 0; k < shown_uses.size(); ++k) {
      if (shown_uses[k] > pairs.size()) continue;
      const auto& [x, y] = pairs[shown_uses[k] - 1];
      lamp_[k].add(mean_over(lamp, x, y) - exact(lamp));
      edge_[k].add(mean_over(edge, x, y) - exact(edge));
    }
    if (pairs.size() < of_sums) return;
    double sum = 0, products = 0;
    for (std::size_t use = 0; use < of_sums; ++use) {
      sum += mean_over(lamp, pairs[use].first, pairs[use].second) / exact(lamp);
    }
    for (std::size_t i = 0; i < table_n; ++i) {
      double product = 1;
      for (std::size_t use = 0; use < of_products; ++use) {
        const auto& [x, y] = pairs[use];
        product *= mean_over(lamp, x.subspan(i, 1), y.subspan(i, 1)) / exact(lamp);
      }
      products += product;
    }
    sum_.add(sum / of_sums - 1);
    product_.add(products / table_n - 1);
  }

  void write(const std::string& row) const {
    for (std::size_t k = 0; k < shown_uses.size(); ++k) {
      const std::string column =
          fmt::format("{}{}", shown_uses[k], shown_uses[k] == 1 ? "st" : "th");
      cell("RMSE of the k-th next2() under a lamp, N = 1024", row, column, lamp_[k]);
      cell("RMSE of the k-th next2() at an edge, N = 1024", row, column, edge_[k]);
    }
    const std::string together =
        "RMSE of many lamps, a next2() each, as a part of the value, N = 1024";
    cell(together, row, "mean of twelve", sum_);
    cell(together, row, "product of six", product_);
  }

 private:
  static void cell(const std::string& title, const std::string& row, const std::string& column,
                   const ErrorSums& errors) {
    if (errors.count == 0) return;
    bench_table({title, row, column, table_n, errors.rmse(), errors.standard_error()});
  }

  scenes::RectangleLight lamp{};
  scenes::PixelEdge edge{};
  std::array<ErrorSums, shown_uses.size()> lamp_{}, edge_{};
  ErrorSums sum_, product_;
};

/// As many sets at once as a result may carry.
constexpr std::size_t sets_at_once = 48;

std::optional<Worth> worth_of(const std::string& kind, std::size_t sets) {
  Worth worth;
  for (std::size_t done = 0; done < sets; done += sets_at_once) {
    const auto got =
        TRY_MEASURE_WITH(large, columns, kind, table_n, neighbours(1 + done, sets_at_once),
                         repeated(table_uses, {2}));
    const Values* const values =
        got ? got->if_exactly(sets_at_once * 2 * table_uses * table_n, unit) : nullptr;
    if (!values) return {};
    const SetsOfPoints points(*values, table_n, 2 * table_uses);
    for (std::size_t set = 0; set < sets_at_once; ++set) {
      Pairs pairs;
      for (std::size_t use = 0; use < table_uses; ++use) {
        pairs.emplace_back(points.column(set, 2 * use), points.column(set, 2 * use + 1));
      }
      worth.add(pairs);
    }
  }
  return worth;
}

/// The same of dimensions 0 and 1, 2 and 3, … of one Sobol' sequence; there are 16 pairs in all,
/// and what is shown ends before them.
std::optional<Worth> worth_of_one_sequence(std::size_t sets) {
  constexpr std::size_t pairs_used = 13;
  std::vector<Values> all;
  for (std::size_t use = 0; use < pairs_used; ++use) {
    const auto got = TRY_MEASURE_WITH(
        large, sobol_columns, {static_cast<unsigned>(2 * use), static_cast<unsigned>(2 * use) + 1},
        table_n, neighbours(1 + 1'000'000 * use, sets));
    const Values* const values = got ? got->if_exactly(sets * 2 * table_n, unit) : nullptr;
    if (!values) return {};
    all.push_back(*values);
  }
  Worth worth;
  for (std::size_t set = 0; set < sets; ++set) {
    Pairs pairs;
    for (const Values& values : all) {
      const SetsOfPoints points(values, table_n, 2);
      pairs.emplace_back(points.column(set, 0), points.column(set, 1));
    }
    worth.add(pairs);
  }
  return worth;
}

TEST_CASE("bench table", "[.bench-table]") {
  constexpr std::size_t sets = 5 * sets_at_once;
  for (const std::string& kind : sampler_kinds) {
    // A best candidate of 1,024 points costs as much as a thousand scrambled ones.
    const auto worth = worth_of(kind, kind == "blue_noise" ? sets_at_once : sets);
    if (worth) worth->write(kind);
  }
  if (const auto worth = worth_of_one_sequence(sets)) worth->write("sobol, one sequence");
}

/// Of exp(x + y + ...), over the mean squared error of independent samples.
class Exponential {
 public:
  explicit Exponential(std::size_t dims) : dims_(static_cast<double>(dims)) {}
  void add(const std::vector<View>& columns, std::size_t n) {
    double sum = 0;
    for (std::size_t i = 0; i < n; ++i) {
      double exponent = 0;
      for (const View x : columns) exponent += x[i];
      sum += std::exp(exponent);
    }
    const double mean = std::pow(std::expm1(1), dims_), square = std::pow(std::expm1(2) / 2, dims_);
    errors_.add(sum / static_cast<double>(n) - mean);
    scale_ = static_cast<double>(n) / (square - mean * mean);
  }
  double rmse() const { return errors_.rmse(); }
  double rmse_error() const { return errors_.standard_error(); }
  double ratio() const { return rmse() * rmse() * scale_; }
  double ratio_error() const { return 2 * rmse() * rmse_error() * scale_; }

 private:
  double dims_, scale_ = 1;
  ErrorSums errors_;
};

/// What the choice of a block costs and brings (6.3).
TEST_CASE("bench table of blocks", "[.bench-table]") {
  const std::vector<unsigned> in_order{0, 1, 2, 3, 4, 5, 6, 7}, chosen{0, 1, 4, 6, 16, 20, 15, 21};
  for (const auto& dimensions : {in_order, chosen}) {
    for (const std::size_t n : {16u, 64u, 256u, 1024u}) {
      constexpr std::size_t sets = 1000, at_once = 100;
      std::array<Exponential, 4> pairs{Exponential(2), Exponential(2), Exponential(2),
                                       Exponential(2)};
      Exponential four(4), eight(8);
      for (std::size_t set = 0; set < sets; ++set) {
        static Values values;
        if (set % at_once == 0) {
          const auto got = TRY_MEASURE(sobol_columns, dimensions, n, neighbours(1 + set, at_once));
          const Values* const all = got ? got->if_exactly(at_once * 8 * n, unit) : nullptr;
          if (!all) return;
          values = *all;
        }
        const SetsOfPoints points(values, n, 8);
        std::vector<View> columns;
        for (std::size_t d = 0; d < 8; ++d) columns.push_back(points.column(set % at_once, d));
        for (std::size_t k = 0; k < 4; ++k) pairs[k].add({columns[2 * k], columns[2 * k + 1]}, n);
        eight.add(columns, n);
        columns.resize(4);
        four.add(columns, n);
      }
      const auto by_ratio = [](const auto& a, const auto& b) { return a.ratio() < b.ratio(); };
      const auto write = [&](const std::string& what, const Exponential& of) {
        bench_table({"mean squared error of exp(x + y + ...) by that of independent samples",
                     (dimensions == chosen ? "the block, " : "dimensions 0 to 7, ") + what,
                     fmt::format("N = {}", n), n, of.ratio(), of.ratio_error()});
      };
      write("worst pair", *std::max_element(pairs.begin(), pairs.end(), by_ratio));
      write("first four", four);
      write("all eight", eight);
    }
  }
}

/// How early an integration may be stopped (6.3): the first and the second block.
TEST_CASE("bench table of early stops", "[.bench-table]") {
  for (const std::string kind : {"stratified", "halton", "sobol"}) {
    constexpr std::size_t sets = 6 * sets_at_once, first = 256, uses = 6;
    std::array<Exponential, uses> errors{Exponential(2), Exponential(2), Exponential(2),
                                         Exponential(2), Exponential(2), Exponential(2)};
    for (std::size_t done = 0; done < sets; done += sets_at_once) {
      const auto got = TRY_MEASURE(columns, kind, table_n, neighbours(1 + done, sets_at_once),
                                   repeated(uses, {2}));
      const Values* const values =
          got ? got->if_exactly(sets_at_once * 2 * uses * table_n, unit) : nullptr;
      if (!values) return;
      const SetsOfPoints points(*values, table_n, 2 * uses);
      for (std::size_t set = 0; set < sets_at_once; ++set) {
        for (std::size_t use = 0; use < uses; ++use) {
          errors[use].add({points.column(set, 2 * use), points.column(set, 2 * use + 1)}, first);
        }
      }
    }
    for (const auto& [use, name] : {std::pair{0u, "1st"}, {1u, "2nd"}, {4u, "5th"}, {5u, "6th"}}) {
      bench_table({"first 256 of 1024 samples: RMSE of exp(x + y) by the k-th next2()", kind, name,
                   first, errors[use].rmse(), errors[use].rmse_error()});
    }
  }
}

/// Cells of a square grid of N cells that a next2() leaves empty (6.3), on average.
TEST_CASE("bench table of empty cells of next2", "[.bench-table]") {
  for (const std::string kind : {"halton", "sobol"}) {
    for (const std::size_t side : {4u, 8u, 16u, 32u}) {
      constexpr std::size_t sets = 50, uses = 4;
      const std::size_t n = side * side;
      const auto got = TRY_MEASURE(columns, kind, n, neighbours(1, sets), repeated(uses, {2}));
      const Values* const values = got ? got->if_exactly(sets * 2 * uses * n, unit) : nullptr;
      if (!values) return;
      const SetsOfPoints points(*values, n, 2 * uses);
      for (std::size_t use = 0; use < uses; ++use) {
        double empty = 0;
        for (std::size_t set = 0; set < sets; ++set) {
          const View x = points.column(set, 2 * use), y = points.column(set, 2 * use + 1);
          std::vector<bool> taken(n);
          for (std::size_t i = 0; i < n; ++i) {
            const auto cell = [&](double value) {
              return static_cast<std::size_t>(value * static_cast<double>(side));
            };
            taken[cell(x[i]) * side + cell(y[i])] = true;
          }
          empty += static_cast<double>(std::count(taken.begin(), taken.end(), false)) / sets;
        }
        bench_table({"empty cells of a grid of N, by call of next2()",
                     fmt::format("{}, {}", kind, use + 1), fmt::format("N = {}", n), n, empty});
      }
    }
  }
}

/// Four dimensions by next2(), what generate() does included.
TEST_CASE("bench table of times", "[.bench-table-time]") {
  constexpr std::uint64_t dims = 4;
  for (const std::string& kind : sampler_kinds) {
    for (const std::uint64_t samples : {16u, 64u, 1024u}) {
      const auto round = seconds_once(
          [&](std::uint64_t rounds) { return seconds_of_samples(kind, dims, samples, rounds); });
      if (!round) break;
      bench_table({"ns a number, four dimensions by next2(), generate() included", kind,
                   fmt::format("N = {}", samples), samples,
                   *round * 1e9 / static_cast<double>(dims * samples)});
    }
  }
}

}  // namespace
}  // namespace mc::checks
