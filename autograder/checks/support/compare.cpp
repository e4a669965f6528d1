#include "checks/support/checks.hpp"

namespace mc::checks {
namespace {

class Agreement {
 public:
  explicit Agreement(const Comparison& comparison) : tolerance_(comparison.tolerance) {}
  double tolerance(std::size_t i) const { return tolerance_[tolerance_.size() == 1 ? 0 : i]; }
  bool agree(double a, double b, std::size_t i) const {
    return a == b || (std::isnan(a) && std::isnan(b)) || std::abs(a - b) <= tolerance(i);
  }
  /// A suspect's values are computed in a different order than the submission's: nine digits must
  /// agree, or the tolerance holds. It must also be much closer than the exact value: if only the
  /// last digits are wrong, most suspects share the others.
  bool is_explained(double got, double exact, double suspected, std::size_t i) const {
    if (!std::isfinite(got) || !std::isfinite(suspected)) return agree(got, suspected, i);
    const double apart = std::abs(got - suspected), error = std::abs(got - exact);
    if (!agree(got, suspected, i) && apart > 1e-9 * std::abs(suspected)) return false;
    return agree(got, exact, i) || !(apart > error / 100);
  }

 private:
  std::span<const double> tolerance_;
};

/// The factor, if got = factor * exact for all values.
std::optional<double> common_factor(std::span<const double> got, std::span<const double> exact) {
  std::optional<double> factor;
  for (std::size_t i = 0; i < got.size(); ++i) {
    if (exact[i] == 0 && got[i] == 0) continue;
    const double here = got[i] / exact[i];
    if (!std::isfinite(here) || here == 0) return {};
    if (!factor) factor = here;
    if (std::abs(here - *factor) > 1e-9 * std::abs(*factor)) return {};
  }
  return factor;
}

std::vector<Curve> generic_suspects(std::span<const double> got, const Comparison& comparison) {
  const std::span<const double> exact = comparison.exact;
  const std::size_t n = exact.size();
  std::vector<Curve> all{
      {std::vector<double>(n, nan),
       comparison.separate_calls
           ? "all results are NaN: look for 0/0, inf/inf and inf - inf"_likely
           : "all values are NaN: never written, only added to, or 0/0"_likely},
      {std::vector<double>(n, 0.0), comparison.separate_calls && !comparison.rule.empty()
                                        ? likely("all results are 0: {}", comparison.rule)
                                        : "all values are 0"_likely}};
  if (n < 3) return all;
  if (const auto factor = common_factor(got, exact); factor && std::abs(*factor - 1) > 1e-6) {
    all.push_back({each(exact, [&](double x) { return *factor * x; }),
                   likely("all values are {:.6g} times as large as they should be", *factor)});
  }
  if (comparison.separate_calls || !std::isnan(got[n - 1])) return all;
  std::vector<double> unwritten(exact.begin(), exact.end());
  unwritten[n - 1] = got[n - 1];
  all.push_back({unwritten, "the last value was never written"_likely});
  return all;
}

/// The hint if all values beyond some limit became that limit.
Likely limit_hint(std::span<const double> got, std::span<const double> exact,
                  const Agreement& agreement) {
  std::optional<double> limit;
  std::size_t wrong = 0, above = 0, right_above = 0, right_below = 0;
  for (std::size_t i = 0; i < got.size(); ++i) {
    if (agreement.agree(got[i], exact[i], i)) continue;
    if (limit && got[i] != *limit) return {};
    limit = got[i];
    ++wrong;
    above += exact[i] > got[i] ? 1u : 0u;
  }
  for (std::size_t i = 0; limit && i < got.size(); ++i) {
    if (!agreement.agree(got[i], exact[i], i)) continue;
    (exact[i] > *limit ? right_above : right_below) += exact[i] == *limit ? 0u : 1u;
  }
  const bool is_upper = above == wrong && right_above == 0;
  const bool is_lower = above == 0 && right_below == 0;
  if (wrong < 2 || right_above + right_below < 2 * wrong || !(is_upper || is_lower)) return {};
  return likely("no value is {} {}: something limits the values", is_upper ? "above" : "below",
                *limit);
}

/// Whether the wrong values have the digits of a float, and most values are wrong: a float holds
/// some values exactly. The first value is an ordinary one.
bool are_of_float(std::span<const double> got, std::span<const double> exact,
                  const Agreement& agreement) {
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < got.size(); ++i) {
    if (agreement.agree(got[i], exact[i], i)) continue;
    const double kept = digits(got[i], exact[i]);
    if (i == 0 ? kept <= 5 || kept >= 9 : kept <= 2 || kept >= 12) return false;
    ++wrong;
  }
  return 4 * wrong > 3 * got.size();
}

/// The largest relative error, if it is so small that the formula must be right.
std::optional<double> small_error(std::span<const double> got, std::span<const double> exact,
                                  const Agreement& agreement) {
  double error = 0;
  for (std::size_t i = 0; i < got.size(); ++i) {
    if (agreement.agree(got[i], exact[i], i)) continue;
    error = std::max(error, std::pow(10, -digits(got[i], exact[i])));
  }
  return error < 1e-5 ? std::optional(error) : std::nullopt;
}

Likely hint_for(std::span<const double> got, const Comparison& comparison,
                const Agreement& agreement) {
  const auto explains = [&](const Curve& curve) {
    if (curve.values.size() != got.size()) return false;
    bool differs = false;  // from the exact values: otherwise it is not a mistake
    for (std::size_t i = 0; i < got.size(); ++i) {
      if (!agreement.is_explained(got[i], comparison.exact[i], curve.values[i], i)) return false;
      differs = differs || !agreement.agree(curve.values[i], comparison.exact[i], i);
    }
    return differs;
  };
  const auto only_one = [&](const std::vector<Curve>& curves) -> std::optional<Likely> {
    std::optional<Likely> hint;
    for (const Curve& curve : curves) {
      if (!explains(curve)) continue;
      if (hint && *hint != curve.hint) return Likely{};  // two explanations
      hint = curve.hint;
    }
    return hint;
  };
  // The check's own suspects come first: they are more specific.
  if (const auto hint = only_one(comparison.suspects)) return *hint;
  const bool is_undefined = std::isnan(comparison.exact[0]);
  if (is_undefined || std::ranges::any_of(got, [](double x) { return std::isinf(x); })) {
    return {};  // an overflow hides what was computed
  }
  if (const auto hint = only_one(generic_suspects(got, comparison))) return *hint;
  if (comparison.is_tame && are_of_float(got, comparison.exact, agreement)) {
    return "only about seven digits are correct, as in a float: use double everywhere"_likely;
  }
  if (auto limited = limit_hint(got, comparison.exact, agreement); limited != Likely{})
    return limited;
  if (const auto error = small_error(got, comparison.exact, agreement);
      error && comparison.is_tame) {
    return likely(
        "almost right, with relative errors of up to {:.1g}: look for a difference of nearly equal "
        "numbers, a float, a rounded constant or a limit",
        *error);
  }
  return {};
}

/// "3rd", "11th", "22nd".
std::string ordinal(std::size_t number) {
  const std::size_t last = number / 10 % 10 == 1 ? 0 : number % 10;
  return fmt::format("{}{}", number, last == 1 ? "st" : last == 2 ? "nd" : last == 3 ? "rd" : "th");
}

/// Which of `count` values are wrong, in words: "all", "the last 3", "every 4th, from 2 on".
/// `wrong` has their indices in ascending order.
std::string pattern_of(std::span<const std::size_t> wrong, std::size_t count) {
  const std::size_t n = wrong.size();
  if (n == count) return count == 1 ? "" : "all of them are wrong";
  const auto of_all = fmt::format(" of {} values", count);
  if (n == 1) return fmt::format("only value {}{} is wrong", wrong[0], of_all);
  const bool in_a_row = wrong[n - 1] - wrong[0] + 1 == n;
  if (in_a_row && wrong[n - 1] == count - 1) {
    return fmt::format("the last {}{} are wrong, from value {} on", n, of_all, wrong[0]);
  }
  if (in_a_row && wrong[0] == 0) return fmt::format("the first {}{} are wrong", n, of_all);
  const std::size_t step = wrong[1] - wrong[0];
  bool is_regular = n >= 3 && wrong[n - 1] + step >= count;
  for (std::size_t k = 1; k < n; ++k) is_regular = is_regular && wrong[k] - wrong[k - 1] == step;
  if (is_regular && !in_a_row) {
    return fmt::format("{}{} are wrong: every {}, from value {} on", n, of_all,
                       step == 2 ? "other" : ordinal(step), wrong[0]);
  }
  return fmt::format("{}{} are wrong, the first is value {}", n, of_all, wrong[0]);
}

/// Which sizes of the inputs are wrong, if all large ones are and no small one is.
std::string sizes_in_words(std::span<const std::size_t> wrong, std::span<const double> sizes) {
  double least = infinity, most = 0;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    const bool is_wrong = std::ranges::binary_search(wrong, i);
    (is_wrong ? least : most) = is_wrong ? std::min(least, sizes[i]) : std::max(most, sizes[i]);
  }
  const bool is_clear = most > 0 && least > most;
  return is_clear ? fmt::format("; all of {} values or more, none of up to {}", least, most) : "";
}

}  // namespace

double digits(double got, double exact) {
  if (got == exact) return 17;
  if (!std::isfinite(got) || !std::isfinite(exact)) return -99;
  const double error = std::abs(got - exact);
  return std::min(17.0, -std::log10(exact == 0 ? error : error / std::abs(exact)));
}

std::optional<Failure> difference(const MeasuredValues& measured, const Comparison& comparison) {
  const Agreement agreement(comparison);
  const std::span<const double> got = measured.values;
  if (got.size() != comparison.exact.size()) {
    return Failure{fmt::format("{} gave {} values", measured.call, got.size()),
                   fmt::format("{} values", comparison.exact.size()), comparison.because};
  }
  std::vector<std::size_t> wrong;
  for (std::size_t i = 0; i < got.size(); ++i) {
    if (!agreement.agree(got[i], comparison.exact[i], i)) wrong.push_back(i);
  }
  if (wrong.empty()) return {};
  const std::size_t first = wrong[0];
  const std::string name = comparison.name
                               ? comparison.name(first)
                               : measured.call + (got.size() > 1 ? fmt::format("[{}]", first) : "");
  const std::string pattern =
      pattern_of(wrong, got.size()) + sizes_in_words(wrong, comparison.sizes);
  const double exact = comparison.exact[first], tolerance = agreement.tolerance(first);
  const double found = digits(got[first], exact);
  return Failure{fmt::format("{} = {}{}{}", name, got[first], pattern.empty() ? "" : "; ", pattern),
                 std::isnan(exact) ? "NaN"
                 : tolerance == 0  ? fmt::format("{}, exactly", exact)
                 : comparison.in_digits && exact != 0
                     ? fmt::format("{}: {:.1f} correct digits needed, {}", exact,
                                   -std::log10(tolerance / std::abs(exact)),
                                   std::isfinite(got[first])
                                       ? fmt::format("{:.1f} found", std::max(0.0, found))
                                       : "no number found")
                     : fmt::format("{} ± {:.3g}", exact, tolerance),
                 comparison.because, hint_for(got, comparison, agreement), comparison.rule};
}

void Results::add(std::string call, double got, double exact, double tolerance, FindSuspects find,
                  std::size_t size) {
  calls_.push_back(std::move(call));
  values_.push_back(got);
  comparison_.exact.push_back(exact);
  comparison_.tolerance.push_back(tolerance);
  comparison_.sizes.push_back(static_cast<double>(size));
  suspects_.push_back(std::move(find));
}

void Results::add_digits(std::string call, double got, double exact, double floor,
                         FindSuspects find, std::size_t size) {
  constexpr double last_bits = 4 * std::numeric_limits<double>::denorm_min();
  add(std::move(call), got, exact, std::pow(10, -floor) * std::abs(exact) + last_bits,
      std::move(find), size);
  comparison_.in_digits = true;
}

void Results::expect(const std::string& because, const std::string& rule) {
  comparison_.because = because;
  comparison_.rule = rule;
  comparison_.is_tame = is_tame;
  comparison_.name = [this](std::size_t i) { return calls_[i]; };
  if (!difference({"", values_}, comparison_)) return pass();
  for (const FindSuspects& find : suspects_) {
    const std::vector<Suspect> suspects = find ? find() : std::vector<Suspect>{};
    comparison_.suspects.resize(std::max(comparison_.suspects.size(), suspects.size()));
    for (std::size_t k = 0; k < suspects.size(); ++k) {
      comparison_.suspects[k].values.push_back(suspects[k].value);
      comparison_.suspects[k].hint = suspects[k].hint;
    }
  }
  expect_each({"", values_}, comparison_);
}

void expect_each(const MeasuredValues& measured, const Comparison& comparison) {
  if (const auto failure = difference(measured, comparison)) fail(*failure);
  pass();
}

}  // namespace mc::checks
