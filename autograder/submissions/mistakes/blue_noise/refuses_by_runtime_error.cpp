// mistake: every refusal throws std::runtime_error
// fails: 4.2, 4.3, 4.4, 4.5, 4.6
// hint: wrong type of exception
#include "blue_noise.hpp"

#include <stdexcept>
#include <string>

#define invalid_argument runtime_error
#include "solutions/blue_noise.cpp"
