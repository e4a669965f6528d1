// Mistakes in task @number@.1.
#include "@lab@.hpp"

#define square(x) right_square(x)
#include "solutions/@lab@.cpp"
#undef square

// mistake: returns x itself
// hint: this is x itself, not its square
namespace mc::square_is_x {
double square(double x) {
  return x;
}
}  // namespace mc::square_is_x
