// mistake: every refusal throws std::runtime_error
// fails: 5.1, 5.2, 5.3, 5.5, 5.6, 5.9, 5.10
// hint: wrong type of exception
#include "halton.hpp"

#include <stdexcept>
#include <string>

#define invalid_argument runtime_error
#include "solutions/halton.cpp"
