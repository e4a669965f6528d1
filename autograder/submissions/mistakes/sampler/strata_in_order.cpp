// mistake: does not shuffle: sample i is in stratum i of every sample dimension
// fails: 6.2
// hint: the pattern must be shuffled
#include "sampler.hpp"

namespace mc {
namespace {

void leave(std::span<double>, Rng&) {}

}  // namespace
}  // namespace mc

#define shuffle leave
#include "solutions/sampler.cpp"
