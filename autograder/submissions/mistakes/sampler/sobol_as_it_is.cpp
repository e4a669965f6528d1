// mistake: does not scramble the Sobol' sequence
// caught by: 6.3 each seed and each dimension is randomised anew
// hint: a sequence as it is has the origin for its first point
#include "sampler.hpp"

namespace mc {
namespace {

void leave(std::span<double>, std::uint64_t) {}

}  // namespace
}  // namespace mc

#define owen_scramble leave
#include "solutions/sampler.cpp"
