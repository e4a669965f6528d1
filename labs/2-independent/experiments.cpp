#include "experiments.hpp"

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include "common/todo.hpp"
#include "runner/experiment.hpp"

// Null if the submission does not define 2.9, which older submissions lack.
namespace mc {
[[gnu::weak]] Estimate irradiance_combined(const RectLight&, std::uint64_t, Rng&);
}  // namespace mc

namespace mc::experiments {
namespace {

/// The initial value of everything that a submission must write.
constexpr double unwritten = std::numeric_limits<double>::quiet_NaN();

template <class Make>
auto replicate(std::uint64_t seed, std::uint64_t replicates, Make make) {
  Rng rng(seed);
  std::vector<decltype(make(rng))> all;
  for (std::uint64_t i = 0; i < replicates; ++i) all.push_back(make(rng));
  return all;
}

template <class Function>
std::vector<double> each(const std::vector<double>& x, Function function) {
  std::vector<double> all;
  for (const double value : x) all.push_back(function(value));
  return all;
}

Density density(const Sampling& sampling) {
  const double parameter = sampling.parameter;
  const auto one = [](double x) { return x >= 0 && x <= 1 ? 1.0 : 0.0; };
  switch (sampling.p) {
    case 0:
      return {[](double u) { return u; }, one};
    case 1:
      return {[=](double u) { return mc::sample_power(u, parameter); },
              [=](double x) { return mc::pdf_power(x, parameter); }};
    case 2:
      return {[=](double u) { return mc::sample_exponential(u, parameter); },
              [=](double x) { return mc::pdf_exponential(x, parameter); }};
    case 3:
      return {[](double u) { return u; },
              [=](double x) {
                if (x < parameter / 2) return 0.0;
                return x < parameter ? std::numeric_limits<double>::infinity() : 1.0;
              }};
    case 4:
      return {[=](double u) {
                const double slope = 1 - parameter;
                return 2 * u / (slope + std::sqrt(slope * slope + 4 * parameter * u));
              },
              [=](double x) { return one(x) * (1 + parameter * (2 * x - 1)); }};
    default:
      throw std::out_of_range("p: must be 0 to 4");
  }
}

}  // namespace

std::vector<double> to_unit(std::vector<std::uint64_t> words) {
  std::vector<double> all;
  for (const std::uint64_t word : words) all.push_back(mc::to_unit(word));
  return all;
}

std::vector<CountedEstimate> estimates(Function g, std::uint64_t n, std::uint64_t seed,
                                       std::uint64_t replicates) {
  std::uint64_t evaluations = 0;
  const Integrand f = integrand(g);
  const Integrand counted{f.dims, [&](std::span<const double> x) {
                            ++evaluations;
                            return f.f(x);
                          }};
  return replicate(seed, replicates, [&](Rng& rng) {
    evaluations = 0;
    const Estimate one = estimate(counted, n, rng);
    return CountedEstimate{one.value, one.standard_error, one.n, evaluations};
  });
}

Traces traces(Function g, std::uint64_t n, std::uint64_t seed, std::uint64_t replicates) {
  Traces seen;
  const Integrand f = integrand(g);
  const Integrand watched{f.dims, [&](std::span<const double> x) {
                            seen.points.insert(seen.points.end(), x.begin(), x.end());
                            seen.values.push_back(f.f(x));
                            return seen.values.back();
                          }};
  seen.estimates = replicate(seed, replicates, [&](Rng& rng) { return estimate(watched, n, rng); });
  return seen;
}

std::vector<Estimate> estimates_in_turn(std::vector<Function> g, std::uint64_t n,
                                        std::vector<std::uint64_t> seeds) {
  if (g.size() != seeds.size()) throw std::out_of_range("seeds: must be as many as g");
  std::vector<Estimate> all;
  for (std::size_t i = 0; i < g.size(); ++i) {
    Rng rng(seeds[i]);
    all.push_back(estimate(integrand(g[i]), n, rng));
  }
  return all;
}

std::vector<double> sample_exponential(std::vector<double> u, double rate) {
  return each(u, [=](double value) { return mc::sample_exponential(value, rate); });
}
std::vector<double> sample_power(std::vector<double> u, double a) {
  return each(u, [=](double value) { return mc::sample_power(value, a); });
}
std::vector<double> pdf_exponential(std::vector<double> x, double rate) {
  return each(x, [=](double value) { return mc::pdf_exponential(value, rate); });
}
std::vector<double> pdf_power(std::vector<double> x, double a) {
  return each(x, [=](double value) { return mc::pdf_power(value, a); });
}

std::vector<CountedEstimate> importance_estimates(Function g, Sampling p, std::uint64_t n,
                                                  std::uint64_t seed, std::uint64_t replicates) {
  std::uint64_t evaluations = 0;
  const Integrand f = integrand(g);
  const Density by = density(p);
  const Integrand counted{f.dims, [&](std::span<const double> x) {
                            ++evaluations;
                            return f.f(x);
                          }};
  return replicate(seed, replicates, [&](Rng& rng) {
    evaluations = 0;
    const Estimate one = estimate_importance(counted, by, n, rng);
    return CountedEstimate{one.value, one.standard_error, one.n, evaluations};
  });
}

ImportanceTraces importance_traces(Function g, Sampling p, std::uint64_t n, std::uint64_t seed,
                                   std::uint64_t replicates) {
  ImportanceTraces seen;
  const Integrand f = integrand(g);
  const Density by = density(p);
  std::uint64_t evaluations = 0;
  const Integrand counted{f.dims, [&](std::span<const double> x) {
                            ++evaluations;
                            return f.f(x);
                          }};
  const Density watched{[&](double u) {
                          const double x = by.sample(u);
                          seen.u.push_back(u);
                          seen.points.push_back(x);
                          seen.values.push_back(f.f({&x, 1}));
                          seen.densities.push_back(by.pdf(x));
                          return x;
                        },
                        by.pdf};
  seen.estimates = replicate(seed, replicates, [&](Rng& rng) {
    evaluations = 0;
    const Estimate one = estimate_importance(counted, watched, n, rng);
    return CountedEstimate{one.value, one.standard_error, one.n, evaluations};
  });
  return seen;
}

Interval confidence_interval(Estimate estimate, double level) {
  return mc::confidence_interval(estimate, level);
}

std::vector<Interval> confidence_intervals(Function g, std::uint64_t n, double level,
                                           std::uint64_t seed, std::uint64_t replicates) {
  const Integrand f = integrand(g);
  return replicate(seed, replicates,
                   [&](Rng& rng) { return mc::confidence_interval(estimate(f, n, rng), level); });
}

IntervalTraces interval_traces(Function g, std::uint64_t n, double level, std::uint64_t seed,
                               std::uint64_t replicates) {
  IntervalTraces seen;
  const Integrand f = integrand(g);
  const Integrand watched{f.dims, [&](std::span<const double> x) {
                            seen.values.push_back(f.f(x));
                            return seen.values.back();
                          }};
  seen.intervals = replicate(seed, replicates, [&](Rng& rng) {
    return mc::confidence_interval(estimate(watched, n, rng), level);
  });
  return seen;
}

std::uint64_t samples_for(Estimate pilot, double target_error) {
  return mc::samples_for(pilot, target_error);
}

std::vector<Estimate> irradiance_area(RectLight light, std::uint64_t n, std::uint64_t seed,
                                      std::uint64_t replicates) {
  return replicate(seed, replicates, [&](Rng& rng) { return mc::irradiance_area(light, n, rng); });
}
std::vector<Estimate> irradiance_hemisphere(RectLight light, std::uint64_t n, std::uint64_t seed,
                                            std::uint64_t replicates) {
  return replicate(seed, replicates,
                   [&](Rng& rng) { return mc::irradiance_hemisphere(light, n, rng); });
}

std::vector<Estimate> irradiance_combined(RectLight light, std::uint64_t n, std::uint64_t seed,
                                          std::uint64_t replicates) {
  if (mc::irradiance_combined == nullptr) throw todo("2.9");
  return replicate(seed, replicates,
                   [&](Rng& rng) { return mc::irradiance_combined(light, n, rng); });
}

namespace {

using Irradiance = Estimate (*)(const RectLight&, std::uint64_t, Rng&);

Irradiance irradiance_by(std::uint64_t way) {
  const Irradiance ways[] = {mc::irradiance_area, mc::irradiance_hemisphere,
                             mc::irradiance_combined};
  if (way >= std::size(ways)) throw std::out_of_range("way: must be 0 to 2");
  if (ways[way] == nullptr) throw todo("2.9");
  return ways[way];
}

}  // namespace

std::vector<ValueAndVariance> irradiance_ways(std::vector<std::uint64_t> ways, RectLight light,
                                              std::uint64_t n, std::uint64_t seed) {
  std::vector<ValueAndVariance> all;
  for (const std::uint64_t way : ways) {
    Rng rng(seed);
    const Estimate one = irradiance_by(way)(light, n, rng);
    const double error = one.standard_error;
    all.push_back({one.value, error * error * static_cast<double>(one.n)});
  }
  return all;
}

std::vector<double> uniforms(std::uint64_t seed, std::vector<std::uint64_t> sizes, double before) {
  Rng rng(seed);
  std::vector<double> all;
  for (const std::uint64_t size : sizes) {
    all.resize(all.size() + size, before);
    mc::uniforms(rng, std::span(all).last(size));
  }
  return all;
}

std::vector<double> uniforms_in_turn(std::vector<std::uint64_t> seeds, std::uint64_t size) {
  std::vector<double> all(seeds.size() * size, unwritten);
  for (std::size_t i = 0; i < seeds.size(); ++i) {
    Rng rng(seeds[i]);
    mc::uniforms(rng, std::span(all).subspan(i * size, size));
  }
  return all;
}

std::vector<double> first_uniforms(std::uint64_t seed, std::uint64_t size, std::uint64_t calls) {
  if (size == 0) throw std::invalid_argument("size: must be positive");
  std::vector<double> block(size);
  return replicate(seed, calls, [&](Rng& rng) {
    mc::uniforms(rng, block);
    return block[0];
  });
}

std::vector<double> uniforms_constant(std::uint64_t word, std::uint64_t size) {
  Rng rng = Rng::constant(word);
  std::vector<double> all(size, unwritten);
  mc::uniforms(rng, all);
  return all;
}

namespace {

/// A source of random numbers, as numbered in means_of().
class Source {
 public:
  Source(unsigned source, std::uint64_t seed) : source_(source), rng_(seed), twister_(seed) {
    if (source > 2) throw std::out_of_range("source: 0 to 2");
  }
  void seed(std::uint64_t seed) { rng_ = Rng(seed); }
  void fill(std::span<double> out) {
    if (source_ == 0) {
      for (double& u : out) u = uniform_(twister_);
    } else if (source_ == 1) {
      for (double& u : out) u = mc::to_unit(rng_());
    } else {
      mc::uniforms(rng_, out);
    }
  }

 private:
  unsigned source_;
  Rng rng_;
  std::mt19937_64 twister_;
  std::uniform_real_distribution<double> uniform_{0, 1};
};

}  // namespace

std::vector<double> means_of(unsigned source, std::uint64_t size, std::uint64_t seed,
                             std::uint64_t replicates) {
  Source from(source, seed);
  std::vector<double> block(size, unwritten), all;
  for (std::uint64_t i = 0; i < replicates; ++i) {
    from.fill(block);
    double sum = 0;
    for (const double u : block) sum += u;
    all.push_back(sum / static_cast<double>(size));
  }
  return all;
}

double repeat_source(unsigned source, std::uint64_t size, std::uint64_t rounds,
                     std::uint64_t seed) {
  Source from(source, seed);
  std::vector<double> block(size, unwritten);
  for (std::uint64_t round = 0; round < rounds; ++round) {
    from.seed(seed + round);
    from.fill(block);
  }
  return block.empty() ? unwritten : block.back();
}

double repeat_irradiance(unsigned way, std::uint64_t n, std::uint64_t rounds) {
  Rng rng(1);
  double last = 0;
  for (std::uint64_t round = 0; round < rounds; ++round) {
    last = irradiance_by(way)({}, n, rng).value;
  }
  return last;
}

}  // namespace mc::experiments

std::span<const mc::runner::Experiment> mc::runner::experiments() {
  static constexpr Experiment all[] = {
      MC_EXPERIMENT(to_unit, "words", "2.1  a number in [0, 1) from each word",
                    {.row_labels = "words"}),
      MC_EXPERIMENT(estimates, "g n seed replicates", "2.2  estimates of g from n samples each"),
      MC_EXPERIMENT(traces, "g n seed replicates",
                    "2.2  the same, with all points and values of g"),
      MC_EXPERIMENT(estimates_in_turn, "g n seeds",
                    "2.2  one estimate per g, each with its own seed",
                    {.index = "seed", .row_labels = "seeds"}),
      MC_EXPERIMENT(sample_exponential, "u rate", "2.3  the quantile x at each u",
                    {.row_labels = "u"}),
      MC_EXPERIMENT(sample_power, "u a", "2.3  the quantile x at each u", {.row_labels = "u"}),
      MC_EXPERIMENT(pdf_exponential, "x rate", "2.3  the density at each x", {.row_labels = "x"}),
      MC_EXPERIMENT(pdf_power, "x a", "2.3  the density at each x", {.row_labels = "x"}),
      MC_EXPERIMENT(importance_estimates, "g p n seed replicates",
                    "2.4  estimates of g from n samples of the density p each"),
      MC_EXPERIMENT(importance_traces, "g p n seed replicates",
                    "2.4  the same, with u, x, g(x) and p(x) of all samples"),
      MC_EXPERIMENT(confidence_interval, "estimate level", "2.5  the interval around one estimate"),
      MC_EXPERIMENT(confidence_intervals, "g n level seed replicates",
                    "2.5  the intervals around estimates from n samples each"),
      MC_EXPERIMENT(interval_traces, "g n level seed replicates",
                    "2.5  the same, with all values of g"),
      MC_EXPERIMENT(samples_for, "pilot target_error",
                    "2.6  the number of samples for the target error"),
      MC_EXPERIMENT(irradiance_area, "light n seed replicates",
                    "2.7  estimates from n points on the light each"),
      MC_EXPERIMENT(irradiance_hemisphere, "light n seed replicates",
                    "2.7  estimates from n directions each"),
      MC_EXPERIMENT(irradiance_combined, "light n seed replicates",
                    "2.9  estimates from n pairs each, of a point and a direction"),
      MC_EXPERIMENT(
          irradiance_ways, "ways light n seed",
          "2.7, 2.9  an estimate, and its variance per sample: 0 points, 1 directions, 2 pairs",
          {.row_labels = "ways"}),
      MC_EXPERIMENT(uniforms, "seed sizes before",
                    "2.8  numbers of calls of these sizes, into spans filled with `before`",
                    {.columns = "u", .index = "i"}),
      MC_EXPERIMENT(uniforms_in_turn, "seeds size",
                    "2.8  size numbers from the generator of each seed",
                    {.columns = "u", .sets = "seeds"}),
      MC_EXPERIMENT(first_uniforms, "seed size calls",
                    "2.8  the first number of each of these calls", {.columns = "u"}),
      MC_EXPERIMENT(uniforms_constant, "word size",
                    "2.8  numbers from a generator that always returns word", {.columns = "u"}),
      MC_EXPERIMENT(means_of, "source size seed replicates",
                    "2.8  means of size numbers: source 0 mt19937_64, 1 to_unit, 2 uniforms",
                    {.columns = "mean"}),
      MC_EXPERIMENT(repeat_source, "source size rounds seed",
                    "2.8  size numbers, rounds times; returns the last one (timing)",
                    {.columns = "u", .points = "size"}),
      MC_EXPERIMENT(repeat_irradiance, "way n rounds",
                    "2.7, 2.9  irradiance by this way, rounds times (timing)"),
  };
  return all;
}

std::vector<mc::runner::Choice> mc::runner::choices() {
  const auto numbered = [](const auto& names) {
    std::vector<std::string> all;
    for (const std::string_view name : names) {
      all.push_back(std::to_string(all.size()) + "  " + text::filled(name, "parameter"));
    }
    return all;
  };
  return {{"g", "is scale * g + offset, where g is", numbered(experiments::function_names)},
          {"p", "is a density, where p is", numbered(experiments::sampling_names)}};
}
