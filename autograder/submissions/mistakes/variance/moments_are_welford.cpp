// mistake: adds value by value to a mean that is rounded where the data are
// caught by: 1.8 the moments keep their digits on hard data
// hint: these are the digits of a running mean
#include "variance.hpp"
#define moments right_moments
#include "solutions/variance.cpp"
#undef moments

namespace mc {

Moments moments(std::span<const double> x) {
  Moments all;
  for (double value : x) add(all, value);
  return all;
}

}  // namespace mc
