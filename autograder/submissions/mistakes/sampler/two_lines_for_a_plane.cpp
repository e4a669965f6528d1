// mistake: a next2() is a pattern for x and another one for y
// fails: 6.2
// hint: two 1D patterns are not a 2D pattern
#include "sampler.hpp"

namespace mc {
namespace {

void two_lines(std::span<double> x, std::span<double> y, Grid, Rng& rng) {
  stratified_1d(x, rng);
  shuffle(x, rng);
  stratified_1d(y, rng);
}

}  // namespace
}  // namespace mc

#define multi_jittered two_lines
#include "solutions/sampler.cpp"
