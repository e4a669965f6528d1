// mistake: every refusal has the same message, which names no argument
// fails: 2.6, 2.9
// hint: name the wrong argument in the exception's message
#include "independent.hpp"

#include <stdexcept>
#include <string>

#define invalid_argument(message) invalid_argument("not valid")
#include "solutions/independent.cpp"
