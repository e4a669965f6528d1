// mistake: begins the primes with 1
// caught by: 5.3 the first primes
// hint: 1 is no prime
#include "halton.hpp"

#define primes right_primes
#include "solutions/halton.cpp"
#undef primes

namespace mc {

std::vector<unsigned> primes(std::size_t count) {
  auto found = right_primes(count);
  found.insert(found.begin(), 1);
  found.resize(count);
  return found;
}

}  // namespace mc
