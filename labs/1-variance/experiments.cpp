#include "experiments.hpp"

#include <algorithm>
#include <span>
#include <stdexcept>
#include <utility>

#include "common/rng.hpp"
#include "runner/experiment.hpp"

namespace mc::experiments {

double mean(std::vector<double> x) {
  return mc::mean(x);
}
double variance_textbook(std::vector<double> x) {
  return mc::variance_textbook(x);
}
double variance_two_pass(std::vector<double> x) {
  return mc::variance_two_pass(x);
}
std::vector<double> two_pass_of_constants(std::vector<double> constants, std::uint64_t n) {
  std::vector<double> all, x(n);
  for (const double c : constants) {
    std::ranges::fill(x, c);
    all.push_back(mc::variance_two_pass(x));
  }
  return all;
}

namespace {

Moments added(std::span<const double> x) {
  Moments all;
  for (const double value : x) add(all, value);
  return all;
}

Moments merged(std::span<const double> x, const std::vector<std::uint64_t>& sizes) {
  Moments all;
  std::size_t i = 0;
  for (const std::uint64_t size : sizes) {
    Moments part;
    for (const std::size_t end = std::min<std::size_t>(x.size(), i + size); i < end; ++i) {
      add(part, x[i]);
    }
    all = mc::merge(all, part);
  }
  return all;
}

}  // namespace

Moments welford(std::vector<double> x) {
  return added(x);
}

double variance_of(Moments moments) {
  return variance(moments);
}

Moments stream(Moments moments, std::vector<double> x, std::uint64_t count) {
  if (x.empty()) throw std::invalid_argument("x: no values to add");
  std::size_t next = 0;
  for (std::uint64_t i = 0; i < count; ++i) {
    add(moments, x[next]);
    if (++next == x.size()) next = 0;
  }
  return moments;
}

Moments merge(Moments a, Moments b) {
  return mc::merge(a, b);
}

Moments merge_parts(std::vector<double> x, std::vector<std::uint64_t> sizes) {
  return merged(x, sizes);
}

double covariance(std::vector<double> x, std::vector<double> y) {
  return mc::covariance(x, y);
}

double dependence(std::vector<double> joint, std::uint64_t columns) {
  return mc::dependence(joint, columns);
}

Moments moments(std::vector<double> x) {
  return mc::moments(x);
}

namespace {

double variance_by(unsigned task, std::span<const double> x) {
  switch (task) {
    case 2:
      return mc::variance_textbook(x);
    case 3:
      return mc::variance_two_pass(x);
    case 4:
      return variance(added(x));
    case 5:
      return variance(merged(x, std::vector<std::uint64_t>(x.size() / 64 + 1, 64)));
    case 8:
      return variance(mc::moments(x));
    default:
      throw std::out_of_range("task: 2, 3, 4, 5 or 8");
  }
}

}  // namespace

std::vector<double> variances(unsigned task, std::vector<double> x, std::uint64_t size) {
  if (size == 0) throw std::invalid_argument("size: must be positive");
  std::vector<double> all;
  std::span<const double> left = x;
  for (; left.size() >= size; left = left.subspan(size)) {
    all.push_back(variance_by(task, left.first(size)));
  }
  return all;
}

double repeat(unsigned task, std::vector<double> x, std::uint64_t rounds, std::uint64_t seed) {
  if (x.empty()) throw std::invalid_argument("x: no values");
  const std::vector<double> original = x;
  Rng changes(seed);
  double sum = 0;
  for (std::uint64_t round = 0; round < rounds; ++round) {
    if (round > 0) {
      double& changed = x[changes() % x.size()];
      changed = original[changes() % x.size()];
    }
    sum += variance_by(task, x);
  }
  return sum / static_cast<double>(rounds);
}

double repeat_made(unsigned task, std::uint64_t n, std::uint64_t rounds, std::uint64_t seed) {
  std::vector<double> x(n);
  for (std::uint64_t i = 0; i < n; ++i) x[i] = 1e9 + static_cast<double>(i * 7919 % 1000) * 1e-3;
  return repeat(task, std::move(x), rounds, seed);
}

}  // namespace mc::experiments

std::span<const mc::runner::Experiment> mc::runner::experiments() {
  static constexpr Experiment all[] = {
      MC_EXPERIMENT(mean, "x", "1.1  mean of x"),
      MC_EXPERIMENT(variance_textbook, "x", "1.2  variance of x by E{X^2} - E{X}^2"),
      MC_EXPERIMENT(variance_two_pass, "x", "1.3  variance of x in two passes"),
      MC_EXPERIMENT(two_pass_of_constants, "constants n",
                    "1.3  variance of n equal values, for each constant",
                    {.row_labels = "constants"}),
      MC_EXPERIMENT(welford, "x", "1.4  moments after add() of each value of x"),
      MC_EXPERIMENT(variance_of, "moments", "1.4  variance() of given moments"),
      MC_EXPERIMENT(stream, "moments x count",
                    "1.4  moments after count calls of add(), with x repeated"),
      MC_EXPERIMENT(merge, "a b", "1.5  merge() of two moments"),
      MC_EXPERIMENT(merge_parts, "x sizes",
                    "1.5  moments of x, computed in parts of these sizes and merged"),
      MC_EXPERIMENT(covariance, "x y", "1.6  covariance of the pairs (x[i], y[i])"),
      MC_EXPERIMENT(dependence, "joint columns",
                    "1.7  dependence of a joint table of weights, stored row by row"),
      MC_EXPERIMENT(moments, "x", "1.8  moments of x in one call"),
      MC_EXPERIMENT(variances, "task x size",
                    "variance of each part of x, size values long, by task 1.task (plots)",
                    {.columns = "variance", .index = "part"}),
      MC_EXPERIMENT(repeat, "task x rounds seed",
                    "mean of rounds variances by task 1.task, while x changes (timing)"),
      MC_EXPERIMENT(repeat_made, "task n rounds seed",
                    "the same for n generated values near 1e9 (timing)"),
  };
  return all;
}

std::vector<mc::runner::Choice> mc::runner::choices() {
  return {};
}
