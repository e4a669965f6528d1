#pragma once
// One comparison of measured values with exact ones, value by value. Where they differ, the report
// names a mistake only if the mistake explains every value; otherwise it says where the wrong
// values are, and no more.

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "checks/support/validation.hpp"

namespace mc::checks {

/// A value that a well-known mistake would give, and what to say if that is what was measured.
struct Suspect {
  double value;
  std::string hint;
};

/// What a well-known mistake gives for all inputs.
struct Curve {
  std::vector<double> values;
  std::string hint;
};

/// `f` of each input.
template <class Inputs, class Function>
std::vector<double> each(const Inputs& inputs, Function f) {
  std::vector<double> values;
  for (const auto& input : inputs) values.push_back(f(input));
  return values;
}

struct Comparison {
  std::vector<double> exact;  ///< NaN where the value is undefined and must be NaN
  /// Of each value, or one for all: |measured - exact| <= tolerance. 0 wants the very value.
  std::vector<double> tolerance = {0};
  std::string because = {};  ///< where the tolerance comes from, or why the values are exact
  std::vector<Curve> suspects = {};
  std::string otherwise = {};  ///< the hint if no suspect explains the values
  /// Names value i: "mean({1, 2})"; by default the call, then [i].
  std::function<std::string(std::size_t)> name = {};
  /// The values are results of separate calls: then suspects about lists (a last value that is
  /// missing, values shifted by one, in reverse) make no sense.
  bool separate_calls = false;
  bool in_digits = false;  ///< the report counts the correct digits instead of saying the tolerance
  bool is_tame = false;    ///< results with seven digits or so show that a float was used
};

/// Measured values, one for each exact one.
struct MeasuredValues {
  std::string call;
  std::span<const double> values;
};

/// Every value is within its tolerance. Of the suspects, and of those that every comparison has
/// (values rounded to float, unwritten, added to what was there, shifted by one, reversed, sign,
/// square, root, reciprocal, a constant factor or offset, constant), one is named if it explains
/// all values, the wrong ones and the right ones, and no other does so with another hint. It
/// explains a wrong value if it is a hundred times nearer to it than the exact value is.
void expect_each(const MeasuredValues& measured, const Comparison& comparison);

/// Results of separate calls, which are compared together: a mistake is named if it explains all of
/// them. What mistakes give is computed only where the comparison fails.
class Results {
 public:
  /// The same mistakes of each call, in the same order.
  using FindSuspects = std::function<std::vector<Suspect>()>;

  void add(std::string call, double got, double exact, double tolerance, FindSuspects find = {});
  /// The same with a tolerance in correct digits of `exact`, or of the last bits of a denormal.
  void add_digits(std::string call, double got, double exact, double floor, FindSuspects find = {});

  /// Every result is within its tolerance. `because` says where the tolerances come from.
  void expect(const std::string& because, const std::string& otherwise);

  bool is_tame = false;  ///< as in Comparison

 private:
  std::vector<std::string> calls_;
  std::vector<double> values_;
  std::vector<FindSuspects> suspects_;
  Comparison comparison_ = {.exact = {}, .tolerance = {}, .separate_calls = true};
};

/// The digits of `exact` that `got` has: -log10 of the relative error (of the error, where `exact`
/// is 0). 17 where they are equal, else -99 where one of them is not finite.
double digits(double got, double exact);

/// The same without ending a check: what it would say.
std::optional<Failure> difference(const MeasuredValues& measured, const Comparison& comparison);

}  // namespace mc::checks
