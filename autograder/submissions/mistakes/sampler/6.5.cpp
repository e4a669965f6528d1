// Mistakes in task 6.5.
#include "sampler.hpp"

#define integrate right_integrate
#include "solutions/sampler.cpp"
#undef integrate

#define INTEGRATE                                                             \
  double integrate(const Scene& scene, Sampler& sampler, std::size_t samples, \
                   [[maybe_unused]] std::uint64_t seed)

namespace mc {
namespace {

/// The sum of count samples, each evaluated `times` times, with advance() after it.
template <class Sum = double>
Sum sum_of(const Scene& scene, Sampler& sampler, std::size_t count, int times = 1) {
  Sum sum = 0;
  for (std::size_t i = 0; i < count; ++i, sampler.advance()) {
    for (int k = 0; k < times; ++k) sum = static_cast<Sum>(sum + scene.sample(sampler));
  }
  return sum;
}

}  // namespace
}  // namespace mc

// mistake: counts its calls, so that no two have the same seed
// hint: a static or global variable
namespace mc::a_new_seed_each_time {
INTEGRATE {
  static std::uint64_t calls = 0;
  return right_integrate(scene, sampler, samples, seed + mix_bits(calls++));
}
}  // namespace mc::a_new_seed_each_time

// mistake: advances before each sample, so the first is skipped
// hint: call advance() after each sample, not before it
namespace mc::advances_first {
INTEGRATE {
  sampler.generate(samples + 1, seed);
  sampler.advance();
  return sum_of(scene, sampler, samples) / static_cast<double>(samples);
}
}  // namespace mc::advances_first

// mistake: never advances to the next sample
// hint: to move to the next one
namespace mc::forgets_to_advance {
INTEGRATE {
  sampler.generate(samples, seed);
  return sum_of(scene, sampler, 1, static_cast<int>(samples)) / static_cast<double>(samples);
}
}  // namespace mc::forgets_to_advance

// mistake: generates a point set of one sample, N times
// hint: generate(samples, seed) once
namespace mc::generates_for_each_sample {
INTEGRATE {
  if (samples == 0) throw std::invalid_argument("samples: must be positive");
  Rng seeds(seed);
  double sum = 0;
  for (std::size_t i = 0; i < samples; ++i) {
    sampler.generate(1, seeds());
    sum += sum_of(scene, sampler, 1);
  }
  return sum / static_cast<double>(samples);
}
}  // namespace mc::generates_for_each_sample

// mistake: passes on only the lower half of the seed
// hint: do not truncate the seed to 32 bits
namespace mc::integral_seed_of_32_bits {
INTEGRATE {
  return right_integrate(scene, sampler, samples, static_cast<unsigned>(seed));
}
}  // namespace mc::integral_seed_of_32_bits

// mistake: takes one sample too few, and divides by N
// hint: the last sample is missing
namespace mc::leaves_out_the_last_sample {
INTEGRATE {
  sampler.generate(samples, seed);
  return sum_of(scene, sampler, samples - 1) / static_cast<double>(samples);
}
}  // namespace mc::leaves_out_the_last_sample

// mistake: returns 0 for no samples
// hint: there is no mean of 0 samples
namespace mc::mean_of_nothing_is_zero {
INTEGRATE {
  return samples == 0 ? 0 : right_integrate(scene, sampler, samples, seed);
}
}  // namespace mc::mean_of_nothing_is_zero

// mistake: divides by N - 1
// hint: this divides by N - 1
namespace mc::mean_over_n_minus_1 {
INTEGRATE {
  sampler.generate(samples, seed);
  return sum_of(scene, sampler, samples) / static_cast<double>(samples - 1);
}
}  // namespace mc::mean_over_n_minus_1

// mistake: sums in a float
// hint: the mean of the scene's values
namespace mc::sum_in_float {
INTEGRATE {
  sampler.generate(samples, seed);
  return sum_of<float>(scene, sampler, samples) / static_cast<double>(samples);
}
}  // namespace mc::sum_in_float

// mistake: sums in an int, which truncates every sample
// hint: added up in an int
namespace mc::sum_in_whole_numbers {
INTEGRATE {
  sampler.generate(samples, seed);
  return sum_of<int>(scene, sampler, samples) / static_cast<double>(samples);
}
}  // namespace mc::sum_in_whole_numbers

// mistake: evaluates each sample twice, and divides by twice their number
// hint: evaluate the scene once
namespace mc::each_sample_twice {
INTEGRATE {
  sampler.generate(samples, seed);
  return sum_of(scene, sampler, samples, 2) / static_cast<double>(2 * samples);
}
}  // namespace mc::each_sample_twice

// mistake: always generates with seed 0
// hint: pass the seed to generate()
namespace mc::ignores_the_seed {
INTEGRATE {
  return right_integrate(scene, sampler, samples, 0);
}
}  // namespace mc::ignores_the_seed

// mistake: returns the sum
// hint: divide by the number of samples
namespace mc::returns_the_sum {
INTEGRATE {
  return right_integrate(scene, sampler, samples, seed) * static_cast<double>(samples);
}
}  // namespace mc::returns_the_sum

// mistake: stops early if the first 16 values are equal
// hint: for all samples, whatever their values
namespace mc::stops_when_values_are_equal {
INTEGRATE {
  if (samples == 0) throw std::invalid_argument("samples: must be positive");
  sampler.generate(samples, seed);
  double sum = 0, first = 0;
  bool equal = true;
  for (std::size_t i = 0; i < samples; ++i, sampler.advance()) {
    const double value = scene.sample(sampler);
    if (i == 0) first = value;
    equal = equal && value == first;
    sum += value;
    if (i == 15 && equal) return value;
  }
  return sum / static_cast<double>(samples);
}
}  // namespace mc::stops_when_values_are_equal
