// mistake: every refusal has the same message, which names no argument
// fails: 1.6, 1.7
// hint: name the wrong argument in the exception's message
#include "variance.hpp"

#include <stdexcept>
#include <string>

#define invalid_argument(message) invalid_argument("not valid")
#include "solutions/variance.cpp"
