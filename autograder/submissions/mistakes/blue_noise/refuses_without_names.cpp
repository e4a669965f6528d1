// mistake: every refusal has the same message, which names no argument
// fails: 4.2, 4.3, 4.4, 4.5, 4.6
// hint: name the wrong argument in the exception's message
#include "blue_noise.hpp"

#include <stdexcept>
#include <string>

#define invalid_argument(message) invalid_argument("not valid")
#include "solutions/blue_noise.cpp"
