#pragma once
// The experiments of lab 6: what is run and measured in a submission. `kind` is the argument of
// make_sampler(). `scene` names a scene of labs/common/scenes.hpp, and `parameters` are the fields
// of its struct in order; an empty list means their default values. `picture` is edge, penumbra,
// defocus, motion or stripes.

#include <cstdint>
#include <string>
#include <vector>

#include "runner/wire.hpp"
#include "sampler.hpp"

namespace mc {
MC_FIELDS(Image, width, height, pixels)
}  // namespace mc

namespace mc::experiments {

/// One call of a sampler.
///   call 0  generate(samples, seed)
///   call 1  next()
///   call 2  next2()
///   call 3  advance()
struct Step {
  unsigned call = 0;
  std::uint64_t samples = 0, seed = 0;
};
MC_FIELDS(Step, call, samples, seed)

/// The result of a call: x for next(), x and y for next2(). `thrown` is 0 if the call returned, 1
/// if it threw std::out_of_range, 2 if std::invalid_argument. Other exceptions end the measurement.
struct Answer {
  unsigned thrown = 0;
  double x = 0, y = 0;
};
MC_FIELDS(Answer, thrown, x, y)

/// 6.4: the results of consecutive calls of one sampler.
std::vector<Answer> play(std::string kind, std::vector<Step> steps);

/// 6.4: the same for two samplers of one kind that exist at the same time. The first sampler makes
/// a step, then the second one makes it with the next higher seed. Returns all results of the first
/// sampler, then all of the second.
std::vector<Answer> play_two(std::string kind, std::vector<Step> steps);

/// All coordinates of a sampler whose samples all make the same calls, `uses`: 1 is next(), 2 is
/// next2(). Each seed has a new sampler. Returns a set per seed, with a column per coordinate.
std::vector<double> columns(std::string kind, std::uint64_t samples,
                            std::vector<std::uint64_t> seeds, std::vector<unsigned> uses);

/// The given dimensions of lab 5's Sobol' sequence, each scrambled (5.8) with its own seed, drawn
/// from Rng(seed). Returns a set for each of `seeds`, with a column per dimension.
std::vector<double> sobol_columns(std::vector<unsigned> dimensions, std::uint64_t samples,
                                  std::vector<std::uint64_t> seeds);

/// 6.5: the integral of a * scene + b with each seed, each by a new sampler.
std::vector<double> estimates(std::string kind, std::string scene, std::vector<double> parameters,
                              double a, double b, std::uint64_t samples,
                              std::vector<std::uint64_t> seeds);

/// The RMSE of a sampler, divided by that of independent samples, for a checkerboard: the product
/// of signs that change at each quarter of each coordinate of `pairs` calls of next2(). For each of
/// `sizes` samples, over so many seeds from 1 on.
std::vector<double> against_independent(std::string kind, std::uint64_t pairs,
                                        std::vector<std::uint64_t> sizes, std::uint64_t seeds);

/// 6.5: integrates a keyed scene (keyed.hpp) by a keyed sampler. A value v below 1/3 counts as 0,
/// any other as low + (high - low) v.
double integrate_keyed(std::uint64_t key, double low, double high, std::uint64_t samples,
                       std::uint64_t seed);

/// 6.6: renders a keyed scene. The numbers of its sampler do not depend on the seeds of pixels.
Image render_keyed(std::uint64_t key, std::uint64_t width, std::uint64_t height, std::uint64_t spp,
                   std::uint64_t seed);

/// 6.6: the seed of each pixel, by pictures whose values are the lower or the upper 32 bits of the
/// seed that the sampler was given.
std::vector<std::uint64_t> pixel_seeds(std::uint64_t width, std::uint64_t height,
                                       std::uint64_t seed);

/// 6.6: a picture by a sampler of the given kind.
Image render(std::string kind, std::string picture, std::uint64_t width, std::uint64_t height,
             std::uint64_t spp, std::uint64_t seed);

/// 6.6: a picture of the samples themselves: each pixel is the mean of the first next().
Image render_noise(std::string kind, std::uint64_t width, std::uint64_t height, std::uint64_t spp,
                   std::uint64_t seed);

/// The calls that one sample of a scene makes, and one sample of a picture: 1 is next(), 2 is
/// next2().
std::vector<unsigned> uses_of(std::string scene, std::vector<double> parameters);
std::vector<unsigned> uses_of_picture(std::string picture);

/// For timing: `rounds` times, generate() and then `dims` coordinates for each of `samples`, by
/// next() (`by` 1) or by next2() (`by` 2). With `by` 0 only the first sample is read, by next2():
/// the cost of generation alone. Round r has the seed `seed` + r. Returns the sum of the last
/// round.
double repeat(std::string kind, unsigned by, std::uint64_t dims, std::uint64_t samples,
              std::uint64_t rounds, std::uint64_t seed);

/// For timing: integrates a scene with its default parameters `rounds` times, with one sampler.
/// Round r has the seed `seed` + r. Returns the last integral.
double repeat_scene(std::string kind, std::string scene, std::uint64_t samples,
                    std::uint64_t rounds, std::uint64_t seed);

/// For timing: the sum of rounds * samples * dims numbers of std::mt19937_64 with
/// std::uniform_real_distribution.
double repeat_textbook(std::uint64_t dims, std::uint64_t samples, std::uint64_t rounds);

}  // namespace mc::experiments

#include "6-sampler/calls.hpp"  // how a report prints these
