// Mistakes in task 6.8.
#include "autograder/submissions/mistakes/sampler/spoiled.hpp"

// mistake: takes dimensions 0 to 7 of the Sobol' sequence, with bad pairs among them
// hint: choose pairs of dimensions that fill the cells
namespace mc::eight_dimensions_in_order {
constexpr unsigned first_eight[] = {0, 1, 2, 3, 4, 5, 6, 7};
constexpr Sequence bad_pairs{first_eight, in_pairs, nested_order};

MAKE_SAMPLER(make_wrong<dimensions_of<fill_sobol>, &bad_pairs>("sobol", kind))
}  // namespace mc::eight_dimensions_in_order

// mistake: shuffles later blocks uniformly, so they cannot be stopped early
// hint: whose first 2^k samples are 2^k consecutive points
namespace mc::blocks_shuffled_uniformly {
constexpr Sequence uniform{sobol_block, in_pairs, random_order};

MAKE_SAMPLER(make_wrong<dimensions_of<fill_sobol>, &uniform>("sobol", kind))
}  // namespace mc::blocks_shuffled_uniformly

// mistake: takes dimension after dimension: after a next(), a next2() has halves of two pairs
// hint: choose pairs of dimensions that fill the cells
namespace mc::halves_of_two_pairs {
std::size_t one_by_one(Places& places, std::size_t count) {
  if (places.next + count > sobol_block.size()) places = {places.round + 1};
  return std::exchange(places.next, places.next + count);
}
constexpr Sequence halves{sobol_block, one_by_one, nested_order};

MAKE_SAMPLER(make_wrong<dimensions_of<fill_sobol>, &halves>("sobol", kind))
}  // namespace mc::halves_of_two_pairs

// mistake: shifts all dimensions of a lattice alike
// hint: one shift for several dimensions
namespace mc::one_shift_for_all {
void shifted_alike(const SampleDimension& dim, std::span<double> x, std::span<double> y, Rng& rng) {
  const std::uint64_t seed = rng();
  fill_lattice<true>(dim, dim.place, x, seed);
  if (!y.empty()) fill_lattice<true>(dim, dim.place + 1, y, seed);
}

MAKE_SAMPLER(make_wrong<shifted_alike, &blocks>("lattice", kind))
}  // namespace mc::one_shift_for_all

// mistake: folds the points of lattice_unfolded, too
// hint: lattice
namespace mc::always_folds {
MAKE_SAMPLER(make_wrong<dimensions_of<fill_lattice<true>>, &blocks>("lattice_unfolded", kind))
}  // namespace mc::always_folds
