// mistake: every refusal throws std::runtime_error
// fails: 2.2, 2.3, 2.4, 2.5, 2.6, 2.7, 2.9
// hint: wrong type of exception
#include "independent.hpp"

#include <stdexcept>
#include <string>

#define invalid_argument runtime_error
#include "solutions/independent.cpp"
