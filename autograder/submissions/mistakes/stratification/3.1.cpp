// Mistakes in task 3.1.
#include "stratification.hpp"

#include <cmath>

#define stratified_1d right_stratified_1d
#include "solutions/stratification.cpp"
#undef stratified_1d

// mistake: puts each point into a random stratum: some get two, some none
// hint: one point in each stratum
// hint: the gain of stratification is lost
namespace mc::any_stratum {
void stratified_1d(std::span<double> x, Rng& rng) {
  std::vector<double> places(x.size());
  right_stratified_1d(places, rng);
  for (double& value : x) value = places[rng() % places.size()];
  std::sort(x.begin(), x.end());
}
}  // namespace mc::any_stratum

// mistake: multiplies by 1 / N, rounded, which falls below the lower edge
// hint: rounded down below the edge
namespace mc::below_the_edge {
void stratified_1d(std::span<double> x, Rng& rng) {
  const auto n = static_cast<double>(x.size());
  const double width = 1 / n;
  for (std::size_t i = 0; i < x.size(); ++i) {
    x[i] = std::min((static_cast<double>(i) + to_unit(rng())) * width,
                    std::nextafter(static_cast<double>(i + 1) / n, 0.0));
  }
}
}  // namespace mc::below_the_edge

// mistake: starts every block of a long pattern with the same random numbers
// hint: share one random number
namespace mc::blocks_alike {
void stratified_1d(std::span<double> x, Rng& rng) {
  const Strata strata(x.size());
  const Rng start(rng());
  for (std::size_t first = 0; first < x.size(); first += block_size) {
    const auto block = x.subspan(first, std::min(block_size, x.size() - first));
    Rng same = start;
    for (double& u : block) u = to_unit(same());
    move_into(strata, first, block);
  }
}
}  // namespace mc::blocks_alike

// mistake: puts the points at the centers of their strata
// hint: every point lies at 0.5 of its stratum: choose a random place
namespace mc::centres {
void stratified_1d(std::span<double> x, Rng&) {
  const auto n = static_cast<double>(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = (static_cast<double>(i) + 0.5) / n;
}
}  // namespace mc::centres

// mistake: keeps points below 1 only, so that others are rounded up to the edge of their stratum
// hint: a point was rounded up to the edge
namespace mc::clamps_the_last_point {
void stratified_1d(std::span<double> x, Rng& rng) {
  const auto n = static_cast<double>(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    x[i] = std::min((static_cast<double>(i) + to_unit(rng())) / n, std::nextafter(1.0, 0.0));
  }
}
}  // namespace mc::clamps_the_last_point

// mistake: jitters with 8 random bits: 256 places in each stratum
// hint: the random numbers have too few bits
namespace mc::eight_bits {
void stratified_1d(std::span<double> x, Rng& rng) {
  const auto n = static_cast<double>(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double u = static_cast<double>(rng() >> 56) / 256;
    const double edge = static_cast<double>(i + 1) / n;
    x[i] = std::min((static_cast<double>(i) + u) / n, std::nextafter(edge, 0.0));
  }
}
}  // namespace mc::eight_bits

// mistake: jitters within the lower half of each stratum
// hint: the numbers cover only
namespace mc::half_the_width {
void stratified_1d(std::span<double> x, Rng& rng) {
  const auto n = static_cast<double>(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    x[i] = (static_cast<double>(i) + to_unit(rng()) / 2) / n;
  }
}
}  // namespace mc::half_the_width

// mistake: returns i + u without dividing by N
// hint: divide by the number of strata
namespace mc::not_divided {
void stratified_1d(std::span<double> x, Rng& rng) {
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = static_cast<double>(i) + to_unit(rng());
}
}  // namespace mc::not_divided

// mistake: moves the points of all strata by one random number
// hint: share one random number
namespace mc::one_jitter_for_all {
void stratified_1d(std::span<double> x, Rng& rng) {
  const double u = to_unit(rng());
  const auto n = static_cast<double>(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    x[i] = std::min((static_cast<double>(i) + u) / n,
                    std::nextafter(static_cast<double>(i + 1) / n, 0.0));
  }
}
}  // namespace mc::one_jitter_for_all

// mistake: shuffles the points of 3.1, which must be in order
// hint: the points are not in order
namespace mc::out_of_order {
void stratified_1d(std::span<double> x, Rng& rng) {
  right_stratified_1d(x, rng);
  mc::shuffle(x, rng);
}
}  // namespace mc::out_of_order

// mistake: rounds (i + u) / N up to the edge of the next stratum
// hint: it was rounded up to 1
namespace mc::reaches_the_edge {
void stratified_1d(std::span<double> x, Rng& rng) {
  const auto n = static_cast<double>(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    x[i] = (static_cast<double>(i) + to_unit(rng())) / n;
  }
}
}  // namespace mc::reaches_the_edge

// mistake: starts its own generator in every call, always with the same seed
// hint: the same numbers
namespace mc::seeds_its_own {
void stratified_1d(std::span<double> x, Rng& /*rng*/) {
  Rng mine(5489);
  right_stratified_1d(x, mine);
}
}  // namespace mc::seeds_its_own

// mistake: ends the loop one too early: the last point is never written
// hint: values were never written
namespace mc::the_last_value_unwritten {
void stratified_1d(std::span<double> x, Rng& rng) {
  const Strata strata(x.size());
  for (std::size_t i = 0; i + 1 < x.size(); ++i) {
    x[i] = strata.place(static_cast<double>(i), to_unit(rng()));
  }
}
}  // namespace mc::the_last_value_unwritten

// mistake: divides i by N as integers, which gives 0
// hint: i / N of two integers is 0
namespace mc::whole_number_division {
void stratified_1d(std::span<double> x, Rng& rng) {
  const auto n = static_cast<double>(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    x[i] = static_cast<double>(i / x.size()) + to_unit(rng()) / n;
  }
}
}  // namespace mc::whole_number_division

// mistake: multiplies by 1 / N, rounded, and keeps only the last point below the edge
// hint: points were rounded across an edge
namespace mc::times_the_reciprocal {
void stratified_1d(std::span<double> x, Rng& rng) {
  const double width = 1 / static_cast<double>(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    x[i] = std::min((static_cast<double>(i) + to_unit(rng())) * width, 1 - 0x1p-53);
  }
}
}  // namespace mc::times_the_reciprocal
