// mistake: every refusal has the same message, which names no argument
// fails: 3.2, 3.3, 3.5, 3.7, 3.8, 3.9
// hint: name the wrong argument in the exception's message
#include "stratification.hpp"

#include <stdexcept>
#include <string>

#define invalid_argument(message) invalid_argument("not valid")
#include "solutions/stratification.cpp"
