// mistake: every refusal has the same message, which names no argument
// fails: 6.1, 6.4, 6.6
// hint: name the wrong argument in the exception's message
#include "sampler.hpp"

#include <stdexcept>
#include <string>

#define invalid_argument(message) invalid_argument("not valid")
#include "solutions/sampler.cpp"
