#include "suspects.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "known_ways.hpp"

namespace mc::checks {

std::vector<Suspect> nearest(double got, double exact, std::vector<Suspect> suspects) {
  std::erase_if(suspects, [=](const Suspect& suspect) {
    return std::isfinite(suspect.value) &&
           !(std::abs(got - suspect.value) <= std::abs(got - exact) / 100);
  });
  return suspects;
}

std::vector<Suspect> scale_suspects(const ExactMoments& exact) {
  const double n = exact.count;
  return {{exact.variance * (n - 1) / n,
           "this divides by n; a sample variance divides by n - 1 (and n/(n-1) of whole numbers is "
           "1)"},
          {exact.variance * n / (n - 1), "n/(n-1) is in here twice: once is enough"},
          {exact.variance * (n - 1), "this is the sum of squared deviations, not divided yet"},
          {std::sqrt(exact.variance), "this is the standard deviation: the variance is its square"},
          {-exact.variance, "the sign is wrong: E{X^2} is the larger one"}};
}

Hints variance_hints(double got, std::span<const double> x, const ExactMoments& exact,
                     const std::string& otherwise) {
  const double n = exact.count;
  const double mean_square = static_cast<double>(exact.m2 / Exact(n) + exact.mean * exact.mean);
  const double mean_in_whole_numbers = sum_in_whole_numbers(x) / n;
  const double about_it = mean_square -
                          2 * mean_in_whole_numbers * static_cast<double>(exact.mean) +
                          mean_in_whole_numbers * mean_in_whole_numbers;
  auto suspects = scale_suspects(exact);
  suspects.push_back({mean_square, "this is E{X^2}: take E{X}^2 off"});
  suspects.push_back({mean_square * n / (n - 1), "this is E{X^2} n/(n-1): the mean is not in it"});
  for (const double around :
       {about_it, mean_square - mean_in_whole_numbers * mean_in_whole_numbers}) {
    suspects.push_back({around * n / (n - 1),
                        "this has a mean in it that was added up in whole numbers: "
                        "std::accumulate(…, 0) adds in int; begin with 0.0"});
  }
  suspects.push_back({0,
                      "the squares add up to 0: in whole numbers? std::accumulate(…, 0) adds in "
                      "int; begin with 0.0"});
  return {nearest(got, exact.variance, std::move(suspects)),
          or_float(got, exact.variance, otherwise)};
}

Hints hard_variance_hints(double got, std::span<const double> x, const ExactMoments& exact,
                          const std::string& otherwise) {
  auto suspects = scale_suspects(exact);
  suspects.push_back({textbook_from_means(x), large_numbers});
  suspects.push_back({textbook_from_sums(x), large_numbers});
  suspects.push_back({uncorrected_here(x), uncorrected});
  suspects.push_back({welford_here(x).m2 / (exact.count - 1), running_mean});
  return {nearest(got, exact.variance, std::move(suspects)),
          otherwise + kept_by_known_ways(x, exact)};
}

Hints welford_hints(double got, std::span<const double> x, const ExactMoments& exact,
                    double divided, const std::string& otherwise) {
  const Welford sums = welford_here(x);
  const double m2 = static_cast<double>(exact.m2), n = exact.count;
  return {nearest(got, m2 / divided,
                  {{sums.from_old_means / divided,
                    "m2 grows by (x - old mean)(x - new mean); this is the old one, twice"},
                   {sums.from_new_means / divided,
                    "m2 grows by (x - old mean)(x - new mean); this is the new one, twice"},
                   {sums.about_first / divided,
                    "the mean never moves from the first value: is 1 / count an integer division, "
                    "which is 0?"},
                   {m2 / (n - 1) / divided, "m2 is a sum: variance() divides it, once"},
                   {m2 * n / (n - 1) / divided,
                    "this is n times the sample variance: m2 is n - 1 times it"}}),
          otherwise, late_count};
}

std::string or_float(double got, double exact, const std::string& otherwise) {
  const double kept = digits(got, exact);
  return kept > 5 && kept < 9 ? "a float keeps seven digits or so: is anything here a float?"
                              : otherwise;
}

std::string kept_by_known_ways(std::span<const double> x, const ExactMoments& exact) {
  const auto kept = [&](double variance) {
    return std::clamp(digits(variance, exact.variance), 0.0, 16.0);
  };
  return fmt::format(
      "; of these data E{{X^2}} - E{{X}}^2 keeps {:.1f} digits, Welford's update {:.1f}, two "
      "corrected passes {:.1f}",
      std::max(kept(textbook_from_means(x)), kept(textbook_from_sums(x))),
      kept(welford_here(x).m2 / (exact.count - 1)), kept(two_pass_here(x)));
}

}  // namespace mc::checks
