// 5.6: star discrepancies, compared with the definition, and with that over too few boxes.

#include "5-halton/experiments.hpp"
#include "checks/halton/exact_points.hpp"

namespace mc::checks {
namespace {

/// Discrepancies of many sets of points, judged together: of a single set, too few boxes may give
/// the result of a different mistake. Add small sets first: the report shows the first wrong one.
class Discrepancies {
 public:
  void add_line(const Values& x);
  void add_plane(const Values& x, const Values& y);
  void expect();

 private:
  void add(const Measured<double>& got, const Values& x, const Values& y, bool is_line);

  Results results_;
};

/// Coordinates with many ties, including 0 and 1.
Values on_a_grid(Rng& rng, std::size_t n);
/// A call for n points takes at most `most` times as long as one for n/4.
void check_growth(const char* what, const std::function<Call(std::size_t)>& measure, std::size_t n,
                  double most, const std::string& cost);

CHECK_CASE("5.6 the star discrepancy of points of the line", "[5.6][points:7][main]") {
  Discrepancies line;
  for (const double place : {0.875, 0.125, 0.5}) {
    // One point per stratum: the worst interval ends just before a point if it lies late.
    for (const std::size_t n : {3u, 20u}) {
      Values x = steps(n);
      for (double& value : x) value += place / static_cast<double>(n);
      std::ranges::shuffle(x, rng);
      line.add_line(x);
    }
  }
  line.add_line(uniform_values(rng, 60, 0, 1));
  for (const std::size_t n : domain::sizes(1025, rng)) {
    line.add_line(n % 2 == 0 ? inverses(3, 0, n) : uniform_values(rng, n, 0, 1));
  }
  line.expect();
}

CHECK_CASE("5.6 the star discrepancy of points of the plane", "[5.6][points:5]") {
  Discrepancies plane;
  for (const std::size_t n : {3u, 5u, 30u, 100u, 300u}) {
    // The left and the top are empty, so that wrong sets of boxes give different results.
    plane.add_plane(uniform_values(rng, n, 0.6, 1), uniform_values(rng, n, 0, 0.8));
    plane.add_plane(uniform_values(rng, n, 0, 0.8), uniform_values(rng, n, 0.6, 1));
    plane.add_plane(uniform_values(rng, n, 0, 1), uniform_values(rng, n, 0, 1));
  }
  // Low-discrepancy points: N = 2^k, 2^k + 1, and binary 10101…
  for (const std::size_t n : {64u, 171u, 256u, 341u, 513u}) {
    plane.add_plane(inverses(2, 1, n), inverses(3, 1, n));
    plane.add_plane(steps(n), inverses(2, 0, n));
    plane.add_plane(sobol_points(0, 0, n), sobol_points(1, 0, n));
  }
  for (const std::size_t n : domain::sizes(300, rng)) {
    plane.add_plane(uniform_values(rng, n, 0, 1), uniform_values(rng, n, 0, 1));
  }
  plane.expect();
}

CHECK_CASE("5.6 points that share coordinates or lie on the border", "[5.6][points:2][edge]") {
  Discrepancies line, plane;
  for (const double corner : {0.0, 1.0, 1 - half_ulp, 0x1p-1074}) {
    line.add_line({corner});
    line.add_line({corner, corner, 0.5});
    plane.add_plane({corner}, {corner});
    plane.add_plane({corner}, {1 - corner});
  }
  plane.add_plane({1, 1, 0}, {0, 1, 1});
  plane.add_plane({0.875, 0.875, 0.875}, {0.125, 0.25, 0.5});  // the worst box ends at y = 1
  plane.add_plane({0.125, 0.25, 0.5}, {0.875, 0.875, 0.875});
  for (int set = 0; set < 12; ++set) {
    const std::size_t n = 3 + rng() % 30;
    plane.add_plane(on_a_grid(rng, n), on_a_grid(rng, n));
    line.add_line(on_a_grid(rng, n));
  }
  Values x, y;
  for (int i = 0; i < 64; ++i) {  // corners of a grid
    x.push_back(i % 8 / 8.0);
    y.push_back(i / 8 / 8.0);
  }
  plane.add_plane(x, y);
  line.expect();
  plane.expect();
}

TEST_CASE("5.6 many points do not take long", "[5.6][points:1][edge]") {
  Rng rng = check_rng();
  const Values x = uniform_values(rng, 1 << 14, 0, 1), y = uniform_values(rng, 1 << 14, 0, 1);
  const auto some = [](const Values& all, std::size_t n) {
    return Values(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(n));
  };
  // For four times as many points N log N takes 4.6 times as long and N^2 16 times; in the plane,
  // N^2 log N 20 times and N^3 64 times. A plain answer takes 3 ms and 30 ms; only above 0.1 s the
  // growth matters, which does not depend on the machine.
  check_growth(
      "star_discrepancy(x)",
      [&](std::size_t n) { return MEASURE_OUTCOME(star_discrepancy_1d, some(x, n)); }, 1 << 14, 8.5,
      "O(N log N)");
  check_growth(
      "star_discrepancy(x, y)",
      [&](std::size_t n) { return MEASURE_OUTCOME(star_discrepancy_2d, some(x, n), some(y, n)); },
      1 << 10, 35, "O(N^2 log N)");
  Discrepancies many;
  many.add_line(uniform_values(rng, 100'003, 0, 1));  // fractions i/n that are added up lose digits
  many.expect();
}

struct Boxes {
  bool open = true, closed = true;
  bool to_1_right = true, to_1_above = true;  ///< includes boxes that end at 1, not at a point
};

/// The largest difference over boxes of these heights that end at the x of a point or at 1.
double worst_box(View x, View y, const Values& heights, Boxes boxes) {
  const auto n = static_cast<double>(x.size());
  std::vector<std::size_t> order(x.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, [&](std::size_t i, std::size_t j) { return x[i] < x[j]; });
  double worst = 0;
  for (const double b : heights) {
    double inside = 0, at_most = 0;  // points in the open box and in the closed box
    const auto look = [&](double a, bool open, bool closed) {
      if (boxes.open && open) worst = std::max(worst, a * b - inside / n);
      if (boxes.closed && closed) worst = std::max(worst, at_most / n - a * b);
    };
    for (std::size_t i = 0; i < order.size();) {
      const double a = x[order[i]];
      look(a, true, false);
      for (; i < order.size() && x[order[i]] == a; ++i) {
        inside += y[order[i]] < b ? 1 : 0;
        at_most += y[order[i]] <= b ? 1 : 0;
      }
      look(a, false, true);
    }
    if (boxes.to_1_right) look(1, true, true);
  }
  return worst;
}

void Discrepancies::add_line(const Values& x) {  // boxes of height 1, points at 0
  add(MEASURE(star_discrepancy_1d, x), x, Values(x.size()), true);
}

void Discrepancies::add_plane(const Values& x, const Values& y) {
  add(MEASURE(star_discrepancy_2d, x, y), x, y, false);
}

void Discrepancies::add(const Measured<double>& got, const Values& x, const Values& y,
                        bool is_line) {
  const auto of = [=](Boxes boxes) {
    Values heights = is_line ? Values{} : y;
    if (is_line || boxes.to_1_above) heights.push_back(1);
    return worst_box(x, y, heights, boxes);
  };
  results_.add(got.call, got.value, of({}), 1e-14, [=]() -> std::vector<Suspect> {
    const Likely
        closed =
            "only open boxes were used: boxes that include the points on their border count, "
            "too"_likely,
        open =
            "only closed boxes were used: boxes that exclude the points on their border count, "
            "too"_likely,
        to_1 = "boxes that end at 1, and not at a point, are missing: they count, too"_likely;
    return {{of({.closed = false}), closed},
            {of({.open = false}), open},
            {of({.to_1_right = false, .to_1_above = false}), to_1},
            {of({.to_1_right = false}), to_1}};
  });
}

void Discrepancies::expect() {
  results_.is_tame = true;
  results_.expect(
      "the largest of |volume - fraction of the points inside| over all boxes",
      "each side of a box ends at 1 or at any point; count the points inside without "
      "those on its upper and right border, and with them; equal points count separately");
}

Values on_a_grid(Rng& rng, std::size_t n) {
  Values x(n);
  for (double& value : x) value = static_cast<double>(rng() % 6) / 5;
  return x;
}

/// The least CPU time of three runs, minus that for a single point.
double cpu_seconds(const std::function<Call(std::size_t)>& measure, std::size_t n) {
  const auto seconds = [&](std::size_t size) {
    const Call call = measure(size);
    if (call.outcome.over_limit()) return infinity;
    require_value(call);
    return call.outcome.cpu_seconds;
  };
  const auto least = [&](std::size_t size) {
    return std::min({seconds(size), seconds(size), seconds(size)});
  };
  return std::max(1e-4, least(n) - least(1));
}

void check_growth(const char* what, const std::function<Call(std::size_t)>& measure, std::size_t n,
                  double most, const std::string& cost) {
  const double few = cpu_seconds(measure, n / 4), many = cpu_seconds(measure, n);
  expect_that(
      many < 0.1 || many < most * few,
      fmt::format("{}: {} points took {} of CPU time, {} took {:.3g} s", what, n,
                  std::isinf(many) ? "too much" : fmt::format("{:.3g} s", many), n / 4, few),
      fmt::format("at most {} times as long", most), "the header promises " + cost,
      "count the points inside by sorting, not separately for each box");
}

}  // namespace
}  // namespace mc::checks
