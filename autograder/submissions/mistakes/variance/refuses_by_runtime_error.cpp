// mistake: every refusal throws std::runtime_error
// fails: 1.6, 1.7
// hint: wrong type of exception
#include "variance.hpp"

#include <stdexcept>
#include <string>

#define invalid_argument runtime_error
#include "solutions/variance.cpp"
