#include "6-sampler/experiments.hpp"

#include <algorithm>
#include <limits>
#include <random>
#include <stdexcept>

#include "6-sampler/calls.hpp"
#include "6-sampler/named_scenes.hpp"
#include "common/todo.hpp"
#include "runner/experiment.hpp"

namespace mc::experiments {
namespace {

/// A sampler that records its calls.
class RecordingSampler final : public Sampler {
 public:
  SamplerTrace trace;
  std::vector<unsigned> uses;
  std::uint64_t sample = 0;

  void generate(std::size_t samples, std::uint64_t seed) override {
    if (samples == 0) throw std::invalid_argument("samples: must be positive");
    ++trace.generates;
    trace.samples.push_back(samples);
    trace.seeds.push_back(seed);
    sample = 0;
  }
  double next() override {
    uses.push_back(1);
    return 0.25;
  }
  Point2 next2() override {
    uses.push_back(2);
    return {0.25, 0.75};
  }
  void advance() override {
    ++trace.advances;
    ++sample;
  }

  /// Counts an evaluation of the scene.
  void count_evaluation() { ++trace.evaluations; }

  /// The trace, with its lists at the lengths expected for this many integrations and positions.
  SamplerTrace with_lengths(std::size_t integrations, std::size_t positions) && {
    trace.samples.resize(integrations);
    trace.seeds.resize(integrations);
    trace.positions.resize(positions);
    return std::move(trace);
  }
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

SamplerTrace integrate_recorded(std::vector<double> values, std::uint64_t samples,
                                std::uint64_t seed) {
  RecordingSampler sampler;
  const Scene scene{"", [&](Sampler&) {
                      sampler.count_evaluation();
                      sampler.trace.positions.push_back(sampler.sample);
                      if (sampler.sample >= values.size()) {
                        throw std::out_of_range("the scene was evaluated after the last sample");
                      }
                      return values[sampler.sample];
                    }};
  sampler.trace.values = {mc::integrate(scene, sampler, samples, seed)};
  return std::move(sampler).with_lengths(1, samples);
}

SamplerTrace render_recorded(std::uint64_t width, std::uint64_t height, std::uint64_t spp,
                             std::uint64_t seed) {
  RecordingSampler sampler;
  const PixelScene scene{width, height, "", [&](std::size_t column, std::size_t row, Sampler&) {
                           sampler.count_evaluation();
                           sampler.trace.positions.push_back(column + width * row);
                           sampler.trace.positions.push_back(sampler.sample);
                           return static_cast<double>(column) + 10 * static_cast<double>(row) +
                                  static_cast<double>(sampler.sample) / static_cast<double>(spp);
                         }};
  const Image image = mc::render(scene, sampler, spp, seed);
  if (image.width != width || image.height != height) {
    throw std::out_of_range("the size of the image is not that of the scene");
  }
  sampler.trace.values = image.pixels;
  return std::move(sampler).with_lengths(width * height, 2 * width * height * spp);
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
  RecordingSampler sampler;
  named(scenes, scene).with(parameters).sample(sampler);
  return sampler.uses;
}

std::vector<unsigned> uses_of_picture(std::string picture) {
  RecordingSampler sampler;
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
      MC_EXPERIMENT(integrate_recorded, "values samples seed",
                    "6.5  how integrate calls the sampler, for a scene of these values"),
      MC_EXPERIMENT(render, "kind picture width height spp seed", "6.6  a picture",
                    {.width = "width"}),
      MC_EXPERIMENT(render_noise, "kind width height spp seed",
                    "6.6  a picture of the samples themselves", {.width = "width"}),
      MC_EXPERIMENT(render_recorded, "width height spp seed", "6.6  how render calls the sampler"),
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
           {"independent", "stratified", "blue_noise", "halton", "sobol", "lattice"}},
          {"picture", "is one of", pictures},
          {"scene", "is one of these, with its --parameters in this order, or \"\"", scenes}};
}
