// mistake: every refusal throws std::runtime_error
// fails: 6.1, 6.4, 6.6
// hint: wrong type of exception
#include "sampler.hpp"

#include <stdexcept>
#include <string>

#define invalid_argument runtime_error
#include "solutions/sampler.cpp"
