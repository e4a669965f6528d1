#pragma once
// Results of several lists, compared together.

#include <string>

#include <fmt/format.h>

#include "1-variance/experiments.hpp"
#include "checks/support/compare.hpp"
#include "floors.hpp"
#include "suspects.hpp"

namespace mc::checks {

/// Sample variances: `measure` asks for that of a list, `floor` gives the digits it keeps.
template <class Measure, class Floor>
Results variances_of(const std::vector<List>& lists, Measure measure, Floor floor) {
  Results variances;
  for (const List& list : lists) {
    const auto got = measure(list.x);
    variances.add_digits(got.call + list.name, got.value, list.exact.variance, floor(list.exact),
                         [&list] { return variance_suspects(list); });
  }
  return variances;
}

/// NaN for fewer than two values; neither finite for values without a finite variance.
template <class Measure>
void expect_no_variance(Rng& rng, Measure measure) {
  for (const Values& x : {Values{uniform(rng, -1, 1)}, Values{}}) {
    const auto got = measure(x);
    expect_nan(got.call, got.value, "a sample variance needs two values; " + because_undefined);
  }
  for (const Values& x : without_finite_variance(rng)) {
    const auto got = measure(x);
    expect_no_number(got.call, got.value, x);
  }
}

class MomentsResults {
 public:
  /// Ends the check where the count is wrong. `list` must outlive these results.
  void add(const std::string& call, const Moments& got, const List& list, double m2_floor) {
    expect_that(got.count == list.x.size(), fmt::format("{}.count = {}", call, got.count),
                fmt::format("{}", list.x.size()), "",
                got.count == 0 ? "count is never set"
                               : "every value counts once, also those in a last, shorter block");
    const auto mean = static_cast<double>(list.exact.mean), m2 = static_cast<double>(list.exact.m2);
    means_.add(call + ".mean" + list.name, got.mean, mean, mean_tolerance(list.exact),
               [&list] { return mean_suspects(list); });
    m2s_.add_digits(call + ".m2" + list.name, got.m2, m2, m2_floor,
                    [&list] { return m2_suspects(list); });
  }

  void expect(const std::string& because, const std::string& of_mean, const std::string& of_m2) {
    means_.is_tame = m2s_.is_tame = is_tame;
    means_.expect(because, of_mean);
    m2s_.expect(because, of_m2);
  }

  bool is_tame = false;

 private:
  Results means_, m2s_;
};

/// Moments{}: count, mean and m2 are 0.
inline void expect_nothing(const std::string& call, const Moments& got, const std::string& hint) {
  expect_that(got.count == 0 && got.mean == 0 && got.m2 == 0, call + " = " + shown(got),
              "count, mean and m2 all 0", "there are no values", hint);
}

}  // namespace mc::checks
