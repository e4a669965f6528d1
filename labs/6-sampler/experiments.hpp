#pragma once
// What lab 6 measures of a submission. A `kind` is what make_sampler() is asked for; a `scene` is
// the name of a file in labs/common/scenes, its `parameters` its struct's fields in order (none: as
// they stand there); a `picture` one of edge, penumbra, defocus, motion, stripes.

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

/// What came of it: x of next(), x and y of next2(); `thrown` is 0 where nothing was, 1 a
/// std::out_of_range, 2 a std::invalid_argument. Other exceptions end the measurement.
struct Answer {
  unsigned thrown = 0;
  double x = 0, y = 0;
};
MC_FIELDS(Answer, thrown, x, y)

/// Calls of one sampler in turn.
std::vector<Answer> play(std::string kind, std::vector<Step> steps);

/// 6.4: two samplers of a kind alive at once. Each step is made by the one and then by the other,
/// whose seeds are larger by 1. What came of it, first of all steps of the one.
std::vector<Answer> play_two(std::string kind, std::vector<Step> steps);

/// What a sampler hands out: with each of `seeds` a new one, whose samples all ask for the same
/// `uses` (1 is next(), 2 is next2()). Set after set, a column for each coordinate.
std::vector<double> columns(std::string kind, std::uint64_t samples,
                            std::vector<std::uint64_t> seeds, std::vector<unsigned> uses);

/// What lab 5 has of the Sobol' sequence: `dimensions`, each scrambled by its own seed made of
/// each of `seeds`. Set after set, a column for each dimension.
std::vector<double> sobol_columns(std::vector<unsigned> dimensions, std::uint64_t samples,
                                  std::vector<std::uint64_t> seeds);

/// integrate() of a scene, a times its value plus b, with each of `seeds` and a new sampler for it.
std::vector<double> estimates(std::string kind, std::string scene, std::vector<double> parameters,
                              double a, double b, std::uint64_t samples,
                              std::vector<std::uint64_t> seeds);

/// What integrate() and render() did with a sampler of ours. The lists have the expected lengths,
/// cut or filled up with zeros; their true lengths are counted.
struct Recorded {
  std::vector<double> values;            ///< what came back: a number, or pixels
  std::vector<std::uint64_t> samples;    ///< of each generate()
  std::vector<std::uint64_t> seeds;      ///< of each generate()
  std::vector<std::uint64_t> positions;  ///< column + width row, and sample, of each evaluation
  std::uint64_t generates = 0, evaluations = 0, advances = 0;
};
MC_FIELDS(Recorded, values, samples, seeds, positions, generates, evaluations, advances)

/// 6.5: of a scene that has the value dealt[i] for sample i.
Recorded integrate_recorded(std::vector<double> dealt, std::uint64_t samples, std::uint64_t seed);

/// 6.6: of a picture that has the value column + 10 row + sample / spp.
Recorded render_recorded(std::uint64_t width, std::uint64_t height, std::uint64_t spp,
                         std::uint64_t seed);

/// 6.6: a picture.
Image render(std::string kind, std::string picture, std::uint64_t width, std::uint64_t height,
             std::uint64_t spp, std::uint64_t seed);

/// 6.6: a picture of nothing but the samples: each pixel is the mean of one next().
Image render_noise(std::string kind, std::uint64_t width, std::uint64_t height, std::uint64_t spp,
                   std::uint64_t seed);

/// What one sample of a scene asks for; and of a picture.
std::vector<unsigned> uses_of(std::string scene, std::vector<double> parameters);
std::vector<unsigned> uses_of_picture(std::string picture);

/// For timing: generate() and then `dims` coordinates for each of `samples`, by next() (`by` 1), by
/// next2() (`by` 2), or none, only the first of each use (`by` 0: what generation costs alone);
/// `rounds` times, round r with the seed `seed` + r. The sum of the last round.
double repeat(std::string kind, unsigned by, std::uint64_t dims, std::uint64_t samples,
              std::uint64_t rounds, std::uint64_t seed);

/// For timing: integrate() of a scene as written in its file, with one sampler; round r with the
/// seed `seed` + r. The last integral.
double repeat_scene(std::string kind, std::string scene, std::uint64_t samples,
                    std::uint64_t rounds, std::uint64_t seed);

/// For timing: as many numbers of std::mt19937_64 and std::uniform_real_distribution.
double repeat_textbook(std::uint64_t dims, std::uint64_t samples, std::uint64_t rounds);

}  // namespace mc::experiments

#include "6-sampler/calls.hpp"  // what a report makes of these
