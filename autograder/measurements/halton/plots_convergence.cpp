// The data of lab 5's plots: errors against N, and against time.

#include <cmath>

#include "checks/support/catch.hpp"
#include "measurements/halton/plot_integrals.hpp"
#include "measurements/halton/plot_points.hpp"
#include "measurements/halton/tails.hpp"

namespace mc::checks {
namespace {

/// An RMSE of so many is right to an eighth of itself: a third of a mark's height.
constexpr std::size_t replicates = 32;

Number error(const Points& points, const Integral& integral) {
  if (!points) return {};
  const auto n = static_cast<double>((*points)[0].size());
  return std::abs(sums_over(*points, integral).errors / n);
}

/// The root of the mean square over sets.
Number rms_error(const std::vector<Points>& sets, const Integral& integral) {
  double squares = 0;
  for (const Points& set : sets) {
    const Number one = error(set, integral);
    if (!one) return {};
    squares += *one * *one;
  }
  return std::sqrt(squares / static_cast<double>(sets.size()));
}

template <class Make>
std::vector<Points> sets_of(std::size_t count, Make make) {
  std::vector<Points> sets;
  while (sets.size() < count) sets.push_back(make());
  return sets;
}

/// One size of the plot, for all integrals: a row for each. Fewer replicates of many points.
void plot_size(std::size_t n, std::span<std::ofstream> files, Rng& rng) {
  const std::size_t sets = n > 10000 ? replicates / 4 : replicates;
  const Points halton = halton_points(n, 4), hammersley = hammersley_points(n, 4);
  const Points sobol = sobol_plot_points(n, {0, 1, 2, 3});
  const auto scrambled = scrambled_sets_of(sobol, sets, n);
  for (std::size_t i = 0; i < plot_integrals.size(); ++i) {
    const Integral& integral = plot_integrals[i];
    const auto random = sets_of(sets, [&] { return random_points(rng, n, integral.dims); });
    const auto strata = sets_of(sets, [&] { return stratified_points(rng, n, integral.dims); });
    plot_row(files[i], std::array{Number(static_cast<double>(n)), rms_error(random, integral),
                                  rms_error(strata, integral), error(halton, integral),
                                  error(hammersley, integral), error(sobol, integral),
                                  rms_error(scrambled, integral)});
  }
}

TEST_CASE("plot error against N", "[.plot]") {
  Rng rng(3);
  std::vector<std::ofstream> files;
  for (std::size_t i = 1; i <= plot_integrals.size(); ++i) {
    files.push_back(plot_file("convergence-" + std::to_string(i) + ".tsv"));
  }
  for (std::size_t n = 16; n <= 65536; n *= 4) plot_size(n, files, rng);
}

/// The same column of base 2, made random in every way of this lab; for exp(x), and for a wave of
/// frequency N.
TEST_CASE("plot error of randomised points", "[.plot]") {
  constexpr std::size_t sets = 256;
  Rng rng(4);
  auto smooth_file = plot_file("randomised-1.tsv"), wave_file = plot_file("randomised-2.tsv");
  std::vector<std::uint64_t> seeds(sets);
  std::iota(seeds.begin(), seeds.end(), std::uint64_t{1});
  for (std::size_t n = 4; n <= 4096; n *= 4) {
    const Column column = column_of(TRY_MEASURE(radical_inverses, 2, 0, n), n);
    std::vector<Points> ways(4);  // a list of all sets, each a column
    ways[0] = columns_of(uniform_values(rng, n * sets, 0, 1), n);
    if (column) {
      ways[1] = columns_of(column_of(TRY_MEASURE(random_shift, *column, 1, sets, 1), n * sets), n);
      ways[3] = columns_of(column_of(TRY_MEASURE(owen_scramble, *column, seeds), n * sets), n);
    }
    ways[2] =
        columns_of(column_of(TRY_MEASURE(radical_inverses_scrambled, 2, 0, n, seeds), n * sets), n);
    const auto row = [&](auto g) {
      std::vector<Number> numbers{static_cast<double>(n)};
      for (const Points& way : ways) {
        numbers.emplace_back();
        if (!way) continue;
        double squares = 0;
        for (const auto& set : *way) {
          double sum = 0;
          for (const double x : set) sum += g(x);
          squares += sum * sum;
        }
        numbers.back() = std::sqrt(squares / sets) / static_cast<double>(n);
      }
      return numbers;
    };
    plot_row(smooth_file, row([](double x) { return std::exp(x) - e_1; }));
    const double frequency = 2 * std::acos(-1.) * static_cast<double>(n);
    plot_row(wave_file, row([&](double x) { return std::cos(frequency * x); }));
  }
}

/// The kurtosis: what the RMSE does not tell.
TEST_CASE("plot the tails of errors", "[.plot]") {
  auto file = plot_file("tails.tsv");
  for (std::size_t n = 16; n <= 4096; n *= 4) {
    const std::size_t sets = std::min<std::size_t>(20'000, 4'000'000 / n);
    const auto errors = errors_of_exp(n, sets);
    plot_row(file, std::array{Number(static_cast<double>(n)),
                              errors ? Number(errors->kurtosis()) : Number(),
                              errors ? Number(errors->kurtosis_error()) : Number()});
  }
}

/// Nanoseconds a point of the plane, `run` making 4,096 of them so many times.
template <class Run>
Number nanoseconds(Run run) {
  const auto round = seconds_a_round(
      [&](std::uint64_t rounds) -> Number {
        const auto got = run(rounds);
        if (!got) return {};
        return got->cpu_seconds;
      },
      0.01);
  if (!round) return {};
  return *round * 1e9 / 4096;
}

TEST_CASE("plot error against time", "[.plot]") {
  auto file = plot_file("speed.tsv");
  constexpr std::size_t n = 4096;
  const Integral& plane = plot_integrals[1];
  const Points halton = halton_points(n, 2), sobol = sobol_plot_points(n, {0, 1});
  std::vector<std::uint64_t> seeds(replicates);
  std::iota(seeds.begin(), seeds.end(), std::uint64_t{1000});
  std::vector<Points> along;
  for (const unsigned base : {2u, 3u}) {
    for (auto& seed : seeds) seed += 1000;
    along.push_back(columns_of(
        column_of(TRY_MEASURE(radical_inverses_scrambled, base, 0, n, seeds), n * replicates), n));
  }
  std::vector<Points> permuted(replicates);
  for (std::size_t i = 0; i < replicates && along[0] && along[1]; ++i) {
    permuted[i] = {(*along[0])[i], (*along[1])[i]};
  }
  const auto points = [](unsigned task) {
    return nanoseconds([=](auto rounds) { return TRY_MEASURE(repeat_points, task, n, 2, rounds); });
  };
  const auto inverses_of = [](unsigned base) {
    return nanoseconds([=](auto rounds) { return TRY_MEASURE(repeat, 1, base, n, rounds, 1); });
  };
  const Number x = inverses_of(2), y = inverses_of(3);
  plot_row(file, std::array{Number(1), x && y ? Number(*x + *y) : Number{}, error(halton, plane)});
  plot_row(file, std::array{Number(2), points(3), error(halton, plane)});
  plot_row(file, std::array{Number(5), points(5), error(sobol, plane)});
  plot_row(file, std::array{Number(8), points(8),
                            rms_error(scrambled_sets_of(sobol, replicates, 7), plane)});
  plot_row(file, std::array{Number(9), points(9), rms_error(permuted, plane)});
}

}  // namespace
}  // namespace mc::checks
