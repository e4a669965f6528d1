#pragma once
// Lab 6 · the sampler: what you implement in starter/sampler.cpp. The handout is README.md in this
// folder.
//
// A sample of a rendered picture is a point of a cube with as many dimensions as the sample needs
// numbers: where in the pixel, when, through which point of the lens, to which point of the light.
// The renderer asks for the coordinates one after the other, when it needs them. It does not know
// whether they are random numbers or come from the point sets of labs 3 to 5: a sampler is a
// drop-in replacement for random().
//
// Every coordinate lies in [0,1). Misuse throws std::invalid_argument with a message that names the
// argument, except where another exception is named. A function without a `throws:` line never
// throws.

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
/// 1 GiB, and a sampler may store one per sample and sample dimension.
inline constexpr std::size_t most_samples = std::size_t{1} << 27;

/// Provides the coordinates of N samples, sample by sample, coordinate by coordinate.
///
/// The k-th next() of every sample is one *sample dimension* (for example, the time at which the
/// shutter is open), the k-th next2() is a pair of them. next() and next2() are counted separately,
/// starting from 0 in every sample. A sample dimension is a column of N numbers, one for each
/// sample, and each kind of sampler defines how a column is filled: for example, stratified.
/// Different columns are independent of each other, or (halton, sobol) different dimensions of one
/// point set. Over seeds, each number of each sample is uniform in [0,1), and each point of a
/// next2() in the unit square, so that estimates are unbiased.
///
/// 6.4  The contract of every kind: a sample may ask for fewer numbers than the one before it, or
/// for none. The value of sample i in a sample dimension depends on the seed, on the number of
/// samples, and, if you like, on the order in which sample dimensions were first asked for. It
/// depends on nothing else: not on what other samples ask for, not on earlier uses of the same
/// object, not on other samplers. A column is made when it is first asked for: 2^27 samples that
/// ask for nothing use no memory.
class Sampler {
 public:
  virtual ~Sampler() = default;

  /// Begins a new integration with `samples` samples, at sample 0. Equal seeds give equal numbers;
  /// different seeds, even consecutive ones, give unrelated numbers.
  /// throws: std::invalid_argument if samples is 0 or more than most_samples.
  virtual void generate(std::size_t samples, std::uint64_t seed) = 0;

  /// The next coordinate of this sample.
  /// throws: std::out_of_range before the first generate(), and after N calls of advance().
  virtual double next() = 0;

  /// Two coordinates that belong together, such as a point of the pixel or of the lens: in the
  /// columns of a next2() the points are well distributed in the plane, not only on each axis.
  /// throws: as next().
  virtual Point2 next2() = 0;

  /// Moves to the next sample, whose coordinates start with the first sample dimension again.
  /// Never throws.
  virtual void advance() = 0;
};

/// A sampler of the given kind:
///
/// 6.1  "independent": all numbers uniform and independent, of 53 random bits, as in lab 2.
///
/// 6.2  "stratified": each next() has one number in each of N strata of [0,1). Each next2() has one
/// point in each cell of strata(N), and one in each of N strata of either axis (multi-jittered,
/// 3.7: so a prime N stratifies both axes). The samples of each next() and of each next2() are in
/// an independent random permutation.
///
/// 6.3  "halton" and "sobol": dimensions of one sequence, in its own order: sample i has point i.
/// The first request takes the first dimension, or the first two if it is a next2(); the next
/// request takes the next. Each dimension is randomized by a seed of its own: Sobol' by nested
/// scrambling (5.8), Halton by permuted digits (5.9), but in base 2 by nested scrambling too. Past
/// the last dimension (32 of Sobol', 8 or more of Halton) they start again at the first, with new
/// seeds and another random order of the points, the same for all of them. Both dimensions of a
/// next2() are from before a start, or both from after it. Another order of the dimensions is
/// right, too, and so is starting again after eight (6.8).
///
/// 6.7  "blue_noise": the first next2() is a blue-noise pattern of exactly N points, as blue as
/// best_candidate with c = 1. Everything else is as in "stratified".
///
/// 6.8  (Stretch: no points.) No next2() of "sobol" leaves more than a quarter of the cells of a
/// square grid of N cells empty, N = 4, 16, 64, 256, 1024, nor do the first 16, 64 or 256 of 1,024
/// samples. A number costs little more than the call that asks for it. Optional:
/// "lattice", with the points of 5.10, and "lattice_unfolded", the same without the tent transform.
/// docs/sampler-blocks.md explains one way to do all of this.
///
/// throws: std::invalid_argument for any other kind, with a message that lists the known kinds.
/// source: Pharr, Jakob, Humphreys 2023, "Physically based rendering", section 8.3 (interface);
///   Kollig, Keller 2002, "Efficient multidimensional sampling" (padding with scrambled sets).
std::unique_ptr<Sampler> make_sampler(std::string_view kind);

/// 6.5  The renderer's loop: the mean of `scene` over the samples of `sampler` after
/// generate(samples, seed), each evaluated once, in order.
/// throws: std::invalid_argument if samples is 0.
double integrate(const Scene& scene, Sampler& sampler, std::size_t samples, std::uint64_t seed);

/// 6.6  A picture with `spp` samples per pixel. Each pixel is an integration with its own seed,
/// which no other pixel has, and no pixel of a picture with another `seed`.
/// throws: std::invalid_argument if spp is 0; if `scene` has more than most_samples pixels.
Image render(const PixelScene& scene, Sampler& sampler, std::size_t spp, std::uint64_t seed);

}  // namespace mc
