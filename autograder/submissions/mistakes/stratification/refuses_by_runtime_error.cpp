// mistake: every refusal throws std::runtime_error
// fails: 3.2, 3.3, 3.5, 3.7, 3.8, 3.9
// hint: wrong type of exception
#include "stratification.hpp"

#include <stdexcept>
#include <string>

#define invalid_argument runtime_error
#include "solutions/stratification.cpp"
