#pragma once
// Compares measured values with exact ones. If they differ, the report names a mistake only if that
// mistake explains every value; otherwise it only says which values are wrong.

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "checks/support/validation.hpp"

namespace mc::checks {

/// The value that a well-known mistake gives, and the hint if that value is measured.
struct Suspect {
  double value;
  Likely hint;
};

/// The values that a well-known mistake gives for all inputs.
struct Curve {
  std::vector<double> values;
  Likely hint;
};

template <class Inputs, class Function>
std::vector<double> each(const Inputs& inputs, Function f) {
  std::vector<double> values;
  for (const auto& input : inputs) values.push_back(f(input));
  return values;
}

struct Comparison {
  std::vector<double> exact;  ///< NaN where the value is undefined and must be NaN
  /// One tolerance per value, or a single one, for |measured - exact|. 0 requires exact equality.
  std::vector<double> tolerance = {0};
  std::string because = {};  ///< the reason for the tolerance, or for exactness
  std::vector<Curve> suspects = {};
  std::string rule = {};           ///< the hint if no suspect explains the values
  std::vector<double> sizes = {};  ///< of the inputs: are only large ones wrong?
  /// Names value i: "mean({1, 2})"; the default is the call and [i].
  std::function<std::string(std::size_t)> name = {};
  /// The values are results of separate calls: suspects about lists (a missing last value, values
  /// shifted by one or reversed) do not apply.
  bool separate_calls = false;
  bool in_digits = false;  ///< report correct digits instead of the tolerance
  bool is_tame = false;    ///< seven correct digits mean that a float was used
};

struct MeasuredValues {
  std::string call;
  std::span<const double> values;
};

/// Every value is within its tolerance. A suspect is named if it explains all values, wrong and
/// correct ones, and no suspect with a different hint does. It explains a wrong value if it is a
/// hundred times closer to it than the exact value is. Some suspects belong to every comparison:
/// values rounded to float, unwritten, shifted by one, reversed, negated, squared, constant, …
void expect_each(const MeasuredValues& measured, const Comparison& comparison);

/// Results of separate calls, compared together: a mistake is named if it explains all of them. The
/// suspects are computed only if the comparison fails.
class Results {
 public:
  /// Must return the same mistakes for each call, in the same order.
  using FindSuspects = std::function<std::vector<Suspect>()>;

  void add(std::string call, double got, double exact, double tolerance, FindSuspects find = {},
           std::size_t size = 0);
  /// The same with a tolerance in correct digits of `exact`, or in the last bits of a denormal.
  void add_digits(std::string call, double got, double exact, double floor, FindSuspects find = {},
                  std::size_t size = 0);

  /// Every result is within its tolerance. `because` is the reason for the tolerances.
  void expect(const std::string& because, const std::string& rule);

  bool is_tame = false;  ///< as in Comparison

 private:
  std::vector<std::string> calls_;
  std::vector<double> values_;
  std::vector<FindSuspects> suspects_;
  Comparison comparison_ = {.exact = {}, .tolerance = {}, .separate_calls = true};
};

/// The number of correct digits: -log10 of the relative error (of the error, if `exact` is 0). 17
/// if both are equal, otherwise -99 if one of them is not finite.
double digits(double got, double exact);

/// The failure that expect_each() would report.
std::optional<Failure> difference(const MeasuredValues& measured, const Comparison& comparison);

}  // namespace mc::checks
