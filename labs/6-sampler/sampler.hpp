#pragma once
// Lab 6 · the sampler: what you implement, in starter/sampler.cpp. The handout is README.md here.
//
// A sample of a rendered picture is a point of a cube with as many dimensions as the sample needs
// random numbers: where in the pixel, when, through which point of the lens, to which point of the
// light. The renderer asks for its coordinates one after the other, as it comes to need them. What
// is behind them (random numbers, or the point sets of labs 3 to 5) it never knows: a sampler is a
// drop-in replacement for random().
//
// Points lie in [0,1) throughout, and random numbers have 53 bits, as those of lab 2 have; misuse
// throws std::invalid_argument naming the argument.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string_view>

#include "blue_noise.hpp"
#include "common/points.hpp"
#include "common/scene.hpp"
#include "halton.hpp"
#include "stratification.hpp"

namespace mc {

/// The largest number of samples of an integration, and of pixels of a picture: 2^27 doubles are
/// 1 GiB, and a sampler may well keep one for each of its coordinates.
inline constexpr std::size_t most_samples = std::size_t{1} << 27;

/// Hands out the coordinates of N samples, sample by sample, coordinate by coordinate.
///
/// The k-th call of next() within a sample is one *use*, the same for all samples (say: the time at
/// which the shutter is hit); the k-th call of next2() is another. The two are counted apart, from
/// 0 for every sample. So a use is a column of N numbers, or of N points of the plane, and each
/// kind of sampler promises something of every column: that it is stratified, say. Different uses
/// have nothing to do with each other (or, for halton and sobol, are different dimensions of one
/// set).
///
/// 6.4  A contract for every kind: a sample may ask for fewer numbers than the one before it, or
/// for none. The value of sample i in a use does not depend on what other samples ask for. It
/// depends on the seed, on the number of samples, and, if you like, on the order in which uses were
/// first asked for; on nothing else: not on what the same object was used for before, nor on other
/// samplers.
class Sampler {
 public:
  virtual ~Sampler() = default;

  /// Gets ready for a new integration with so many samples, and stands at the first of them. Equal
  /// seeds give equal numbers; different ones, even neighbours, unrelated numbers. Throws for 0
  /// samples and for more than most_samples.
  virtual void generate(std::size_t samples, std::uint64_t seed) = 0;

  /// The next coordinate of this sample. Throws std::out_of_range before the first generate(), and
  /// once all samples are done: after N advance()s.
  virtual double next() = 0;

  /// Two coordinates that belong together, as a point of the pixel or of the lens: a good point set
  /// in the plane, not on each axis only. Throws as next() does.
  virtual Point2 next2() = 0;

  /// Moves on to the next sample, whose coordinates begin anew. Never throws.
  virtual void advance() = 0;
};

/// A sampler of one of these kinds; any other name throws, with a list of them.
///
/// 6.1  "independent": all numbers uniform and independent, as those of random().
///
/// 6.2  "stratified": each next() has one number in each of N strata of [0,1); each next2() one
/// point in each cell of strata(N) and at the same time one in each of N strata on either axis
/// (multi-jittered, 3.7: so a prime N stratifies both axes). Every use in a random order of its
/// own.
///
/// 6.3  "halton" and "sobol": dimensions of the sequence from index 0, in the order in which uses
/// are first asked for (a next2() takes two), each randomised by a seed of its own: Sobol' by
/// nested scrambling (5.8); Halton with its digits permuted (5.9), but in base 2 by nested
/// scrambling too. Any number of uses, in blocks of eight dimensions: the first block is dimensions
/// 0 to 7 in the sequence's own order; every other block is dimensions 0 to 7 again, scrambled
/// anew, its points in a random order that is the same for all its dimensions and no other block's.
/// Where one dimension of a block is left and a next2() asks for two, that one is left over.
///
/// 6.7  "blue_noise": the first next2() is a blue-noise pattern of exactly N points, as blue as
/// best_candidate with c = 1; all else is as in "stratified".
///
/// 6.8  The speed task has no function of its own: a number should cost little more than the call
/// that asks for it, also with few samples, and nobody should pay for a use that is never asked
/// for.
std::unique_ptr<Sampler> make_sampler(std::string_view kind);

/// 6.5  The renderer's loop: the mean of `scene` over so many samples of `sampler`. Throws for 0
/// samples.
double integrate(const Scene& scene, Sampler& sampler, std::size_t samples, std::uint64_t seed);

/// 6.6  A picture with `spp` samples per pixel, every pixel an integration of its own: no two have
/// the same random numbers, unless the seed is the same. Throws for spp = 0, and for a `scene` of
/// more than most_samples pixels.
Image render(const PixelScene& scene, Sampler& sampler, std::size_t spp, std::uint64_t seed);

}  // namespace mc
