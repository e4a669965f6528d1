// Mistakes in task 3.4.
#include "stratification.hpp"

#include <random>
#include <utility>

#define shuffle right_shuffle
#define stratified right_stratified
#include "solutions/stratification.cpp"
#undef shuffle
#undef stratified

// mistake: shuffles with its own generator, always with the same seed
// hint: draw it from the given generator
// hint: permutations occur
namespace mc::always_the_same_order {
void shuffle(std::span<double> x, Rng& /*rng*/) {
  std::mt19937 mine;
  std::shuffle(x.begin(), x.end(), mine);
}
}  // namespace mc::always_the_same_order

// mistake: copies random values over each other instead of swapping them
// hint: it does not copy one over another
namespace mc::copies_values {
void shuffle(std::span<double> x, Rng& rng) {
  const std::vector<double> from(x.begin(), x.end());
  for (double& value : x) value = from[rng() % from.size()];
}
}  // namespace mc::copies_values

// mistake: shuffles all patterns but the first, so the first n of N points lie in its first rows
// hint: an estimate that stops early
namespace mc::first_pattern_in_order {
void stratified(PointSet& points, Rng& rng) {
  if (points.dims() < 2) return stratified_1d(points.column(0), rng);
  PointSet rest(points.size(), points.dims() - 2);
  right_stratified(rest, rng);
  stratified_2d(points.column(0), points.column(1), strata(points.size()), rng);
  for (std::size_t d = 2; d < points.dims(); ++d) {
    std::ranges::copy(rest.column(d - 2), points.column(d).begin());
  }
}
}  // namespace mc::first_pattern_in_order

// mistake: sorts by keys of 16 bits and leaves equal ones in their order
// hint: 16-bit random numbers are too short
namespace mc::keys_of_16_bits {
void shuffle(std::span<double> x, Rng& rng) {
  std::vector<std::pair<std::uint64_t, double>> keyed;
  for (const double value : x) keyed.emplace_back(rng() >> 48, value);
  std::stable_sort(keyed.begin(), keyed.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  for (std::size_t k = 0; k < x.size(); ++k) x[k] = keyed[k].second;
}
}  // namespace mc::keys_of_16_bits

// mistake: swaps each value with a later one, never with itself
// hint: a value may be swapped with itself
namespace mc::never_stays {
void shuffle(std::span<double> x, Rng& rng) {
  for (std::size_t i = 0; i + 1 < x.size(); ++i) {
    std::swap(x[i], x[i + 1 + rng() % (x.size() - i - 1)]);
  }
}
}  // namespace mc::never_stays

// mistake: draws one 2D pattern and shuffles it for each pair of dimensions
// hint: make a new one for each
namespace mc::one_pattern_for_all_pairs {
void stratified(PointSet& points, Rng& rng) {
  right_stratified(points, rng);
  std::vector<double> x(points.size()), y(points.size());
  if (points.dims() < 4) return;
  std::ranges::copy(points.column(0), x.begin());
  std::ranges::copy(points.column(1), y.begin());
  for (std::size_t d = 2; d + 1 < points.dims(); d += 2) {
    Rng again = rng;
    shuffle(x, rng);
    shuffle(y, again);
    std::ranges::copy(x, points.column(d).begin());
    std::ranges::copy(y, points.column(d + 1).begin());
  }
}
}  // namespace mc::one_pattern_for_all_pairs

// mistake: shuffles every pattern by the same permutation
// hint: shuffle each one separately
namespace mc::one_shuffle_for_all {
void stratified(PointSet& points, Rng& rng) {
  std::size_t d = 0;
  for (; d + 1 < points.dims(); d += 2) {
    stratified_2d(points.column(d), points.column(d + 1), strata(points.size()), rng);
  }
  if (d < points.dims()) stratified_1d(points.column(d), rng);
  const Rng same = rng;
  for (std::size_t axis = 0; axis < points.dims(); ++axis) {
    rng = same;
    shuffle(points.column(axis), rng);
  }
}
}  // namespace mc::one_shuffle_for_all

// mistake: shuffles with 16 random bits per choice, too few for 100,000 values
// hint: 16-bit random numbers are too short
namespace mc::shuffle_of_16_bits {
void shuffle(std::span<double> x, Rng& rng) {
  for (std::size_t n = x.size(); n > 1; --n) std::swap(x[n - 1], x[(rng() & 0xffff) % n]);
}
}  // namespace mc::shuffle_of_16_bits

// mistake: shuffles blocks of 128 values separately
// hint: do not shuffle in blocks
namespace mc::shuffles_blocks {
void shuffle(std::span<double> x, Rng& rng) {
  for (std::size_t first = 0; first < x.size(); first += 128) {
    right_shuffle(x.subspan(first, std::min<std::size_t>(128, x.size() - first)), rng);
  }
}
}  // namespace mc::shuffles_blocks

// mistake: swaps each value with any of the n, which favors some permutations
// hint: each value is swapped with any of the n values
namespace mc::swaps_with_any {
void shuffle(std::span<double> x, Rng& rng) {
  for (double& value : x) std::swap(value, x[rng() % x.size()]);
}
}  // namespace mc::swaps_with_any

// mistake: ends the loop one too early: the last value never moves
// hint: never moves: shuffle
// hint: shuffle all values, including the last one
namespace mc::the_last_one_stays {
void shuffle(std::span<double> x, Rng& rng) {
  if (x.size() > 1) right_shuffle(x.first(x.size() - 1), rng);
}
}  // namespace mc::the_last_one_stays

// mistake: permutes pattern 4 as pattern 1, pattern 5 as pattern 2, …
// hint: one order for several
namespace mc::three_orders_for_all_patterns {
void stratified(PointSet& points, Rng& rng) {
  right_stratified(points, rng);
  if (points.dims() < 8) return;
  const Rng start(rng());
  std::size_t pattern = 0;
  for (std::size_t d = 0; d + 1 < points.dims(); d += 2, ++pattern) {
    stratified_2d(points.column(d), points.column(d + 1), strata(points.size()), rng);
    for (const std::size_t axis : {d, d + 1}) {
      Rng order = start;
      for (std::size_t k = 0; k < pattern % 3; ++k) order = Rng(order());
      shuffle(points.column(axis), order);
    }
  }
}
}  // namespace mc::three_orders_for_all_patterns

// mistake: pads with two 1D patterns instead of one 2D pattern
// hint: two 1D patterns are not a 2D pattern
namespace mc::two_lines_for_a_plane {
void stratified(PointSet& points, Rng& rng) {
  latin_hypercube(points, rng);
}
}  // namespace mc::two_lines_for_a_plane

// mistake: pads patterns without shuffling them
// hint: shuffle each one separately
namespace mc::unshuffled_padding {
void stratified(PointSet& points, Rng& rng) {
  std::size_t d = 0;
  for (; d + 1 < points.dims(); d += 2) {
    stratified_2d(points.column(d), points.column(d + 1), strata(points.size()), rng);
  }
  if (d < points.dims()) stratified_1d(points.column(d), rng);
}
}  // namespace mc::unshuffled_padding

// mistake: shuffles x and y of a pattern separately
// hint: are the coordinates of a point moved together
namespace mc::x_and_y_shuffled_apart {
void stratified(PointSet& points, Rng& rng) {
  right_stratified(points, rng);
  for (std::size_t d = 0; d < points.dims(); ++d) shuffle(points.column(d), rng);
}
}  // namespace mc::x_and_y_shuffled_apart

// mistake: stores the order of the points in 16 bits
// hint: dimensions (0,1), (2,3), … are jittered grids
namespace mc::order_in_16_bits {
void stratified(PointSet& points, Rng& rng) {
  right_stratified(points, rng);
  for (std::size_t d = 0; d < points.dims(); ++d) {
    const auto x = points.column(d);
    for (std::size_t i = 65536; i < x.size(); ++i) x[i] = x[i % 65536];
  }
}
}  // namespace mc::order_in_16_bits

// mistake: the order of every third pattern is that of the first in the second
// hint: no permutation is a product of two others
namespace mc::order_of_two_others {
void stratified(PointSet& points, Rng& rng) {
  const std::size_t n = points.size();
  std::vector<std::vector<double>> orders;
  std::vector<double> x(n), y(n);
  for (std::size_t d = 0; d < points.dims(); d += 2) {
    std::vector<double> order(n);
    std::iota(order.begin(), order.end(), 0.0);
    right_shuffle(order, rng);
    for (std::size_t i = 0; i < n && d % 6 == 4; ++i) {
      order[i] = orders[d / 2 - 1][static_cast<std::size_t>(orders[d / 2 - 2][i])];
    }
    const bool is_pair = d + 1 < points.dims();
    is_pair ? stratified_2d(x, y, strata(n), rng) : stratified_1d(x, rng);
    for (std::size_t i = 0; i < n; ++i) {
      const auto from = static_cast<std::size_t>(order[i]);
      points.column(d)[i] = x[from];
      if (is_pair) points.column(d + 1)[i] = y[from];
    }
    orders.push_back(order);
  }
}
}  // namespace mc::order_of_two_others

// mistake: takes values out of a vector by erase(), which is quadratic
// hint: more steps or memory than the header's cost allows
// limit: time
namespace mc::erases_values {
void shuffle(std::span<double> x, Rng& rng) {
  std::vector<double> left(x.begin(), x.end());
  for (double& value : x) {
    const auto chosen = left.begin() + static_cast<std::ptrdiff_t>(rng() % left.size());
    value = *chosen;
    left.erase(chosen);
  }
}
}  // namespace mc::erases_values

// mistake: sorts by random keys below n, of which many are equal
// hint: values with equal keys must not stay in order
namespace mc::keys_below_n {
void shuffle(std::span<double> x, Rng& rng) {
  std::vector<std::pair<std::size_t, double>> keys;
  for (const double value : x) keys.emplace_back(rng() % x.size(), value);
  std::stable_sort(keys.begin(), keys.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = keys[i].second;
}
}  // namespace mc::keys_below_n
