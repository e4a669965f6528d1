// mistake: the quantile that leaves half outside is negative: low and high change places
// caught by: 2.5 a confidence interval
// caught by: 2.5 intervals of normal samples cover as often as theory says
// caught by: 2.5 intervals of rare events cover as rarely as theory says
// hint: low and high are the wrong way round
#include "independent.hpp"

#define confidence_interval right_confidence_interval
#include "solutions/independent.cpp"
#undef confidence_interval

namespace mc {

Interval confidence_interval(const Estimate& estimate, double level) {
  if (!(level > 0 && level < 1)) throw std::invalid_argument("level: must lie inside (0, 1)");
  const double reach = normal_quantile((1 - level) / 2) * estimate.standard_error;
  return {estimate.value - reach, estimate.value + reach};
}

}  // namespace mc
