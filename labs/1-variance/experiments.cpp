#include "experiments.hpp"

#include <algorithm>
#include <stdexcept>

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

namespace {

Moments added(const std::vector<double>& x) {
  Moments all;
  for (const double value : x) add(all, value);
  return all;
}

Moments merged(const std::vector<double>& x, const std::vector<std::uint64_t>& sizes) {
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

Moments stream(std::uint64_t count, double offset) {
  const double pattern[] = {offset + 4, offset + 7, offset + 13, offset + 16};
  Moments all;
  for (std::uint64_t i = 0; i < count; ++i) add(all, pattern[i % 4]);
  return all;
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

double repeat_over(const std::vector<double>& x, unsigned task, std::uint64_t rounds) {
  double last = 0;
  for (std::uint64_t round = 0; round < rounds; ++round) {
    switch (task) {
      case 2:
        last = mc::variance_textbook(x);
        break;
      case 3:
        last = mc::variance_two_pass(x);
        break;
      case 4:
        last = variance(added(x));
        break;
      case 5:
        last = variance(merged(x, std::vector<std::uint64_t>(x.size() / 64 + 1, 64)));
        break;
      case 8:
        last = variance(mc::moments(x));
        break;
      default:
        throw std::out_of_range("task: 2, 3, 4, 5 or 8");
    }
  }
  return last;
}

}  // namespace

double repeat(unsigned task, std::vector<double> x, std::uint64_t rounds) {
  return repeat_over(x, task, rounds);
}

double repeat_made(unsigned task, std::uint64_t n, std::uint64_t rounds) {
  std::vector<double> x(n);
  for (std::uint64_t i = 0; i < n; ++i) x[i] = 1e9 + static_cast<double>(i * 7919 % 1000) * 1e-3;
  return repeat_over(x, task, rounds);
}

}  // namespace mc::experiments

std::span<const mc::runner::Experiment> mc::runner::experiments() {
  static constexpr Experiment all[] = {
      MC_EXPERIMENT(mean, "x", "1.1  mean of x"),
      MC_EXPERIMENT(variance_textbook, "x", "1.2  variance of x by E{X^2} - E{X}^2"),
      MC_EXPERIMENT(variance_two_pass, "x", "1.3  variance of x in two passes"),
      MC_EXPERIMENT(welford, "x", "1.4  add() of each value of x"),
      MC_EXPERIMENT(variance_of, "count:mean:m2", "1.4  variance of moments"),
      MC_EXPERIMENT(stream, "count offset",
                    "1.4  add() of count values offset + 4, 7, 13, 16, ..."),
      MC_EXPERIMENT(merge, "count:mean:m2 count:mean:m2", "1.5  moments of two streams"),
      MC_EXPERIMENT(merge_parts, "x sizes", "1.5  x added in parts of these sizes, then merged"),
      MC_EXPERIMENT(covariance, "x y", "1.6  covariance of the pairs (x, y)"),
      MC_EXPERIMENT(dependence, "joint columns", "1.7  distance of a table from independence"),
      MC_EXPERIMENT(moments, "x", "1.8  moments of x, fast"),
      MC_EXPERIMENT(repeat, "task x rounds", "the function of task 1.task, rounds times (timing)"),
      MC_EXPERIMENT(repeat_made, "task n rounds", "the same over n values made here (timing)"),
  };
  return all;
}
