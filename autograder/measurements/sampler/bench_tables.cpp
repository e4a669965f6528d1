// Lab 6 in the bench: what each next2() is worth, and what a number costs where samples are few.

#include <array>
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
    const auto got = TRY_MEASURE_WITH(large, sobol_pair, static_cast<unsigned>(2 * use), table_n,
                                      neighbours(1 + 1'000'000 * use, sets));
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
