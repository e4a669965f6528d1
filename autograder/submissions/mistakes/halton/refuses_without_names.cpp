// mistake: every refusal has the same message, which names no argument
// fails: 5.1, 5.2, 5.3, 5.5, 5.6, 5.9, 5.10
// hint: name the wrong argument in the exception's message
#include "halton.hpp"

#include <stdexcept>
#include <string>

#define invalid_argument(message) invalid_argument("not valid")
#include "solutions/halton.cpp"
