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
/// object, not on other samplers.
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
/// 6.3  "halton" and "sobol": eight dimensions of the sequence, with the points from index 0 on, in
/// their order. Each dimension is randomized by a different seed: Sobol' by nested scrambling
/// (5.8), Halton by permuted digits (5.9), but in base 2 by nested scrambling too. The eight are
/// four pairs: of Sobol' dimensions (0, 1), (4, 6), (16, 20), (15, 21), since these leave no cell
/// empty of the square grid of N cells, N = 4, 16, 64, 256, 1024; of Halton's the primes (2, 3),
/// (5, 7), (11, 13), (17, 19). In the order in which sample dimensions are first asked for, a
/// next2() takes the next pair. A next() takes the first half of the next pair, and the next()
/// after it takes the second half.
///
/// When all four pairs are taken, a next2(), or a next() with no half left to take, begins another
/// block: the same eight dimensions with new seeds and with the points in a new order that the
/// eight share. (A half that is left over is then not used.) The order is a nested shuffle: the
/// index of a point is the number of its sample with each bit flipped or not, from the highest bit
/// on, by an independent random decision for each string of bits before it. So the first 2^k
/// samples of every block have 2^k consecutive points, beginning at a multiple of 2^k: an
/// integration may stop early. If N is not a power of 2, the order is one of the points up to the
/// next power of 2.
///
/// 6.3  "lattice" is a stretch task: optional, and worth no points. Without it, make_sampler
/// refuses it like any unknown kind. It uses the same blocks, of lattices (5.10): dimension d of
/// point i is phi(i) z_d + s_d modulo 1, folded by the tent transform, with the radical inverse phi
/// in base 2, z = lattice_vector, d from 0 to 7 in four pairs, and a random shift s_d. The first
/// 2^k points are a lattice, in another order.
///
/// 6.7  "blue_noise": the first next2() is a blue-noise pattern of exactly N points, as blue as
/// best_candidate with c = 1. Everything else is as in "stratified".
///
/// 6.8  The speed task adds no function: a number should cost little more than the call that asks
/// for it, also with few samples, and a sample dimension that is never asked for uses no memory.
///
/// throws: std::invalid_argument for any other kind, with a message that lists the known kinds.
/// source: Pharr, Jakob, Humphreys 2023, "Physically based rendering", section 8.3 (interface);
///   Kollig, Keller 2002, "Efficient multidimensional sampling" (padding with scrambled sets);
///   Burley 2020, "Practical hash-based Owen scrambling" (nested shuffles).
std::unique_ptr<Sampler> make_sampler(std::string_view kind);

/// 6.5  The renderer's loop: the mean of `scene` over `samples` samples of `sampler`.
/// throws: std::invalid_argument if samples is 0.
double integrate(const Scene& scene, Sampler& sampler, std::size_t samples, std::uint64_t seed);

/// 6.6  A picture with `spp` samples per pixel. Each pixel is an integration with its own seed,
/// which no other pixel has, and no pixel of a picture with another `seed`.
/// throws: std::invalid_argument if spp is 0; if `scene` has more than most_samples pixels.
Image render(const PixelScene& scene, Sampler& sampler, std::size_t spp, std::uint64_t seed);

}  // namespace mc
