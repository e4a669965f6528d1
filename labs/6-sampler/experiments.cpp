#include "6-sampler/experiments.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <random>
#include <stdexcept>
#include <utility>

#include "6-sampler/calls.hpp"
#include "6-sampler/keyed.hpp"
#include "6-sampler/named_scenes.hpp"
#include "common/todo.hpp"
#include "runner/experiment.hpp"

namespace mc::experiments {
namespace {

/// A sampler whose next() is a function of generate()'s arguments and of the sample.
class FunctionSampler final : public Sampler {
 public:
  using Function = double(std::uint64_t samples, std::uint64_t seed, std::uint64_t sample);
  explicit FunctionSampler(std::function<Function> next) : next_(std::move(next)) {}

  void generate(std::size_t samples, std::uint64_t seed) override {
    if (samples == 0) throw std::invalid_argument("samples: must be positive");
    samples_ = samples;
    seed_ = seed;
    sample_ = 0;
  }
  double next() override {
    if (sample_ >= samples_) {
      throw std::out_of_range(samples_ == 0 ? "the scene was evaluated before generate()"
                                            : "the scene was evaluated after the last sample");
    }
    return next_(samples_, seed_, sample_);
  }
  Point2 next2() override { return {next(), next()}; }
  void advance() override { ++sample_; }

 private:
  std::function<Function> next_;
  std::uint64_t samples_ = 0, seed_ = 0, sample_ = 0;
};

/// A sampler that lists its calls.
class ListingSampler final : public Sampler {
 public:
  std::vector<unsigned> uses;

  void generate(std::size_t, std::uint64_t) override {}
  double next() override {
    uses.push_back(1);
    return 0.25;
  }
  Point2 next2() override {
    uses.push_back(2);
    return {0.25, 0.75};
  }
  void advance() override {}
};

Answer answer_of(Sampler& sampler, const Step& step) {
  Answer answer;
  try {
    if (step.call == 0) sampler.generate(step.samples, step.seed);
    if (step.call == 1) answer.x = sampler.next();
    if (step.call == 2) {
      const Point2 point = sampler.next2();
      answer.x = point.x;
      answer.y = point.y;
    }
    if (step.call == 3) sampler.advance();
  } catch (const todo&) {
    throw;
  } catch (const std::out_of_range&) {
    answer.thrown = 1;
  } catch (const std::invalid_argument&) {
    answer.thrown = 2;
  } catch (const std::exception& error) {
    throw std::runtime_error("an exception in " + spelled(step) + ": " + error.what());
  }
  return answer;
}

}  // namespace

std::vector<Answer> play(std::string kind, std::vector<Step> steps) {
  const auto sampler = mc::make_sampler(kind);
  std::vector<Answer> answers;
  for (const Step& step : steps) answers.push_back(answer_of(*sampler, step));
  return answers;
}

std::vector<Answer> play_two(std::string kind, std::vector<Step> steps) {
  const auto first = mc::make_sampler(kind), second = mc::make_sampler(kind);
  std::vector<Answer> answers, of_second;
  for (Step step : steps) {
    answers.push_back(answer_of(*first, step));
    ++step.seed;
    of_second.push_back(answer_of(*second, step));
  }
  answers.insert(answers.end(), of_second.begin(), of_second.end());
  return answers;
}

std::vector<double> columns(std::string kind, std::uint64_t samples,
                            std::vector<std::uint64_t> seeds, std::vector<unsigned> uses) {
  std::size_t dims = 0;
  for (const unsigned use : uses) dims += use == 2 ? 2 : 1;
  std::vector<double> all(seeds.size() * dims * samples);
  double* set = all.data();
  for (const std::uint64_t seed : seeds) {
    const auto sampler = mc::make_sampler(kind);
    sampler->generate(samples, seed);
    for (std::size_t i = 0; i < samples && dims > 0; ++i, sampler->advance()) {
      double* to = set + i;
      for (const unsigned use : uses) {
        if (use == 2) {
          const Point2 point = sampler->next2();
          *to = point.x;
          to += samples;
          *to = point.y;
        } else {
          *to = sampler->next();
        }
        to += samples;
      }
    }
    set += dims * samples;
  }
  return all;
}

std::vector<double> sobol_columns(std::vector<unsigned> dimensions, std::uint64_t samples,
                                  std::vector<std::uint64_t> seeds) {
  std::vector<double> all(seeds.size() * dimensions.size() * samples,
                          std::numeric_limits<double>::quiet_NaN());
  std::span<double> rest = all;
  for (const std::uint64_t seed : seeds) {
    Rng rng(seed);
    for (const unsigned dimension : dimensions) {
      mc::sobol(dimension, 0, rest.first(samples));
      mc::owen_scramble(rest.first(samples), rng());
      rest = rest.subspan(samples);
    }
  }
  return all;
}

std::vector<double> estimates(std::string kind, std::string scene, std::vector<double> parameters,
                              double a, double b, std::uint64_t samples,
                              std::vector<std::uint64_t> seeds) {
  const Scene bare = named(scenes, scene).with(parameters);
  const Scene scaled{bare.uses, [&](Sampler& sampler) { return a * bare.sample(sampler) + b; }};
  std::vector<double> values;
  for (const std::uint64_t seed : seeds) {
    const auto sampler = mc::make_sampler(kind);
    values.push_back(mc::integrate(scaled, *sampler, samples, seed));
  }
  return values;
}

std::vector<double> against_independent(std::string kind, std::uint64_t pairs,
                                        std::vector<std::uint64_t> sizes, std::uint64_t seeds) {
  const Scene checkerboard{"next2", [=](Sampler& from) {
                             double product = 1;
                             for (std::uint64_t k = 0; k < pairs; ++k) {
                               const Point2 point = from.next2();
                               const auto quarters =
                                   static_cast<int>(4 * point.x) + static_cast<int>(4 * point.y);
                               if (quarters % 2 == 1) product = -product;
                             }
                             return product;
                           }};
  const auto sampler = mc::make_sampler(kind);
  std::vector<double> ratios;
  for (const std::uint64_t samples : sizes) {
    double squares = 0;  // the mean is 0, the variance of a sample 1
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
      const double value = mc::integrate(checkerboard, *sampler, samples, seed);
      squares += value * value;
    }
    const double mean_square = squares / static_cast<double>(seeds);
    ratios.push_back(std::round(1000 * std::sqrt(mean_square * static_cast<double>(samples))) /
                     1000);
  }
  return ratios;
}

double integrate_keyed(std::uint64_t key, double low, double high, std::uint64_t samples,
                       std::uint64_t seed) {
  FunctionSampler sampler([=](std::uint64_t n, std::uint64_t of, std::uint64_t i) {
    return keyed_next(key, n, of, i);
  });
  std::uint64_t evaluations = 0;
  const Scene scene{"next", [&](Sampler& from) {
                      const double v = keyed_value(key, 0, 0, evaluations++, from.next());
                      return v < 1. / 3 ? 0 : low + (high - low) * v;
                    }};
  return mc::integrate(scene, sampler, samples, seed);
}

Image render_keyed(std::uint64_t key, std::uint64_t width, std::uint64_t height, std::uint64_t spp,
                   std::uint64_t seed) {
  FunctionSampler sampler(
      [=](std::uint64_t n, std::uint64_t, std::uint64_t i) { return keyed_next(key, n, 0, i); });
  std::map<std::pair<std::size_t, std::size_t>, std::uint64_t> evaluations;
  const PixelScene scene{
      width, height, "next", [&](std::size_t column, std::size_t row, Sampler& from) {
        return keyed_value(key, column, row, evaluations[{column, row}]++, from.next());
      }};
  return mc::render(scene, sampler, spp, seed);
}

std::vector<std::uint64_t> pixel_seeds(std::uint64_t width, std::uint64_t height,
                                       std::uint64_t seed) {
  const PixelScene scene{width, height, "next",
                         [](std::size_t, std::size_t, Sampler& from) { return from.next(); }};
  std::vector<std::uint64_t> seeds;
  for (const int shift : {0, 32}) {
    FunctionSampler sampler([=](std::uint64_t, std::uint64_t of, std::uint64_t) {
      return static_cast<double>(static_cast<std::uint32_t>(of >> shift)) * 0x1p-32;
    });
    const Image image = mc::render(scene, sampler, 1, seed);
    seeds.resize(image.pixels.size());
    for (std::size_t k = 0; k < seeds.size(); ++k) {
      const double pixel = image.pixels[k] >= 0 ? std::min(image.pixels[k], 1.0) : 1;
      seeds[k] |= static_cast<std::uint64_t>(pixel * 0x1p32) << shift;
    }
  }
  return seeds;
}

Image render(std::string kind, std::string picture, std::uint64_t width, std::uint64_t height,
             std::uint64_t spp, std::uint64_t seed) {
  const auto sampler = mc::make_sampler(kind);
  return mc::render(named(pictures, picture).sized(width, height), *sampler, spp, seed);
}

Image render_noise(std::string kind, std::uint64_t width, std::uint64_t height, std::uint64_t spp,
                   std::uint64_t seed) {
  const auto sampler = mc::make_sampler(kind);
  const PixelScene noise{width, height, "next",
                         [](std::size_t, std::size_t, Sampler& from) { return from.next(); }};
  return mc::render(noise, *sampler, spp, seed);
}

std::vector<unsigned> uses_of(std::string scene, std::vector<double> parameters) {
  ListingSampler sampler;
  named(scenes, scene).with(parameters).sample(sampler);
  return sampler.uses;
}

std::vector<unsigned> uses_of_picture(std::string picture) {
  ListingSampler sampler;
  named(pictures, picture).sized(64, 64).sample(20, 30, sampler);
  return sampler.uses;
}

namespace {

/// The sum of the coordinates that repeat() reads in one round, of the first `count` samples.
double sum_of(Sampler& sampler, unsigned by, std::uint64_t dims, std::uint64_t count) {
  double sum = 0;
  for (std::uint64_t i = 0; i < count; ++i, sampler.advance()) {
    if (by == 1) {
      for (std::uint64_t d = 0; d < dims; ++d) sum += sampler.next();
    } else {
      for (std::uint64_t d = 0; d < dims; d += 2) {
        const Point2 point = sampler.next2();
        sum += point.x + point.y;
      }
    }
  }
  return sum;
}

}  // namespace

double repeat(std::string kind, unsigned by, std::uint64_t dims, std::uint64_t samples,
              std::uint64_t rounds, std::uint64_t seed) {
  const auto sampler = mc::make_sampler(kind);
  double sum = 0;
  for (std::uint64_t round = 0; round < rounds; ++round) {
    sampler->generate(samples, seed + round);
    sum = sum_of(*sampler, by, dims, by == 0 ? 1 : samples);
  }
  return sum;
}

double repeat_scene(std::string kind, std::string scene, std::uint64_t samples,
                    std::uint64_t rounds, std::uint64_t seed) {
  const Scene integrated = named(scenes, scene).with({});
  const auto sampler = mc::make_sampler(kind);
  double integral = 0;
  for (std::uint64_t round = 0; round < rounds; ++round) {
    integral = mc::integrate(integrated, *sampler, samples, seed + round);
  }
  return integral;
}

double repeat_textbook(std::uint64_t dims, std::uint64_t samples, std::uint64_t rounds) {
  std::mt19937_64 bits(samples);
  std::uniform_real_distribution<double> uniform(0, 1);
  double sum = 0;
  for (std::uint64_t i = 0; i < rounds * samples * dims; ++i) sum += uniform(bits);
  return sum;
}

}  // namespace mc::experiments

std::span<const mc::runner::Experiment> mc::runner::experiments() {
  static constexpr Experiment all[] = {
      MC_EXPERIMENT(play, "kind steps",
                    "6.4  consecutive calls of a sampler: 0:N:seed is generate, 1:0:0 next, "
                    "2:0:0 next2, 3:0:0 advance"),
      MC_EXPERIMENT(play_two, "kind steps", "6.4  the same for two samplers at the same time"),
      MC_EXPERIMENT(columns, "kind samples seeds uses",
                    "6.1  all coordinates of a sampler, one per column; uses: 1 is next, 2 next2",
                    {.points = "samples", .sets = "seeds"}),
      MC_EXPERIMENT(estimates, "kind scene parameters a b samples seeds",
                    "6.5  integrals of a * scene + b, one per seed",
                    {.columns = "integral", .index = "seed", .row_labels = "seeds"}),
      MC_EXPERIMENT(sobol_columns, "dimensions samples seeds",
                    "6.3  dimensions of the Sobol' sequence, scrambled",
                    {.points = "samples", .sets = "seeds"}),
      MC_EXPERIMENT(against_independent, "kind pairs sizes seeds",
                    "the RMSE by that of independent samples, for a checkerboard of quarters",
                    {.columns = "ratio", .index = "samples", .row_labels = "sizes"}),
      MC_EXPERIMENT(integrate_keyed, "key low high samples seed",
                    "6.5  the integral of a scene that is a function of a key"),
      MC_EXPERIMENT(render, "kind picture width height spp seed", "6.6  a picture",
                    {.width = "width"}),
      MC_EXPERIMENT(render_noise, "kind width height spp seed",
                    "6.6  a picture of the samples themselves", {.width = "width"}),
      MC_EXPERIMENT(render_keyed, "key width height spp seed",
                    "6.6  a picture of a scene that is a function of a key", {.width = "width"}),
      MC_EXPERIMENT(pixel_seeds, "width height seed", "6.6  the seed of each pixel",
                    {.columns = "seed", .index = "pixel"}),
      MC_EXPERIMENT(uses_of, "scene parameters",
                    "the calls of one sample of a scene: 1 is next, 2 next2", {.columns = "use"}),
      MC_EXPERIMENT(uses_of_picture, "picture", "the calls of one sample of a picture",
                    {.columns = "use"}),
      MC_EXPERIMENT(repeat, "kind by dims samples rounds seed",
                    "6.8  coordinates by next (by 1), next2 (2), or only generation (0) (timing)"),
      MC_EXPERIMENT(repeat_scene, "kind scene samples rounds seed",
                    "6.8  integrals of a scene, rounds times (timing)"),
      MC_EXPERIMENT(repeat_textbook, "dims samples rounds",
                    "6.8  numbers of std::mt19937_64 (timing)"),
  };
  return all;
}

std::vector<mc::runner::Choice> mc::runner::choices() {
  std::vector<std::string> scenes, pictures;
  for (const auto& [scene, parameters] : experiments::scene_parameters) {
    scenes.push_back(std::string(scene) + ": " + std::string(parameters));
  }
  for (const auto& picture : experiments::pictures) pictures.emplace_back(picture.name);
  return {{"kind",
           "is one of",
           {"independent", "stratified", "blue_noise", "halton", "sobol", "lattice",
            "lattice_unfolded"}},
          {"picture", "is one of", pictures},
          {"scene", "is one of these, with its --parameters in this order, or \"\"", scenes}};
}
