#include <iterator>

#include "checks/support/checks.hpp"

namespace mc::checks {
namespace {

/// Whether the integer parts of the values are 0 … strata-1, equally often: a division is missing.
/// If the values of the first row are sorted, the row number is wrong instead.
bool are_undivided(View x, std::size_t strata) {
  const auto cell = [=](double value) { return std::floor(value * static_cast<double>(strata)); };
  const auto end = std::ranges::find_if(x, [](double value) { return !(value < 1); });
  const bool is_in_order = std::is_sorted(
      x.begin(), end, [&](double one, double other) { return cell(one) < cell(other); });
  if (is_in_order && end - x.begin() >= 8) return false;
  std::vector<std::size_t> counts(strata);
  for (const double value : x) {
    if (!(value >= 0 && value < static_cast<double>(strata))) return false;
    ++counts[static_cast<std::size_t>(value)];
  }
  return strata > 1 &&
         std::ranges::all_of(counts, [&](std::size_t c) { return c * strata == x.size(); });
}

}  // namespace

void require_in_cube(const std::string& call, const std::string& name, View x, std::size_t strata,
                     std::size_t other) {
  const auto odd =
      std::ranges::find_if_not(x, [](double value) { return value >= 0 && value < 1; });
  if (odd == x.end()) return;
  const auto at = static_cast<std::size_t>(odd - x.begin());
  const auto is_nan = [](double value) { return std::isnan(value); };
  const auto is_in_turned_grid = [scale = static_cast<double>(other) / static_cast<double>(strata)](
                                     double value) { return value >= 0 && value * scale < 1; };
  Likely cause;
  if (std::ranges::all_of(x, is_nan)) {
    cause = "all values are NaN: they were never written, or only added to (+=)"_likely;
  } else if (is_nan(*odd) && std::all_of(odd, x.end(), is_nan)) {
    cause = likely("the last {} of {} values were never written", x.size() - at, x.size());
  } else if (is_nan(*odd)) {
    cause = "this value was never written, or is 0/0"_likely;
  } else if (*odd == 1) {
    cause = "it was rounded up to 1: keep it below the upper edge of its stratum"_likely;
  } else if (other > 1 && std::ranges::all_of(x, is_in_turned_grid)) {
    cause = likely("divided by {}, the strata of the other axis: nx and ny are swapped", other);
  } else if (are_undivided(x, strata)) {
    cause = likely("divide by the number of strata, {}", strata);
  }
  refuse(call,
         {fmt::format("gave {}[{}] = {}", name, at, *odd),
          *odd == 1 ? "numbers in [0, 1): the upper faces of the unit cube do not belong to it"
                    : "numbers in [0, 1)",
          "", cause});
}

SampleSets sets_from_xy(std::string call, View x, View y, std::span<const std::uint64_t> sizes) {
  Values values;
  values.reserve(2 * x.size());
  std::size_t first = 0;
  for (const std::uint64_t size : sizes) {
    for (const View all : {x, y}) append(values, all.subspan(first, size));
    first += size;
  }
  return {std::move(call), sizes, 2, std::move(values)};
}

SampleSets sets_from_columns(const Measured<Values>& got, std::size_t n, std::size_t dims,
                             std::size_t sets, std::size_t strata) {
  SampleSets all(got.call, sets, n, dims, got.exactly(n * dims * sets, any_number));
  for (std::size_t set = 0; set < sets; ++set) {
    for (std::size_t d = 0; d < dims; ++d) {
      const std::string name = dims == 1 ? "x" : fmt::format("column {}, x", d);
      require_in_cube(got.call, name, all.column(set, d), strata);
    }
  }
  return all;
}

Uniforms jitters_of(const SampleSets& sets, std::span<const Pattern> patterns,
                    const std::string& elsewhere) {
  Uniforms jitters{sets.call, 0};
  for (const Pattern& pattern : patterns) jitters.positions += sets.n * pattern.dims.size();
  jitters.values.resize(sets.size() * jitters.positions);
  std::vector<std::size_t> axis_of;  // the dimension of every n positions
  for (std::size_t set = 0; set < sets.size(); ++set) {
    std::size_t first = set * jitters.positions;
    for (const Pattern& pattern : patterns) {
      const auto cells = expect_one_in_each_cell(sets, set, pattern, elsewhere);
      for (std::size_t i = 0; i < pattern.dims.size(); ++i, first += sets.n) {
        const View column = sets.column(set, pattern.dims[i]);
        jitters.bits = std::min(jitters.bits, bits_of_jitter(pattern.strata[i]));
        for (std::size_t k = 0; k < sets.n; ++k) {
          jitters.values[first + cells[k]] = jitter_of(column[k], pattern.strata[i]);
        }
        if (set == 0) axis_of.push_back(pattern.dims[i]);
      }
    }
  }
  jitters.name = [axis_of, n = sets.n, dims = sets.dims](std::size_t position) {
    const std::size_t d = axis_of[position / n];
    return fmt::format("the jitter of {} in cell {}",
                       dims <= 2 ? (d == 0 ? "x" : "y") : fmt::format("coordinate {}", d),
                       position % n);
  };
  return jitters;
}

std::size_t common_values(View a, View b) {
  Values x(a.begin(), a.end()), y(b.begin(), b.end()), common;
  std::ranges::sort(x);
  std::ranges::sort(y);
  std::set_intersection(x.begin(), x.end(), y.begin(), y.end(), std::back_inserter(common));
  return common.size();
}

void expect_fresh(const SampleSets& sets, const SampleSets& other_seed,
                  std::span<const Pattern> patterns) {
  for (const Pattern& pattern : patterns) {
    for (std::size_t i = 0; i < pattern.dims.size(); ++i) {
      const std::size_t d = pattern.dims[i];
      const View a = sets.column(0, d);
      const std::pair<View, const char*> others[] = {
          {sets.column(1, d), "two consecutive sets"},
          {other_seed.column(0, d), "a set with another seed"}};
      for (const auto& [b, where] : others) {
        if (2 * common_values(a, b) <= a.size()) continue;
        const Values jitters =
            each(a, [&](double value) { return jitter_of(value, pattern.strata[i]); });
        const auto [low, high] = std::ranges::minmax_element(jitters);
        fail(Failure{
            fmt::format("{}: coordinate {} is the same in {}", sets.call, d, where),
            "different points in each set and for each seed",
            "estimates are unbiased only if points are random",
            *high - *low < 1e-6
                ? likely("every point lies at {:.3g} of its stratum: choose a random place", *low)
                : "the same numbers are used again: draw new ones from the "
                  "given generator"_likely});
      }
    }
  }
  pass();
}

}  // namespace mc::checks
