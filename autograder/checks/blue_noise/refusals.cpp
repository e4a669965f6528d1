// What the functions of lab 4 refuse, one table per task: the "throws:" lines of the header.

#include "checks/blue_noise/random_sets.hpp"

namespace mc::checks {
namespace {

/// Calls with x and y of different or zero sizes.
std::vector<InvalidCall> without_points(Call (*into)(std::uint64_t x, std::uint64_t y)) {
  std::vector<InvalidCall> calls;
  for (const auto& [x, y] : {std::pair{3u, 4u}, {4u, 3u}, {0u, 3u}, {3u, 0u}, {0u, 0u}}) {
    calls.push_back({into(x, y), x == y ? "x|y|size|point" : "x|y|size",
                     "x and y have the same size, at least 1"});
  }
  return calls;
}

std::vector<InvalidCall> wrong_candidates() {
  std::vector<InvalidCall> calls = without_points([](std::uint64_t x, std::uint64_t y) {
    return MEASURE_OUTCOME(best_candidate_into, x, y, 1);
  });
  for (const double c : {0.0, -0.0, -1.0, -1e-9, -1e300, nan, infinity, -infinity}) {
    for (const std::uint64_t points : {3u, 1u}) {
      calls.push_back({MEASURE_OUTCOME(best_candidate_into, points, points, c), "c",
                       "c, the candidates for each earlier point, is positive and finite"});
    }
  }
  return calls;
}

REFUSAL_CASES("4.2", "misuse of best_candidate is refused", "2", "a refusal names the argument",
              "1", wrong_candidates())

/// Radii that are not positive, or need too many points.
std::vector<InvalidCall> wrong_radii() {
  std::vector<InvalidCall> calls;
  for (const double radius : {-1.0, 0.0, -0.0, -1e-9, nan, -infinity, 1e-200, 5e-324, 1e-7, 1e-9,
                              std::nextafter(1e-5, 0)}) {
    calls.push_back({MEASURE_OUTCOME(poisson_disk, radius, 1, 1), "radius",
                     radius > 0 ? "the points do not fit into memory" : "a distance is positive"});
  }
  return calls;
}

CHECK_CASE("4.3 a radius that makes no sense is refused", "[4.3][edge][points:2]") {
  expect_refused(wrong_radii());
}

/// The first number in a text that lies between low and high.
std::optional<double> number_between(const std::string& text, double low, double high) {
  for (std::size_t at = 0; at < text.size(); ++at) {
    const double number = std::strtod(text.c_str() + at, nullptr);
    if (number >= low && number <= high) return number;
  }
  return {};
}

CHECK_CASE("4.3 the message for a radius too small for memory contains the number of points",
           "[4.3][edge][points:1]") {
  expect_argument_named(wrong_radii());
  for (const double radius : {1e-7, uniform(rng, 1, 9) * 1e-9, uniform(rng, 1, 9) * 1e-12}) {
    const auto call = MEASURE_OUTCOME(poisson_disk, radius, 1, 1);
    const double squares = 1 / (radius * radius);
    // Disks of half the radius are at most as dense as a triangular lattice; disks of the radius
    // cover, so there are at least as many as in the thinnest covering (Kershner 1939).
    expect_that(
        number_between(call.outcome.bytes, 0.384 * squares, 1.155 * squares).has_value(),
        fmt::format("{} threw std::invalid_argument(\"{}\")", call.text, call.outcome.bytes),
        fmt::format("a message with the number of points: about {:.2g}", 0.7 * squares),
        "between 0.385 / radius^2 (fewer do not cover) and 1.155 / radius^2 (more do not fit)",
        "the number is about 0.7 / radius^2, a double printed by std::to_string or %g: 1.5e+12");
  }
}

/// Calls in which the size of `power` does not fit kmax.
void add_wrong_sizes(std::vector<InvalidCall>& calls,
                     const std::function<Call(int kmax, std::uint64_t size)>& made) {
  for (const auto& [kmax, size] :
       {std::pair{0, 1u}, {-1, 1u}, {-3, 1u}, {-2, 9u}, {std::numeric_limits<int>::min(), 1u}}) {
    calls.push_back({made(kmax, size), "kmax", "kmax is at least 1"});
  }
  for (const std::uint64_t size : {0u, 9u, 24u, 26u, 49u}) {
    calls.push_back({made(2, size), "power", "(2 kmax + 1)^2 = 25 values are needed"});
  }
  calls.push_back({made(1 << 15, 131073), "power",
                   "65537^2 = 2^32 + 131073 values are needed: the number overflows 32 bits",
                   "(2 kmax + 1)^2 overflows an int: compute it in std::size_t"});
}

std::vector<InvalidCall> wrong_sizes() {
  std::vector<InvalidCall> calls = without_points([](std::uint64_t x, std::uint64_t y) {
    return MEASURE_OUTCOME(periodogram_into, x, y, 1, 9);
  });
  add_wrong_sizes(calls, [](int kmax, std::uint64_t size) {
    return MEASURE_OUTCOME(periodogram_into, 3, 3, kmax, size);
  });
  return calls;
}

REFUSAL_CASES("4.4", "misuse of periodogram is refused", "2", "a refusal names the argument", "1",
              wrong_sizes())

std::vector<InvalidCall> wrong_rings() {
  std::vector<InvalidCall> calls;
  add_wrong_sizes(calls, [](int kmax, std::uint64_t size) {
    return MEASURE_OUTCOME(radial_power, Values(size, 1.0), kmax);
  });
  return calls;
}

REFUSAL_CASES("4.5", "misuse of radial_power is refused", "0.5", "a refusal names the argument",
              "0.5", wrong_rings())

std::vector<InvalidCall> wrong_tiles() {
  std::vector<InvalidCall> calls;
  for (const int copies : {0, -1, -7}) {
    calls.push_back(
        {MEASURE_OUTCOME(tile_of, 3, 2, copies), "copies", "there is at least one copy"});
  }
  for (const int copies : {2, 1}) {
    calls.push_back(
        {MEASURE_OUTCOME(tile_of, 0, 2, copies), "pattern", "the pattern has no points"});
    for (const std::uint64_t dims : {0u, 1u, 3u}) {
      calls.push_back({MEASURE_OUTCOME(tile_of, 3, dims, copies), "pattern",
                       "a pattern of the square has two dimensions"});
    }
  }
  return calls;
}

REFUSAL_CASES("4.6", "misuse of tile is refused", "1", "a refusal names the argument", "1",
              wrong_tiles())

}  // namespace
}  // namespace mc::checks
